// What `stability` says of a spring of known frequency, and what the options of `run` do to its scene.
#include <cmath>
#include <complex>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace {

using furrow::test::text_of;

// 800 N/m, 2 kg, omega = 20 rad/s; with damping 8 N s/m lambda = -2 +- 19.9 i.
std::string spring(double damping, double step) {
  std::ostringstream text;
  text << "title = \"Spring\"\n[time]\nend = 2.0\nmethod = \"verlet\"\nstep = " << step
       << "\n[output]\ninterval = 0.5\nframes = [0.0, 0.5, 1.0]\n[[material]]\nname = \"soft\"\nyoung = 1e6\npoisson = "
          "0.25\n"
          "[[lattice]]\nname = \"spring\"\norigin = [0.0, 0.0]\nrows = 1\ncolumns = 2\nspacing = 1.0\nnode_mass = 2.0\n"
          "material = \"soft\"\nfixed_columns = [0]\nstructural = { stiffness = 800.0, damping = "
       << damping << " }\n[[lattice.node]]\nrow = 0\ncolumn = 1\ndisplacement = [0.1, 0.0]\n";
  return text.str();
}

class StepCommands : public furrow::test::Program {
 protected:
  struct Row {
    std::string predicted, measured, rest;
  };
  Row row(const std::string& method) const {
    std::istringstream lines(out());
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string name;
      Row found;
      if (!(words >> name) || name != method || !(words >> found.predicted >> found.measured)) continue;
      std::getline(words, found.rest);
      return found;
    }
    ADD_FAILURE() << method << " is not in\n" << out();
    return {};
  }
};

TEST_F(StepCommands, StabilityKnowsTheSpringsEigenvalueAndItsLimits) {
  put("s.toml", spring(8, 1e-2));
  ASSERT_EQ(furrow("stability s.toml").code, 0) << err();
  EXPECT_NE(out().find("at t = 0 s "), std::string::npos);
  double real = 0, imaginary = 0;
  ASSERT_EQ(std::sscanf(out().c_str() + out().find("lambda ="), "lambda = %lf %lf", &real, &imaginary), 2) << out();
  EXPECT_NEAR(real, -2, 1e-3);
  EXPECT_NEAR(imaginary, std::sqrt(400 - 4.0), 1e-2);
  EXPECT_NE(out().find("structural link from node"), std::string::npos) << out();
  // On lambda alone: rk4 where |1 + z + z^2/2 + z^3/6 + z^4/24| = 1; found here by halving.
  double low = 0.05, high = 0.5;
  for (int k = 0; k < 60; ++k) {
    const double h = 0.5 * (low + high);
    const std::complex<double> z = h * std::complex<double>(-2, std::sqrt(396.0));
    (std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))) < 1 ? low : high) = h;
  }
  EXPECT_NEAR(std::stod(row("rk4").predicted), low, 6e-3 * low);
  EXPECT_NEAR(std::stod(row("rk4").measured), low, 2e-2 * low);
  EXPECT_EQ(row("rk4").rest.find("UNSTABLE"), std::string::npos);
  EXPECT_NE(row("rk4").rest.find("stable"), std::string::npos);
}

TEST_F(StepCommands, StabilityOfALongStepIsUnstableForThoseWhoseLimitItExceeds) {
  put("s.toml", spring(0, 0.12));
  ASSERT_EQ(furrow("stability s.toml --method verlet rk4").code, 0) << err();
  EXPECT_NEAR(std::stod(row("verlet").predicted), 0.1, 1e-3);
  EXPECT_NE(row("verlet").rest.find("UNSTABLE"), std::string::npos);
  EXPECT_NEAR(std::stod(row("rk4").predicted), std::sqrt(8.0) / 20, 2e-3);
  EXPECT_EQ(row("rk4").rest.find("UNSTABLE"), std::string::npos) << row("rk4").rest;
  EXPECT_EQ(out().find("\npece "), std::string::npos) << "only those that were named";
}

TEST_F(StepCommands, StabilityOfAnImplicitMethodIsAnyStep) {
  put("s.toml", spring(8, 1e-2));
  ASSERT_EQ(furrow("stability s.toml --method odeint_implicit_euler").code, 0) << err();
  EXPECT_EQ(row("odeint_implicit_euler").measured, "any") << out();
}

