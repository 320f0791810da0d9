// Calibrations in which nothing is compared, or a key is varied twice: none of them recommends a setting.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "scene/read.h"
#include "system/ode.h"
#include "tests/bent_stem.h"
#include "tests/files.h"
#include "validation/calibration/calibration.h"
#include "validation/calibration/says.h"
#include "validation/page/observables.h"

namespace furrow::validation {
namespace {

const std::string twig = test::bent_twig();
const std::string stiffness = "lattice[0].structural.stiffness";

struct Bench {
  test::OwnDirectory directory;
  Bench() {
    put("twig.toml", twig);
    put("other.toml", twig);
    put("near.csv", "displacement [mm],force [N]\n2,1\n9,3\n");
  }
  std::filesystem::path at(const std::string& name) const { return directory.path() / name; }
  void put(const std::string& name, const std::string& text) const { std::ofstream(at(name)) << text; }
  Calibration of(const std::string& targets, const std::vector<std::string>& vary,
                 const std::vector<std::string>& scenes = {"twig"}, const std::filesystem::path& out = {}) const {
    put("to.toml", targets);
    CalibrationRequest asked{.scenes = {}, .vary = vary, .targets = at("to.toml"), .directory = out};
    for (const std::string& scene : scenes) asked.scenes.push_back(at(scene + ".toml"));
    asked.plan.global_points = 5;
    asked.plan.local_points = 3;
    return calibrate(asked);
  }
};

template <class Fault = std::exception>
std::string said_by(const std::function<void()>& what) {
  try {
    what();
  } catch (const Fault& fault) {
    return fault.what();
  }
  return "nothing";
}

std::string targeted(const std::string& keys) { return "[[target]]\n" + keys + "\n"; }
std::string valued(const std::string& observable, const std::string& keys = "value = 1.0\ntolerance = 1.0") {
  return targeted("observable = \"" + observable + "\"\n" + keys);
}
std::string worded(const std::string& observable, const std::string& said) {
  return valued(observable, "relation = \"says\"\nvalue = \"" + said + "\"");
}
const std::string near_curve = targeted("curve = \"near.csv\"\ntolerance = 0.5");

TEST(CalibrationRefuses, TargetsThatNoRunCouldSay) {
  const Bench bench;
  bench.put("before.csv", "displacement [mm],force [N]\n-20,0\n-10,0\n");
  const std::vector<std::pair<std::string, std::string>> wrong{
      {targeted("curve = \"before.csv\"\ntolerance = 1.0"), "before.csv:2: the displacement must not be below 0"},
      {valued("mean_force", "window = [-50.0, -10.0]\nvalue = 1.0\ntolerance = 1.0"), "must not begin below 0"},
      {valued("mean_force", "window = [5.0, 10.5]\nvalue = 1.0\ntolerance = 1.0"), "the plate goes 10 mm"},
      {valued("split", "window = [0.0, 5.0]\nvalue = 1.0\ntolerance = 1.0"), "window has no effect on split"},
      {worded("largest_force", "foo"), "largest_force says a number, no words"},
      {worded("split", "yess"), "the words of split are \"not by the end\", not \"yess\""},
      {worded("pieces", "no splitt"), "did you mean \"no split\"?"},
      {worded("first_structural_tear_place", "row 0"), "\"none torn\" or a place such as \"row 1, column 1 (fixed)"},
      {valued("first_structural_tear_place"), "first_structural_tear_place says words, no number"}};
  for (const auto& one : wrong) {
    const auto& text = one.first;
    const auto& message = one.second;
    const std::string error = said_by<std::invalid_argument>([&] { bench.of(text, {stiffness + "=1e3,2e3"}); });
    EXPECT_NE(error.find(message), std::string::npos) << text << error;
  }
}

TEST(CalibrationRefuses, TolerancesAndWeightsThatCompareNothing) {
  const Bench bench;
  const auto of = [](const char* value, const char* tolerance, const std::string& more = "") {
    return valued("largest_force", std::string("value = ") + value + "\ntolerance = " + tolerance + "\n" + more);
  };
  const std::string same = of("1.0", "1.0");
  const std::vector<std::pair<std::string, std::string>> wrong{
      {of("1.0", "1e-300"), "tolerance must be from 1e-12 to 1e+12, not 1e-300"},
      {of("0.0", "1e-300"), "tolerance must be from 1e-12 to 1e+12"},
      {of("1e308", "1e-10"), "tolerance must be from 1e-09 to 1e+09 times the value, 1e+308, not 1e-10"},
      {of("1.0", "1e10"), "times the value, 1, not 1e+10"},
      {targeted("curve = \"near.csv\"\ntolerance = 1e-10"), "times the largest force of the curve, 3, not 1e-10"},
      {of("1.0", "1.0", "weight = 1e-320"), "weight must be from 1e-06 to 1e+06"},
      {of("1.0", "1.0", "weight = 0.0"), "weight must be above 0"},
      {"missing = 0.5\n" + same, "missing must be from 1 to 1e+06, not 0.5"},
      {same + same, "target 2: wants the same as target 1"},
      {of("1.0", "1.0", "name = \"a\"") + of("2.0", "1.0", "name = \"a\""), "is named \"a\", as target 1"}};
  for (const auto& one : wrong) {
    const auto& text = one.first;
    const auto& message = one.second;
    const std::string error = said_by<std::invalid_argument>([&] { bench.of(text, {stiffness + "=1e3,2e3"}); });
    EXPECT_NE(error.find(message), std::string::npos) << text << error;
  }
  const std::string alone = said_by([&] {
    bench.of(valued("largest_force", "scene = \"twig\"\nvalue = 1.0\ntolerance = 1.0"), {stiffness + "=1e3,2e3"},
             {"twig", "other"});
  });
  EXPECT_NE(alone.find("no [[target]] is of scene \"other\""), std::string::npos) << alone;
}

TEST(CalibrationRefuses, AKeyThatIsVariedTwiceHoweverItIsWritten) {
  const Bench bench;
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"contact.friction=0:0.5", "twig:contact.friction=0.1:0.2"}, "contact.friction of twig is varied twice, by"},
      {{"twig:contact.friction=0:0.5", "contact.friction=0.1,0.2"}, "contact.friction of twig is varied twice"},
      {{stiffness + "=1e3,2e3", "lattice[00].structural.stiffness=1e3:2e3"}, stiffness + " of twig is varied twice"},
      {{stiffness + "=1e3,2e3", stiffness + ".=1e3,2e3"}, "is varied twice"},
      {{"plate[0].velocity=[0.1, 0],[0.2, 0]", "plate[0].velocity.x=0.1:0.2"}, "velocity.x of twig is varied twice"},
      {{"plate[0].velocity.x=0.1:0.2", "plate[0].velocity=[0.1, 0],[0.2, 0]"}, "velocity of twig is varied twice"},
      {{stiffness + "=1e3,1000.0"}, "names a value twice"},
      {{stiffness + "=1e3"}, "one value varies nothing"},
      {{"contact.friction=0.1:0.1"}, "must begin below its end"},
      {{"contact.friction=0:0.5:log"}, "must lie above 0"},
      {{"contact.friction=0.1:0.10000000001"}, "the same to eight digits"},
      {{"model.gravity=-1e308:1e308"}, "the range is too wide"},
      {{"title=x,"}, "a value is empty"},
      {{"title=,x"}, "a value is empty"},
      {{"title=x,,y"}, "a value is empty"},
      {{R"(title="a\",b)"}, "a quote is opened and not closed"},
      {{"title='a,b"}, "a quote is opened and not closed"},
      {{R"(title="a",'a')"}, "names a value twice"},
      {{R"(title="a\"b",'a"b')"}, "names a value twice"},
      {{"packing[0].seed=1,2"}, "a seed only draws another packing"}};
  for (const auto& one : wrong) {
    const auto& vary = one.first;
    const auto& message = one.second;
    const std::string error = said_by<std::invalid_argument>([&] { bench.of(near_curve, vary); });
    EXPECT_NE(error.find(message), std::string::npos) << vary[0] << ": " << error;
  }
  EXPECT_EQ(bench.of(near_curve, {"plate[0].velocity.x=0.1,0.11", "plate[0].velocity.y=0,0.01"}).points, 4)
      << "two numbers of one key are two";
  for (const char* two :
       {R"(title="a\"b",c)", R"(title='a,b',"c")", R"(title="a,'",'"')", R"(title='a\','b')", R"(title="",x)"}) {
    const std::string error = said_by([&] { bench.of(near_curve, {two}); });
    EXPECT_NE(error.find("no key moves any target: 2 settings"), std::string::npos) << two << ": " << error;
  }
}

// By the misfit alone the setting that does not get there would be the best.
TEST(Calibration, PrefersASettingThatReachesTheTarget) {
  const Bench bench;
  bench.put("near.csv", "displacement [mm],force [N]\n2,100\n9,300\n");
  for (const std::string key : {"time.end=0.08,0.1", "plate[0].velocity.x=0.08,0.1"}) {
    const Calibration found = bench.of(near_curve, {key});
    EXPECT_EQ(found.best.front().searched.setting[0], "0.1") << key;
    EXPECT_GT(found.best.front().fresh.misfit(), found.targets.missing);
    EXPECT_LT(found.best.back().fresh.misfit(), found.best.front().fresh.misfit());
    EXPECT_FALSE(whole(found.best.back().fresh));
  }
}

TEST(Calibration, JudgesTheReachBySettingsNotByTheScene) {
  const Bench bench;
  bench.put("near.csv", "displacement [mm],force [N]\n2,1\n12,3\n");
  EXPECT_EQ(bench.of(near_curve, {"time.end=0.1,0.13"}).best.front().searched.setting[0], "0.13");
  const std::string error = said_by<std::invalid_argument>([&] { bench.of(near_curve, {"time.end=0.05:0.1"}); });
  EXPECT_NE(error.find("in twig the plate goes 10 mm"), std::string::npos) << error;
}

TEST(Calibration, OfWhichNoRunSaysATargetIsAnError) {
  const Bench bench;
  const std::vector<std::pair<std::string, std::string>> unsaid{
      {valued("mean_force", "window = [5.05, 5.0500001]\nvalue = 1.0\ntolerance = 1.0"),
       "target \"mean_force\" of twig"},
      {valued("largest_force") + valued("first_tear"), "no run says target \"first_tear\" of twig, in 2 settings"},
      {valued("finished"), "no key moves any target: 2 settings"},
      {valued("largest_force", "value = 1e9\nrelation = \"below\"\ntolerance = 10.0"),
       "each of the 2 settings meets every target"}};
  for (const auto& one : unsaid) {
    const auto& text = one.first;
    const auto& message = one.second;
    const std::string error = said_by<NothingCompared>([&] { bench.of(text, {stiffness + "=1e3,2e3"}); });
    EXPECT_NE(error.find(message), std::string::npos) << text << error;
  }
}

TEST(Calibration, ThatFindsNothingLeavesNoResultOfAnEarlierOne) {
  const Bench bench;
  const std::filesystem::path out = bench.at("out");
  const std::vector<std::string> keys{stiffness + "=1e3,2e3"};
  const auto there = [&](const char* name) { return std::filesystem::exists(out / name); };
  write_calibration(bench.of(near_curve, keys, {"twig"}, out), out);
  for (const char* name : {"calibration.json", "calibration.html", "best/twig.toml"}) EXPECT_TRUE(there(name)) << name;
  bench.put("out/notes.txt", "mine");
  EXPECT_THROW(bench.of(targeted("observable = \"none\""), keys, {"twig"}, out), std::invalid_argument);
  EXPECT_TRUE(there("calibration.json")) << "a call that is wrong changes nothing";
  EXPECT_THROW(bench.of(valued("finished"), keys, {"other"}, out), NothingCompared);
  for (const char* name : {"calibration.json", "calibration.html", "best"}) EXPECT_FALSE(there(name)) << name;
  EXPECT_TRUE(there("runs.jsonl"));
  EXPECT_TRUE(there("notes.txt"));
  write_calibration(bench.of(near_curve, keys, {"twig"}, out), out);
  EXPECT_TRUE(there("best/twig.toml"));
}

TEST(Calibration, OfWhichEveryRunDivergesIsADivergence) {
  const Bench bench;
  const std::string error = said_by<Divergence>([&] { bench.of(near_curve, {stiffness + "=1e12,2e12"}); });
  EXPECT_NE(error.find("every setting failed"), std::string::npos) << error;
}

TEST(Says, TheWordsThatMeasureReturns) {
  RunRecord run;
  run.force = {{0, 1, 2}, {1, 2, 1}, {0, 0, 0}, {1, 2, 1}};
  run.met = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& name : observable_names()) {
    const Measured measured = measure(run, name);
    if (!measured.words.empty()) {
      EXPECT_EQ(fault_of_words(name, measured.words), "");
    }
    if (std::isfinite(measured.value)) {
      EXPECT_TRUE(says_of(name).number) << name;
    }
  }
  EXPECT_EQ(fault_of_words("first_structural_tear_place", "row 1, column 2 (fixed) to row 2, column 2"), "");
}

