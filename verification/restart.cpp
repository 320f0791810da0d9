// A run that pauses goes on as if it had not.
//
//   one-step methods:  y(2n steps) = n steps after n steps, bit for bit
//   PECE needs f of the step before. A method that is kept has it; a fresh one begins with a step of Heun, whose local
//   error differs by C h^3: the difference afterwards falls with the third power of the step.
//
// What a system holds besides the numbers of its state: which links are torn, and which contact owns which tangential
// spring. A new system made from saved numbers therefore goes on alike only in scenes without friction and torn links.
//
// Source: the definition of the methods, src/methods.
#include "verification/check.h"
#include "verification/frozen_scenes.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

// Runs to the middle and on from there: with the same method, or with a fresh one; on the same system, or a new one
// that starts from the saved numbers.
State paused(const Case& c, const std::string& method_name, bool fresh_method, bool fresh_system) {
  const auto go_on = [](double, const State&, const JumpReport&) { return true; };
  System system(c.scene);
  State y = system.initial_state();
  auto method = make_method(method_name);
  const long half = c.steps / 2;
  const double middle = c.step * static_cast<double>(half);
  run(system, *method, y, {.start = 0, .end = middle, .step = c.step, .stop = {}}, go_on);
  if (fresh_method) method = make_method(method_name);
  System second = fresh_system ? System(c.scene) : std::move(system);
  run(second, *method, y, {.start = middle, .end = c.end(), .step = c.step, .stop = {}}, go_on);
  y.resize(static_cast<std::size_t>(second.first_spring()));
  return y;
}

State unpaused(Case c, const std::string& method) {
  c.scene.time.method = method;
  Outcome o = outcome(c, c.scene);
  o.y.resize(static_cast<std::size_t>(o.system.first_spring()));
  return o.y;
}

double greatest_difference(const State& a, const State& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::fabs(a[k] - b[k]));
  return most;
}

TEST(Restart, APauseChangesNoBit) {
  requirement("invariants.restart");
  for (const Case& c : cases()) {
    const char* reason = "the system keeps torn links and the slots of the springs, the method its history";
    for (const char* method : {"pece", "verlet", "rk4"}) {
      expect("difference after a pause, " + std::string(method) + ", " + c.name,
             greatest_difference(unpaused(c, method), paused(c, method, false, false)), 0, exact(reason));
    }
    expect("difference with a fresh method, rk4, " + c.name,
           greatest_difference(unpaused(c, "rk4"), paused(c, "rk4", true, false)), 0, exact("rk4 remembers nothing"));
    const bool remembers = System(c.scene).has_friction() || outcome(c, c.scene).torn > 0;
    if (remembers) continue;
    expect("difference of a system made from the saved state, rk4, " + c.name,
           greatest_difference(unpaused(c, "rk4"), paused(c, "rk4", true, true)), 0,
           exact("without friction and torn links the numbers of the state are all there is"));
  }
}

TEST(Restart, LostHistoryCostsPeceOneStepOfHeun) {
  requirement("invariants.restart_of_pece");
  for (const char* smooth : {"single_spring.toml", "cantilever.toml"}) {
    Case c = case_of(scenes / smooth);
    std::vector<double> steps, differences;
    for (int level = 0; level < 3; ++level) {
      c.step /= 2;
      c.steps *= 2;
      steps.push_back(c.step);
      differences.push_back(greatest_difference(unpaused(c, "pece"), paused(c, "pece", true, false)));
    }
    expect("order of the difference, " + c.name, fitted_slope(steps, differences), 3,
           absolute(0.2, "one step of Heun for one of PECE: both have local errors of h^3; next term h^4"));
  }
}

}  // namespace
}  // namespace furrow::verification
