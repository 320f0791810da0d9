// What an engine's output says beside furrow's own run from the same start.
//
//   early force  on plates and walls, up to a time at which the bed is not chaotic yet: error over the greatest force, for
//                each step that the engine ran with, against furrow's rk4 at the smallest of them, and the observed order
//   later        the mean of the push over the rest of the run, with its standard error from ten blocks; heights of the
//                discs and of the surface at the end; how far bodies are apart then: none of it a verdict
//   links        which are torn, and how many steps apart those tore that tore early, in the engine or here
//
// Of what is judged `good` is true or false, of the rest null: `later` and `end`, where there is no force, and all of a deck
// that has another law than the scene.
//
// The deck, and every output of each step, must be whole and of this deck.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace furrow {

struct Compared {
  nlohmann::ordered_json json;
  std::string text;            // the same for a reader
  std::optional<bool> good{};  // the forces have the order of the step, and links tear as here; empty: no verdict
  bool in_vain = false;        // there was nothing that could have been compared
};

// `early`: s; the whole run if it ends before. Throws std::invalid_argument if it is before the first row of the output, FileError
// where a file of the deck or of the engine is not whole or not of this deck.
Compared compare_with_engine(const std::filesystem::path& directory, double early);

}  // namespace furrow