TEST_F(StepCommands, StabilityAtALaterTimeIsOfTheStateThere) {
  put("s.toml", spring(8, 1e-2));
  ASSERT_EQ(furrow("stability s.toml --at 1.5 --method rk4").code, 0) << err();
  EXPECT_NE(out().find("at t = 1.5 s "), std::string::npos) << out();
  EXPECT_EQ(furrow("stability s.toml --at 2.0001 --method rk4").code, 2);
  EXPECT_EQ(furrow("stability s.toml --at 2.0 --method rk4").code, 0) << err();
}

TEST_F(StepCommands, StabilityOfWhatNothingActsOnSaysSo) {
  std::string text = spring(0, 1e-2);
  text.replace(text.find("stiffness = 800.0"), 17, "stiffness = 0.0");
  put("s.toml", text);
  ASSERT_EQ(furrow("stability s.toml --method rk4").code, 0) << err();
  EXPECT_NE(out().find("nothing acts on anything here"), std::string::npos) << out();
}

// An undamped spring has its energy multiplied by |r|^(2 n) in n steps, r the greatest root of the method's recurrence at
// z = i h omega: r^2 = r (1 + 3/2 z) - z/2 of ab2, r^2 = r (1 + z + 3/4 z^2) - z^2/4 of pece.
TEST_F(StepCommands, StabilitySaysWhatAMethodMakesOfTheEnergyOfAnUndampedSpring) {
  using Complex = std::complex<double>;
  const auto made = [](Complex one, Complex none) {  // r^2 = one r + none
    const Complex root = std::sqrt(one * one + 4.0 * none);
    const double size = std::max(std::abs(one + root), std::abs(one - root)) / 2;
    return 100 * (std::pow(size, 400) - 1);
  };
  put("s.toml", spring(0, 0.015));
  ASSERT_EQ(furrow("stability s.toml --method ab2 pece").code, 0) << err();
  const Complex z(0, 0.015 * 20);
  for (const auto& [method, want] :
       {std::pair{"ab2", made(1.0 + 1.5 * z, -0.5 * z)}, {"pece", made(1.0 + z + 0.75 * z * z, -0.25 * z * z)}}) {
    double got = 0;
    const std::string rest = row(method).rest;
    ASSERT_EQ(std::sscanf(rest.c_str() + rest.find("energy "), "energy %lf %%", &got), 1) << rest;
    // What is left of the energy, but for the first steps and for where in its swing it is seen: both of order h omega.
    EXPECT_NEAR(100 + got, 100 + want, 0.5 * std::abs(z) * (100 + want)) << method;
  }
  EXPECT_NE(out().find("growth of more than 1e-5 a step, as furrow explain"), std::string::npos) << out();
  EXPECT_NE(out().find("grow by more than 1e-3 a step"), std::string::npos) << out();
}

// The plate of the first scene meets the lattice later than in 200 steps: round-off over round-off is no energy made.
TEST_F(StepCommands, StabilityBeforeAnythingHappensSaysSo) {
  ASSERT_EQ(furrow("stability " + scene("scenario_1") + " --method pece rk4").code, 0) << err();
  for (const char* method : {"pece", "rk4"})
    EXPECT_NE(row(method).rest.find("stable; nothing happens in them"), std::string::npos) << out();
}

// A disc that touches the wall at this moment: differences of places see a stiffness there, of their own making.
TEST_F(StepCommands, StabilityOfAContactThatJustBeginsIsOfNothing) {
  ASSERT_EQ(furrow("stability " + scene("disc_on_wall") + " --method pece").code, 0) << err();
  EXPECT_NE(out().find("nothing acts on anything here"), std::string::npos) << out();
  EXPECT_EQ(row("pece").measured, "any") << out();
  EXPECT_EQ(out().find("UNSTABLE"), std::string::npos) << out();
}

TEST_F(StepCommands, AFrameAtUntilIsTakenAndLaterOnesAreNot) {
  put("s.toml", spring(8, 1e-2));
  ASSERT_EQ(furrow("run s.toml --until 0.5 --out here").code, 0) << err();
  EXPECT_EQ(text_of(directory_ / "here/frames/frames.csv"), "index,t [s],displacement [m]\n0,0,0\n1,0.5,0\n");
  ASSERT_EQ(furrow("run s.toml --until 0.49 --out there").code, 0) << err();
  EXPECT_EQ(text_of(directory_ / "there/frames/frames.csv"), "index,t [s],displacement [m]\n0,0,0\n");
  ASSERT_EQ(furrow("run s.toml --out whole").code, 0) << err();
  EXPECT_TRUE(std::filesystem::exists(directory_ / "whole/frames/links_002.vtp"));
}

