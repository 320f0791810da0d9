// What `explain` says of lattices, of what is modelled and left out, and of a bed that diverges.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "explain.h"

namespace {

using furrow::test::discs;
using furrow::test::Explain;
using furrow::test::spring;

// By hand: 16.5 k s, 10.25 k s^3, 2 k s of three columns of springs all alike; the rod by d = 4 sqrt(EI/EA).
TEST_F(Explain, SaysWhichBeamALatticeIs) {
  const std::string lattice = R"(
title = "Stem"
time = { end = 0.1, step = 1e-4 }
material = [{ name = "soft", young = 1e6, poisson = 0.25 }]
[[lattice]]
name = "stem"
origin = [0.0, 0.0]
rows = 10
columns = 3
spacing = 0.01
node_mass = 5.0
material = "soft"
fixed_rows = [0, 1]
structural = { stiffness = 1e4, damping = 50.0, strength = 40.0 }
shear = { stiffness = 1e4, damping = 50.0, strength = 40.0 }
bending = { stiffness = 1e4, damping = 50.0, strength = 40.0 }
)";
  const std::string text = explain(lattice);
  ASSERT_EQ(code_, 0) << errors_;
  EXPECT_NE(text.find("EA = 1650 N, EI = 0.1025 N m^2, GA = 200 N, nu = 0.25"), std::string::npos) << text;
  EXPECT_NE(text.find("diameter 0.03153 m, young 2.114e+06 Pa"), std::string::npos) << text;
  EXPECT_NE(text.find("tears in tension at 330 N, in bending at 2.05 N m"), std::string::npos) << text;
}

TEST_F(Explain, SaysWhereTheLedgerOfEnergyDoesNotClose) {
  const auto said = [&](const std::string& model, const std::string& more = "") {
    const std::string text = explain(
        "title = \"Wall\"\ntime = { end = 0.1, step = 1e-4 }\nmodel = { " + model +
        " }\ncontact = { damping_factor = 0.1, friction = 0.5" + more +
        " }\nmaterial = [{ name = \"soft\", young = 1e6, poisson = 0.25 }]\n"
        "disc = [{ position = [0.0, 0.2], radius = 0.1, material = \"soft\" }]\n"
        "wall = [{ point = [0.0, 0.0], normal = [0.0, 1.0], material = \"soft\" }]\noutput = { energy = true }\n");
    EXPECT_EQ(code_, 0) << errors_;
    return text.find("so the energy ledger does not close") != std::string::npos;
  };
  EXPECT_TRUE(said("after_slip = \"less_viscous\""));
  EXPECT_FALSE(said("after_slip = \"elastic\""));
  EXPECT_FALSE(
      said("after_slip = \"less_viscous\", law = \"linear\"", ", normal_stiffness = 1e4, tangential_stiffness = 1e4"));
}

TEST_F(Explain, SaysHowAPlateReachesItsSpeed) {
  const std::string plates = R"(
title = "Plates"
disc = [{ position = [5.0, 5.0], radius = 0.1, material = "soft" }]
time = { end = 0.1, step = 1e-4 }
material = [{ name = "soft", young = 1e6, poisson = 0.25 }]
plate = [{ name = "sudden", left_edge = 0.0, lower_edge = 0.0, width = 0.1, height = 0.1, velocity = [0.1, 0.0], material = "soft" },
         { name = "slow", left_edge = 1.0, lower_edge = 0.0, width = 0.1, height = 0.1, velocity = [0.1, 0.0], ramp = 0.2, material = "soft" },
         { name = "still", left_edge = 2.0, lower_edge = 0.0, width = 0.1, height = 0.1, velocity = [0.0, 0.0], material = "soft" }]
)";
  const std::string text = explain(plates);
  ASSERT_EQ(code_, 0) << errors_;
  EXPECT_TRUE(std::regex_search(text, std::regex("plate sudden +ramp: none, full speed at once"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("plate slow +reaches its speed in 0.2 s"))) << text;
  EXPECT_FALSE(std::regex_search(text, std::regex("plate still +ramp"))) << text;
}

