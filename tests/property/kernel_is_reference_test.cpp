// The kernel gives the bits of the reference, after every step: random scenes with every option of the law, and beds of
// more than one block. RapidCheck shrinks what fails to a small scene. The paper's scenes are compared from end to end
// with FURROW_LONG.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
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

// All methods; of those that evaluate often, fewer steps.
std::vector<std::string> methods_for(const System& system) {
  std::vector<std::string> names;
  for (const MethodInfo& method : method_catalogue())
    if (refusal(method, system).empty()) names.push_back(method.name);
  return names;
}

long steps_of(const std::string& method, long evaluations) {
  const MethodInfo info = make_method(method)->info();
  const int a_step = info.evaluations > 0 ? info.evaluations : 20;  // as many as they need
  return info.dense_jacobian ? 1 : std::max(2L, evaluations / a_step);
}

RC_GTEST_PROP(KernelIsReference, AfterEveryStepOfRandomScenes, ()) {
  const Scene scene = some_scene();
  BothSolvers both(scene);
  const auto method = *rc::gen::elementOf(methods_for(both.kernel()));
  std::string found;
  if (test::either()) {
    both.prepare(true);
    found = both.run(method, 1e-4, steps_of(method, 20));
    if (!found.empty()) found = "while it is prepared, " + found;
    both.prepare(false);
  }
  if (found.empty()) found = both.run(method, 1e-4, steps_of(method, 70));
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

constexpr int discs_of_bed = 4096 + 700, discs_a_row = 70;

// Numbered at random, so that pairs reach across blocks all over the bed.
std::vector<Disc> discs_over_blocks(std::mt19937_64& random) {
  std::vector<int> place(discs_of_bed);
  for (int k = 0; k < discs_of_bed; ++k) place[k] = k;
  for (int k = discs_of_bed - 1; k > 0; --k) std::swap(place[k], place[random() % static_cast<std::uint64_t>(k + 1)]);
  std::vector<Disc> discs;
  for (const int k : place) {
    const double jitter = 1e-6 * static_cast<double>(random() % 1000);
    discs.push_back({{0.019 * (k % discs_a_row) + jitter, 0.009 + 0.019 * (k / discs_a_row) - jitter},
                     0.0095 + jitter,
                     {1e-3 * static_cast<double>(random() % 100), -0.1},
                     static_cast<double>(random() % 7),
                     k % 3 == 0 ? "hard" : "soft"});
  }
  return discs;
}

// Within the bed.
Plate plate_in_bed() {
  Plate p;
  p.name = "plate";
  p.left_edge = 0.4;
  p.lower_edge = 0.1;
  p.height = 0.3;
  p.velocity = {1, 0.1};
  p.material = "hard";
  return p;
}

Lattice lattice_in_bed() {
  const LinkKind some_tear{2000, 1, 5};
  return {.name = "lattice",
          .origin = {0.8, 0},
          .rows = 20,
          .columns = 2,
          .spacing = 0.02,
          .node_mass = 0.2,
          .material = "soft",
          .fixed_rows = {0},
          .structural = some_tear,
          .shear = some_tear};
}

// What a bed has is chosen by `choose(n)`, a number below n.
template <class Choose>
Scene bed_over_blocks(int threads, std::uint64_t seed, const Choose& choose) {
  std::mt19937_64 random(seed);
  Scene s;
  s.material = materials();
  s.disc = discs_over_blocks(random);
  s.wall = {{"", {0, 0}, {0, 1}, "hard"}};
  s.search.threads = threads;
  s.contact = {.damping_factor = 2.0, .friction = 0.4, .rolling_friction = 0.2};
  if (choose(3) == 1) s.contact.damping_factor = {}, s.contact.damping = 0.5;
  s.contact.normal_stiffness = 3e4;
  s.contact.tangential_stiffness = 1e4;
  s.model.law = std::array{ForceLaw::hertz_mindlin, ForceLaw::linear, ForceLaw::rescaled_mindlin}[choose(3)];
  s.model.rolling = std::array{Rolling::smoothed, Rolling::spring, Rolling::none}[choose(3)];
  s.model.after_slip = std::array{AfterSlip::elastic, AfterSlip::less_viscous}[choose(2)];
  s.model.moment_arm = std::array{MomentArm::contact_point, MomentArm::half_overlap, MomentArm::radius}[choose(3)];
  s.model.slip_damping = choose(2) == 0;
  if (choose(2) == 1) s.plate = {plate_in_bed()};
  if (choose(2) == 1) s.lattice = {lattice_in_bed()};
  s.output.energy = choose(3) != 2;
  s.output.angles = choose(2) == 1;
  if (choose(4) == 3) s.contact.friction = s.contact.rolling_friction = 0;
  return s;
}

void expect_same_bits(const Scene& bed, long steps) {
  BothSolvers both(bed);
  EXPECT_EQ(both.kernel().threads(), bed.search.threads);
  EXPECT_EQ(both.run("pece", 1e-4, steps), "") << bed.search.threads << " threads";
  EXPECT_GT(both.contacts(), 2 * 9000);  // at two moments at least
}

// The first has the law alone; then each option comes up at least once in four beds.
TEST(KernelIsReference, InBedsOfMoreThanOneBlockOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 4})
    expect_same_bits(bed_over_blocks(threads, 7, [&](int among) { return (threads - 1) % among; }),
                     threads == 1 ? 3 : 1);
}

TEST(KernelIsReference, InBedsOfMoreThanOneBlockWithOptionsAtRandom) {
  const int beds = std::getenv("FURROW_LONG") != nullptr ? 60 : 1;
  for (int k = 0; k < beds; ++k) {
    std::mt19937_64 random(static_cast<std::uint64_t>(k));
    const auto choose = [&](int among) { return static_cast<int>(random() % static_cast<std::uint64_t>(among)); };
    expect_same_bits(bed_over_blocks(1 + choose(4), random(), choose), 1);
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
