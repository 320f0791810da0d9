// A run that pauses goes on as if it had not.
//
//   one-step methods:  y(2n steps) = n steps after n steps, bit for bit
//   PECE needs f of the step before. A method that is kept has it; a fresh one begins with a step of Heun, whose local
//   error differs by C h^3: the difference afterwards falls with the third power of the step.
//
// What a system holds besides the numbers of its state: which links are torn, and which contact owns which tangential
// spring. A copy of it has them; a new system made from saved numbers goes on alike only in scenes without friction and
// torn links.
//
// Source: the definition of the methods, src/methods.
#include "verification/check.h"
#include "verification/frozen_scenes.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

enum class Second { same, copy, made_anew };

// Runs to the middle and on from there: on the same system with the same method; or with a fresh method on a copy of
// the system, after the first has gone on, or on a new system that starts from the saved numbers.
State paused(const Case& c, const std::string& method_name, Second second) {
  const auto go_on = [](double, const State&, const JumpReport&) { return true; };
  const double middle = c.step * static_cast<double>(c.steps / 2);
  const RunPlan rest{.start = middle, .end = c.end(), .step = c.step, .stop = {}};
  System system(c.scene);
  State y = system.initial_state();
  const auto method = make_method(method_name);
  run(system, *method, y, {.start = 0, .end = middle, .step = c.step, .stop = {}}, go_on);
  const State saved = y;
  System other = second == Second::copy ? system : System(c.scene);
  if (second != Second::made_anew) run(system, *method, y, rest, go_on);
  if (second != Second::same) {
    y = saved;
    run(other, *make_method(method_name), y, rest, go_on);
  }
  y.resize(static_cast<std::size_t>(system.first_spring()));
  return y;
}

struct Whole {
  State y;
  bool remembers;  // more than the numbers of the state
};

Whole unpaused(Case c, const std::string& method) {
  c.scene.time.method = method;
  Outcome o = outcome(c, c.scene);
  o.y.resize(static_cast<std::size_t>(o.system.first_spring()));
  return {o.y, o.system.has_friction() || o.torn > 0};
}

double greatest_difference(const State& a, const State& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::fabs(a[k] - b[k]));
  return most;
}

TEST(Restart, APauseChangesNoBit) {
  requirement("invariants.restart");
  for (const Case& c : cases()) {
    const auto expect_same = [&](const Whole& whole, const std::string& method, Second second, const std::string& what,
                                 const std::string& reason) {
      expect("difference " + what + ", " + method + ", " + c.name,
             greatest_difference(whole.y, paused(c, method, second)), 0, exact(reason));
    };
    const char* kept = "the system keeps torn links and the slots of the springs, the method its history";
    for (const char* method : {"pece", "verlet"})
      expect_same(unpaused(c, method), method, Second::same, "after a pause", kept);
    const Whole whole = unpaused(c, "rk4");
    expect_same(whole, "rk4", Second::same, "after a pause", kept);
    expect_same(whole, "rk4", Second::copy, "of a copy that goes on later with a fresh method",
                "a system shares nothing with its copy, and rk4 remembers nothing");
    if (whole.remembers) continue;
    expect_same(whole, "rk4", Second::made_anew, "of a system made from the saved state",
                "without friction and torn links the numbers of the state are all there is");
  }
}

TEST(Restart, LostHistoryCostsPeceOneStepOfHeun) {
  requirement("invariants.restart_of_pece");
  for (const char* smooth : {"single_spring.toml", "cantilever.toml"}) {
    Case c = case_of(scenes / smooth);
    c.steps /= 4;
    std::vector<double> steps, differences;
    for (int level = 0; level < 3; ++level) {
      c.step /= 2;
      c.steps *= 2;
      steps.push_back(c.step);
      differences.push_back(greatest_difference(unpaused(c, "pece").y, paused(c, "pece", Second::copy)));
    }
    expect("order of the difference, " + c.name, fitted_slope(steps, differences), 3,
           absolute(0.2, "one step of Heun for one of PECE: both have local errors of h^3; next term h^4"));
  }
}

}  // namespace
}  // namespace furrow::verification
