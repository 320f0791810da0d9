// Keys that a scene has no use for, and what passes through the gaps of a lattice's border: both are said.
#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

// Of the sound scene, whose plate stands far off, after a change.
Lines warnings(const std::function<void(Scene&)>& change) {
  Scene scene = sound_scene();
  scene.disc[0].position = {0, 3};
  change(scene);
  return scene_warnings(scene);
}

TEST(SceneIdle, NothingIsSaidOfDefaults) {
  EXPECT_EQ(warnings([](Scene&) {}), Lines{});
  EXPECT_EQ(warnings([](Scene& s) { s.disc = {}; }), Lines{});
  EXPECT_EQ(warnings([](Scene& s) { s = parse_scene(canonical_text(s), "written"); }), Lines{});
}

TEST(SceneIdle, LatticesHaveNoUseForWhatNothingAsksFor) {
  EXPECT_EQ(warnings([](Scene& s) { s.time.locate = Locate::tears; }),
            Lines{"time.locate: has no effect: no lattice can tear"});
  EXPECT_EQ(warnings([](Scene& s) { s.disc = {}, s.lattice[0].auxiliary_points = 4; }),
            Lines{"lattice[0].auxiliary_points: has no effect: there are no discs"});
  EXPECT_EQ(warnings([](Scene& s) { s.plate = {}, s.wall = {}, s.lattice[0].contact_radius = 0.02; }),
            (Lines{"material[1]: no part is of it",
                   "lattice[0].contact_radius: has no effect: there is neither a plate nor a wall"}));
  EXPECT_EQ(warnings([](Scene& s) { s.lattice[0].tear = TearRule::magnitude; }),
            Lines{"lattice[0].tear: has no effect: no link has a strength"});
  EXPECT_EQ(warnings([](Scene& s) { s.lattice[0].damper = Damper::full; }),
            Lines{"lattice[0].damper: has no effect: no link is damped"});
  EXPECT_EQ(warnings([](Scene& s) {
              s.time.locate = Locate::tears, s.lattice[0].tear = TearRule::magnitude,
              s.lattice[0].damper = Damper::full;
              s.lattice[0].structural = s.lattice[0].shear = {.stiffness = 1, .damping = 1, .strength = 1};
            }),
            Lines{});
}

TEST(SceneIdle, ALinkThatALaterOneSaysAgainIsSaid) {
  const auto with = [](std::vector<LinkSetting> links) {
    return warnings([&](Scene& s) {
      s.lattice[0].structural = s.lattice[0].shear = {.stiffness = 1};
      s.lattice[0].link = std::move(links);
    });
  };
  EXPECT_EQ(with({{.rows = {1}, .stiffness = 2}, {.rows = {1}, .stiffness = 3}}),
            Lines{"lattice[0].link[0]: has no effect: without it all links would be the same; of two that choose one "
                  "link the later holds"});
  EXPECT_EQ(with({{.rows = {1}, .stiffness = 2}, {.rows = {1}, .stiffness_factor = 3}}), Lines{});
}

TEST(SceneIdle, NodesThatNoLinkHoldsAreSaid) {
  const Lines said{"lattice[0]: no link of it has a stiffness: its nodes do not hold each other"};
  EXPECT_EQ(warnings([](Scene& s) { s.lattice[0].structural = s.lattice[0].shear = {}; }), said);
  EXPECT_EQ(warnings([](Scene& s) { s.lattice[0].structural = s.lattice[0].shear = {.damping = 1}; }), said);
  EXPECT_EQ(warnings([](Scene& s) { s.lattice[0].columns = 1, s.lattice[0].structural = s.lattice[0].shear = {}; }),
            said);
}

TEST(SceneIdle, FrictionThatNothingCarriesIsSaid) {
  const auto with = [](double stiffness, std::optional<double> damping) {
    return warnings([&](Scene& s) {
      s.model.law = ForceLaw::linear;
      s.contact.friction = 0.5;
      s.contact.normal_stiffness = 1e4;
      s.contact.tangential_stiffness = stiffness;
      s.contact.tangential_damping = damping;
    });
  };
  EXPECT_EQ(with(0, {}),
            Lines{"contact.friction: has no effect: tangential_stiffness is 0, and the tangent is not damped"});
  EXPECT_EQ(with(1e4, {}), Lines{});
  EXPECT_EQ(with(0, 2), Lines{});
}

