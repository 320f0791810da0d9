// The fixed kernels that the project's speed is followed by: each is a certain piece of work, done a certain number of
// times from a certain start, with an answer that must come out the same to the bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace furrow::benchmarks {

// One kernel made ready.
struct Work {
  std::function<void(long calls)> run;
  std::function<std::uint64_t()> answer;  // 64-bit FNV-1a of all that was computed
  std::function<double()> error;          // m, what the method got wrong; empty where nothing is integrated
};

struct Kernel {
  std::string name, what;
  long calls;  // evaluations, steps, ... in a measurement
  Work (*make)(const std::filesystem::path& beds);
};

const std::vector<Kernel>& kernels();

// The paper's scenes, for their profile; they are not followed from commit to commit. A call is a step.
const std::vector<Kernel>& whole_scenes();

// Settles the beds that kernels start from and writes them into a directory; takes seconds and is no part of any
// measurement. with_bed throws std::runtime_error if there is none.
void make_beds(const std::filesystem::path& directory);
Scene with_bed(Scene scene, const std::filesystem::path& file);

Scene paper_scene(const std::string& name);

// A bed side by side `copies` times, without plates and with the walls between taken out: discs that touched these now
// touch each other, with twice the overlap. The last wall must be the right one, the left one at x = 0.
Scene repeated(const Scene& scene, int copies);

}  // namespace furrow::benchmarks
