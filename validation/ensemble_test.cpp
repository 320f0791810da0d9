// A kept ensemble is taken if it is whole and of the same scenes and model; what is judged by it is judged as said.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "output/files.h"
#include "report/seal.h"
#include "validation/page/chapters/chapters.h"
#include "validation/studies/few_members.h"
#include "validation/studies/kept_ensemble.h"
#include "validation/studies/statements.h"
#include "validation/studies/verdict.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct Place {
  fs::path path = fs::temp_directory_path() / ("furrow_ensemble_" + std::to_string(getpid()));
  Place() { fs::create_directories(path); }
  ~Place() { fs::remove_all(path); }
};

// Of made-up members, but for the one of scene 1, which runs in milliseconds.
const Numbers& sound() {
  static const Numbers numbers = [] {
    Numbers all("ensemble", "full");
    const Maker maker = this_maker({});
    const Json made_up{{"surface", 0.1}, {"mean_force", 1.0}, {"largest_force_discs", 2.0}, {"force_ratio", 3.0}};
    for (const std::string& key : ensemble_keys(false)) all.add({.key = key, .value = made_up}, maker);
    for (const Member& member : paper_members(false)) {
      const Task task = member.task();
      all.add({.key = task.key, .input = task.input, .value = member.scene == "scenario_1" ? task.run() : made_up},
              maker);
    }
    return all;
  }();
  return numbers;
}

Json& result(Json& kept, const std::string& key) {
  for (Json& one : kept["results"]) {
    if (one["key"] == key) return one;
  }
  throw std::out_of_range(key);
}

// With its names beside its numbers, so that either can be spoilt.
Json& says(Json& kept, const std::string& key) {
  Json& one = result(kept, key);
  if (one.contains("names")) {
    const Json& names = kept["names"][one["names"].get<std::size_t>()];
    Json value;
    for (std::size_t k = 0; k < names.size(); ++k) value[names[k].get<std::string>()] = one["value"][k];
    one["value"] = std::move(value);
    one.erase("names");
  }
  return one["value"];
}

void remove(Json& kept, const std::string& group) {
  Json left = Json::array();
  for (const Json& one : kept["results"]) {
    if (!one["key"].get<std::string>().starts_with(group)) left.push_back(one);
  }
  kept["results"] = left;
}

struct Way {
  const char* name;
  std::function<void(Json&)> spoil;
};

const std::vector<Way>& ways() {
  static const std::vector<Way> all{
      {"null", [](Json& e) { e = nullptr; }},
      {"empty", [](Json& e) { e = Json::object(); }},
      {"of another study", [](Json& e) { e["study"] = "order"; }},
      {"of the quick form", [](Json& e) { e["form"] = "quick"; }},
      {"no results", [](Json& e) { e.erase("results"); }},
      {"results are text", [](Json& e) { e["results"] = "x"; }},
      {"one member less", [](Json& e) { remove(e, "scenario_2 disc 51"); }},
      {"one member more", [](Json& e) { result(e, "scenario_2 disc 51")["key"] = "scenario_2 disc 101"; }},
      {"one too many",
       [](Json& e) {
         e["results"].push_back(result(e, "scenario_2 disc 51"));
         e["results"].back()["key"] = "scenario_2 disc 101";
       }},
      {"without a reading", [](Json& e) { remove(e, "scenario_3 sphere"); }},
      {"without scene 1", [](Json& e) { remove(e, "scenario_1"); }},
      {"without a changed model", [](Json& e) { remove(e, changes()[3].key(2)); }},
      {"an empty member", [](Json& e) { says(e, "scenario_2 disc 8") = Json::object(); }},
      {"a member is a number", [](Json& e) { says(e, "scenario_2 disc 8") = 1.5; }},
      {"a number is null", [](Json& e) { says(e, "scenario_2 disc 8")["force_ratio"] = nullptr; }},
      {"a number is NaN", [](Json& e) { says(e, "scenario_2 disc 8")["force_ratio"] = std::nan(""); }},
      {"a list is empty", [](Json& e) { says(e, "scenario_2 disc 8")["force_by_way"] = Json::array(); }},
      {"a list holds null",
       [](Json& e) {
         says(e, "scenario_2 disc 8")["force_by_way"] = {1.5, nullptr};
       }},
      {"a list holds words",
       [](Json& e) {
         says(e, "scenario_2 disc 8")["force_by_way"] = {1.5, "2"};
       }},
      {"no mean force", [](Json& e) { says(e, "scenario_3 disc 8").erase("mean_force"); }},
      {"surface is text", [](Json& e) { says(e, "scenario_3 disc 8")["surface"] = "0.07"; }},
  };
  return all;
}

std::string wrong_with(const fs::path& file) {
  try {
    return unusable_ensemble(Numbers::read(file));
  } catch (const FileError& error) {
    return error.what();
  }
}

Json json_of(const fs::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream);
}

TEST(KeptEnsemble, TheOneInTheTreeCanBeUsed) {
  EXPECT_EQ(wrong_with(fs::path(FURROW_SOURCE_DIR) / "reference_data/studies/ensemble.json"), "");
}

