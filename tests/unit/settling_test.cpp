// How a bed settles: when it counts as settled, what settles twice, and where its surface is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "output/warnings.h"
#include "run/observe.h"
#include "run/prepare.h"
#include "scene/read.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// Twelve discs that fall into a box, well damped.
Scene bed() {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.damping_factor = 0.5;
  scene.wall = {wall({0, 0}, {0, 1}), wall({-0.05, 0}, {1, 0}), wall({0.05, 0}, {-1, 0})};
  for (int k = 0; k < 12; ++k) scene.disc.push_back(disc({-0.03 + 0.02 * (k % 4), 0.012 + 0.024 * (k / 4)}, 0.0095));
  scene.settle = Settle{.speed = 5e-3, .hold = 0.1, .limit = 5};
  return scene;
}

struct Look {
  double t, speed;
};

std::vector<Look> looks_of(const Scene& scene, Prepared* prepared = nullptr) {
  std::vector<Look> looks;
  Prepared p = prepare(scene, [&](double t, double speed) {
    looks.push_back({t, speed});
    return true;
  });
  if (prepared) *prepared = std::move(p);
  return looks;
}

TEST(Settling, EndsWhenNothingWasFastForAsLongAsItMustHold) {
  for (const double hold : {0.1, 0.25, 0.4}) {
    Scene scene = bed();
    scene.settle->hold = hold;
    Prepared p = prepare(scene);
    const std::vector<Look> looks = looks_of(scene, &p);
    double fast_at = 0;
    for (const Look& look : looks) {
      if (look.speed > 5e-3) fast_at = look.t;
      if (&look != &looks.back()) {
        EXPECT_LT(look.t - fast_at, hold) << "settled before";
      }
    }
    EXPECT_GE(looks.back().t - fast_at, hold);
    EXPECT_EQ(p.settling_time, looks.back().t);
    EXPECT_GT(fast_at, 0);
  }
}

// Every hundred calls, of which the first is that of the start.
TEST(Settling, LooksEveryHundredSteps) {
  const std::vector<Look> looks = looks_of(bed());
  for (std::size_t k = 0; k < looks.size(); ++k)
    EXPECT_NEAR(looks[k].t, (100 * static_cast<double>(k + 1) - 1) * 1e-4, 1e-12);
}

// Discs that start at rest are slow for a moment: a tenth of a second passes before a bed may count as settled.
TEST(Settling, DoesNotTakeTheStartForTheEnd) {
  Scene scene = bed();
  scene.settle->hold = 0;
  scene.settle->speed = 100;
  const std::vector<Look> looks = looks_of(scene);
  EXPECT_GE(looks.back().t, 0.1);
  EXPECT_LT(looks.back().t, 0.1 + 2e-2);
}

TEST(Settling, LeavesOutTheShareThatMayBeLoose) {
  Scene scene = bed();
  scene.disc.push_back(disc({0, 3}, 0.0095, {0, 30}));
  scene.settle->loose = 0.1;  // one of thirteen
  for (const Look& look : looks_of(scene)) EXPECT_LT(look.speed, 2);
  scene.settle->loose.reset();
  scene.settle->limit = 0.3;
  std::vector<double> speeds;
  EXPECT_THROW(prepare(scene,
                       [&](double, double speed) {
                         speeds.push_back(speed);
                         return true;
                       }),
               Divergence);
  EXPECT_GT(speeds.front(), 20);
}

TEST(Settling, UntilItsLimitAndNotLonger) {
  Scene scene = bed();
  const Prepared p = prepare(scene);
  scene.settle->limit = p.settling_time - 1e-3;
  EXPECT_THROW(prepare(scene), Divergence);
  scene.settle->limit = p.settling_time + 1e-3;
  EXPECT_EQ(prepare(scene).settling_time, p.settling_time);
}

TEST(Settling, TakesItsOwnStepAndThePapersMethod) {
  Scene scene = bed();
  const Prepared usual = prepare(scene);
  scene.time.step = 3e-5;
  scene.time.method = "rk4";
  scene.settle->step = 1e-4;
  const Prepared own = prepare(scene);
  EXPECT_EQ(own.y, usual.y);
  EXPECT_EQ(own.settling_steps, usual.settling_steps);
}

