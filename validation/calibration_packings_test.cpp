// Spreads over packings are those of runs that were made: scenes without a packing have none.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>

#include "scene/read.h"
#include "tests/bent_stem.h"
#include "tests/files.h"
#include "validation/calibration/calibration.h"

namespace furrow::validation {
namespace {

// What it gives depends on where the discs are placed.
constexpr const char* bed = R"(title = "a plate meets three discs"
time = { end = 0.1, step = 1e-5 }
output = { interval = 2e-3 }
material = [{ name = "wood", young = 2e7, poisson = 0.3 }]
wall = [{ point = [0.0, 0.0], normal = [0.0, 1.0], material = "wood" }]
[[plate]]
left_edge = -0.012
lower_edge = 0.001
width = 0.01
height = 0.03
velocity = [0.1, 0.0]
material = "wood"
[[packing]]
count = 3
radius_min = 2e-3
radius_max = 3e-3
lower_left = [0.0, 0.0]
upper_right = [0.02, 0.01]
material = "wood"
)";

struct Place {
  test::OwnDirectory directory;
  Place() {
    put("stalk.toml", test::bent_twig());
    put("bed.toml", bed);
  }
  std::filesystem::path at(const std::string& name) const { return directory.path() / name; }
  void put(const std::string& name, const std::string& text) const { std::ofstream(at(name)) << text; }
  // A target for each scene; one key that is in all.
  Calibration of(const std::vector<std::string>& scenes, int packings, std::optional<int> fresh) const {
    std::string targets;
    CalibrationRequest asked{
        .scenes = {}, .vary = {"plate[0].velocity.x=0.1,0.11"}, .targets = at("to.toml"), .directory = {}};
    for (const std::string& scene : scenes) {
      asked.scenes.push_back(at(scene + ".toml"));
      targets += "[[target]]\nscene = \"" + scene + "\"\nobservable = \"mean_force\"\nvalue = 1.0\ntolerance = 1.0\n";
    }
    put("to.toml", targets);
    asked.plan.packings = packings;
    asked.fresh = fresh;
    return calibrate(asked);
  }
  std::string refusal_of(int packings, std::optional<int> fresh) const {
    try {
      of({"stalk"}, packings, fresh);
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "nothing";
  }
};

TEST(Packings, AreRefusedWhereNoSceneHasOne) {
  const Place place;
  EXPECT_TRUE(place.refusal_of(2, {}).starts_with("--packings 2: no scene has a packing, ")) << place.refusal_of(2, {});
  EXPECT_TRUE(place.refusal_of(1, 5).starts_with("--fresh 5: no scene has a packing, ")) << place.refusal_of(1, 5);
  const Candidate best = place.of({"stalk"}, 1, {}).best.front();
  for (const Point& point : {best.searched, best.fresh}) {
    EXPECT_EQ(point.misfits.size(), 1U);
    EXPECT_TRUE(std::isnan(point.spread())) << "one run has none";
  }
}

TEST(Packings, AreAsManyAsWereAskedForIfOneSceneHasOne) {
  const Place place;
  for (const std::vector<std::string>& scenes : {std::vector<std::string>{"bed"}, {"stalk", "bed"}}) {
    const Candidate best = place.of(scenes, 2, 3).best.front();
    EXPECT_EQ(best.searched.misfits.size(), 2U);
    EXPECT_EQ(best.fresh.misfits.size(), 3U);
    EXPECT_GT(best.fresh.spread(), 0);
    EXPECT_EQ(place.of(scenes, 1, {}).best.front().fresh.misfits.size(), 5U);
  }
}

// A range and a list: either compares a point with its neighbours, packing by packing.
TEST(Identify, TakesAPointWithAValueOfEachPackingAndTarget) {
  const Place place;
  place.put("to.toml", "[[target]]\nobservable = \"largest_force\"\nvalue = 1.0\ntolerance = 1.0\n");
  for (const std::string values : {"1e3,2e3", "1e3:2e3"}) {
    Runs runs({}, 1);
    const Evaluator evaluator({{"stalk", read_scene(place.at("stalk.toml"))}},
                              {VariedKey::of("lattice[0].structural.stiffness=" + values)},
                              read_targets(place.at("to.toml"), {"stalk"}), runs);
    const Setting setting = combinations(evaluator.keys()).front();
    EXPECT_THROW(evaluator.at(setting, {0, 2}), std::logic_error) << "the second would be a copy";
    const Point whole = evaluator.at(setting, {});
    EXPECT_NO_THROW(identify(evaluator, whole, {}));
    Point twice = whole, none = whole;
    twice.values.push_back(whole.values.front());
    twice.misfits.push_back(whole.misfits.front());
    none.values.front().clear();
    for (const Point& wrong : {twice, none}) {
      EXPECT_THROW(identify(evaluator, wrong, {}), std::logic_error) << values;
      EXPECT_THROW(stepped(evaluator, wrong, {}), std::logic_error) << values;
    }
  }
}

}  // namespace
}  // namespace furrow::validation
