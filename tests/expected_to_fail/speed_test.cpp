// What takes longer than it need: counted, not timed.
#include <algorithm>
#include <random>

#include "tests/expected_to_fail/expected_to_fail.h"
#include "tests/unit/counting_system.h"

namespace furrow::test {
namespace {

TEST_F(ExpectedToFail, PecEvaluatesLessOftenThanPece) {
  mended_in("tests/unit/methods_test.cpp");
  const double pec = evaluations_a_step("pec"), pece = evaluations_a_step("pece");
  ASSERT_EQ(pece, 2) << "its second one is the jump's";
  EXPECT_RIGHT(pec < pece) << "all contacts less often than " << pece << " times a step; they were evaluated " << pec
                           << " times";
}

TEST_F(ExpectedToFail, VerletTakesTheRatesThatAJumpLeaves) {
  mended_in("tests/unit/methods_test.cpp");
  for (const char* method : {"verlet", "odeint_velocity_verlet"}) {
    const double a_step = evaluations_a_step(method);
    EXPECT_RIGHT(a_step == 1) << method << " evaluates all contacts once a step, in the jump or by itself; it was "
                              << a_step << " times";
  }
}

// How far from each other in memory the two of a contact are, in numbers of a state.
double mean_distance(const Scene& scene) {
  const System system(scene);
  const State y = system.initial_state();
  double sum = 0, count = 0;
  system.for_each_contact(0, y, [&](const Contact& c) {
    if (c.id.kind != disc_disc) return;
    sum += std::abs(system.x_of(c.id.a) - system.x_of(c.id.b));
    ++count;
  });
  if (count == 0) throw std::runtime_error("nothing touches");
  return sum / count;
}

TEST_F(ExpectedToFail, ListedInAnyOrderNeighboursAreNearInMemory) {
  mended_in("tests/unit/search_cost_test.cpp");
  constexpr int rows = 100, columns = 60;
  Scene scene = empty_scene();
  for (int k = 0; k < rows * columns; ++k)
    scene.disc.push_back(disc({0.199 * (k % columns), 0.199 * (k / columns)}, 0.1));  // NOLINT(*-integer-division)
  const double in_order = mean_distance(scene);
  ASSERT_LT(in_order, columns);
  std::shuffle(scene.disc.begin(), scene.disc.end(), std::mt19937_64(1));
  const double shuffled = mean_distance(scene);
  EXPECT_RIGHT(shuffled < 2 * in_order) << "those that touch are about " << in_order
                                        << " apart, as where they are listed row by row; they are " << shuffled;
}

}  // namespace
}  // namespace furrow::test