TEST(Curve, IsComparedWithTheComponentOfItsHeading) {
  const Bench bench;
  bench.put("to.toml", near_curve);
  RunRecord run;
  run.force = {.mm = {0, 5, 10}, .fx = {3, 3, 3}, .fy = {-4, -4, -4}, .f = {5, 5, 5}};
  run.scene.time.end = 0.1;
  run.scene.plate.resize(1);
  run.scene.plate[0].velocity = {0.1, 0};
  const std::vector<std::pair<std::string, double>> all{{"force", 5}, {"F", 5}, {"Fx", 3}, {"Fy", -4}};
  for (const auto& one : all) {
    bench.put("near.csv", "displacement [mm]," + one.first + " [N]\n2,1\n9,3\n");
    EXPECT_EQ(value_of(read_targets(bench.at("to.toml"), {"twig"}).all.at(0), run), Json({one.second, one.second}))
        << one.first;
  }
}

TEST(Curve, IsNotContinuedBeyondTheRun) {
  RunRecord run;
  run.force = {{1, 2, 3}, {1, 2, 1}, {0, 0, 0}, {1, 2, 1}};
  run.scene.time.end = 0.03;
  run.scene.plate.resize(1);
  run.scene.plate[0].velocity = {0.1, 0};
  CalibrationTarget t;
  const auto said = [&](double from, double to) {
    t.curve = MeasuredCurve{.file = {}, .mm = {from, to}, .force = {1, 1}};
    return comparable(t, value_of(t, run));
  };
  EXPECT_TRUE(said(1, 3));
  EXPECT_FALSE(said(0.5, 3)) << "before the first sample";
  EXPECT_FALSE(said(1, 3.5)) << "after the plate has stopped";
  run.force.f[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(said(1, 3));
}

}  // namespace
}  // namespace furrow::validation