TEST(SceneIdle, ARampLongerThanTheRunIsSaid) {
  EXPECT_EQ(warnings([](Scene& s) {
              s.plate[0].velocity = {0.1, 0}, s.plate[0].ramp = 1.5 * s.time.end;
            }),
            Lines{"plate[0].ramp: is longer than the run: the velocity is never reached"});
  EXPECT_EQ(warnings([](Scene& s) { s.plate[0].velocity = {0.1, 0}, s.plate[0].ramp = s.time.end; }), Lines{});
  EXPECT_EQ(warnings([](Scene& s) {
              s.lattice[0].drive = {{.rows = {2}, .velocity = {0.1, 0}, .ramp = 9e9}};
            }),
            Lines{"lattice[0].drive[0].ramp: is longer than the run: the velocity is never reached"});
}

// sqrt(2 g R) with R = 0.1 m.
TEST(SceneIdle, ASpeedOfSettlingThatFallingDiscsKeepToIsSaid) {
  const auto with = [](double speed) { return warnings([&](Scene& s) { s.settle = Settle{.speed = speed}; }); };
  EXPECT_EQ(with(1.4), Lines{});
  EXPECT_EQ(with(1.41), Lines{"settle.speed: a disc that falls by its radius is no faster than 1.4 m/s: what counts as "
                              "settled may still fall"});
}

TEST(SceneIdle, WhatCannotHappenNeedsNotBeAllowed) {
  EXPECT_EQ(warnings([](Scene& s) {
              s.output.energy = false, s.disc = {}, s.plate = {};
              s.allow = Allow{.energy_made = 0.1,
                              .energy_lost = 0.1,
                              .behind_walls = true,
                              .through_plates = true,
                              .through_lattices = true};
            }),
            (Lines{"allow.energy_made: has no effect: output.energy is false",
                   "allow.energy_lost: has no effect: output.energy is false",
                   "allow.behind_walls: has no effect: there are no discs",
                   "allow.through_plates: has no effect: there is no plate",
                   "allow.through_lattices: has no effect: there are no discs"}));
  EXPECT_EQ(warnings([](Scene& s) { s.output.angles = true; }),
            Lines{"output.angles: has no effect: there are no frames (output.frames)"});
}

// Points of 10 mm / 2 are 5 mm apart: a disc of 2.4 mm can lie between, one of 2.6 mm cannot.
TEST(SceneGaps, DiscsThatPassBetweenThePointsOfABorderAreSaidWithTheNumberThatHoldsThem) {
  const auto with = [](double radius, int points) {
    return warnings([&](Scene& s) { s.disc[0].radius = radius, s.lattice[0].auxiliary_points = points; });
  };
  EXPECT_EQ(with(0.0026, 1), Lines{});
  EXPECT_EQ(with(0.0024, 1),
            Lines{"lattice[0].auxiliary_points: discs of radius 0.0024 m pass between the points of its border, which "
                  "are 0.005 m apart: take at least 2 points, or 0, the whole border"});
  EXPECT_EQ(with(0.0024, 2), Lines{});
  EXPECT_EQ(with(0.0024, 0), Lines{});
}

// The upper row is pushed up by 20 mm, so that the sides are 30 mm long and their points 15 mm apart.
TEST(SceneGaps, OfAStretchedLatticeTheLongestSegmentCounts) {
  const Lines said = warnings([](Scene& s) {
    s.disc[0].radius = 0.004, s.lattice[0].auxiliary_points = 1;
    for (int column = 0; column < s.lattice[0].columns; ++column) {
      NodeSetting up;
      up.row = s.lattice[0].rows - 1;
      up.column = column;
      up.displacement = {0, 0.02};
      s.lattice[0].node.push_back(up);
    }
  });
  EXPECT_EQ(said,
            Lines{"lattice[0].auxiliary_points: discs of radius 0.004 m pass between the points of its border, which "
                  "are up to 0.015 m apart: take at least 3 points, or 0, the whole border"});
}

