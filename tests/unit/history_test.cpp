// What is carried from one step to the next: a run that is saved and goes on elsewhere is the same run, to the bit.
#include <gtest/gtest.h>

#include <set>

#include "resumed.h"

namespace furrow {
namespace {

using namespace test;

// Sixteen numbers a body at most: for methods with a dense Jacobian, too. Contacts stick, slide, begin and end, links
// tear, within two hundred steps.
Scene small_busy_scene() {
  Scene scene = busy_scene(4);
  scene.model.tight_plates = scene.model.new_faces = true;
  scene.plate = {plate({0.06, 0.001}, 0.01, 0.2, {2, 0})};
  scene.disc[3].position = {0.089, 0.03};
  scene.disc[3].velocity = {3, -0.5};
  return scene;
}

// Nothing that depends on velocity: for symplectic methods.
Scene elastic_scene() {
  Scene scene = empty_scene();
  scene.disc = {disc({-0.3, 0.12}, 0.1, {2, -1}), disc({-0.3, 0.35}, 0.1, {2, -2})};
  scene.wall = {wall({0, 0}, {0, 1})};
  Lattice l = lattice({0, 0.05}, 3, 3, 0.1);
  l.fixed_rows = {0};
  l.node_mass = 0.5;
  l.structural = link_kind(2e4, 0, 40);
  l.shear = link_kind(1e4, 0, 30);
  scene.lattice = {l};
  return scene;
}

struct Tried {
  int runs = 0, methods = 0, after_tears = 0, after_slips = 0;
};

// From every opening step, directly after tears and slips, and late.
std::set<std::size_t> places(const Course& whole) {
  std::set<std::size_t> k{0, 1, 2, 3, 4, 5, 6, whole.saved.size() / 2, whole.saved.size() - 2};
  for (const auto* some : {&whole.tears, &whole.slips}) {
    for (std::size_t n = 0; n < some->size() && n < 3; ++n) k.insert((*some)[n]);
  }
  return k;
}

void expect_to_go_on(const Scene& scene, const Setting& setting, Tried& tried) {
  Running running(scene, setting);
  const Course whole = course_of(running, setting, true);
  ASSERT_GT(whole.saved.size(), 8u);
  for (const std::size_t k : places(whole)) {
    const Course rest = course_from(scene, setting, whole.saved[k]);
    SCOPED_TRACE(setting.method + ", saved after step " + std::to_string(k));
    EXPECT_EQ(rest.end.reason, whole.end.reason);
    EXPECT_EQ(rest.end.steps, whole.end.steps);
    EXPECT_EQ(rest.end.events, whole.end.events);
    EXPECT_EQ(rest.end.event_evaluations, whole.end.event_evaluations);
    ASSERT_EQ(rest.bits.size(), whole.bits.size() - k - 1);
    for (std::size_t n = 0; n < rest.bits.size(); ++n)
      ASSERT_EQ(rest.bits[n], whole.bits[k + 1 + n]) << "step " << n << " after it";
    ++tried.runs;
    tried.after_tears += std::count(whole.tears.begin(), whole.tears.end(), k) > 0 ? 1 : 0;
    tried.after_slips += std::count(whole.slips.begin(), whole.slips.end(), k) > 0 ? 1 : 0;
  }
  ++tried.methods;
}

Tried over_the_catalogue(const Scene& scene, Locate locate, double end, double step) {
  Tried tried;
  const System system(scene);
  for (const MethodInfo& info : method_catalogue()) {
    if (!refusal(info, system).empty()) continue;
    // A dense Jacobian takes long.
    expect_to_go_on(scene, {info.name, locate, info.dense_jacobian ? 0.3 * end : end, step}, tried);
  }
  std::printf("%d methods, %d runs that go on, %d after a tear, %d after springs returned\n", tried.methods, tried.runs,
              tried.after_tears, tried.after_slips);
  return tried;
}

int count_of(bool with_conservative) {
  int count = 0;
  for (const MethodInfo& info : method_catalogue()) count += with_conservative || !info.conservative ? 1 : 0;
  return count;
}

class GoesOn : public testing::TestWithParam<Locate> {};

TEST_P(GoesOn, ByTheSameBitsWithFrictionAndTears) {
  const Tried tried = over_the_catalogue(small_busy_scene(), GetParam(), 0.0081, 1e-4);
  EXPECT_EQ(tried.methods, count_of(false));
  EXPECT_GE(tried.after_tears, tried.methods);
  EXPECT_GE(tried.after_slips, tried.methods);
}

TEST_P(GoesOn, ByTheSameBitsWithoutForcesThatDependOnVelocity) {
  const Tried tried = over_the_catalogue(elastic_scene(), GetParam(), 0.1501, 1e-3);
  EXPECT_EQ(tried.methods, count_of(true));
  EXPECT_GE(tried.after_tears, tried.methods);
}

std::string name_of(const testing::TestParamInfo<Locate>& p) {
  return p.param == Locate::none ? "Nothing" : p.param == Locate::tears ? "Tears" : "All";
}

INSTANTIATE_TEST_SUITE_P(Locating, GoesOn, testing::Values(Locate::none, Locate::tears, Locate::all), name_of);

// A last step is cut to end where the run does; from the one before a longer run goes on as if it had never ended.
TEST_P(GoesOn, BeyondItsEndByTheBitsOfALongerRun) {
  int methods = 0;
  for (const MethodInfo& info : method_catalogue()) {
    if (info.conservative) continue;
    Setting setting{info.name, GetParam(), 0.00123, 1e-4};
    Running first(small_busy_scene(), setting);
    course_of(first, setting, false);
    setting.end = 0.0025;
    Running longer(small_busy_scene(), setting);
    const Course whole = course_of(longer, setting, false);
    const Course rest = course_from(small_busy_scene(), setting, first.before_end);
    ASSERT_GT(rest.bits.size(), 2u) << info.name;
    ASSERT_LT(rest.bits.size(), whole.bits.size()) << info.name;
    EXPECT_TRUE(std::equal(rest.bits.rbegin(), rest.bits.rend(), whole.bits.rbegin())) << info.name;
    ++methods;
  }
  EXPECT_EQ(methods, count_of(false));
}

TEST(History, SavingDisturbsNothing) {
  for (const MethodInfo& info : method_catalogue()) {
    if (info.conservative) continue;
    const Setting setting{info.name, Locate::none, 0.005, 1e-4};
    Running watched(small_busy_scene(), setting), alone(small_busy_scene(), setting);
    EXPECT_EQ(course_of(watched, setting, true).bits, course_of(alone, setting, false).bits) << info.name;
  }
}

// Without its history a method goes other ways: the test above would see one that names none.
TEST(History, IsMissedByAMethodThatHasOne) {
  const Setting setting{"pece", Locate::none, 0.005, 1e-4};
  Running whole(small_busy_scene(), setting);
  const Course all = course_of(whole, setting, true);
  Running running(small_busy_scene(), setting);
  HistoryReader reader(all.saved[20]);
  running.history(reader);
  running.method = make_method("pece");
  EXPECT_NE(course_of(running, setting, false).bits.back(), all.bits.back());
}

TEST(Discrete, AForeignStateIsRefused) {
  System system(small_busy_scene());
  const DiscreteState good = system.discrete_state();
  EXPECT_NO_THROW(system.restore(good));
  const auto refused = [&](auto change) {
    DiscreteState bad = good;
    change(bad);
    EXPECT_THROW(system.restore(bad), std::invalid_argument);
  };
  refused([](DiscreteState& d) { d.torn = {100000}; });
  refused([](DiscreteState& d) { d.unused.push_back(d.unused[0]); });
  refused([](DiscreteState& d) { d.unused[0] = -1; });
  refused([](DiscreteState& d) { d.held = {{disc_disc, 0, 77, d.spring_count(), 1}}; });
  refused([](DiscreteState& d) { d.held = {{9, 0, 1, d.spring_count(), 1}}; });
  refused([](DiscreteState& d) {
    const int n = d.spring_count();
    d.held = {{disc_wall, 0, 0, n, 1}, {disc_disc, 0, 1, n + 1, 1}};
  });
}

}  // namespace
}  // namespace furrow