// A plate at a working depth: the bed settles without it, then with it; one with a lower edge stands in both.
TEST(Settling, IsTwiceForAPlateAtAWorkingDepth) {
  Scene scene = bed();
  Plate deep = plate({0.02, 0}, 0.004, 0.1, {0.3, 0});
  deep.name = "deep";
  deep.lower_edge.reset();
  deep.working_depth = 0.012;
  Plate standing = plate({-0.0005, 0.045}, 0.001, 0.1, {0.1, 0});
  standing.name = "standing";
  scene.plate = {deep, standing};
  Prepared p = prepare(bed());
  std::vector<Look> looks = looks_of(scene, &p);
  // The time starts from zero a second time.
  std::size_t second = 0;
  for (std::size_t k = 1; k < looks.size(); ++k) {
    if (looks[k].t < looks[k - 1].t) second = k;
  }
  ASSERT_GT(second, 0u);
  EXPECT_EQ(p.settling_steps, std::lround(looks[second - 1].t / 1e-4) + std::lround(looks.back().t / 1e-4));
  EXPECT_EQ(p.settling_time, looks.back().t);
  Scene without = scene;
  without.plate = {standing};
  const Prepared first = prepare(without);
  EXPECT_EQ(*p.surface, surface_height(first.system, first.y));
  EXPECT_EQ(*p.scene.plate[0].lower_edge, *p.surface - 0.012);
  EXPECT_EQ(*p.scene.plate[1].lower_edge, 0.045);
  EXPECT_FALSE(p.scene.plate[0].working_depth.has_value());
  EXPECT_EQ(p.system.plate_at(0, 0).lower, *p.surface - 0.012);
  EXPECT_EQ(p.system.plate_at(0, 0).vx, 0.3);  // it goes again
  EXPECT_GT(observe(p.system, 0, p.y).contacts, 10);
  // The second bed is one that fell round the plate.
  Scene placed = p.scene;
  placed.settle = scene.settle;
  EXPECT_EQ(prepare(placed).y, p.y);
}

TEST(Settling, WithoutAPlateAtADepthIsOnceAndHasASurface) {
  Prepared p = prepare(bed());
  const std::vector<Look> looks = looks_of(bed(), &p);
  for (std::size_t k = 1; k < looks.size(); ++k) EXPECT_GT(looks[k].t, looks[k - 1].t);
  EXPECT_EQ(p.settling_steps, std::lround(p.settling_time / 1e-4));
  EXPECT_EQ(*p.surface, surface_height(p.system, p.y));
}

TEST(Settling, LosesNoNumberOfAStateWithoutALedger) {
  Scene scene = bed();
  const Prepared with = prepare(scene);
  scene.output.energy = false;
  const Prepared without = prepare(scene);
  ASSERT_EQ(without.y.size() + ledger_entries, with.y.size());
  EXPECT_TRUE(std::equal(without.y.begin(), without.y.end(), with.y.begin()));
}

TEST(Settling, SaysWhyABedDidNotSettle) {
  Scene scene = bed();
  scene.settle->limit = 0.0205;  // they still fall, at some 0.2 m/s
  try {
    prepare(scene);
    FAIL();
  } catch (const Divergence& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("not settled after 0.0205 s: the fastest body moves at 0."), std::string::npos) << text;
    EXPECT_NE(text.find("settle.speed is 0.005 m/s"), std::string::npos) << text;
    EXPECT_EQ(text.find("stability limit"), std::string::npos) << text;  // its step is short enough
  }
  scene.settle->loose = 0.5;
  try {
    prepare(scene);
    FAIL();
  } catch (const Divergence& error) {
    EXPECT_NE(std::string(error.what()).find("the fastest body that is not loose moves"), std::string::npos)
        << error.what();
  }
}

