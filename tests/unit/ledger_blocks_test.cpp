// The energy ledger of beds of more discs than one block holds.
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/kernel.h"
#include "ledger_law.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;
using namespace test::ledger;

// 3,000 pairs of discs in a row of pairs: more discs than one block holds, and each pair with its own speed.
class ManyPairs : public testing::Test {
 protected:
  static constexpr int pairs = 3000;
  static Vec2 velocity(int pair) { return {0.02 + 1e-6 * pair, -0.01 - 2e-6 * pair}; }

  static Scene scene(double friction) {
    Scene s = empty_scene();
    s.contact.damping_factor = 0.1;
    s.contact.friction = friction;
    s.contact.rolling_friction = 0.05;
    s.model.rolling_smoothing = 0.5;
    for (int k = 0; k < pairs; ++k) {
      const double x = 0.25 * (k % 60), y = 0.5 * (k / 60);
      s.disc.push_back(disc({x, y}, radius, velocity(k), 0.2));
      s.disc.push_back(disc({x, y - 2 * radius + overlap}, radius));
    }
    return s;
  }
  static double sum(auto&& of_pair) {
    double all = 0;
    for (int k = 0; k < pairs; ++k) all += of_pair(velocity(k));
    return all;
  }
  const Law law{radius / 2, mass / 2};
  const double arm = radius - overlap / 2;
};

TEST_F(ManyPairs, ThePowersOfAllBlocksAreAddedUp) {
  System system(scene(1e3));
  State y = system.initial_state();
  system.jump(0, y);
  ASSERT_GT(kernel_of(system.solver()).search().blocks.size(), 1u);
  const State dydt = rates(system, 0, y);
  const double viscous = sum([&](Vec2 v) {
    const double slip = v.x + 0.2 * arm;
    return law.viscosity * v.y * v.y + law.shear_viscosity * slip * slip;
  });
  EXPECT_NEAR(dydt[system.ledger_of(contact_viscous)], viscous, round_off * viscous);
  const double rolling = sum([&](Vec2 v) {
    return 0.05 * (radius / 2) * (law.elastic - law.viscosity * v.y) * 0.2 * 0.2 / std::hypot(0.2, 0.5);
  });
  EXPECT_NEAR(dydt[system.ledger_of(rolling_work)], rolling, round_off * rolling);
}

TEST_F(ManyPairs, SlidingAndStiffeningOfAllBlocksAreAddedUp) {
  const double friction = 0.01, wound = 1e-7;
  System system(scene(friction));
  State y = system.initial_state();
  system.jump(0, y);
  const State slips = rates(system, 0, y);
  for (int k = 0; k < system.spring_count(); ++k) {
    const int at = system.first_spring() + k;
    y[at] = slips[at] > 0 ? wound : slips[at] < 0 ? -wound : 0;
  }
  const State dydt = rates(system, 0, y);
  const double sliding = sum([&](Vec2 v) {
    const double slip = v.x + 0.2 * arm;
    return (friction * (law.elastic - law.viscosity * v.y) - law.stiffness * wound) * slip;
  });
  EXPECT_NEAR(dydt[system.ledger_of(friction_work)], sliding, round_off * sliding);
  const double stiffer = sum([&](Vec2 v) { return 0.5 * wound * wound * law.stiffness / (2 * overlap) * -v.y; });
  EXPECT_NEAR(dydt[system.ledger_of(stiffening)], stiffer, round_off * stiffer);
}

TEST_F(ManyPairs, WhatAJumpReturnsInAllBlocksIsBookedAsFriction) {
  const double friction = 0.01, wound = 1e-4;
  System system(scene(friction));
  State y = system.initial_state();
  system.jump(0, y);
  const State slips = rates(system, 0, y);
  for (int k = 0; k < system.spring_count(); ++k) {
    if (slips[system.first_spring() + k] != 0) y[system.first_spring() + k] = k % 2 == 0 ? wound : -wound;
  }
  y[system.ledger_of(friction_work)] = 3;
  EXPECT_TRUE(system.jump(0, y).springs_changed);
  const double freed = sum([&](Vec2 v) {
    const double reach = friction * (law.elastic - law.viscosity * v.y) / law.stiffness;
    return 0.5 * law.stiffness * (wound * wound - reach * reach);
  });
  EXPECT_NEAR(y[system.ledger_of(friction_work)] - 3, freed, round_off * freed);
  const double booked = y[system.ledger_of(friction_work)];
  EXPECT_FALSE(system.jump(0, y).springs_changed);
  EXPECT_EQ(y[system.ledger_of(friction_work)], booked);
}

}  // namespace
}  // namespace furrow
