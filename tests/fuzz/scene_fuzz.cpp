// Fuzz target of libFuzzer: a text is read as a scene and, if it is one and small, run for a few steps of a few
// methods. Sanitizers find what is wrong in memory; the checks here find messages without a place, scenes that do not
// survive being written, and errors of a kind that nobody expects.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

#include "methods/method.h"
#include "run/observe.h"
#include "run/prepare.h"
#include "run/run.h"
#include "scene/read.h"

namespace furrow {
namespace {

void demand(bool kept, const std::string& what) {
  if (kept) return;
  std::fprintf(stderr, "fuzz: %s\n", what.c_str());
  std::abort();
}

// file:line:column: error: what
bool has_place(const std::string& message) {
  int line = 0, column = 0, end = 0;
  return std::sscanf(message.c_str(), "fuzz:%d:%d: error: %n", &line, &column, &end) == 2 && end > 0 && line > 0 &&
         column > 0 && message.size() > static_cast<std::size_t>(end);
}

// Few enough parts for a step to take no time to speak of.
bool is_small(const Scene& scene) {
  double parts = 10.0 * static_cast<double>(scene.disc.size() + scene.wall.size() + scene.plate.size());
  for (const Packing& p : scene.packing) parts += 10.0 * p.count;
  for (const Lattice& l : scene.lattice) parts += 10.0 * l.rows * l.columns + l.auxiliary_points;
  return parts < 3000;
}

void survives_being_written(const Scene& scene) {
  const std::string text = canonical_text(scene);
  try {
    demand(canonical_text(parse_scene(text, "fuzz")) == text, "what was written reads as another scene");
  } catch (const SceneError& error) {
    demand(false, "what was written is refused: " + std::string(error.what()));
  }
}

void take_steps(const Scene& scene, const std::string& name) {
  const auto method = make_method(name, {scene.time.relative_tolerance, scene.time.absolute_tolerance});
  System system = unsettled(scene);
  if (!refusal(method->info(), system).empty()) return;
  State y = system.initial_state(), rates(y.size());
  system.rhs(0, y, rates);
  observe(system, 0, y);
  RunPlan plan;
  plan.step = scene.time.step;
  plan.end = 4 * plan.step;
  plan.locate = scene.time.locate;
  int steps = 0;
  const RunEnd end =
      run(system, *method, y, plan, [&](double, const State&, const JumpReport&) { return ++steps < 10; });
  demand(end.ending != Ending::diverged || !end.reason.empty(), "a run has diverged without a reason");
  observe(system, end.time, y);
  disc_stresses(system, end.time, y);
  link_forces(system, 0, y);
}

void try_text(const std::string& text) {
  Scene scene;
  try {
    scene = parse_scene(text, "fuzz");
  } catch (const SceneError& error) {
    demand(!error.messages().empty(), "a scene is refused without a message");
    for (const std::string& message : error.messages()) demand(has_place(message), "no place in: " + message);
    return;
  }
  if (!is_small(scene)) return;
  survives_being_written(scene);
  for (const char* method : {"pece", "symplectic_euler", "verlet", "pece_adaptive", "rkc", "odeint_dopri5"}) {
    try {
      take_steps(scene, method);
    } catch (const Divergence&) {          // stated: at the start something is not finite
    } catch (const std::runtime_error&) {  // stated: a packing has no room
    }
  }
}

}  // namespace
}  // namespace furrow

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  furrow::try_text({reinterpret_cast<const char*>(data), size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

// Every second time a number gives way to another one: bytes at random seldom leave a scene.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  static const char* const numbers[] = {"0.0", "-1.0", "1e300", "1e-300", "1e17", "1e-9", "0.5", "0.01", "0.0101", "1",
                                        "2",   "inf",  "1e9",   "1e-17",  "100",  "-0.0", "3.0", "1e5",  "1e-4",   "0"};
  std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t from = size == 0 ? 0 : text.find_first_of("0123456789", (seed / 2) % size);
  if (seed % 2 == 0 || size == 0 || from == std::string::npos) return LLVMFuzzerMutate(data, size, most);
  const std::size_t to = std::min(text.find_first_not_of("0123456789.e", from), size);
  text.replace(from, to - from, numbers[(seed / 64) % std::size(numbers)]);
  const std::size_t length = std::min(text.size(), most);
  std::copy_n(text.data(), length, reinterpret_cast<char*>(data));
  return length;
}
