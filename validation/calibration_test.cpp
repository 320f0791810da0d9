// Calibration on scenes whose answer is known: synthetic curves with noise that was put in.
#include "validation/calibration/calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <random>
#include <set>

#include "scene/read.h"
#include "tests/bent_stem.h"
#include "tests/owned_file.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;
using test::OwnDirectory;
using test::text_of;

// A plate bends a small stem, which does not tear. 24 mm, 0.02 CPU s.
const std::string stem = R"(title = "a plate bends a stem"
time = { end = 0.24, step = 1e-4 }
contact = { damping_factor = 0.5, friction = 0 }
output = { interval = 2e-3 }
material = [{ name = "wood", young = 2e5, poisson = 0.3 }, { name = "tool", young = 2e5, poisson = 0.3 }]
)" + test::bent_stem(4, "0.022", "tool");

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

// What the scene gives with a setting, every 0.5 mm, with noise of that standard deviation.
void measure_curve(const fs::path& file, const std::vector<std::pair<const char*, const char*>>& truth, double noise) {
  std::vector<VariedKey> keys;
  Setting setting;
  for (const auto& [key, value] : truth) {
    keys.push_back(VariedKey::of(std::string(key) + "=" + value));
    setting.emplace_back(value);
  }
  const Scene scene = scene_with({"stem", parse_scene(stem, "stem")}, keys, setting, 0);
  const RunRecord run = observed_run(prepare(scene), scene.time);
  std::mt19937_64 random(7);
  std::normal_distribution<double> error(0, noise);
  std::ofstream csv(file);
  csv << "displacement [mm],force [N]\n";
  for (std::size_t k = 2; k < run.force.mm.size(); k += 2)
    csv << run.force.mm[k] << "," << run.force.f[k] + error(random) << "\n";
}

struct Place {
  OwnDirectory directory;
  fs::path at(const std::string& name) const { return directory.path() / name; }
  Place() { write(at("stem.toml"), stem); }
  CalibrationRequest request(std::vector<std::string> vary) const {
    CalibrationRequest asked{
        .scenes = {at("stem.toml")}, .vary = std::move(vary), .targets = at("targets.toml"), .directory = at("out")};
    asked.plan.global_points = 60;
    asked.plan.local_points = 60;
    return asked;
  }
};

constexpr const char* curve_targets = "[[target]]\ncurve = \"curve.csv\"\ntolerance = 0.05\n";
const std::string structural = "lattice[0].structural.stiffness", shear = "lattice[0].shear.stiffness";