TEST_F(Explain, CountsWhatIsModelled) {
  const std::string text = explain(discs);
  // 2 discs: x, y, vx, vy, spin; room for springs and one dummy slot; 7 of the ledger.
  const int springs = static_cast<int>(numbers(text, "tangential springs", "room for").at(0));
  EXPECT_EQ(numbers(text, "modelled (", "numbers of state").at(0), 2 * 5 + springs + 1 + 7);
  EXPECT_EQ(numbers(text, "discs", "numbers each").at(0), 2);
  EXPECT_EQ(numbers(text, "discs", "numbers each").at(1), 5);
  EXPECT_NE(text.find("1 wall, 0 plates"), std::string::npos);
  const std::string lattice = explain(spring);
  EXPECT_EQ(numbers(lattice, "modelled (", "numbers of state").at(0), 4 + 7);
  EXPECT_EQ(numbers(lattice, "lattice nodes", "free").at(0), 1);
  EXPECT_NE(lattice.find("1 free, 4 numbers each; 1 fixed, none"), std::string::npos);
  EXPECT_NE(lattice.find("1: 1 structural, 0 shear, 0 bending"), std::string::npos);
  EXPECT_NE(lattice.find("its structural links never tear"), std::string::npos);
  EXPECT_NE(lattice.find("has no shear links"), std::string::npos);
  EXPECT_NE(lattice.find("has no bending links"), std::string::npos);
}

TEST_F(Explain, SaysWhatIsLeftOutOnlyWhereItIs) {
  const std::string with = explain(discs);
  for (const char* not_left_out : {"every friction coefficient is zero", "rolling friction coefficient is zero",
                                   "no discs", "model.gravity = 0", "do not touch each other"})
    EXPECT_EQ(with.find(not_left_out), std::string::npos) << not_left_out;
  std::string without = discs;
  without.replace(without.find("gravity = 2.5"), 13, "gravity = 0.0");
  without.replace(without.find("rolling_friction = 0.02"), 23, "");
  const std::string text = explain(without);
  EXPECT_NE(text.find("model.gravity = 0"), std::string::npos) << text;
  EXPECT_NE(text.find("every rolling friction coefficient is zero"), std::string::npos) << text;
  EXPECT_EQ(text.find("no spins, no tangential springs"), std::string::npos) << text;
  EXPECT_NE(explain(spring).find("no discs"), std::string::npos);
}

// A bed whose own step is so long that it blows up while it settles.
TEST_F(Explain, DivergesWithExitThreeWhereItsBedDoes) {
  std::string scene = discs + "[settle]\nspeed = 1e-3\nstep = 0.05\n";
  const std::string text = explain(scene);
  EXPECT_EQ(code_, 3) << text;
  EXPECT_NE(errors_.find("furrow: error: while settling"), std::string::npos) << errors_;
  EXPECT_NE(text.find("E* ="), std::string::npos) << "what it knew before is said";
}

// A disc that just touches is as stiff as its weight makes it, one that falls as its speed: what t = 0 allows is not safe.
TEST_F(Explain, AStepIsWeighedByTheImpactThatIsToCome) {
  const auto said = [&](const std::string& height, const std::string& step) {
    return explain(
        "title = \"Above a wall\"\noutput = { interval = 0.01 }\ntime = { end = 0.1, method = \"verlet\", step = " +
        step +
        " }\ncontact = { damping_factor = 0.3 }\n"
        "material = [{ name = \"soft\", young = 1e8, poisson = 0.3 }]\n"
        "disc = [{ position = [0.0, " +
        height +
        "], radius = 0.1, material = \"soft\" }]\n"
        "wall = [{ point = [0.0, 0.0], normal = [0.0, 1.0], material = \"soft\" }]\n");
  };
  const auto has = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  const std::string touches = said("0.0999999999", "5e-3");
  EXPECT_TRUE(has(touches, "which its weight gives a disc that just touches")) << touches;
  EXPECT_TRUE(has(touches, "NOT safely in an impact to come")) << touches;
  EXPECT_TRUE(has(said("0.0999999999", "1e-4"), "well inside"));
  const std::string falls = said("2.1", "5e-3");  // 2 m: sqrt(2 g h) = 6.264 m/s
  EXPECT_TRUE(has(falls, "at 6.26 m/s, that of a fall to what is below")) << falls;
  EXPECT_TRUE(has(falls, "NOT the scene's step")) << falls;
  EXPECT_TRUE(has(falls, "NOT safely in an impact to come")) << falls;
}

