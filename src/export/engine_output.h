// What a deck has written, by the step over that of the scene.
#pragma once

#include <filesystem>
#include <vector>

#include "physics/vec2.h"

namespace furrow {

struct EngineBody {
  int id;          // from 1
  Vec2 at, speed;  // m, m/s
};

struct EngineOutput {
  int refine = 1;
  std::vector<std::vector<double>> forces;  // step, then Fx, Fy of each plate and wall
  std::vector<EngineBody> end;              // in the order of their numbers; empty: not written yet
  std::vector<std::vector<double>> tears;   // step, count
  std::vector<std::vector<double>> links;   // two bodies, from 1
};

// By growing refine. Throws FileError if there is none.
std::vector<EngineOutput> engine_outputs(const std::filesystem::path& directory);

// Lines that are nothing but so many numbers; with 0 any number of them.
std::vector<std::vector<double>> rows_of_numbers(const std::filesystem::path& file, std::size_t columns = 0);

}  // namespace furrow