std::string error_of(const std::function<void()>& what) {
  try {
    what();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

double number(const std::string& text) { return std::stod(text); }

TEST(Calibration, RecoversTheKeysOfANoisyCurveWithinItsIntervals) {
  const Place place;
  measure_curve(place.at("curve.csv"), {{structural.c_str(), "3100"}, {shear.c_str(), "730"}}, 0.05);
  write(place.at("targets.toml"), curve_targets);
  const Calibration found = calibrate(place.request({structural + "=1e3:1e4:log", shear + "=200:2000:log"}));
  ASSERT_EQ(found.identified.known.size(), 2U);
  EXPECT_TRUE(found.identified.flat.empty());
  // The noise has the standard deviation that the tolerance says, so the misfit of the truth is 1 +- 1/sqrt(2 n), n =
  // 59 points: 4 of these are 0.37.
  EXPECT_NEAR(found.best.front().fresh.misfit(), 1, 0.37);
  const double truth[] = {3100, 730};
  for (std::size_t k = 0; k < 2; ++k) {
    const Known& known = found.identified.known[k];
    ASSERT_FALSE(known.low.empty()) << known.key;
    EXPECT_LT(number(known.low), truth[k]) << known.key;
    EXPECT_GT(number(known.high), truth[k]) << known.key;
    EXPECT_LT(number(known.high) / number(known.low), std::sqrt(10)) << known.key << ": half the range at most";
  }
}

// From a point that is no minimum the slopes lead on: what the theory would say about it is not so.
TEST(Identify, GivesNoIntervalAwayFromAMinimum) {
  const Place place;
  measure_curve(place.at("curve.csv"), {{structural.c_str(), "3100"}, {shear.c_str(), "730"}}, 0.05);
  write(place.at("targets.toml"), curve_targets);
  Runs runs({}, 1);
  const Evaluator evaluator({{"stem", parse_scene(stem, "stem")}},
                            {VariedKey::of(structural + "=1e3:1e4:log"), VariedKey::of(shear + "=200:2000:log")},
                            read_targets(place.at("targets.toml"), {"stem"}), runs);
  const auto known_at = [&](const Setting& setting) {
    return identify(evaluator, evaluator.at(setting, {}), {}).known;
  };
  for (const Known& known : known_at({"3100", "730"})) EXPECT_TRUE(known.arrived && !known.low.empty()) << known.key;
  for (const Known& known : known_at({"8000", "300"})) {
    EXPECT_FALSE(known.arrived) << known.key;
    EXPECT_EQ(known.low + known.high, "") << known.key;
  }
}

// Only 1/E* = (1 - nu^2)/E_1 + (1 - nu^2)/E_2 enters the contact.
TEST(Calibration, SaysThatTheTwoModuliOfOneContactCannotBeToldApart) {
  const Place place;
  measure_curve(place.at("curve.csv"), {}, 0.05);
  write(place.at("targets.toml"), curve_targets);
  const Calibration found =
      calibrate(place.request({"material[0].young=1e5:1e6:log", "material[1].young=1e5:1e6:log"}));
  ASSERT_EQ(found.identified.flat.size(), 1U);
  const Flat& flat = found.identified.flat.front();
  EXPECT_LT(flat.direction[0] * flat.direction[1], 0) << "the one goes up as the other goes down";
  EXPECT_TRUE(found.identified.known[0].low.empty());
  EXPECT_TRUE(found.identified.known[1].low.empty());
}

TEST(Calibration, TellsTheSumOfTheTwoWhenOneIsKnown) {
  const Place place;
  measure_curve(place.at("curve.csv"), {}, 0.05);
  write(place.at("targets.toml"), curve_targets);
  const Calibration found = calibrate(place.request({"material[0].young=1e5:1e6:log"}));
  EXPECT_TRUE(found.identified.flat.empty());
  ASSERT_EQ(found.identified.known.size(), 1U);
  EXPECT_LT(number(found.identified.known[0].low), 2e5);
  EXPECT_GT(number(found.identified.known[0].high), 2e5);
}

constexpr const char* statement = "[[target]]\nobservable = \"largest_force\"\nvalue = 8.0\ntolerance = 0.5\n";

TEST(Calibration, ThatBeginsAgainReplaysItsRunsAndFindsTheSame) {
  const Place place;
  write(place.at("targets.toml"), statement);
  CalibrationRequest asked = place.request({structural + "=1e3:1e4:log"});
  asked.plan.global_points = 15;
  asked.plan.local_points = 10;
  const Calibration first = calibrate(asked), second = calibrate(asked);
  EXPECT_GT(first.made, 10);
  EXPECT_EQ(second.made, 0);
  EXPECT_EQ(second.replayed, first.made);
  EXPECT_EQ(first.best.front().searched.setting, second.best.front().searched.setting);
  EXPECT_EQ(first.best.front().searched.misfits, second.best.front().searched.misfits);
}

// As after a kill in the midst of a line.
TEST(Calibration, MakesOnlyTheRunsThatWereCutOff) {
  const Place place;
  write(place.at("targets.toml"), statement);
  CalibrationRequest asked = place.request({structural + "=1e3:1e4:log"});
  asked.plan.global_points = 15;
  asked.plan.local_points = 10;
  const Calibration first = calibrate(asked);
  const fs::path kept = place.at("out") / "runs.jsonl";
  fs::resize_file(kept, fs::file_size(kept) / 2);
  test::make_its_own(kept);
  const Calibration second = calibrate(asked);
  EXPECT_GT(second.replayed, 0);
  EXPECT_GT(second.made, 0);
  EXPECT_EQ(second.made + second.replayed, first.made);
  EXPECT_EQ(calibrate(asked).made, 0) << "the line that was cut did not spoil the next";
  EXPECT_EQ(first.best.front().searched.setting, second.best.front().searched.setting);
}

TEST(Calibration, TakesOtherToleranceWithoutARun) {
  const Place place;
  write(place.at("targets.toml"), statement);
  CalibrationRequest asked = place.request({"lattice[0].damper=axial,full"});
  const Calibration first = calibrate(asked);
  write(place.at("targets.toml"), "[[target]]\nobservable = \"largest_force\"\nvalue = 8.0\ntolerance = 1.0\n");
  const Calibration second = calibrate(asked);
  EXPECT_EQ(second.made, 0);
  EXPECT_NEAR(second.best.front().fresh.misfit(), first.best.front().fresh.misfit() / 2, 1e-12);
}

TEST(Calibration, TriesEveryCombinationOfListedValues) {
  const Place place;
  write(place.at("targets.toml"), statement);
  const Calibration found = calibrate(place.request({"lattice[0].damper=axial,full", structural + "=1e3,2e3,4e3"}));
  EXPECT_EQ(found.points, 6);
  EXPECT_EQ(found.identified.effects.size(), 3U) << "the other damper, two other stiffnesses";
}

TEST(Calibration, OfAKeyThatIsAnIntegerTriesTheIntegersOfItsRange) {
  const Place place;
  write(place.at("targets.toml"), statement);
  const Calibration found = calibrate(place.request({"lattice[0].rows=3:5", structural + "=1e3,4e3"}));
  std::set<std::string> tried;
  for (const Candidate& c : found.best) tried.insert(c.searched.setting[0]);
  for (const std::string& rows : tried) EXPECT_TRUE(rows == "3" || rows == "4" || rows == "5") << rows;
  EXPECT_GT(tried.size(), 1U) << "the key was set";
  for (const Known& known : found.identified.known) EXPECT_TRUE(known.low.empty() || known.low != known.high);
  EXPECT_NE(error_of([&] { calibrate(place.request({"lattice[0].rows=2.5:5"})); }).find("must be an integer"),
            std::string::npos);
}

TEST(Calibration, LeavesASceneFileThatRuns) {
  const Place place;
  write(place.at("targets.toml"), statement);
  const Calibration found = calibrate(place.request({structural + "=1e3,4e3"}));
  write_calibration(found, place.at("out"));
  const Scene best = read_scene(place.at("out") / "best/stem.toml");
  EXPECT_EQ(best.lattice.at(0).structural.stiffness, number(found.best.front().searched.setting[0]));
  const Json json = Json::parse(text_of(place.at("out") / "calibration.json"));
  EXPECT_EQ(json.at("best").at(0).at("setting").at(structural), found.best.front().searched.setting[0]);
  EXPECT_NE(text_of(place.at("out") / "calibration.html").find("Which key moves what"), std::string::npos);
}

// A run that fails is a result, and no better than one that misses by the stated number of tolerances.
TEST(Calibration, OfWhichEveryRunFailsIsAnErrorThatSaysWhy) {
  const Place place;
  write(place.at("targets.toml"), statement);
  try {
    calibrate(place.request({structural + "=1e12,2e12"}));
    FAIL() << "it found something";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("every setting failed"), std::string::npos) << error.what();
  }
}

TEST(Calibration, SaysWhatIsWrongWithAKey) {
  const Place place;
  write(place.at("targets.toml"), statement);
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"contact.friction", "must be KEY=low:high"},
      {"contact.friction=0.9:0.1", "must begin below its end"},
      {"contact.friction=-1:1:log", "must lie above 0"},
      {"contact.friction=a:b", "must be a number"},
      {"contact.frction=0.1:0.9", "did you mean \"friction\"?"},
      {"contact.friction=-0.5:0.9", "contact.friction"},
      {"lattice[3].spacing=0.01:0.02", "there is no item 3"},
      {"lattice[0].damper=axial,ful", "did you mean \"full\"?"},
      {"lattice[0].damper=axial,axial", "names a value twice"},
      {"time.method=pece,foo", "time.method=foo"},
      {"time.method=\"ver,let\",pece", "--vary time.method=\"ver,let\": "},
      {"time.method=\"verlet,pece", "a quote is opened and not closed"},
      {"other:contact.friction=0.1:0.9", "there is no scene \"other\""},
      {"contact.friction,contact.friction=0.1:0.9", "is varied twice"}};
  for (const auto& [key, message] : wrong) {
    const std::string error = error_of([&, &vary = key] { calibrate(place.request({vary})); });
    EXPECT_NE(error.find(message), std::string::npos) << key << ": " << error;
  }
}

