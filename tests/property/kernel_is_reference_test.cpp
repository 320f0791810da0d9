// The kernel gives the bits of the reference, after every step: random scenes with every option of the law, and beds of
// more than one block. RapidCheck shrinks what fails to a small scene. The paper's scenes are compared from end to end
// with FURROW_LONG.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <ostream>
#include <random>

#include "both_solvers.h"
#include "random_scene.h"
#include "run/prepare.h"
#include "scene/read.h"

namespace furrow {
namespace {

using test::BothSolvers;
using test::materials;
using test::some_scene;

RC_GTEST_PROP(KernelIsReference, AfterEveryStepOfRandomScenes, ()) {
  const Scene scene = some_scene();
  BothSolvers both(scene);
  const auto method = *rc::gen::element<std::string>("pece", "rk4", "symplectic_euler", "ab2");
  const std::string found = both.run(method, 1e-4, 40);
  RC_CLASSIFY(both.contacts() > 0, "something touched");
  if (!found.empty()) RC_LOG() << canonical_text(scene);
  RC_LOG() << found << '\n';
  RC_ASSERT(found.empty());
}

// What the property rests on: it sees a difference of the last bit.
TEST(KernelIsReference, ADifferenceOfTheLastBitIsSeen) {
  Scene scene;
  scene.material = materials();
  scene.contact.friction = 0.5;
  scene.disc = {{{0, 0}, 0.01, {}, 0, "soft"}, {{0.019, 0}, 0.01, {}, 0, "soft"}};
  const System system(scene);
  const State y = system.initial_state();
  for (std::size_t k = 0; k < y.size(); ++k) {
    State other = y;
    other[k] = std::nextafter(other[k], 1e300);
    EXPECT_NE(test::difference(system, y, system, other), "") << test::name_of_number(system, static_cast<int>(k));
  }
  EXPECT_EQ(test::difference(system, y, system, y), "");
}

// Numbered at random, so that pairs reach across blocks all over the bed.
Scene bed_over_blocks(int threads) {
  constexpr int count = 4096 + 700, a_row = 70;
  std::mt19937_64 random(7);
  std::vector<int> place(count);
  for (int k = 0; k < count; ++k) place[k] = k;
  for (int k = count - 1; k > 0; --k) std::swap(place[k], place[random() % static_cast<std::uint64_t>(k + 1)]);
  Scene s;
  s.material = materials();
  s.contact = {.damping_factor = 2.0, .friction = 0.4, .rolling_friction = 0.2};
  s.search.threads = threads;
  s.wall = {{"", {0, 0}, {0, 1}, "hard"}};
  for (const int k : place) {
    const double jitter = 1e-6 * static_cast<double>(random() % 1000);
    s.disc.push_back({{0.019 * (k % a_row) + jitter, 0.009 + 0.019 * (k / a_row) - jitter},
                      0.0095 + jitter,
                      {1e-3 * static_cast<double>(random() % 100), -0.1},
                      static_cast<double>(random() % 7),
                      k % 3 == 0 ? "hard" : "soft"});
  }
  return s;
}

TEST(KernelIsReference, InBedsOfMoreThanOneBlockOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 4}) {
    BothSolvers both(bed_over_blocks(threads));
    EXPECT_EQ(both.kernel().threads(), threads);
    EXPECT_EQ(both.run("pece", 1e-4, threads == 1 ? 3 : 1), "") << threads << " threads";
    EXPECT_GT(both.contacts(), 2 * 9000);  // at two moments at least
  }
}

// The beds of the paper's scenes as they lie, and the plate's first way through them; with FURROW_LONG all of it.
class PapersScenes : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, PapersScenes, testing::Values("scenario_1", "scenario_2", "scenario_3"));

TEST_P(PapersScenes, AreTheSameBitsFromTheReference) {
  const Scene scene = read_scene(std::string(FURROW_SOURCE_DIR) + "/validation/scenes/" + GetParam() + ".toml");
  const Prepared p = prepare(scene);
  BothSolvers both(p.scene);
  both.start_from(p.y, p.system.discrete_state());
  const bool whole = std::getenv("FURROW_LONG") != nullptr;
  const long steps = whole ? std::lround(scene.time.end / scene.time.step) : 300;
  EXPECT_EQ(both.run(scene.time.method, scene.time.step, steps), "");
}

}  // namespace
}  // namespace furrow
