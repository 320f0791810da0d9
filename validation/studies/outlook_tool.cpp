// A tool that bends against a rigid one in the same bed.
#include <algorithm>
#include <cmath>

#include "report/seal.h"
#include "report/study.h"
#include "run/observe.h"
#include "run/prepare.h"
#include "run/run.h"
#include "validation/studies/outlook.h"

namespace furrow::validation {
namespace {

constexpr double row_every = 1e-3;     // s
constexpr double past_the_ramp = 0.4;  // s: the ramp of 0.2 s, and as long for the bed to fill up in front of the tool

// The plate stands where the lattice does, as wide and as deep, and moves as its driven row does.
Scene scene_of(bool rigid, int packing) {
  Scene scene = scene_named("deformable_tool");
  scene.output.energy = false;
  for (Packing& p : scene.packing) p.seed = 401 + static_cast<std::uint64_t>(packing);
  if (!rigid) return scene;
  const Lattice tool = scene.lattice.at(0);
  Plate plate;
  plate.name = tool.name;
  plate.material = tool.material;
  plate.left_edge = tool.origin.x;
  plate.lower_edge = tool.origin.y;
  plate.width = tool.stem->diameter;
  plate.height = tool.stem->length;
  plate.velocity = tool.drive.at(0).velocity;
  plate.ramp = tool.drive.at(0).ramp;
  scene.lattice.clear();
  scene.plate = {plate};
  return scene;
}

Json run_of(const Scene& scene) {
  Prepared prepared = prepare(scene);
  System& system = prepared.system;
  const Timing& time = prepared.scene.time;
  const auto method = make_method(time.method);
  const RunPlan plan{.start = 0, .end = time.end, .step = time.step, .stop = {}};
  double sum = 0, squares = 0, largest = 0, rows = 0;
  std::size_t torn = 0;
  long next = std::lround(past_the_ramp / row_every);
  const RunEnd end = run(system, *method, prepared.y, plan, [&](double t, const State& y, const JumpReport& jump) {
    torn += jump.torn.size();
    if (t < static_cast<double>(next) * row_every - 0.5 * time.step) return true;
    ++next;
    const Observation seen = observe(system, t, y);
    const Force force = seen.plate.empty() ? seen.drive.at(0) : seen.plate[0];
    const double f = std::hypot(force.x, force.y);
    sum += f;
    squares += f * f;
    largest = std::max(largest, f);
    rows += 1;
    return true;
  });
  if (end.ending == Ending::diverged) throw Divergence(end.reason);
  const double mean = sum / rows, variance = std::max(0.0, squares / rows - mean * mean);
  constexpr int digits = 6;
  return {{"mean_force", to_digits(mean, digits)},
          {"largest_force", to_digits(largest, digits)},
          {"fluctuation", to_digits(std::sqrt(variance) / mean, digits)},
          {"torn", torn}};
}

}  // namespace

int tool_packings(bool quick) { return quick ? 1 : 6; }

std::string tool_key(bool rigid, int packing) {
  return std::string("tool ") + (rigid ? "rigid " : "deformable ") + std::to_string(packing);
}

Task tool_task(bool rigid, int packing) {
  const Scene scene = scene_of(rigid, packing);
  return {tool_key(rigid, packing), [scene] { return run_of(scene); }, hash_of_scene(scene)};
}

}  // namespace furrow::validation
