// What must hold of every scene whatever it is, with no number known beforehand: nothing depends on where the observer
// stands, which way he looks, how fast he goes.
//
//   turned by Q and carried at V:
//     r' = Q r + V t
//     v' = Q v + V
//     spin' = det(Q) spin
//
// Source: invariance of Newton's laws.
#include <cmath>

#include "run/observe.h"
#include "verification/observers.h"

namespace furrow::verification::invariants {
namespace {

Scene weightless(Scene scene) {
  scene.model.gravity = 0;
  return scene;
}

Scene without_plates(Scene scene) {
  scene.plate.clear();
  return scene;
}

// Edges and travel of plates as binary fractions: left + width must not round.
Scene in_binary_fractions(Scene scene) {
  for (Plate& p : scene.plate) {
    for (double* edge : {&p.left_edge, &*p.lower_edge, &p.width, &p.height})
      *edge = std::round(*edge * 0x1p20) * 0x1p-20;
    p.velocity = {std::round(p.velocity.x * 0x1p10) * 0x1p-10, std::round(p.velocity.y * 0x1p10) * 0x1p-10};
  }
  return scene;
}

TEST(Invariants, TheScenesAreAtWork) {
  requirement("invariants.at_work");
  for (const Case& c : cases()) {
    const Outcome base = outcome(c, c.scene);
    const Observation at_end = observe(base.system, c.end(), base.y);
    const char* reason = "else the relations below would say little";
    if (c.name == "scenario_1") expect_true(c.name + " tears links", base.torn >= 1, reason);
    if (!c.scene.settle && c.scene.disc.size() == 120) {
      expect_true(c.name + " has more than 150 contacts", at_end.contacts > 150, reason);
      expect_true(c.name + " resists the plate", at_end.plate[0].x < -1, reason);
    }
    expect_true(c.name + " moves", greatest_speed(base.system, base.y) > 1e-3, reason);
  }
}

TEST(Invariants, TurnedScenesTurnTheirMotion) {
  requirement("invariants.turned");
  for (Case c : cases()) {
    c.scene = weightless(c.scene);  // weight has a direction of its own
    const Outcome base = outcome(c, c.scene);
    const Difference limit = rounding(c, base);
    expect_same(c.name + " by a quarter", difference(base, outcome(c, seen(c.scene, quarter_turn)), quarter_turn, 0),
                limit);
    c.scene = without_plates(c.scene);
    const Outcome bare = outcome(c, c.scene);
    expect_same(c.name + " by 0.7 rad, without plates",
                difference(bare, outcome(c, seen(c.scene, part_turn)), part_turn, 0), rounding(c, bare));
  }
}

TEST(Invariants, MirrorImagesMirrorTheirMotionBitForBit) {
  requirement("invariants.mirrored");
  for (Case c : cases()) {
    c.scene = in_binary_fractions(c.scene);
    const Outcome base = outcome(c, c.scene);
    const Scene image = seen(c.scene, mirror);
    State start = base.system.initial_state();
    const int bodies = base.system.parts().bodies();
    for (int b = 0; b < bodies; ++b) {
      start[base.system.x_of(b)] *= -1;
      start[base.system.vx_of(b)] *= -1;
      if (base.system.has_friction() && b < base.system.parts().disc.count()) start[base.system.spin_of(b)] *= -1;
    }
    const Difference got = difference(base, outcome(c, image, start), mirror, 0);
    const char* reason = "a sign is no rounding, and the mirror image sums in the same order";
    expect("greatest difference of place [m], " + c.name, got.position, 0, exact(reason));
    expect("greatest difference of velocity [m/s], " + c.name, got.velocity, 0, exact(reason));
  }
}

TEST(Invariants, MovingObserversSeeTheSame) {
  requirement("invariants.moving");
  for (Case c : cases()) {
    c.scene.wall.clear();  // a wall and a fixed node stand still for one observer only
    for (Lattice& l : c.scene.lattice) l.fixed_rows.clear(), l.fixed_columns.clear();
    const Outcome base = outcome(c, c.scene);
    const Difference limit = rounding(c, base, drift.velocity.x * c.end());
    expect_same(c.name, difference(base, outcome(c, seen(c.scene, drift)), drift, c.end()), limit);
  }
}

}  // namespace
}  // namespace furrow::verification::invariants
