// Slots of tangential springs: as many as are needed come when they are needed, and nobody can tell afterwards.
#include <gtest/gtest.h>

#include "resumed.h"
#include "run/observe.h"
#include "run/prepare.h"
#include "scene/read.h"

namespace furrow {
namespace {

using namespace test;

// Leaves room for so many springs only.
void force_room(Running& running, int slots) {
  DiscreteState d = running.system.discrete_state();
  d.unused.erase(d.unused.begin(), d.unused.end() - slots);
  running.system.restore(d);
  running.y = running.system.initial_state();
}

struct Pair {
  Course ample, tight;
  int first_room = 0, last_room = 0;
};

Pair with_and_without_room(const Scene& scene, const Setting& setting, int slots) {
  Running ample(scene, setting), tight(scene, setting);
  force_room(tight, slots);
  Pair pair;
  pair.first_room = tight.system.spring_count();
  pair.ample = course_of(ample, setting, false);
  pair.tight = course_of(tight, setting, false);
  pair.last_room = tight.system.spring_count();
  return pair;
}

TEST(Slots, ComeWhenNeededWithoutAChangeOfABitInAnyMethod) {
  const Scene scene = busy_scene(6);
  int methods = 0;
  std::size_t steps = 0;
  for (const MethodInfo& info : method_catalogue()) {
    if (!refusal(info, System(scene)).empty()) continue;
    for (const Locate locate : {Locate::none, Locate::all}) {
      const Pair pair = with_and_without_room(scene, {info.name, locate, info.dense_jacobian ? 0.002 : 0.01, 1e-4}, 0);
      EXPECT_EQ(pair.tight.end.reason, pair.ample.end.reason);
      EXPECT_EQ(pair.tight.bits, pair.ample.bits) << info.name;
      EXPECT_EQ(pair.first_room, 0);
      EXPECT_GT(pair.last_room, 0) << info.name;
      steps += pair.tight.bits.size();
    }
    ++methods;
  }
  EXPECT_GT(methods, 20);
  EXPECT_GT(steps, 2000u);
}

TEST(Slots, GrowFromAnyRoomAlike) {
  const Scene scene = busy_scene(40);
  const Setting setting{"pece", Locate::none, 0.02, 1e-4};
  for (const int slots : {0, 1, 2, 7, 12}) {
    const Pair pair = with_and_without_room(scene, setting, slots);
    EXPECT_EQ(pair.tight.bits, pair.ample.bits) << slots;
    EXPECT_GT(pair.last_room, slots);
  }
}

TEST(Slots, AreKeptByARunThatGoesOn) {
  const Scene scene = busy_scene(6);
  const Setting setting{"odeint_abm4", Locate::none, 0.01, 1e-4};
  Running running(scene, setting);
  force_room(running, 1);
  const Course whole = course_of(running, setting, true);
  for (std::size_t k = 0; k + 1 < whole.saved.size(); k += 7) {
    const Course rest = course_from(scene, setting, whole.saved[k]);
    ASSERT_FALSE(rest.bits.empty());
    EXPECT_EQ(rest.bits.back(), whole.bits.back()) << k;
  }
}

// A run that ends as diverged on a step that made room ends in the state that was reported, at its time, with the room.
TEST(Slots, AreThereInTheStateThatADivergenceIsSeenIn) {
  const Setting setting{"pece", Locate::none, 0.02, 1e-4};
  int failed = 0;
  for (int slots = 0; slots < 120; slots += 2) {
    Running running(busy_scene(40), setting);
    force_room(running, slots);
    State before, seen;
    double seen_at = -1;
    const RunEnd end = running.go_on(setting, [&](double t, const State& y, const JumpReport& report) -> bool {
      seen = y;
      seen_at = t;
      if (!before.empty() && report.grown.count > 0) throw Divergence("on purpose");
      before = y;
      return true;
    });
    if (end.ending != Ending::diverged) continue;
    ++failed;
    ASSERT_EQ(running.y.size(), running.system.size());
    EXPECT_GT(running.y.size(), before.size());
    EXPECT_EQ(running.y, seen);
    EXPECT_EQ(end.time, seen_at);
  }
  EXPECT_GT(failed, 3);
}

// The paper's second scene with as little damping as an ordinary material has: its soft discs fall on one another and
// are near to more than five others each for a while.
TEST(Slots, SufficeForABedThatSettlesWithOrdinaryDamping) {
  for (const double damping : {0.2, 0.5}) {
    Scene scene = read_scene(FURROW_SOURCE_DIR "/validation/scenes/scenario_2.toml");
    scene.contact.damping_factor = damping;
    const int foreseen = unsettled(scene).spring_count();
    const Prepared settled = prepare(scene);
    EXPECT_GT(settled.system.spring_count(), foreseen);
    EXPECT_LT(greatest_speed(settled.system, settled.y, scene.settle->loose.value_or(0)), scene.settle->speed);
  }
}

}  // namespace
}  // namespace furrow
