// After a jump a method repeats its own opening steps, to the bit. A link tears, which the method learns of as in a
// run; the state and the links are put back to the start; every step from there must be the step of the first time.
// A method that goes on with what it remembers of the other force takes another way, however small its error is. The
// test is SciML's (OrdinaryDiffEq.jl, its multistep methods after a callback), for every method of the catalogue.
#include <gtest/gtest.h>

#include <set>

#include "run/events.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

constexpr double omega = 200;       // rad/s, of two nodes of 2 kg on a link of 4e4 N/m
constexpr double h = 0.1 / omega;   // s
constexpr int longest_history = 5;  // steps, of Adams-Bashforth 5

// Two nodes fly apart until their link tears, in the ninth step: v sin(omega t) > strength omega/stiffness from
// omega t = 0.85 on. A disc swings in a trough of two walls meanwhile.
Scene pulled_apart(double damping) {
  constexpr double stiffness = 4e4, speed = 0.02;  // N/m, m/s of each node
  Scene scene = empty_scene();
  Lattice l = lattice({0, 1}, 1, 2, 0.1);
  l.structural = link_kind(stiffness, damping, stiffness * 2 * speed / omega * std::sin(0.85));
  l.node = {node_setting(0, 0, {}, {-speed, 0}), node_setting(0, 1, {}, {speed, 0})};
  scene.lattice = {l};
  scene.disc = {disc({0, 0}, 0.1, {0.3, 0.1})};
  scene.wall = {wall({0, -0.0995}, {0, 1}), wall({-0.0995, 0}, {1, 0.2})};
  return scene;
}

struct Opening {
  std::vector<State> states;  // after each step, the last one torn
  std::vector<double> times;  // s
  long evaluations = 0;
};

// From the start to the first tear. `heard`: whether the method is told.
Opening opening(System& system, Method& method, State y, bool heard) {
  Opening o;
  const long before = method.evaluations();
  double t = 0;
  jump(system, method, t, y);
  for (bool torn = false; !torn && o.states.size() < 1000;) {
    t += method.step(system, t, y, h);
    const JumpReport report = heard ? jump(system, method, t, y) : system.jump(t, y);
    torn = report.flow_jumped();
    o.states.push_back(y);
    o.times.push_back(t);
  }
  o.evaluations = method.evaluations() - before;
  return o;
}

struct Openings {
  Opening first, second;
  bool same() const { return first.times == second.times && first.states == second.states; }
};

Openings both_openings(const std::string& name, const Scene& scene, bool heard) {
  System system(scene);
  const auto method = make_method(name, {.relative = 1e-4, .absolute = 1e-7, .first_step = h / 10});
  const State start = system.initial_state();
  const DiscreteState whole = system.discrete_state();
  Openings o;
  o.first = opening(system, *method, start, heard);
  system.restore(whole);
  o.second = opening(system, *method, start, heard);
  return o;
}

void expect_the_same(const Openings& o) {
  ASSERT_EQ(o.first.times, o.second.times);
  for (std::size_t n = 0; n < o.first.states.size(); ++n)
    ASSERT_EQ(o.first.states[n], o.second.states[n]) << "step " << n + 1;
  EXPECT_EQ(o.first.evaluations, o.second.evaluations);
}

TEST(AfterAJump, EveryMethodRepeatsItsOwnOpeningStepsToTheBit) {
  for (const double damping : {0.0, 20.0}) {
    const Scene scene = pulled_apart(damping);
    for (const MethodInfo& info : method_catalogue()) {
      if (!refusal(info, System(scene)).empty()) continue;
      SCOPED_TRACE(info.name + ", damping " + std::to_string(damping));
      const Openings o = both_openings(info.name, scene, true);
      EXPECT_GT(o.first.states.size(), longest_history + 1u) << "the history is not full when the link tears";
      EXPECT_LT(o.first.states.size(), 1000u) << "no link tears";
      expect_the_same(o);
    }
  }
}

// The test before sees a method that is not told, if it remembers what its next step uses.
TEST(AfterAJump, AMethodThatHearsNothingOfItTakesAnotherWay) {
  const Scene scene = pulled_apart(20);
  std::set<std::string> noticed;
  for (const MethodInfo& info : method_catalogue()) {
    if (!info.conservative && !both_openings(info.name, scene, false).same()) noticed.insert(info.name);
  }
  for (const char* name : {"pece", "pec", "pecece", "ab2", "verlet", "odeint_ab2", "odeint_ab3", "odeint_ab4",
                           "odeint_ab5", "odeint_abm2", "odeint_abm3", "odeint_abm4", "odeint_abm5",
                           "odeint_velocity_verlet", "pece_adaptive", "rkc", "odeint_dopri5", "odeint_fehlberg78"}) {
    EXPECT_EQ(noticed.count(name), 1u) << name;
  }
  EXPECT_EQ(noticed.count("rk4"), 0u) << "it remembers nothing";
}

}  // namespace
}  // namespace furrow
