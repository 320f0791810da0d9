// Stems, links that differ, notches, rollers and driven nodes as a scene says them.
#include "scene/stem.h"

#include <gtest/gtest.h>

#include <cmath>

#include "run/observe.h"
#include "run/system.h"
#include "scene/lattice_parts.h"
#include "scene/mechanism.h"
#include "scene/set_key.h"
#include "scene/strip.h"
#include "system/parts.h"
#include "tests/unit/scene_text.h"
#include "tests/unit/scenes.h"

namespace furrow::test {
namespace {

const std::string head = R"(title = "Stem"
time = { end = 1.0, step = 1e-6 }
material = [{ name = "wood", young = 1e9, poisson = 0.3, density = 800.0 }]
[[lattice]]
origin = [0.0, 0.0]
columns = 3
material = "wood"
fixed_rows = [0]
)";
const std::string stem = "stem = { young = 5e8, poisson = 0.3, diameter = 0.006, length = 0.12, strength = 2e7 }\n";

std::string refusal(const std::string& text) {
  try {
    parse_scene(text, "s.toml");
    return {};
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(Stems, SayRowsSpacingAndMass) {
  const Scene scene = parse_scene(head + stem, "s.toml");
  const Lattice& l = scene.lattice[0];
  EXPECT_EQ(l.rows, 41);
  EXPECT_NEAR(l.spacing, 0.003, 1e-18);
  EXPECT_NEAR(l.node_mass * 2 * 40, 800 * pi / 4 * 36e-6 * 0.12, 1e-16);
}

TEST(Stems, AreReadAgainAsTheyAreWritten) {
  const Scene scene = parse_scene(head + stem, "s.toml");
  const std::string text = canonical_text(scene);
  EXPECT_EQ(text.find("node_mass"), std::string::npos);
  EXPECT_EQ(canonical_text(parse_scene(text, "again.toml")), text);
}

TEST(Stems, WantNoKeyThatFollowsFromThem) {
  EXPECT_NE(refusal(head + "rows = 41\n" + stem).find("rows: follows from stem: leave it out"), std::string::npos);
  EXPECT_NE(refusal(head + "shear = { stiffness = 1.0, damping = 0.0 }\n" + stem).find("shear: follows from stem"),
            std::string::npos);
  EXPECT_NE(refusal(head).find("lattice[0].rows: missing, but required"), std::string::npos);
  Scene scene = parse_scene(head + stem, "s.toml");
  EXPECT_EQ(set_key(scene, "lattice[0].spacing", "0.1"), "follows from stem: leave it out");
  EXPECT_EQ(set_key(scene, "lattice[0].stem.length", "0.15"), "");
}

TEST(Stems, OfTooManyColumnsOrTooShortAreRefused) {
  const auto with = [](const std::string& what, const std::string& by) {
    std::string text = head + stem;
    return refusal(text.replace(text.find(what), what.size(), by));
  };
  EXPECT_NE(with("columns = 3", "columns = 6").find("columns: a stem has 3, 4 or 5 columns"), std::string::npos);
  EXPECT_NE(with("length = 0.12", "length = 0.011").find("less than two diameters"), std::string::npos);
  EXPECT_NE(with("poisson = 0.3, diam", "poisson = 0.01, diam").find("is outside 0.05 <= poisson <= 0.5"),
            std::string::npos);
  Scene scene = parse_scene(head + stem, "s.toml");
  scene.lattice[0].columns = 5;
  scene.lattice[0].stem->poisson = 0.05;
  scene.lattice[0].stem->length = 0.0157;
  EXPECT_EQ(problems_of(scene).at(0).path, "lattice[0].stem");
}

// The rod that a lattice is, by hand: 16.5 k s, 10.25 k s^3, 2 k s for three columns with all springs alike.
TEST(Beams, OfThePapersLatticeIsARodOf31Millimetres) {
  Lattice l = lattice({0, 0}, 10, 3, 0.01);
  l.fixed_rows = {0, 1};
  l.node_mass = 5;
  l.structural = l.shear = l.bending = link_kind(1e4, 50, 40);
  const Beam b = beam_of(l).value();
  EXPECT_NEAR(b.tension, 1650, 1e-9);
  EXPECT_NEAR(b.bending, 0.1025, 1e-14);
  EXPECT_NEAR(b.shear, 200, 1e-10);
  EXPECT_NEAR(b.poisson, 0.25, 1e-13);
  EXPECT_NEAR(b.diameter(), 0.0315, 5e-5);
  EXPECT_NEAR(b.young(), 2.1e6, 5e4);
  EXPECT_EQ(b.length, 0.08);
  EXPECT_TRUE(b.held);
  EXPECT_FALSE(b.isotropic);
  EXPECT_NEAR(b.tearing_tension(), 1650 * 40 / (1e4 * 0.02), 1e-9);  // bending links stretch twice as far
}

TEST(Beams, AreIsotropicWithShearLinksHalfAsStiff) {
  Lattice l = lattice({0, 0}, 9, 5, 0.01);
  l.structural = link_kind(2e3, 0, infinity);
  l.shear = link_kind(1e3, 0, infinity);
  EXPECT_TRUE(beam_of(l)->isotropic);
  EXPECT_NEAR(beam_of(l)->poisson, 1.0 / 3, 1e-14);
  l.shear.stiffness *= 1.001;
  EXPECT_FALSE(beam_of(l)->isotropic);
  EXPECT_FALSE(beam_of(lattice({0, 0}, 9, 1, 0.01)).has_value());
}

TEST(Beams, OfAStemAreItsRod) {
  const Scene scene = parse_scene(head + stem, "s.toml");
  const Beam b = beam_of(scene.lattice[0]).value();
  const double area = pi / 4 * 36e-6;
  EXPECT_NEAR(b.diameter(), 0.006, 1e-15);
  EXPECT_NEAR(b.young(), 5e8, 1e-4);
  EXPECT_NEAR(b.tearing_tension(), 2e7 * area, 1e-9);
  EXPECT_NEAR(b.bending * b.tearing_curvature, 2e7 * area * 0.006 / 8, 1e-12);
  EXPECT_NEAR(b.mass, 800 * area, 1e-13);
}

Lattice square() {
  Lattice l = lattice({0, 0}, 4, 3, 0.1);
  l.structural = link_kind(100, 1, 5);
  l.shear = link_kind(50, 1, 5);
  return l;
}

TEST(Links, OfARegionLieInItWithBothEnds) {
  Lattice l = square();
  l.link = {{.kind = LinkChoice::structural, .rows = {1, 2}, .stiffness = 7}};
  for (const LatticeLink& link : links_of(l)) {
    const auto inside = [](int node) { return node / 3 == 1 || node / 3 == 2; };
    const bool chosen = link.kind == LinkClass::structural && inside(link.a) && inside(link.b);
    EXPECT_EQ(link.stiffness, chosen ? 7 : link.kind == LinkClass::shear ? 50 : 100) << link.a << ' ' << link.b;
  }
}

TEST(Links, OfTwoSettingsTheLaterHolds) {
  Lattice l = square();
  l.link = {{.strength = 2}, {.from = {1, 1}, .to = {0, 0}, .strength_factor = 0.5, .torn = true}};
  int changed = 0;
  for (const LatticeLink& link : links_of(l)) {
    const bool chosen = link.a == 0 && link.b == 4;
    changed += chosen ? 1 : 0;
    EXPECT_EQ(link.strength, chosen ? 1 : 2);
    EXPECT_EQ(link.torn, chosen);
  }
  EXPECT_EQ(changed, 1);
}

TEST(Links, OfANotchStayTornWhateverALaterSettingChanges) {
  Lattice l = square();
  const LinkSetting notch{.cut_from = Vec2{-0.1, 0.15}, .cut_to = Vec2{0.04, 0.15}, .torn = true};
  const auto torn = [&] {
    const std::vector<LatticeLink> links = links_of(l);
    return std::count_if(links.begin(), links.end(), [](const LatticeLink& k) { return k.torn; });
  };
  l.link = {notch, {.damping = 3}};
  EXPECT_EQ(torn(), 1);
}

TEST(Links, OfLinesOutsideTheLatticeAreRefused) {
  Scene scene = empty_scene();
  scene.lattice = {square()};
  const auto faults = [&](const LinkSetting& s) {
    scene.lattice[0].link = {s};
    std::vector<std::string> paths;
    for (const Problem& p : problems_of(scene)) paths.push_back(p.path);
    return paths;
  };
  using Paths = std::vector<std::string>;
  EXPECT_EQ(faults({.rows = {0, 1, 9}, .stiffness = 1}), Paths{"lattice[0].link[0].rows[2]"});
  EXPECT_EQ(faults({.columns = {3}, .stiffness = 1}), Paths{"lattice[0].link[0].columns[0]"});
  EXPECT_EQ(faults({.from = {0, 0}, .to = {1, 7}, .stiffness = 1}), Paths{"lattice[0].link[0].to[1]"});
  EXPECT_EQ(faults({.rows = {1, 1}, .stiffness = 1}), Paths{"lattice[0].link[0].rows[1]"});
  EXPECT_EQ(faults({.rows = {0, 1}, .stiffness = 1}), Paths{});
}

TEST(Links, ThatASettingDoesNotChangeAreSaid) {
  Scene scene = empty_scene();
  scene.lattice = {square()};
  const auto warning = [&](const LinkSetting& s) {
    scene.lattice[0].link = {s};
    const std::vector<std::string> lines = scene_warnings(scene);
    const auto own = std::find_if(lines.begin(), lines.end(),
                                  [](const std::string& line) { return line.starts_with("lattice[0].link[0]: "); });
    return own == lines.end() ? std::string() : own->substr(20);
  };
  EXPECT_EQ(warning({.kind = LinkChoice::shear}), "has no effect: it changes nothing of the links that it chooses");
  EXPECT_EQ(warning({.stiffness = 5, .torn = true}),
            "its links are torn: their stiffness, damping and strength have no effect");
  EXPECT_EQ(warning({.stiffness = 5}), "");
  EXPECT_EQ(warning({.torn = true}), "");
}

TEST(Notches, AreTornFromTheStartWithBothSolvers) {
  for (const SolverKind kind : {SolverKind::kernel, SolverKind::reference}) {
    Scene scene = empty_scene();
    scene.time.solver = kind;
    scene.lattice = {square()};
    scene.lattice[0].link = {{.cut_from = Vec2{-0.1, 0.15}, .cut_to = Vec2{0.04, 0.15}, .torn = true}};
    const System system(scene);
    std::vector<std::string> torn;
    for (int k = 0; k < system.parts().link.count(); ++k)
      if (system.torn(k)) torn.push_back(system.parts().link_name(k));
    ASSERT_EQ(torn.size(), 1U);  // the diagonals meet at x = 0.05
    EXPECT_EQ(torn[0],
              "structural link from node (row 1, column 0) of lattice 0 to node (row 2, column 0) of lattice 0");
  }
}

TEST(Rollers, KeepOneCoordinate) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 2, 0.1);
  l.structural = link_kind(100, 0, infinity);
  l.node = {{.row = 0, .column = 0, .displacement = {-0.01, 0.02}, .force = {3, 4}, .fixed_x = true},
            {.row = 0, .column = 1, .fixed_x = true, .fixed_y = true}};
  scene.lattice = {l};
  const System system(scene);
  EXPECT_EQ(system.parts().free_nodes, 1);
  State rates(system.size());
  system.rhs(0, system.initial_state(), rates);
  EXPECT_EQ(rates[system.vx_of(0)], 0);
  EXPECT_NE(rates[system.vy_of(0)], 0);
}

TEST(Mechanisms, SeeNotchesAndRollers) {
  Lattice l = square();
  l.fixed_rows = {0};
  EXPECT_EQ(free_motions(l), 0);
  l.link = {{.cut_from = Vec2{-1, 0.151}, .cut_to = Vec2{1, 0.151}, .torn = true}};
  EXPECT_EQ(free_motions(l), 3);  // the upper part is loose
  Lattice cell = lattice({0, 0}, 2, 2, 0.1);
  cell.structural = link_kind(100, 0, infinity);
  EXPECT_EQ(free_motions(cell), 1);
  cell.node = {{.row = 0, .column = 0, .fixed_x = true, .fixed_y = true}, {.row = 0, .column = 1, .fixed_y = true}};
  EXPECT_EQ(free_motions(cell), 1);
  cell.node.push_back({.row = 1, .column = 0, .fixed_x = true});
  EXPECT_EQ(free_motions(cell), 0);
}

Scene driven(double ramp) {
  Scene scene = empty_scene();
  scene.lattice = {square()};
  scene.lattice[0].drive = {{.rows = {3}, .velocity = {0.5, -0.25}, .ramp = ramp}};
  return scene;
}

TEST(Drives, MoveNodesAsTheySay) {
  for (const double ramp : {0.0, 0.4}) {
    const System system(driven(ramp));
    EXPECT_EQ(system.parts().free_nodes, 9);
    for (const double t : {0.0, 0.1, 0.4, 1.0}) {
      const NodeMotion nodes = system.nodes(t, system.initial_state());
      const double share = t < ramp ? t / ramp : 1, time = t < ramp ? t * t / ramp / 2 : t - ramp / 2;
      EXPECT_NEAR(nodes.vx[9], 0.5 * share, 1e-15);
      EXPECT_NEAR(nodes.x[9], 0.5 * time, 1e-15);
      EXPECT_NEAR(nodes.y[11], 0.3 - 0.25 * time, 1e-15);
      EXPECT_EQ(nodes.x[0], 0);
    }
  }
}

TEST(Drives, StandStillWhileASceneIsPrepared) {
  System system(driven(0));
  system.prepare(true);
  const NodeMotion nodes = system.nodes(0.7, system.initial_state());
  EXPECT_EQ(nodes.x[9], 0);
  EXPECT_EQ(nodes.vx[9], 0);
}

TEST(Drives, ThatMeetEachOtherOrFixedNodesAreRefused) {
  Scene scene = sound_scene();
  Lattice& l = scene.lattice[0];
  l.fixed_rows = {0};
  l.drive = {{.rows = {2}}, {.columns = {0}}, {}, {.rows = {0}}};
  Lines lines;
  for (const auto& [path, message] : problems_of(scene)) lines.push_back(path + ": " + message);
  EXPECT_EQ(lines, (Lines{"lattice[0].drive[1]: drives nodes that lattice[0].drive[0] drives",
                          "lattice[0].drive[2]: drives rows or columns: give one of them",
                          "lattice[0].drive[3]: drives nodes that are fixed",
                          "lattice[0].drive[3]: drives nodes that lattice[0].drive[1] drives"}));
}

}  // namespace
}  // namespace furrow::test
