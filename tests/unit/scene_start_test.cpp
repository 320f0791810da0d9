// Where the parts of a scene stand at its start: what cannot be is refused, what may be meant is warned of.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

// A bed of its own far from the other parts of the sound scene.
Scene with(const std::function<void(Scene&)>& change) {
  Scene s = sound_scene();
  s.disc = {Disc{.position = {-2, 1}, .radius = 0.1, .material = "soft"}};
  s.plate = {};
  change(s);
  return s;
}

Lines problems(const std::function<void(Scene&)>& change) {
  Lines lines;
  for (const auto& [path, message] : problems_of(with(change))) lines.push_back(path + ": " + message);
  return lines;
}

Lines warnings(const std::function<void(Scene&)>& change) { return scene_warnings(with(change)); }

Disc disc(double x, double y, double radius = 0.1) {
  return Disc{.position = {x, y}, .radius = radius, .material = "soft"};
}

Plate plate(double left, double lower, double width = 0.5, double height = 0.5) {
  return Plate{.left_edge = left, .lower_edge = lower, .width = width, .height = height, .material = "hard"};
}

TEST(SceneStart, FindsNothingAmongPartsThatStandApartOrTouch) {
  const auto separate = [](Scene& s) { s.disc.push_back(disc(-1.8, 1)), s.disc.push_back(disc(-2, 0.1)); };
  EXPECT_EQ(problems(separate), Lines{});
  EXPECT_EQ(warnings(separate), Lines{});
}

TEST(SceneStart, RefusesDiscsDeeperInEachOtherThanTheSmallerRadius) {
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(disc(-2, 1.001)); }).size(), 1u);
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(disc(-2, 1.099)); }).size(), 1u);
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(disc(-2, 1.05, 1e-3)); }).size(), 1u);
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(disc(-2, 1.101)); }), Lines{});
  EXPECT_EQ(warnings([](Scene& s) { s.disc.push_back(disc(-2, 1.15)); }),
            Lines{"1 contact overlaps at the start, the deepest by 0.5 of a radius, between disc[0] and disc[1]: the "
                  "energy of the overlap is let loose"});
}

TEST(SceneStart, RefusesDiscsInsideOtherParts) {
  EXPECT_EQ(problems([](Scene& s) { s.plate = {plate(-2.1, 0.8)}; }),
            Lines{"disc[0].position: the centre is inside plate[0]"});
  const auto on_lattice = [](double x, double y) {
    return problems([&](Scene& s) { s.disc[0].position = {x, y}, s.disc[0].radius = 1e-3; });
  };
  EXPECT_EQ(on_lattice(0.005, 0.015), Lines{"disc[0].position: the centre is inside lattice[0]"});
  EXPECT_EQ(on_lattice(0.01, 0.01), Lines{"disc[0].position: the centre is on the border of lattice[0]"});
  EXPECT_EQ(on_lattice(0.01, 0.0123), Lines{"disc[0].position: the centre is on the border of lattice[0]"});
  EXPECT_EQ(on_lattice(0.0111, 0.01), Lines{});
}

TEST(SceneStart, RefusesNodesInOnePlaceAndLinksOfNoLength) {
  const auto moved = [](double x, double y) {
    return problems([&](Scene& s) { s.lattice[0].node = {{.row = 1, .displacement = {x, y}}}; });
  };
  EXPECT_EQ(moved(0.01, 0).size(), 1u);   // onto its neighbour
  EXPECT_EQ(moved(0, -0.01).size(), 1u);  // onto a fixed one
  EXPECT_EQ(moved(0.01, 1e-14).size(), 1u);
  EXPECT_EQ(moved(0.005, 0), Lines{});
}

TEST(SceneStart, RefusesALatticeBehindAWallOrInAPlate) {
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].origin.y = -1; }).size(), 4u);
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].fixed_rows = {0, 1, 2}, s.lattice[0].origin.y = -1; }), Lines{});
  EXPECT_FALSE(problems([](Scene& s) { s.plate = {plate(-0.1, -0.1)}; }).empty());
  EXPECT_FALSE(problems([](Scene& s) { s.plate = {plate(0.008, 0.004, 0.01, 0.1)}; }).empty());
  EXPECT_EQ(problems([](Scene& s) { s.plate = {plate(0.01, 0, 0.01, 0.1)}; }), Lines{});
  EXPECT_EQ(warnings([](Scene& s) { s.plate = {plate(0.003, 0.004, 0.002, 0.1)}; }),
            Lines{"plate[0]: stands in lattice[0], whose nodes alone feel it"});
}

TEST(SceneStart, RefusesWhatIsGivenTwice) {
  EXPECT_EQ(problems([](Scene& s) {
              s.wall.push_back({.point = {7, 0}, .normal = {0, 3}, .material = "soft"});
            }),
            Lines{"wall[1]: the same as wall[0]: its stiffness would count twice"});
  EXPECT_EQ(problems([](Scene& s) {
              s.plate = {plate(3, 0.1), plate(3, 0.1)};
            }),
            Lines{"plate[1]: in the place of plate[0]: what touches one touches both"});
}

