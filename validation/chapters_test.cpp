// What the chapters of the page say of the studies that are kept: one name for each thing, and what each number is of.
#include "validation/page/chapters/chapters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace furrow::validation {
namespace {

const Shelf& kept() {
  static const Shelf shelf(std::filesystem::path(FURROW_SOURCE_DIR) / "reference_data/studies");
  return shelf;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const Json& headline_of(const Json& report, const std::string& tile) {
  for (const Json& headline : report.at("headlines"))
    if (headline.at("tile") == tile) return headline;
  static const Json none{{"value", ""}, {"text", ""}};
  return none;
}

const Json& part_of(const Json& report, const std::string& key, const std::string& begin) {
  for (const Json& part : report.at("parts"))
    if (part.contains(key) && part.at(key).get<std::string>().starts_with(begin)) return part;
  static const Json none = Json::object();
  return none;
}

// All that a reader sees of a chapter but its drawings.
void collect(const Json& value, std::string& text) {
  if (value.is_string()) text += value.get<std::string>() + "\n";
  if (value.is_array())
    for (const Json& item : value) collect(item, text);
  if (!value.is_object()) return;
  for (const auto& [key, item] : value.items())
    if (!std::set<std::string>{"id", "links", "file", "name", "script", "variables", "blocks"}.contains(key))
      collect(item, text);
}

TEST(Chapters, CallASceneByOneName) {
  for (const Study& study : catalogue()) {
    std::string text;
    collect(study.chapter(kept()).json(), text);
    EXPECT_GT(text.size(), 500u) << study.name;
    for (const char* other : {"scenario_", "first scene's", "second scene", "third scene"})
      EXPECT_FALSE(has(text, other)) << study.name << ": " << text.substr(text.find(other) - 60, 120);
  }
}

TEST(Chapters, SayInTheTileWhereItBreaksOfOneMoment) {
  const std::string text = headline_of(stability(kept()).json(), "breaks").at("text");
  EXPECT_TRUE(has(text, "as the plate starts")) << text;
  for (const char* scene : {"scene 2, discs: ", "scene 2, spheres: ", "scene 3, discs: "})
    EXPECT_TRUE(has(text, scene)) << text;
  for (const char* other : {"scene 1", "at the lattice", "start: "}) EXPECT_FALSE(has(text, other)) << text;
}

TEST(Chapters, SayOfEachMarkOfTheAtlasWhichMomentItIsOf) {
  const Json report = stability(kept()).json();
  const Json& atlas = part_of(report, "name", "stability_atlas");
  const std::string caption = atlas.at("caption");
  ASSERT_GT(atlas.at("blocks").at("points").size(), 2u);
  for (const Json& point : atlas.at("blocks").at("points")) {
    const std::string label = point[2];
    EXPECT_TRUE(has(caption, label + ": as the plate ")) << label << " in " << caption;
    EXPECT_TRUE(label.ends_with(" s")) << label;
  }
}

// Two programs in one number: the law and the evaluations of both.
TEST(Chapters, SayOfRivalsWhatLawAndHowManyEvaluationsTheyHave) {
  const Json report = speed(kept()).json();
  const std::string text = headline_of(report, "engines").at("text");
  EXPECT_TRUE(has(text, " (the same law")) << text;
  EXPECT_TRUE(has(text, ", 1 evaluation a step) in that bed as furrow with one evaluation")) << text;
  const auto ratio_of = [](const Json& b) { return b.at("ratio")[1].get<double>(); };
  double same = infinity, another = infinity;
  for (const Json& b : kept().of("speed").find("rivals.json")->value.at("benchmarks")) {
    if (b.value("aggregate_name", "") != "median" || !b.value("agrees", false)) continue;
    if (b.at("run_name").get<std::string>().rfind("furrow", 0) == 0) continue;
    double& least = b.at("label").get<std::string>().rfind("the same law", 0) == 0 ? same : another;
    least = std::min(least, ratio_of(b));
  }
  EXPECT_EQ(has(text, "The fastest has another law: "), another < same) << text;
  int rivals = 0;
  for (const Json& claim : report.at("claims")) {
    const std::string words = claim.at("text");
    if (!has(words, "fastest rival")) continue;
    ++rivals;
    EXPECT_TRUE(has(words, "1 evaluation a step), over that of ")) << words;
  }
  EXPECT_EQ(rivals, 2);
}

TEST(Chapters, GiveWhatIsYesOrNoNoIntervalOfOnes) {
  int asked = 0;
  const Json judged = statements(kept()).json(), read = readings_of_the_paper(kept()).json();
  for (const Json& row : part_of(judged, "caption", "Every statement").at("rows")) {
    if (!has(row[4].get<std::string>(), "come to their end")) continue;
    ++asked;
    EXPECT_EQ(row[6], "–") << row;
    EXPECT_EQ(row[7], "–") << row;
  }
  EXPECT_EQ(asked, 5) << "scene 1, and two scenes in two readings";
  for (const Json& row : part_of(read, "caption", "Sentences of the paper").at("rows"))
    if (row[2].is_string()) {
      EXPECT_FALSE(has(row[2].get<std::string>() + ";", "at 1;")) << row;
    }
}

TEST(Chapters, NameEachMethodOnAParetoFrontOnce) {
  const Json report = work_precision(kept()).json();
  const Json& blocks = part_of(report, "name", "work_precision_summary").at("blocks");
  std::set<std::pair<int, std::string>> fronts, names;
  for (const Json& row : blocks.at("fronts")) fronts.emplace(row[0].get<int>(), row[3].get<std::string>());
  for (const Json& row : blocks.at("names"))
    EXPECT_TRUE(names.emplace(row[0].get<int>(), row[5].get<std::string>()).second) << row;
  EXPECT_GT(fronts.size(), 20u);
  EXPECT_EQ(names, fronts);
  // In pixels of a panel, 350 by 175, as pareto.gp draws it: names of 6.6 a letter and 14 high lie within, side by side.
  std::map<int, std::vector<std::array<double, 4>>> boxes;
  for (const Json& row : blocks.at("names")) {
    const Json& panel = blocks.at("panels").at(row[0].get<std::size_t>());
    const auto within = [&](double value, int low, int high) {
      return std::log10(value / panel[low].get<double>()) /
             std::log10(panel[high].get<double>() / panel[low].get<double>());
    };
    const double x = 350 * within(row[3].get<double>(), 1, 2), y = 175 * within(row[4].get<double>(), 3, 4);
    const double length = 6.6 * static_cast<double>(row[5].get<std::string>().size());
    EXPECT_TRUE(x > 0 && x + length <= 350 && y - 7 > 0 && y + 7 <= 175) << row;
    for (const auto& [left, right, low, top] : boxes[row[0].get<int>()])
      EXPECT_FALSE(x < right - 0.01 && left + 0.01 < x + length && y - 7 < top - 0.01 && low + 0.01 < y + 7) << row;
    boxes[row[0].get<int>()].push_back({x, x + length, y - 7, y + 7});
  }
}

// Who has no script, or no pointer, finds the names there.
TEST(Chapters, NameEachCurveInTheDataOfAChart) {
  const Json report = work_precision(kept()).json();
  const Json& chart = part_of(report, "name", "work_precision_scenario_1");
  std::set<std::string> names;
  for (const char* block : {"curves_evaluations", "curves_cpu", "failures_cpu"})
    for (const Json& row : chart.at("blocks").at(block))
      names.insert(row.back().is_string() ? row.back() : Json("none"));
  EXPECT_TRUE(names.contains("pece") && names.contains("ab2") && !names.contains("none"));
}

}  // namespace
}  // namespace furrow::validation