TEST(KeptEnsemble, EveryWayToSpoilItMakesItUnusable) {
  Place place;
  const fs::path file = place.path / "ensemble.json";
  sound().write(file);
  EXPECT_EQ(wrong_with(file), "");
  const Json whole = json_of(file);
  for (const Way& way : ways()) {
    Json spoilt = whole;
    way.spoil(spoilt);
    for (const bool sealed : {false, true}) {
      if (sealed && spoilt.is_object()) seal(spoilt);
      std::ofstream(file) << spoilt.dump();
      EXPECT_NE(wrong_with(file), "") << way.name << (sealed ? ", sealed" : "");
    }
  }
  Json changed = whole;
  says(changed, "scenario_2 disc 8")["mean_force"] = 1.5;
  std::ofstream(file) << changed.dump();
  EXPECT_NE(wrong_with(file), "") << "changed by hand";
}

TEST(KeptEnsemble, OneOfAnotherModelOrSceneIsNotTaken) {
  Place place;
  const std::string key = "scenario_1 disc 1";
  const auto taken = [&](const Numbers& numbers) {
    numbers.write(place.path / "ensemble.json");
    return kept_ensemble(place.path, {"scenario_1 disc"}).at("scenario_1 disc").size();
  };
  EXPECT_EQ(taken(sound()), 1u);
  Result of_another_model = *sound().find(key), of_another_scene = of_another_model;
  of_another_model.value["mean_force"] = 2 * of_another_model.value["mean_force"].get<double>();
  of_another_scene.input = sound().find("scenario_2 disc 1")->input;
  for (const Result& one : {of_another_model, of_another_scene}) {
    Numbers foreign = sound();
    foreign.add(one, foreign.makers()[0]);
    EXPECT_THROW(taken(foreign), FileError);
  }
}

TEST(KeptEnsemble, AMissingOneIsAnError) {
  Place place;
  EXPECT_THROW(kept_ensemble(place.path), FileError);
}

TEST(FewMembers, ANormOfNothingOrOfOneNumberIsStrange) {
  const Json member{{"surface", 0.1}, {"mean_force", 1.0}, {"largest_force_discs", 2.0}, {"force_ratio", 3.0}};
  const std::vector<Json> five(5, member);
  EXPECT_TRUE(std::isinf(strangeness(five, norm_of({}))));
  EXPECT_TRUE(std::isinf(strangeness(five, norm_of({member}))));
  EXPECT_TRUE(std::isinf(strangeness(five, norm_of(five)))) << "without deviation";
  EXPECT_TRUE(std::isinf(strangeness({}, norm_of({member, member}))));
}

// ---- the statements that are judged by it ----

Numbers gaps_tried() {
  Numbers numbers("statements", "full");
  for (const Gap& gap : gaps(false)) numbers.add({.key = gap.key(), .value = {{"failed", "x"}}}, this_maker({}));
  return numbers;
}

Shelf shelf_with(const Numbers& ensemble) {
  Shelf shelf{fs::path()};
  shelf.put(gaps_tried());
  shelf.put(ensemble);
  return shelf;
}

TEST(StatementsChapter, HasWordsForEveryGap) {
  const Json report = statements(shelf_with(sound())).json();
  std::size_t rows = 0;
  for (const Gap& gap : gaps(false)) rows += gap.shown.size();
  EXPECT_EQ(report.at("parts").back().at("rows").size(), rows);
}

TEST(StatementsChapter, WithoutAWholeEnsembleIsAnErrorThatSaysHowToMakeIt) {
  Shelf without{fs::path()};
  without.put(gaps_tried());
  for (const Shelf& shelf : {without, shelf_with(Numbers("ensemble", "quick"))}) {
    try {
      statements(shelf);
      ADD_FAILURE() << "a chapter without an ensemble";
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("furrow study ensemble"), std::string::npos) << error.what();
    }
  }
}

// A paper's number of 100 and 20 members around a median that is `off` from it, spread by 1.
std::string verdict_on(double off) {
  Statement statement;
  statement.value = 100;
  std::vector<Json> members;
  for (int k = 0; k < 20; ++k) members.push_back({{"x", 100 + off + (k - 9.5) / 19}});
  return verdict_of(statement, sample_of("x", members));
}

TEST(Verdict, OfANumberGoesByItsDistanceFromTheMedian) {
  EXPECT_EQ(verdict_on(0), "reproduced");
  EXPECT_EQ(verdict_on(9), "reproduced") << "within a tenth";
  EXPECT_EQ(verdict_on(-11), "reproduced in kind");
  EXPECT_EQ(verdict_on(33), "reproduced in kind") << "within a third";
  EXPECT_EQ(verdict_on(34), "not reproduced");
}

TEST(Verdict, OfALimitGoesByTheShareThatKeepsIt) {
  Statement by;
  by.value = 50;
  by.relation = "by";
  const auto verdict_for = [&](int keeping) {
    std::vector<Json> members(20, {{"x", "not by the end"}});
    for (int k = 0; k < keeping; ++k) members[static_cast<std::size_t>(k)] = {{"x", 40.0}};
    return verdict_of(by, sample_of("x", members));
  };
  EXPECT_EQ(verdict_for(10), "reproduced");
  EXPECT_EQ(verdict_for(1), "reproduced in kind");
  EXPECT_EQ(verdict_for(0), "not reproduced");
}

TEST(Verdict, WhatNoMemberSaysIsNotTestable) {
  Statement statement;
  statement.value = 100;
  EXPECT_EQ(verdict_of(statement, sample_of("x", {})), "not testable");
  EXPECT_EQ(verdict_of(statement, sample_of("x", {{{"x", "no split"}}})), "not reproduced");
}

}  // namespace
}  // namespace furrow::validation
