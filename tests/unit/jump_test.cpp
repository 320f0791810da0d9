// Between steps: life of a tangential spring, return to the Coulomb limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "kernel/kernel.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// One disc of radius 0.1 m above a floor, mu = 0.5; a contact is near below a gap of a tenth of the radius, 0.01 m.
Scene disc_on_floor() {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({0, 0.15}, 0.1)};
  scene.wall = {wall({0, 0}, {0, 1})};
  return scene;
}

struct DiscOnFloor {
  System system{disc_on_floor()};
  State y = system.initial_state();
  double t = 0;

  JumpReport jump_at_gap(double gap) {
    y[system.y_of(0)] = 0.1 + gap;
    t += 1e-3;
    return system.jump(t, y);
  }
  int slot() const {
    const Candidates& list = kernel_of(system.solver()).search().candidates[disc_wall];
    return list.count() == 0 ? -1 : list.slot[0];
  }
  double& spring() { return y[system.first_spring() + slot()]; }
};

// mu Fn/St = mu (2/3 2 E* root d)/(8 G* root) = mu d E*/(6 G*);  E*/G* = (1e6/1.875)/(4e5/3.5) = 14/3.
constexpr double limit_for_overlap = 0.5 * 14 / 18;

TEST(TangentialSpring, IsBornBeforeTheTouch) {
  DiscOnFloor d;
  d.jump_at_gap(0.0101);
  EXPECT_EQ(d.slot(), -1);
  d.jump_at_gap(0.0099);
  ASSERT_GE(d.slot(), 0);
  EXPECT_EQ(d.spring(), 0);
}

// The first step of a run takes them over instead of an evaluation, so they must be those of one: of contacts that
// stick, of one that slid back to the limit, and of one that opened.
TEST(Jump, LeavesTheRatesOfItsState) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  d.y[d.system.vx_of(0)] = 0.3;
  for (const auto& [spring, gap] : {std::pair{1e-3, -0.01}, {0.5, -0.01}, {1e-3, 0.001}}) {
    d.spring() = spring;
    const JumpReport left = d.jump_at_gap(gap);
    ASSERT_NE(left.rates, nullptr);
    const State want = rates(d.system, d.t, d.y);
    ASSERT_GT(want.size(), 0u);
    EXPECT_EQ(*left.rates, want) << "spring " << spring << ", gap " << gap;
  }
}

TEST(TangentialSpring, WindsOnlyWhileTouching) {
  DiscOnFloor d;
  d.jump_at_gap(0.005);
  d.y[d.system.vx_of(0)] = 0.3;
  EXPECT_EQ(rates(d.system, d.t, d.y)[d.system.first_spring()], 0);
  d.y[d.system.y_of(0)] = 0.098;
  EXPECT_NEAR(rates(d.system, d.t, d.y)[d.system.first_spring()], 0.3, 1e-15);
}

TEST(TangentialSpring, PushesBack) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  d.spring() = 1e-3;  // below the limit
  const double stiffness = 8 * (4e5 / 3.5) * std::sqrt(0.1 * 0.01);
  const Vec2 force = force_on(d.system, rates(d.system, d.t, d.y), 0);
  EXPECT_NEAR(force.x, -stiffness * 1e-3, 1e-12 * stiffness);
}

TEST(TangentialSpring, ReturnsToTheCoulombLimitBothWays) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  for (const double sign : {1.0, -1.0}) {
    d.spring() = sign * 0.5;
    const JumpReport report = d.jump_at_gap(-0.01);
    EXPECT_NEAR(d.spring(), sign * limit_for_overlap * 0.01, 1e-15);
    EXPECT_TRUE(report.springs_changed);
    EXPECT_FALSE(report.flow_jumped());
  }
}

TEST(TangentialSpring, StaysAsItIsBelowTheLimit) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  d.spring() = 0.99 * limit_for_overlap * 0.01;
  const double before = d.spring();
  EXPECT_FALSE(d.jump_at_gap(-0.01).springs_changed);
  EXPECT_EQ(d.spring(), before);
}