TEST(SceneGaps, OneNodeHasNoBorder) {
  EXPECT_EQ(warnings([](Scene& s) {
              s.disc[0].radius = 1e-3, s.lattice[0].rows = s.lattice[0].columns = 1, s.lattice[0].fixed_rows = {};
              s.lattice[0].auxiliary_points = 2, s.lattice[0].structural = s.lattice[0].shear = {};
            }),
            Lines{});
}

// Rows at 0, 10 and 20 mm; a plate 5 mm high on its way to them between two rows.
TEST(SceneGaps, APlateThatPassesBetweenTwoRowsIsSaidAndNoOther) {
  const auto with = [](Vec2 corner, Vec2 velocity, double height = 0.005) {
    return warnings([&](Scene& s) {
      s.time.end = 1;
      s.lattice[0].fixed_rows = {};
      s.lattice[0].origin = {1, 1};
      s.plate[0].left_edge = corner.x, s.plate[0].lower_edge = corner.y;
      s.plate[0].width = 0.02, s.plate[0].height = height, s.plate[0].velocity = velocity;
    });
  };
  EXPECT_EQ(with({0.9, 1.002}, {0.2, 0}),
            Lines{"plate[0]: its height, 0.005 m, is less than the spacing of lattice[0], 0.01 m, and no node stands "
                  "over against it: plates meet nodes alone, so it can pass between two of them"});
  EXPECT_EQ(with({0.9, 0.998}, {0.2, 0}), Lines{}) << "it meets the lowest row";
  EXPECT_EQ(with({0.9, 1.2}, {0.2, 0}), Lines{}) << "it passes above";
  EXPECT_EQ(with({0.9, 1.002}, {-0.2, 0}), Lines{}) << "it moves away";
  EXPECT_EQ(with({0.9, 1.002}, {0.02, 0}), Lines{}) << "it does not come so far";
  EXPECT_EQ(with({0.9, 1.002}, {0, 0}), Lines{}) << "it stands";
  EXPECT_EQ(with({0.9, 1.002}, {0.2, 0}, 0.01), Lines{}) << "it is as high as they are apart";
}

TEST(SceneStart, PlatesThatAreOneSurfaceAreNotSaidToBeFeltTwice) {
  const auto with = [](bool tight, Vec2 velocity) {
    return warnings([&](Scene& s) {
      s.lattice = {};
      s.model.tight_plates = tight;
      s.plate[0] = {.left_edge = 0.5, .lower_edge = 0, .width = 0.1, .height = 0.1, .material = "hard"};
      s.plate.push_back(s.plate[0]);
      s.plate[1].name = "other", s.plate[1].left_edge = 0.6, s.plate[1].velocity = velocity;
    });
  };
  EXPECT_EQ(with(true, {}), Lines{});
  EXPECT_EQ(with(false, {}).size(), 3U) << "each on the wall, and one on the other";
  EXPECT_EQ(with(true, {0.1, 0}).size(), 1U) << "they part";
}

TEST(SceneNumbers, AValueOutOfItsRangeIsSaidAndNotWhatWouldFollow) {
  const auto problems = [](const std::function<void(Scene&)>& change) {
    Scene scene = sound_scene();
    change(scene);
    Lines lines;
    for (const auto& [path, message] : problems_of(scene)) lines.push_back(path);
    return lines;
  };
  EXPECT_EQ(problems([](Scene& s) { s.plate[0].width = -1; }), Lines{"plate[0].width"});
  EXPECT_EQ(problems([](Scene& s) { s.disc[0].radius = -1; }), Lines{"disc[0].radius"});
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].spacing = -1; }), Lines{"lattice[0].spacing"});
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].node_mass = 0; }), Lines{"lattice[0].node_mass"});
  EXPECT_EQ(problems([](Scene& s) { s.model.disc_depth = -1; }), Lines{"model.disc_depth"});
  EXPECT_EQ(problems([](Scene& s) { s.material[0].density = -1; }), Lines{"material[0].density"});
}

}  // namespace
}  // namespace furrow