TEST_F(StepCommands, ARunGoesWhereItsSceneIsNamedAfterUnlessItIsTold) {
  put("s.toml", spring(8, 1e-2));
  ASSERT_EQ(furrow("run s.toml --until 0.5").code, 0) << err();
  EXPECT_TRUE(std::filesystem::exists(directory_ / "runs/s/run.json"));
  EXPECT_EQ(nlohmann::json::parse(out())["scene"], "s.toml");
  EXPECT_EQ(out(), text_of(directory_ / "runs/s/run.json"));
}

TEST_F(StepCommands, AStepMayBeAsLongAsTheRunAndNoLonger) {
  put("s.toml", spring(8, 1e-2));
  EXPECT_EQ(furrow("run s.toml --until 0.5 --dt 0.5 --method odeint_implicit_euler --out here").code, 0) << err();
  EXPECT_EQ(furrow("run s.toml --until 0.4 --dt 0.5 --method odeint_implicit_euler --out there").code, 2);
  EXPECT_FALSE(std::filesystem::exists(directory_ / "there"));
}

// What stood in the directory of a run from an earlier one is gone: its state, its frames, its partial files.
TEST_F(StepCommands, NothingOfAnEarlierRunIsLeft) {
  put("s.toml", spring(8, 1e-2));
  ASSERT_EQ(furrow("run s.toml --out here").code, 0) << err();
  const std::string state = text_of(directory_ / "here/state.csv");
  ASSERT_EQ(furrow("run s.toml --until 0.5 --out here").code, 0) << err();
  EXPECT_NE(text_of(directory_ / "here/state.csv"), state);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory_ / "here")) {
    EXPECT_EQ(entry.path().string().find("002"), std::string::npos) << entry.path();
    EXPECT_EQ(entry.path().string().find(".partial"), std::string::npos) << entry.path();
  }
}

// A bed that never settles leaves no state that could be taken for its own.
TEST_F(StepCommands, ARunThatDoesNotSettleLeavesNoStateOfAnEarlierOne) {
  const std::string disc =
      "title = \"Bouncing\"\n[time]\nend = 0.01\nstep = 1e-4\n[[material]]\nname = \"soft\"\nyoung = 1e6\npoisson = "
      "0.25\n"
      "[[disc]]\nposition = [0.0, 0.2]\nradius = 0.1\nmaterial = \"soft\"\n[[wall]]\npoint = [0.0, 0.0]\nnormal = "
      "[0.0, 1.0]\n"
      "material = \"soft\"\n";
  put("s.toml", disc);
  ASSERT_EQ(furrow("run s.toml --out here").code, 0) << err();
  ASSERT_TRUE(std::filesystem::exists(directory_ / "here/state.csv"));
  put("s.toml", disc + "[settle]\nspeed = 1e-6\nlimit = 0.5\n");
  EXPECT_EQ(furrow("run s.toml --out here").code, 3) << err();
  EXPECT_NE(err().find("not settled after 0.5 s"), std::string::npos) << err();
  EXPECT_FALSE(std::filesystem::exists(directory_ / "here/state.csv"));
  EXPECT_FALSE(std::filesystem::exists(directory_ / "here/plate_force.csv"));
  const auto json = nlohmann::json::parse(text_of(directory_ / "here/run.json"));
  EXPECT_EQ(json["ended"], "diverged");
  EXPECT_EQ(json["ended_at"], 0);
}

// Two nodes on one spot have no direction between them: what came of it went into a solver that crashed.
TEST_F(StepCommands, StabilityOfANodeOnAnotherIsAnErrorNotACrash) {
  std::string text = spring(8, 1e-2);
  text.replace(text.find("[0.1, 0.0]"), 10, "[-1.0, 0.0]");
  put("s.toml", text);
  const int code = furrow("stability s.toml").code;
  EXPECT_TRUE(code == 2 || code == 3) << code;
  EXPECT_NE(err().find("error: "), std::string::npos) << err();
}

}  // namespace