TEST(TangentialSpring, ReturnedEnergyIsBookedAsFriction) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  d.spring() = 0.5;
  const double stiffness = 8 * (4e5 / 3.5) * std::sqrt(0.1 * 0.01);
  const double limit = limit_for_overlap * 0.01;
  d.jump_at_gap(-0.01);
  const double want = 0.5 * stiffness * (0.25 - limit * limit);
  EXPECT_NEAR(d.y[d.system.ledger_of(friction_work)], want, 1e-12 * want);
}

TEST(TangentialSpring, RelaxesWhenTheContactOpens) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  d.spring() = 1e-3;
  EXPECT_TRUE(d.jump_at_gap(0.001).springs_changed);
  EXPECT_EQ(d.spring(), 0);
  EXPECT_FALSE(d.jump_at_gap(0.001).springs_changed);
}

TEST(TangentialSpring, KeepsItsSlotThroughEightQuietSteps) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  const int slot = d.slot();
  for (int k = 0; k < 8; ++k) {
    d.jump_at_gap(0.02);
    EXPECT_EQ(d.slot(), slot) << "quiet step " << k + 1;
  }
  d.jump_at_gap(0.02);
  EXPECT_EQ(d.slot(), -1);
}

TEST(TangentialSpring, ANearStepBeginsTheCountAnew) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  for (int k = 0; k < 8; ++k) d.jump_at_gap(0.02);
  d.jump_at_gap(0.005);
  for (int k = 0; k < 8; ++k) d.jump_at_gap(0.02);
  EXPECT_GE(d.slot(), 0);
}

TEST(TangentialSpring, KeepsItsSlotHoweverFarTheContactFlies) {
  DiscOnFloor d;
  d.jump_at_gap(-0.01);
  const int slot = d.slot();
  for (int k = 0; k < 8; ++k) d.jump_at_gap(100.0 * (k + 1));  // the list has been renewed
  EXPECT_EQ(d.slot(), slot);
  d.jump_at_gap(900);
  d.jump_at_gap(1900);
  EXPECT_EQ(d.slot(), -1);
}

TEST(TangentialSpring, NoTwoContactsShareASlotAndAnUnusedOneIsZero) {
  System system(busy_scene());
  State y = system.initial_state();
  const auto method = make_method("pece");
  RunPlan plan;
  plan.end = 0.04;
  std::size_t most = 0;
  long reused = 0;
  std::set<int> ever;
  std::vector<std::set<int>> history;
  const RunEnd end = run(system, *method, y, plan, [&](double, const State& now, const JumpReport&) {
    std::set<int> used;
    std::size_t holders = 0;
    for (const Candidates& list : kernel_of(system.solver()).search().candidates) {
      for (const int slot : list.slot) {
        if (slot < 0) continue;
        ++holders;
        used.insert(slot);
      }
    }
    EXPECT_EQ(used.size(), holders);
    for (int k = 0; k < system.spring_count(); ++k) {
      EXPECT_TRUE(used.count(k) != 0 || now[system.first_spring() + k] == 0);
    }
    if (!history.empty()) {
      for (const int slot : used) reused += ever.count(slot) != 0 && history.back().count(slot) == 0 ? 1 : 0;
    }
    ever.insert(used.begin(), used.end());
    history.push_back(used);
    most = std::max(most, used.size());
    return true;
  });
  EXPECT_EQ(end.ending, Ending::finished) << end.reason;
  EXPECT_GT(most, 20u);
  EXPECT_GT(reused, 5);
}

TEST(TangentialSpring, MoreContactsThanAPlaneHoldsHaveOneEach) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  for (int k = 0; k < 40; ++k) scene.disc.push_back(disc({1e-3 * k, 0}, 0.1));  // 780 pairs touch
  System system(scene);
  State y = system.initial_state();
  ASSERT_LT(system.spring_count(), 780);
  const JumpReport report = system.jump(0, y);
  EXPECT_EQ(y.size(), system.size());
  EXPECT_GT(report.grown.count, 0u);
  EXPECT_EQ(report.rates->size(), system.size());
  const std::vector<int>& slot = kernel_of(system.solver()).search().candidates[disc_disc].slot;
  EXPECT_EQ(std::set<int>(slot.begin(), slot.end()).size(), 780u);
  EXPECT_GE(*std::min_element(slot.begin(), slot.end()), 0);
}

}  // namespace
}  // namespace furrow
