// Files of targets and of curves, how far a value is from its target, and what the slopes about a point say.
#include "validation/calibration/targets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "scene/read.h"
#include "tests/files.h"
#include "tests/plate_beside_disc.h"
#include "validation/calibration/identify.h"
#include "validation/calibration/linear_theory.h"
#include "validation/calibration/read_curve.h"
#include "validation/page/observables.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

struct Desk {
  test::OwnDirectory directory;
  std::filesystem::path put(const std::string& name, const std::string& text) const {
    std::ofstream(directory.path() / name, std::ios::binary) << text;
    return directory.path() / name;
  }
  MeasuredCurve curve(const std::string& text) const {
    MeasuredCurve curve;
    read_curve(curve, put("curve.csv", text));
    return curve;
  }
  std::string fault_of_curve(const std::string& text) const {
    try {
      curve(text);
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "nothing";
  }
  std::string fault_of_targets(const std::string& name, const std::string& text) const {
    try {
      read_targets(put(name, text), {"stem"});
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "nothing";
  }
};

TEST(FileOfTargets, WithAKeyTwiceIsNoJson) {
  const Desk desk;
  const std::string start = R"({"target": [{"observable": "largest_force", "tolerance": 1, "value": 20)";
  EXPECT_EQ(desk.fault_of_targets("to.json", start + "}]}"), "nothing");
  const std::string fault = desk.fault_of_targets("to.json", start + R"(, "value": 1000}]})");
  EXPECT_NE(fault.find("to.json: "), std::string::npos) << fault;
  EXPECT_NE(fault.find("value"), std::string::npos) << fault;
  EXPECT_NE(desk.fault_of_targets("to.json", start + R"(}], "target": []})"), "nothing") << "in the head too";
}

// 200,000 deep: more than the stack holds, were it read or deleted by recursion.
TEST(FileOfTargets, NestedTooDeepIsAnError) {
  const Desk desk;
  constexpr std::size_t deep = 200000;
  const std::string list = std::string(deep, '[') + std::string(deep, ']');
  std::string key = "a";
  for (std::size_t k = 0; k < deep; ++k) key += ".a";
  for (const std::string name : {"name", "value"})
    EXPECT_NE(desk.fault_of_targets("to.json", "{\"target\": [{\"" + name + "\": " + list + "}]}"), "nothing");
  EXPECT_NE(desk.fault_of_targets("to.toml", "[[target]]\nvalue = " + list + "\n").find("to.toml:2: "),
            std::string::npos);
  for (const std::string& text : {"[" + key + "]\n", key + " = 1\n", "x = { " + key + " = 1 }\n"})
    EXPECT_NE(desk.fault_of_targets("to.toml", text).find("to.toml:1: a key of too many parts"), std::string::npos);
}

TEST(CurveFile, HasAHeadingOfTwoNamesEachWithOneUnit) {
  const Desk desk;
  const std::string points = "\n1,2\n2,3\n";
  for (const std::string heading :
       {"force [mm],displacement [N]", "displacement [mm],force [N] [kN]",
        "displacement [mm],force [N] per metre width", "displacement [mm] [m],force [N]",
        "displacement [mm],force [kN]", "displacement [cm],force [N]", "displacement [mm],force", "[mm],[N]",
        "displacement [mm],force [N],", "displacement [mm],force [[N]]", "displacement [mm],force [N]x",
        "displacement [MM],force [N]", "displacement [mm];force [N]", ""}) {
    const std::string fault = desk.fault_of_curve(heading + points);
    EXPECT_NE(fault.find("curve.csv:1: the heading must name"), std::string::npos) << heading << ": " << fault;
    EXPECT_NE(fault.find("displacement in [mm] or [m], the second force or F or Fx or Fy in [N]"), std::string::npos)
        << fault;
  }
  for (const std::string heading : {"displacement [mm],force [N]", " displacement  [ mm ] ,\tforce [N] ",
                                    "\"displacement [mm]\",\"F [N]\"", "Displacement [mm],Force [N]",
                                    "\xEF\xBB\xBF"
                                    "displacement [mm],Fy [N]"})
    EXPECT_EQ(desk.curve(heading + points).mm, (std::vector<double>{1, 2})) << heading;
  EXPECT_EQ(desk.curve("displacement [m],force [N]" + points).mm, (std::vector<double>{1000, 2000}));
}

// A measured horizontal force is no magnitude.
TEST(CurveFile, SaysByItsHeadingWhichComponentItHolds) {
  const Desk desk;
  const auto component = [&](const std::string& heading, const std::string& key) {
    desk.put("curve.csv", "displacement [mm]," + heading + "\n1,2\n2,3\n");
    const std::string text = "[[target]]\ncurve = \"curve.csv\"\ntolerance = 1.0\n";
    try {
      return read_targets(desk.put("to.toml", text + (key.empty() ? "" : "component = \"" + key + "\"\n")), {"stem"})
          .all.at(0)
          .curve->component;
    } catch (const std::invalid_argument& fault) {
      return std::string(fault.what());
    }
  };
  for (const std::string one : {"F", "Fx", "Fy"}) {
    EXPECT_EQ(component(one + " [N]", ""), one);
    EXPECT_EQ(component(one + " [N]", one), one);
    EXPECT_EQ(component("force [N]", one), one) << "the heading names none";
    for (const std::string other : {"F", "Fx", "Fy"}) {
      if (one == other) continue;
      EXPECT_TRUE(component(one + " [N]", other)
                      .ends_with("component is \"" + other + "\", but the heading of curve.csv names \"" + one +
                                 "\": correct one of them, or leave component out"))
          << component(one + " [N]", other);
    }
  }
  EXPECT_EQ(component("force [N]", ""), "F");
  EXPECT_EQ(component("\"fX [ N ]\"", ""), "Fx");
  EXPECT_EQ(component("Fx [N]", "Fz").find("but the heading"), std::string::npos) << "one fault, once";
}

TEST(CurveFile, HoldsDecimalNumbers) {
  const Desk desk;
  const std::string heading = "displacement [mm],force [N]\n1,2\n";
  for (const std::string line : {"0x14,1", "20,0x1p3", "20,inf", "20,nan", "20,", "20,1,", "20,1,2", "20", "20 1,1",
                                 "20,1e", "20,+-1", "20,- 1"}) {
    const std::string fault = desk.fault_of_curve(heading + line + "\n");
    EXPECT_NE(fault.find("curve.csv:3: must be two numbers"), std::string::npos) << line << ": " << fault;
  }
  for (const std::string line : {"20,1e-400", "20,-1e400", "1e400,1"})
    EXPECT_NE(desk.fault_of_curve(heading + line + "\n").find("too small or too large"), std::string::npos) << line;
  EXPECT_EQ(desk.curve(heading + "20,1e-320\n").force.at(1), 1e-320);
  EXPECT_EQ(desk.curve(heading + "+2e1,-.5\n").force.at(1), -0.5);
}

TEST(CurveFile, IsTheSameWithTheLineEndsOfOtherSystems) {
  const Desk desk;
  const auto forces = [&](const std::string& end, const std::string& last) {
    return desk.curve("displacement [mm],force [N]" + end + "1,2" + end + end + "2,3" + last).force;
  };
  for (const std::string end : {"\n", "\r\n"}) {
    for (const std::string& last : {std::string(), end, end + end, end + "  " + end})
      EXPECT_EQ(forces(end, last), (std::vector<double>{2, 3}));
  }
}

// Kept runs are known by it, each with all that it asks.
TEST(Asked, OfALongCurveIsShortAndTellsItFromOthers) {
  CalibrationTarget target;
  target.curve.emplace();
  for (int k = 0; k < 100000; ++k) target.curve->mm.push_back(0.1 * k);
  const std::string whole = target.asked();
  EXPECT_LT(whole.size(), 100U);
  target.curve->mm.back() += 1e-9;
  EXPECT_NE(target.asked(), whole);
  target.curve->mm.pop_back();
  EXPECT_NE(target.asked(), whole);
}

// Forty residuals 5 atan(20 (x - 0.35)), of a least at 0.35. From 0.5 a whole step goes to 0, where they are larger.
Slopes bent(double x) {
  const double u = 20 * (x - 0.35);
  const auto all = [](double value) { return Eigen::VectorXd::Constant(40, value); };
  return {all(5 * std::atan(u)), all(1), all(100 / (1 + u * u)), Eigen::VectorXd::Constant(1, x),
          Eigen::VectorXd::Zero(1)};
}
double misfit_of(double x) { return bent(x).residuals.norm(); }

TEST(LinearTheory, ReachesTheLeastByPartsOfAStep) {
  double x = 0.5;
  std::vector<double> shares;
  for (int k = 0; k < 8 && misfit_of(x) > 1e-9; ++k) {
    const double step = step_within_ranges(bent(x))[0];
    const auto share = falling_share([&](double part) { return misfit_of(x + part * step); }, misfit_of(x));
    ASSERT_TRUE(share) << x;
    shares.push_back(*share);
    x += *share * step;
  }
  EXPECT_EQ(shares.front(), 0.5);
  EXPECT_NEAR(x, 0.35, 1e-9);
  EXPECT_FALSE(falling_share([](double) { return 1.0; }, 1)) << "not less";
}

TEST(LinearTheory, KnowsWhetherAPointIsALeast) {
  for (const double x : {0.5, 0.2, 0.36}) EXPECT_FALSE(arrived(bent(x), Intervals(bent(x)).half)) << x;
  EXPECT_TRUE(arrived(bent(0.35), Intervals(bent(0.35)).half));
  EXPECT_TRUE(arrived(bent(0.351), Intervals(bent(0.351)).half)) << "off by 0.001; half the interval is 0.003";
}

TEST(LinearTheory, SeesABendAndAJump) {
  const auto all = [](double value) { return Eigen::VectorXd::Constant(3, value); };
  const auto of = [&](double low, double middle, double high, double at = 0.5) {
    return bend(all(low), all(middle), all(high), at, all(1));
  };
  EXPECT_EQ(of(1, 2, 3), 0);
  EXPECT_EQ(of(1, 1.5, 3, 0.25), 0) << "not in the middle";
  EXPECT_NEAR(of(-1, 0.1, 1.4), 2 * 0.1 / 2.4, 1e-12);
  EXPECT_NEAR(of(0, 0, 5), 1, 1e-12) << "a jump on one side";
  EXPECT_NEAR(of(0, 5, 5), 1, 1e-12);
  EXPECT_GT(of(1, 0, 1), 1e9) << "both sides are worse by as much";
  EXPECT_EQ(of(1, 1, 1), 0) << "flat";
  EXPECT_EQ(of(1, 1, 9, 0), 0) << "at the edge of a range";
}

// 10 (x - a) and 10 (x + y - b).
Slopes two_keys(double x, double y, double a, double b, double least) {
  return {Eigen::Vector2d(10 * (x - a), 10 * (x + y - b)), Eigen::Vector2d(1, 1),
          (Eigen::Matrix2d() << 10, 0, 10, 10).finished(), Eigen::Vector2d(x, y), Eigen::Vector2d(least, 0)};
}

TEST(LinearTheory, StaysWithinTheRanges) {
  const Eigen::VectorXd step = step_within_ranges(two_keys(0.5, 0.5, 1.5, 1.8, 0));
  EXPECT_NEAR(step[0], 0.5, 1e-12);
  EXPECT_NEAR(step[1], 0.3, 1e-12) << "the least with x = 1, not that of x = 1.5, which is y = 0.3";
  EXPECT_NEAR(step_within_ranges(two_keys(1, 0.8, 1.5, 1.8, 0)).norm(), 0, 1e-12) << "the least at the edge is one";
}

TEST(LinearTheory, TakesNoStepBetweenTwoIntegers) {
  EXPECT_NEAR(step_within_ranges(two_keys(0.5, 0.5, 0.55, 1, 0.1)).norm(), 0, 1e-12);
  EXPECT_NEAR(step_within_ranges(two_keys(0.5, 0.5, 0.55, 1, 0))[0], 0.05, 1e-12);
}

TEST(Known, IsSaidInWordsWithWhatLimitsIt) {
  EXPECT_EQ(words_of({.key = "a", .value = "2", .low = "1", .high = "3"}), "a = 2, 95 % interval 1 to 3");
  EXPECT_EQ(words_of({.key = "a", .value = "2", .low = "1", .high = "2", .at_edge = true}),
            "a = 2, 95 % interval 1 to 2; it is at the edge of its range");
  EXPECT_EQ(words_of({.key = "a", .value = "2", .low = "", .high = ""}), "a = 2, not identifiable");
  EXPECT_EQ(words_of({.key = "a", .value = "2", .low = "", .high = "", .at_edge = true, .arrived = false}),
            "a = 2, not a minimum yet: try more --points; it is at the edge of its range");
}

TEST(Residual, IsNothingWhereALimitIsKept) {
  CalibrationTarget t;
  t.value = {10, 20};
  t.tolerance = 2;
  const auto of = [&t](Relation relation, const Json& value) {
    t.relation = relation;
    return residuals(t, value, 7).at(0);
  };
  EXPECT_EQ(of(Relation::equals, 14.0), 2);
  EXPECT_EQ(of(Relation::equals, 6.0), -2);
  EXPECT_EQ(of(Relation::below, 6.0), 0);
  EXPECT_EQ(of(Relation::below, 14.0), 2);
  EXPECT_EQ(of(Relation::above, 14.0), 0);
  EXPECT_EQ(of(Relation::above, 6.0), -2);
  EXPECT_EQ(of(Relation::between, 15.0), 0);
  EXPECT_EQ(of(Relation::between, 24.0), 2);
  EXPECT_EQ(of(Relation::equals, "not by the end"), 7) << "what does not happen misses by the stated number";
  EXPECT_EQ(of(Relation::equals, Json()), 7);
}

// One target of two cannot be met: by squares it rules the misfit, bounded it counts at most once.
TEST(Misfit, IsAtMostOneWhereTheLossIsBounded) {
  Targets two;
  two.all.resize(2);
  two.all[0].value = two.all[1].value = {0, 0};
  const Json values = Json::array({100.0, 0.0});
  EXPECT_NEAR(misfit(two, values), 100 / std::sqrt(2), 1e-12);
  two.bounded = true;
  EXPECT_NEAR(misfit(two, values), std::sqrt(0.5 * 1e4 / (1e4 + 1)), 1e-12);
}

TEST(Observables, AreAllKnownByTheirNames) {
  RunRecord run;
  run.force = {{0, 1, 2}, {1, 2, 1}, {0, 0, 0}, {1, 2, 1}};
  for (const std::string& name : observable_names()) EXPECT_NO_THROW(measure(run, name)) << name;
  EXPECT_THROW(measure(run, "none"), std::invalid_argument);
}

// A plate that starts from rest in 0.04 s and then goes on with 0.5 m/s: v t^2/(2 r) within the ramp, v (t - r/2) after it.
TEST(ObservedRun, SaysHowFarThePlateHasGoneThroughItsRamp) {
  const Scene scene = test::plate_beside_disc("end = 0.1", "ramp = 0.04", "frames = [0.02, 0.1]");
  const RunRecord run = observed_run(prepare(scene), scene.time);
  const std::vector<double> mm{0, 2.5, 10, 20, 30, 40};
  ASSERT_EQ(run.force.mm.size(), mm.size());
  for (std::size_t k = 0; k < mm.size(); ++k) EXPECT_NEAR(run.force.mm[k], mm[k], 1e-9) << k;
  ASSERT_EQ(run.frames.size(), 2u);
  EXPECT_NEAR(run.frames[0].mm, 2.5, 1e-9);
  EXPECT_NEAR(run.frames[1].mm, 40, 1e-9);
}

}  // namespace
}  // namespace furrow::validation
