// Boost.Odeint's steppers through run(): failures that end a run, scenes that are refused, collisions that are seen.
#include <gtest/gtest.h>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// Two discs in one place: the direction of their force is 0/0.
TEST(OdeintRun, NaNIsADivergenceForEveryMethod) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1), disc({0, 0}, 0.1)};
  for (const MethodInfo& info : method_catalogue()) {
    System system(scene);
    State y = system.initial_state();
    const State start = y;
    const auto method = make_method(info.name);
    const RunEnd end = run(system, *method, y, {.end = 0.1, .step = 0.01}, [](auto...) { return true; });
    EXPECT_EQ(end.ending, Ending::diverged) << info.name;
    EXPECT_EQ(y, start) << info.name;
    EXPECT_LT(method->evaluations(), 3000) << info.name;
  }
}

TEST(OdeintRun, SymplecticMethodsRefuseDampingFrictionAndDampers) {
  Scene scene = busy_scene(2);
  const auto method = make_method("odeint_symplectic_euler");
  System system(scene);
  State y = system.initial_state();
  try {
    run(system, *method, y, {}, [](auto...) { return true; });
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    for (const char* what : {"damping of contacts", "friction of contacts", "damping of the links of lattice stem"})
      EXPECT_NE(text.find(what), std::string::npos) << what;
  }
}

TEST(OdeintRun, SymplecticMethodsRefuseNothingElse) {
  Scene scene = single_spring(4, 0);
  EXPECT_EQ(System(scene).velocity_dependence(), "");
  scene.contact.friction = 0.5;  // of nothing with nothing
  scene.contact.damping_factor = 0.5;
  EXPECT_EQ(System(scene).velocity_dependence(), "");
  scene.plate = {plate({3, 0}, 1, 1, {-1, 0})};
  EXPECT_EQ(System(scene).velocity_dependence(), "damping of contacts, friction of contacts");
}

// A disc of v = 1 m/s against a wall half a metre away: a contact of some 0.03 s. In free flight the error estimate is
// zero and the step grows to its cap: half a second of it flies over the collision.
double rebound(const std::string& name, double max_step) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0.6}, 0.1, {0, -1})};
  scene.wall = {wall({0, 0}, {0, 1})};
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method(name, {1e-8, 1e-8, 1e-3});
  run(system, *method, y, {.end = 1, .step = max_step}, [](auto...) { return true; });
  return y[system.vy_of(0)];
}

TEST(OdeintRun, ControlledMethodsSeeACollisionWhenTheirStepIsCapped) {
  for (const MethodInfo& info : method_catalogue()) {
    if (!info.controlled) continue;
    EXPECT_NEAR(rebound(info.name, 1e-3), 1, 1e-4) << info.name;
  }
}

}  // namespace
}  // namespace furrow