TEST(Unsettled, HasAllPartsWhereTheyAreWritten) {
  Scene scene = bed();
  Packing p{.count = 3,
            .radius_min = 0.005,
            .radius_max = 0.005,
            .lower_left = {-0.05, 0.2},
            .upper_right = {0.05, 0.3},
            .material = "soft",
            .seed = 3};
  scene.packing = {p};
  Plate deep = plate({0.02, 0}, 0.004, 0.1, {0.3, 0});
  deep.lower_edge.reset();
  deep.working_depth = 0.012;
  scene.plate = {deep, plate({5, 0.7}, 0.004, 0.1)};
  const System system = unsettled(scene);
  EXPECT_EQ(system.parts().disc.count(), 15);
  EXPECT_EQ(system.parts().plate[0].lower, 0);
  EXPECT_EQ(system.parts().plate[1].lower, 0.7);
  EXPECT_EQ(system.initial_state()[system.y_of(5)], scene.disc[5].position.y);
}

// Discs of 0.2 and 0.4 m and one of 0.6 m: mean width 0.4 m, over a span of 1.3 m three strips. Tops: 0.1 + 0.1 in the
// first, 0.9 + 0.2 in the second, where the one below does not count, 0.3 + 0.3 in the last, which holds its centre.
TEST(SurfaceHeight, IsOfStripsAsWideAsTheMeanDisc) {
  Scene scene = empty_scene();
  scene.disc = {disc({0.1, 0.1}, 0.1), disc({0.6, 0.9}, 0.2), disc({1.0, 0.3}, 0.3)};
  const System system(scene);
  EXPECT_NEAR(surface_height(system, system.initial_state()), (0.2 + 1.1 + 0.6) / 3, 1e-12);
  scene.disc.push_back(disc({0.6, 0.1}, 0.2));  // still a mean of 0.4 m
  const System more(scene);
  EXPECT_NEAR(surface_height(more, more.initial_state()), (0.2 + 1.1 + 0.6) / 3, 1e-12);
  scene.disc[2].position.x = 10.6;  // 27 strips over 10.9 m, of which three have a top
  const System wide(scene);
  EXPECT_NEAR(surface_height(wide, wide.initial_state()), (0.2 + 1.1 + 0.6) / 3, 1e-12);
}

// 4.914 m/s up: at rest for an instant, after 0.501 s, 1.7 m above the floor.
TEST(Settling, AThrownDiscIsNotSettledAtTheTopOfItsWay) {
  for (const double step : {5.06e-3, 5.009e-3, 1e-3}) {
    Scene scene = empty_scene();
    scene.model.gravity = 9.81;
    scene.contact.damping_factor = 0.5;
    scene.wall = {wall({0, 0}, {0, 1})};
    scene.disc = {disc({0, 0.5}, 0.05, {0, 4.914})};
    scene.time.step = step;
    scene.settle = Settle{};
    scene.settle->limit = 1;  // it is back on the floor after 1.1 s
    EXPECT_THROW(prepare(scene), Divergence) << step;
  }
}

// What is said of a plate whose place the scene gives is said of one that gets the same place from the bed.
TEST(Settling, APlateAtAWorkingDepthIsWarnedOfAsOneThatStandsThere) {
  Scene scene = bed();
  scene.time.end = 1;
  Lattice held = lattice({0.1, 0}, 12, 2, 0.01);
  held.fixed_columns = {0, 1};
  scene.lattice = {held};
  Plate deep = plate({0.02, 0}, 0.004, 0.1, {0.3, 0});
  deep.lower_edge.reset();
  deep.working_depth = 0.03;
  scene.plate = {deep};
  const Prepared p = prepare(scene);
  Scene stands = scene;
  stands.plate[0].working_depth.reset();
  stands.plate[0].lower_edge = p.scene.plate[0].lower_edge;
  std::vector<std::string> expected = scene_warnings(stands);
  const std::vector<std::string> before = scene_warnings(scene);
  std::erase_if(expected, [&](const std::string& warning) {
    return !warning.starts_with("plate[") || std::find(before.begin(), before.end(), warning) != before.end();
  });
  ASSERT_FALSE(expected.empty()) << "it goes through held nodes";
  EXPECT_EQ(warnings_of_lowered_plates(scene, p.scene), expected);
  EXPECT_TRUE(warnings_of_lowered_plates(stands, stands).empty()) << "said before";
}

}  // namespace
}  // namespace furrow