// What is far away, beside or above is no place to fall to; a lattice is, and what is thrown comes faster than it falls.
TEST_F(Explain, ADiscFallsToWhatIsStraightBelowIt) {
  const auto speed_of = [&](const std::string& parts, const std::string& velocity = "[0.0, 0.0]") {
    const std::string text = explain(
        "title = \"Falls\"\noutput = { interval = 0.01 }\ntime = { end = 0.1, method = \"verlet\", step = 1e-6 }\n"
        "contact = { damping_factor = 0.3 }\nmaterial = [{ name = \"soft\", young = 1e8, poisson = 0.3 }]\n"
        "disc = [{ position = [0.0, 1.1], radius = 0.1, material = \"soft\", velocity = " +
        velocity + " }]\n" + parts);
    std::smatch found;
    return std::regex_search(text, found, std::regex("an impact to come +at ([0-9.]+) m/s")) ? std::stod(found[1])
                                                                                             : NAN;
  };
  const std::string floor = "{ point = [0.0, 0.0], normal = [0.0, 1.0], material = \"soft\" }";
  const double by_fall = 4.43;  // m/s, sqrt(2 g 1 m)
  EXPECT_NEAR(speed_of("wall = [" + floor + "]\n"), by_fall, 0.005);
  EXPECT_NEAR(speed_of("wall = [" + floor +
                       ", { point = [1000.0, -500.0], normal = [0.4472135954999579, "
                       "0.8944271909999159], material = \"soft\" }]\n"),
              by_fall, 0.005);
  EXPECT_NEAR(
      speed_of("wall = [" + floor + ", { point = [-1.0, -1000.0], normal = [1.0, 1e-9], material = \"soft\" }]\n"),
      by_fall, 0.005);
  EXPECT_NEAR(speed_of("wall = [" + floor +
                       "]\nplate = [{ left_edge = 50.0, lower_edge = -80.0, width = 1.0, height = "
                       "1.0, velocity = [0.0, 0.0], material = \"soft\" }]\n"),
              by_fall, 0.005);
  EXPECT_NEAR(speed_of("wall = [" + floor + "]\n", "[0.0, -3.0]"), 5.35, 0.005) << "sqrt(v^2 + 2 g 1 m)";
  EXPECT_NEAR(
      speed_of("[[lattice]]\norigin = [-0.2, 0.0]\nrows = 2\ncolumns = 5\nspacing = 0.1\nnode_mass = 1.0\n"
               "contact_radius = 0.01\nfixed_rows = [0]\nmaterial = \"soft\"\nstructural = { stiffness = 1e4, damping "
               "= 1.0 }\n"),
      4.18, 0.005)
      << "the upper row at 0.1 m, its radius 0.01 m: sqrt(2 g 0.89 m)";
}

// What something below already holds, a plate or another disc, comes to no further place below it.
TEST_F(Explain, WhatIsHeldFromBelowDoesNotFall) {
  const auto said = [&](const std::string& heights, const std::string& parts) {
    std::string all;
    std::istringstream words(heights);
    for (std::string y; words >> y;) all += "{ position = [0.0, " + y + "], radius = 0.1, material = \"soft\" },";
    return explain(
        "title = \"Held\"\noutput = { interval = 0.01 }\ntime = { end = 0.1, method = \"verlet\", step = 1e-6 }\n"
        "contact = { damping_factor = 0.3 }\nmaterial = [{ name = \"soft\", young = 1e8, poisson = 0.3 }]\n"
        "wall = [{ point = [0.0, -50.0], normal = [0.0, 1.0], material = \"soft\" }]\ndisc = [" +
        all + "]\n" + parts);
  };
  const auto falls = [](const std::string& text) { return text.find("that of a fall") != std::string::npos; };
  const std::string plate =
      "plate = [{ left_edge = -0.5, lower_edge = 0.5, width = 1.0, height = 0.5, velocity = [0.0, 0.0], material = "
      "\"soft\" }]\n";
  EXPECT_FALSE(falls(said("1.0999", plate))) << "0.1 mm deep in the plate, 51 m above the wall";
  EXPECT_TRUE(falls(said("1.5", plate))) << "0.4 m above it";
  EXPECT_FALSE(falls(said("1.0999 1.2998 1.4997", plate))) << "piled";
  EXPECT_TRUE(falls(said("-40.0 -39.8001", ""))) << "of two that touch each other the lower one falls";
}

}  // namespace