TEST(SceneStart, OneMistakeOfManyPartsIsToldTwoHundredTimesAndCounted) {
  const Lines all = problems([](Scene& s) {
    s.wall.assign(3001, s.wall[0]);
    for (std::size_t k = 0; k < s.wall.size(); ++k) s.wall[k].name = std::to_string(k);
  });
  ASSERT_EQ(all.size(), 201u);
  EXPECT_EQ(all[199], "wall[200]: the same as wall[0]: its stiffness would count twice");
  EXPECT_EQ(all.back(), ": 2800 errors more than the 200 that are listed; mend these first");
  const Lines plates = problems([](Scene& s) { s.plate.assign(50, plate(3, 0.1)); });
  EXPECT_NE(plates.back().find(" errors more than"), std::string::npos) << plates.back();
  EXPECT_GE(std::stol(plates.back().substr(2)), 50 * 49 / 2 - 200);
}

TEST(SceneStart, WarnsOfEachWallBehindAnotherOnce) {
  const Lines told = warnings([](Scene& s) {
    for (const double y : {-1.0, 0.0, -0.5}) s.wall.push_back({.point = {0, y}, .normal = {0, 1}, .material = "soft"});
    s.wall.erase(s.wall.begin());
  });
  for (const char* line : {"wall[0]: lies behind wall[1]", "wall[2]: lies behind wall[1]"})
    EXPECT_EQ(std::count(told.begin(), told.end(), line), 1) << line;
}

TEST(SceneStart, WarnsOfPartsThatShareASurfaceOrFeelNothingOfEachOther) {
  EXPECT_EQ(warnings([](Scene& s) {
              s.plate = {plate(3, 0.5), plate(3.5, 0.5)};
            }),
            Lines{"plate[1]: shares a surface with plate[0]: what lies on their common edge feels both"});
  EXPECT_EQ(warnings([](Scene& s) {
              s.plate = {plate(3, 0.5), plate(3.25, 0.5)};
            }),
            Lines{"plate[1]: overlaps plate[0]: what touches both feels both"});
  EXPECT_EQ(warnings([](Scene& s) { s.plate = {plate(3, 0)}; }),
            Lines{"plate[0]: shares a surface with wall[0]: what lies on their common edge feels both"});
  EXPECT_EQ(warnings([](Scene& s) { s.plate = {plate(3, -0.1)}; }),
            Lines{"plate[0]: reaches behind wall[0]: they do not feel each other"});
  EXPECT_EQ(warnings([](Scene& s) {
              s.lattice.push_back(s.lattice[0]);
              s.lattice[1].name = "other", s.lattice[1].origin = {0.005, 0.005};
            }),
            Lines{"lattice[1]: crosses lattice[0]: lattices do not feel each other"});
}

TEST(SceneNumbers, TakesNormalsOfAnyLength) {
  for (const Vec2 normal : {Vec2{0, 1e200}, Vec2{0, 1e-162}, Vec2{3e-170, 4e-170}, Vec2{0, 5e-324}, Vec2{0, 1.7e308}}) {
    EXPECT_EQ(problems([&](Scene& s) {
                s.wall[0].normal = normal, s.disc[0].position = {0, 3}, s.lattice = {};
              }),
              Lines{});
    EXPECT_EQ(problems([&](Scene& s) {
                s.wall[0].normal = normal, s.disc[0].position = {0, -3}, s.lattice = {};
              }),
              Lines{"disc[0].position: the centre is behind wall[0]"});
  }
}

TEST(SceneNumbers, RefusesWhatOverOrUnderflows) {
  const std::vector<std::function<void(Scene&)>> changes = {
      [](Scene& s) { s.disc[0].radius = 1e-200; },
      [](Scene& s) { s.disc[0].radius = 1e200; },
      [](Scene& s) {
        s.disc[0].position = {1e200, 1};
      },
      [](Scene& s) {
        s.disc[0].velocity = {1e200, 1};
      },
      [](Scene& s) { s.disc[0].spin = 1e200; },
      [](Scene& s) { s.material[0].density = 1e-320; },
      [](Scene& s) { s.material[0].young = 1e-320; },
      [](Scene& s) { s.material[0].young = 1e307, s.disc[0].radius = 100, s.disc[0].position.y = 200; },
      [](Scene& s) { s.contact.damping_factor = 1e300; },
      [](Scene& s) { s.model.rolling_smoothing = 1e-200; },
      [](Scene& s) { s.lattice[0].spacing = 1e-200; },
      [](Scene& s) { s.lattice[0].node_mass = 1e-310; },
      [](Scene& s) { s.lattice[0].structural.stiffness = 1e300, s.lattice[0].node_mass = 1e-10; },
      [](Scene& s) {
        s.lattice[0].node = {{.row = 1, .displacement = {1e200, 0}}};
      },
      [](Scene& s) { s.plate = {plate(1e200, 1)}; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) EXPECT_FALSE(problems(changes[i]).empty()) << i;
}

TEST(SceneSizes, AreBoundedBeforeWorkBegins) {
  EXPECT_EQ(problems([](Scene& s) { s.time.step = 1e-300; }),
            Lines{"time.step: time.end / time.step = 1e+300 steps; at most 1e+10"});
  EXPECT_FALSE(problems([](Scene& s) { s.time.end = 1e308; }).empty());
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].rows = s.lattice[0].columns = 100'000; }),
            Lines{"lattice[0]: rows times columns = 1e+10 nodes of 1000 bytes; at most 1.6e+07"});
  EXPECT_FALSE(problems([](Scene& s) {
                 s.packing.assign(3, {.count = 10'000'000, .upper_right = {1e4, 1e4}, .material = "soft"});
               }).empty());
  EXPECT_FALSE(problems([](Scene& s) { s.settle = Settle{.limit = 1e30}; }).empty());
  EXPECT_EQ(problems([](Scene& s) { s.settle = Settle{.hold = 2, .limit = 1}; }),
            Lines{"settle.hold: longer than settle.limit, 1 s"});
  EXPECT_EQ(problems([](Scene& s) { s.time.relative_tolerance = 1e-17; }),
            Lines{"time.relative_tolerance: 1e-17 is outside 1e-14 <= relative_tolerance <= 0.1"});
}

