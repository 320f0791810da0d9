// Prints one line "scene hash" for a short run of each scene of the paper and some others, settled and moved for a
// while with everything on. Built with other compilers and flags, and run with the reference or on threads, it must
// print the lines of hashes.txt; the reference, which looks at every pair, runs the shorter scenes alone, and so does
// `short`, for builds that are slow.
//
// Usage: state_hashes DIRECTORY_OF_SCENES [reference | threads | short]
#include <cinttypes>
#include <cstdio>
#include <filesystem>

#include "run/prepare.h"
#include "run/run.h"
#include "scene/read.h"
#include "system/order.h"

namespace {

using furrow::Scene;

// A bed that settles in a moment: fewer discs, a generous idea of rest.
Scene shortened(Scene scene) {
  for (furrow::Packing& packing : scene.packing) packing.count = 120;
  if (scene.settle) scene.settle = furrow::Settle{.speed = 0.8, .hold = 0.1, .limit = 5};
  scene.time.end = std::min(scene.time.end, 0.05);
  scene.output.frames.clear();
  return scene;
}

// A touch, a slip that stops, and a release, all located.
Scene bouncing(Scene scene) {
  scene.contact.damping_factor = 0.2;
  scene.contact.friction = 0.3;
  scene.disc.front().velocity.x = 0.05;
  scene.time.method = "pece";
  scene.time.step = 1e-5;
  scene.time.locate = furrow::Locate::all;
  return scene;
}

// A bed of two packings, one through the other, just large enough for two blocks.
Scene wide(Scene scene) {
  scene.settle.reset();
  scene.plate.clear();
  scene.packing.resize(1);
  scene.packing[0].count = furrow::discs_per_block / 2 + 200;
  scene.packing[0].lower_left = {0, 0};
  scene.packing[0].upper_right = {3, 1.5};
  scene.packing.push_back(scene.packing[0]);
  scene.packing[1].seed += 1;
  scene.wall.back().point.x = 3;
  scene.time.end = 0.02;
  return scene;
}

// The question is whether the bits are the same, not whether the laws hold.
std::uint64_t hash_after_run(Scene scene) {
  constexpr double any = 1e9;
  scene.allow = furrow::Allow{any, any, any, any, true, true, true};
  furrow::Prepared prepared = furrow::prepare(scene);
  const auto method =
      furrow::make_method(scene.time.method, {.relative = 1e-2, .absolute = 1e-4, .first_step = scene.time.step});
  furrow::run(prepared.system, *method, prepared.y,
              {.start = 0, .end = scene.time.end, .step = scene.time.step, .stop = {}, .locate = scene.time.locate},
              [](double, const furrow::State&, const furrow::JumpReport&) { return true; });
  return prepared.system.state_hash(prepared.y);
}

void print(const char* name, const char* variant, const Scene& scene) {
  std::printf("%-14s %-13s %016" PRIx64 "\n", name, variant, hash_after_run(scene));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string setting = argc == 3 ? argv[2] : "";
  const bool reference = setting == "reference", fewer = reference || setting == "short";
  if (argc != 2 && !fewer && setting != "threads") {
    std::fprintf(stderr, "usage: state_hashes DIRECTORY_OF_SCENES [reference | threads | short]\n");
    return 2;
  }
  const std::filesystem::path directory = argv[1];
  for (const char* name : {"scenario_1", "scenario_2", "scenario_3", "single_spring", "disc_on_wall", "cantilever"}) {
    Scene scene = shortened(furrow::read_scene(directory / (std::string(name) + ".toml")));
    if (reference) scene.time.solver = furrow::SolverKind::reference;
    if (std::string(name) == "scenario_1") scene.time.end = 0.6;  // until links have torn
    print(name, "pece", scene);
    if (fewer && !scene.packing.empty()) continue;
    Scene chosen = scene;  // steps that the method chooses, tears located
    chosen.time.step = 1e-3;
    chosen.time.locate = furrow::Locate::tears;
    for (const char* method : {"pece_adaptive", "rkc"}) {
      chosen.time.method = method;
      print(name, method, chosen);
    }
    if (std::string(name) == "disc_on_wall") print(name, "located", bouncing(scene));
    if (scene.disc.empty() && scene.packing.empty()) continue;
    scene.time.method = "rk4";
    print(name, "rk4", scene);
    scene.model.disc_mass = furrow::DiscMass::sphere;
    scene.time.method = "verlet";
    scene.time.step = std::min(scene.time.step, 1e-5);
    scene.time.end = std::min(scene.time.end, 0.002);
    print(name, "sphere", scene);
  }
  if (fewer) return 0;
  Scene bed = wide(furrow::read_scene(directory / "scenario_2.toml"));
  if (setting == "threads") bed.search.threads = 3;
  print("wide bed", "pece", bed);
  return 0;
}
