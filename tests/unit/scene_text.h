// Texts and scenes that the tests of reader, validation and writer start from, and the errors that they come to.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "scene/read.h"

// What a designated initializer leaves out has the default that scene.h gives it; g++ 12 warns of it all the same.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace furrow {

using Lines = std::vector<std::string>;
inline const std::filesystem::path source_dir = FURROW_SOURCE_DIR;

inline const std::string good = R"(title = "a disc falls"
[time]
end = 1.0
step = 1e-3
[[material]]
name = "soft"
young = 2e5
poisson = 0.3
[[disc]]
position = [0.0, 1.0]
radius = 0.1
material = "soft"
)";

inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

inline std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Messages without the name of the file, and without "error: ".
inline Lines errors(const std::string& text) {
  try {
    parse_scene(text, "f");
  } catch (const SceneError& error) {
    Lines lines;
    for (const std::string& message : error.messages()) lines.push_back(changed(message.substr(2), " error: ", " "));
    return lines;
  }
  return {};
}

inline Lines errors_with(const std::string& from, const std::string& to) { return errors(changed(good, from, to)); }
inline Lines errors_after(const std::string& more) { return errors(good + more); }  // `more` begins in line 13

// A lattice of 3 rows and 2 columns under a plate, and a disc on a floor: nothing is wrong with it.
inline Scene sound_scene() {
  Scene s;
  s.title = "sound";
  s.material = {Material{.name = "soft", .young = 2e5, .poisson = 0.3}, Material{.name = "hard", .rigid = true}};
  s.disc = {Disc{.position = {0, 1}, .radius = 0.1, .material = "soft"}};
  s.wall = {Wall{.name = "floor", .material = "hard"}};
  s.plate = {Plate{.name = "tool", .left_edge = 0.5, .lower_edge = 1, .material = "hard"}};
  s.lattice = {Lattice{.name = "stem", .rows = 3, .columns = 2, .material = "soft", .fixed_rows = {0}}};
  s.lattice[0].structural = s.lattice[0].shear = {.stiffness = 1};
  return s;
}

}  // namespace furrow
