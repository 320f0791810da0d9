// What an engine's output says beside furrow's own run from the same start.
//
//   early force  on plates and walls, up to a time at which the bed is not chaotic yet: error over the greatest force, for
//                each step that the engine ran with, against furrow's rk4 at the smallest of them, and the observed order
//   later        the mean of the push over the rest of the run, with its standard error from ten blocks; heights of the
//                discs and of the surface at the end; how far bodies are apart then
//   links        which are torn, and how many steps apart those tore that tore early
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace furrow {

struct Compared {
  nlohmann::ordered_json json;
  std::string text;  // the same for a reader
  bool good = true;  // where the deck is exact: the order of the step is there, and links tear in the same steps
};

// `early`: s; the whole run if it ends before. Throws FileError where the engine has left nothing.
Compared compare_with_engine(const std::filesystem::path& directory, double early);

}  // namespace furrow