TEST(Calibration, SaysWhatIsWrongWithTargets) {
  const Place place;
  write(place.at("falls.csv"), "displacement [mm],force [N]\n1,2\n0.5,3\n");
  write(place.at("units.csv"), "displacement,force\n1,2\n2,3\n");
  write(place.at("far.csv"), "displacement [m],force [N]\n0.001,2\n0.1,3\n");
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"", "there is no [[target]]"},
      {"[[target]", "targets.toml:1"},
      {"[[target]]\nobservable = \"largest_forc\"\nvalue = 1.0\ntolerance = 1.0", "did you mean \"largest_force\"?"},
      {"[[target]]\nobservable = \"largest_force\"\nvalue = 1.0", "tolerance is missing"},
      {"[[target]]\nobservable = \"largest_force\"\nvalue = 1.0\ntolerance = 0.0", "tolerance must be above 0, not 0"},
      {"[[target]]\nobservable = \"largest_force\"\ntolerance = 1.0", "value is missing"},
      {"[[target]]\nobservable = \"largest_force\"\nvalue = 1.0\ntolerance = 1.0\nwieght = 2.0",
       "did you mean \"weight\"?"},
      {"[[target]]\nobservable = \"largest_force\"\nvalue = [2.0, 1.0]\nrelation = \"between\"\ntolerance = 1.0",
       "rising"},
      {"[[target]]\nscene = \"root\"\nobservable = \"largest_force\"\nvalue = 1.0\ntolerance = 1.0",
       "scene must be one of"},
      {"[[target]]\ncurve = \"falls.csv\"\ntolerance = 1.0", "falls.csv:3: the displacement must rise"},
      {"[[target]]\ncurve = \"units.csv\"\ntolerance = 1.0", "units.csv:1: the heading must name"},
      {"[[target]]\ncurve = \"far.csv\"\ntolerance = 1.0", "asks for 100 mm of displacement"},
      {"[[target]]\nobservable = \"largest_force\"\nvalue = -inf\ntolerance = 1.0", "value must be finite, not -inf"},
      {"[[target]]\nobservable = \"largest_force\"\nvalue = nan\ntolerance = 1.0", "value must be finite, not nan"},
      {"[[target]]\ncurve = \"none.csv\"\ntolerance = 1.0", "cannot read"}};
  for (const auto& [text, message] : wrong) {
    write(place.at("targets.toml"), text);
    const std::string error = error_of([&] { calibrate(place.request({"contact.friction=0.1,0.2"})); });
    EXPECT_NE(error.find(message), std::string::npos) << text << ": " << error;
  }
}

TEST(Calibration, ReadsTheSameTargetsFromJson) {
  const Place place;
  write(place.at("targets.toml"), statement);
  write(place.at("targets.json"), R"({"target": [{"observable": "largest_force", "value": 8.0, "tolerance": 0.5}]})");
  const Targets a = read_targets(place.at("targets.toml"), {"stem"}),
                b = read_targets(place.at("targets.json"), {"stem"});
  EXPECT_EQ(a.all.at(0).asked(), b.all.at(0).asked());
  EXPECT_EQ(a.all.at(0).value, b.all.at(0).value);
}

}  // namespace
}  // namespace furrow::validation
