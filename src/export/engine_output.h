// What a deck has written, by the step over that of the scene.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "export/deck_run.h"
#include "physics/vec2.h"

namespace furrow {

struct EngineBody {
  int id;          // from 1
  Vec2 at, speed;  // m, m/s
};

// When something happened, in steps of the scene: after the first, at the latest with the second.
struct StepSpan {
  double after, by;
};

struct EngineOutput {
  int refine = 1;
  std::vector<std::vector<double>> forces;  // step, then Fx, Fy of each plate and wall
  std::vector<EngineBody> end;              // every body once
  std::vector<double> tears;                // the step of the scene of each tear, in their order
  std::map<int, StepSpan> links;            // of each bond's link, when it tore
};

// By growing refine. `scene_hash` is the one that the deck hands on to its outputs. Throws FileError if there is none,
// or if a file is not just what the run writes: it names the file, the line, and what to do.
std::vector<EngineOutput> engine_outputs(const std::filesystem::path& directory, const DeckRun& run,
                                         const std::string& scene_hash);

}  // namespace furrow