TEST(SceneEffects, OptionsOfTheModelThatNothingUsesAreSaid) {
  const auto first = [](const std::function<void(Scene&)>& change) {
    const Lines all = warnings([&](Scene& s) {
      s.contact = {};
      s.lattice = {};
      change(s);
    });
    return all.empty() ? std::string() : all.front();
  };
  const std::string smooth = ": has no effect: nothing has friction";
  EXPECT_EQ(first([](Scene& s) { s.model.moment_arm = MomentArm::radius; }), "model.moment_arm" + smooth);
  EXPECT_EQ(first([](Scene& s) { s.model.after_slip = AfterSlip::less_viscous; }), "model.after_slip" + smooth);
  EXPECT_EQ(first([](Scene& s) { s.model.law = ForceLaw::rescaled_mindlin; }), "model.law" + smooth);
  EXPECT_EQ(first([](Scene& s) { s.model.slip_damping = false; }), "model.slip_damping" + smooth);
  EXPECT_EQ(first([](Scene& s) { s.model.slip_damping = false, s.contact.friction = 0.5; }),
            "model.slip_damping: has no effect: nothing is damped");
  EXPECT_EQ(first([](Scene& s) { s.model.rolling = Rolling::spring; }),
            "model.rolling: has no effect: nothing has rolling friction");
  EXPECT_EQ(first([](Scene& s) { s.model.pull = true; }), "model.pull: has no effect: nothing is damped");
  EXPECT_EQ(first([](Scene& s) { s.model.tight_plates = true; }),
            "model.tight_plates: has no effect: there is no plate");
  EXPECT_EQ(first([](Scene& s) { s.model.new_faces = true; }), "model.new_faces: has no effect: no lattice can tear");
  EXPECT_EQ(first([](Scene& s) { s.contact.damping = 1, s.contact.tangential_damping = 2; }),
            "contact.tangential_damping" + smooth);
  EXPECT_EQ(first([](Scene& s) { s.output.checkpoint = 2 * s.time.end; }),
            "output.checkpoint: has no effect: it is longer than the run");
  EXPECT_EQ(first([](Scene& s) { s.plate = {plate(5, 0.3)}, s.plate[0].velocity = {}, s.plate[0].ramp = 0.1; }),
            "plate[0].ramp: has no effect: the velocity is 0");
  EXPECT_EQ(first([](Scene& s) {
              s.contact.friction = 0.5, s.contact.damping = 1, s.model.after_slip = AfterSlip::less_viscous;
            }),
            "");
}

TEST(SceneEffects, AreMissedByWordWhatIsGivenForNothing) {
  EXPECT_EQ(warnings([](Scene& s) { s.model.disc_mass = DiscMass::sphere, s.model.disc_depth = 0.2; }),
            Lines{"model.disc_depth: has no effect: the masses are those of spheres"});
  EXPECT_EQ(warnings([](Scene& s) { s.search.threads = 2; }),
            Lines{"search.threads: has no effect: it is for beds of more than 4096 discs"});
  EXPECT_EQ(warnings([](Scene& s) {
              s.lattice[0].rows = 1, s.lattice[0].columns = 9, s.lattice[0].shear = {},
              s.lattice[0].bending.stiffness = 1;
            }),
            Lines{"lattice[0].bending: a strand of one row has no stiffness across itself: its bending links lie along "
                  "it"});
  EXPECT_EQ(warnings([](Scene& s) { s.lattice[0].rows = 2, s.lattice[0].bending.stiffness = 1; }),
            Lines{"lattice[0].bending: makes no links: there are fewer than 3 rows and fewer than 3 columns"});
  EXPECT_EQ(warnings([](Scene& s) { s.lattice[0].shear = {}; }),
            Lines{"lattice[0]: 2 of its motions meet no stiffness: it folds up freely"});
}

}  // namespace
}  // namespace furrow
