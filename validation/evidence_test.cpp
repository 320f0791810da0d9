// What is kept and used again is shown to be whole and of the same program; what is missing is named.
#include "validation/page/evidence.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>

#include "output/files.h"
#include "report/seal.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/faults.h"
#include "validation/page/verification.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct Place {
  fs::path path = fs::temp_directory_path() / ("furrow_evidence_" + std::to_string(getpid()));
  Place() { fs::create_directories(path); }
  ~Place() { fs::remove_all(path); }
};

fs::path reference(const std::string& name) { return fs::path(FURROW_SOURCE_DIR) / "reference_data" / name; }

Json json_of(const fs::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream);
}

void write(const fs::path& file, const Json& json) { std::ofstream(file) << json.dump(); }

struct Way {
  const char* name;
  std::function<void(Json&)> spoil;
};

// ---- what the page rests on ----

TEST(Evidence, AllInTheTreeCanBeShown) {
  EXPECT_EQ(unusable_faults(reference("faults.json")), "");
  const Evidence of_the_tree{{}, {}, reference("studies"), catalogue()};
  for (const std::string& name : studies_of_the_page()) EXPECT_EQ(unusable_study(of_the_tree, name), "");
}

TEST(Evidence, AMissingStudyOrFaultFileIsNamed) {
  Place place;
  const auto missing =
      missing_evidence({place.path / "checks.json", place.path / "faults.json", place.path / "studies", catalogue()});
  ASSERT_EQ(missing.size(), 2 + studies_of_the_page().size());
  EXPECT_EQ(missing[0], "cannot read " + (place.path / "checks.json").string() + "; made by: scripts/test");
  EXPECT_EQ(missing[1], "cannot read " + (place.path / "faults.json").string() + "; made by: scripts/faults");
  EXPECT_EQ(missing[2], "cannot read " + (place.path / "studies" / (studies_of_the_page()[0] + ".json")).string() +
                            "; made by: scripts/studies " + studies_of_the_page()[0]);
  EXPECT_EQ(missing_evidence({}).size(), 0u) << "what was not asked for is not missing";
}

TEST(Evidence, ASceneOfThePlayersThatIsNotThereIsNamed) {
  const Place place;
  const fs::path there = place.path / "there.toml", absent = place.path / "best_reading/scenario_1.toml";
  std::ofstream(there) << "title = \"a scene\"\n";
  Evidence evidence;
  evidence.scenes = {there, absent, place.path};
  const std::vector<std::string> missing = missing_evidence(evidence);
  ASSERT_EQ(missing.size(), 2u) << "a directory is no scene";
  EXPECT_EQ(missing[0],
            "cannot read " + absent.string() + ", whose run the players show; it comes with the source tree");
}

TEST(Evidence, WhatWasNotAskedForIsSaidWithWhatMakesIt) {
  const auto has = [](const Evidence& evidence, const std::string& words) {
    const std::vector<std::string> all = evidence_not_given(evidence);
    return std::any_of(all.begin(), all.end(), [&](const std::string& one) { return one.find(words) != one.npos; });
  };
  for (const std::string command :
       {"scripts/test", "scripts/faults", "scripts/mutants", "scripts/judge --keep", "scripts/studies"}) {
    EXPECT_TRUE(has({}, "; made by: " + command)) << command;
    EXPECT_TRUE(fs::exists(fs::path(FURROW_SOURCE_DIR) / command.substr(0, command.find(' ')))) << command;
  }
  Evidence all_but_edits{.checks = "c", .faults = "f", .studies = "s", .judgements = "j"};
  EXPECT_EQ(evidence_not_given(all_but_edits).size(), 1u);
  EXPECT_TRUE(has(all_but_edits, "random edits of the source: not given by --mutants"));
  all_but_edits.mutants = "m";
  EXPECT_EQ(evidence_not_given(all_but_edits).size(), 0u);
}

// A study of two numbers and its chapter.
Report chapter_of_two(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("convergence");
  return Report("Two numbers", "Which?").text(numbers.at("a").dump() + numbers.at("b").dump());
}

TEST(Evidence, EveryWayToSpoilTheNumbersOfAStudyIsNamed) {
  const std::vector<Way> ways{{"a list", [](Json& s) { s = Json::array(); }},
                              {"empty", [](Json& s) { s = Json::object(); }},
                              {"of another study", [](Json& s) { s["study"] = "order"; }},
                              {"of the quick form", [](Json& s) { s["form"] = "quick"; }},
                              {"no form", [](Json& s) { s.erase("form"); }},
                              {"of another schema", [](Json& s) { s["schema"] = 3; }},
                              {"no results", [](Json& s) { s["results"] = Json::array(); }},
                              {"a result that the chapter needs is not there", [](Json& s) { s["results"].erase(1); }},
                              {"two results of one key", [](Json& s) { s["results"].push_back(s["results"][0]); }},
                              {"a maker that is not there", [](Json& s) { s["results"][0]["maker"] = 7; }},
                              {"no commit", [](Json& s) { s["makers"][0].erase("commit"); }}};
  Place place;
  const fs::path file = place.path / "convergence.json";
  const Evidence evidence{
      {}, {}, place.path, {{.name = "convergence", .measure = [](Measurement&) {}, .chapter = chapter_of_two}}};
  Numbers numbers("convergence", "full");
  for (const char* key : {"a", "b"}) numbers.add({.key = key, .value = 1}, this_maker({{"src/run/run.cpp", "1"}}));
  numbers.write(file);
  EXPECT_EQ(unusable_study(evidence, "convergence"), "");
  const Json sound = json_of(file);
  for (const Way& way : ways) {
    Json spoilt = sound;
    way.spoil(spoilt);
    if (spoilt.is_object()) seal(spoilt);
    write(file, spoilt);
    EXPECT_NE(unusable_study(evidence, "convergence"), "") << way.name;
  }
  Json changed = sound;
  changed["results"][0]["value"] = 2;
  write(file, changed);
  EXPECT_NE(unusable_study(evidence, "convergence"), "") << "changed by hand";
  std::ofstream(file) << sound.dump().substr(0, 200);
  EXPECT_NE(unusable_study(evidence, "convergence"), "") << "cut short";
}

Json sound_checks() {
  Json all{{"tests", 1},
           {"missing", Json::array()},
           {"checks", {{{"test", "A.B"}, {"requirement", "r"}, {"good", true}, {"error", 0.1}, {"tolerance", 0.2}}}}};
  seal(all);
  return all;
}

TEST(Evidence, EveryWayToSpoilTheChecksIsNamed) {
  const std::vector<Way> ways{
      {"no checks", [](Json& c) { c["checks"] = Json::array(); }},
      {"the suite has faults", [](Json& c) { c["missing"].push_back("A.C left no record"); }},
      {"good beyond its tolerance", [](Json& c) { c["checks"][0]["error"] = 0.3; }},
      {"good with an error that is not finite", [](Json& c) { c["checks"][0]["error"] = "nan"; }},
      {"good is text", [](Json& c) { c["checks"][0]["good"] = "true"; }},
      {"no test", [](Json& c) { c["checks"][0].erase("test"); }},
      {"a check is null", [](Json& c) { c["checks"][0] = nullptr; }}};
  Place place;
  const fs::path file = place.path / "checks.json";
  write(file, sound_checks());
  EXPECT_EQ(unusable_checks(file), "");
  for (const Way& way : ways) {
    Json spoilt = sound_checks();
    way.spoil(spoilt);
    seal(spoilt);
    write(file, spoilt);
    EXPECT_NE(unusable_checks(file), "") << way.name;
  }
}

TEST(Evidence, OfAPartOfTheSuiteItIsSaidHowManyChecksThereAreAndWhatIsMissing) {
  Place place;
  const fs::path file = place.path / "checks.json";
  Json part = sound_checks();
  part["missing"].push_back("A.C left no record");
  seal(part);
  write(file, part);
  EXPECT_EQ(verdict_of({.checks = file}).trouble,
            file.string() + ": holds 1 checks only; 1 faults of the suite, the first: A.C left no record");
  write(file, sound_checks());
  EXPECT_EQ(verdict_of({.checks = file}).trouble, "");
}

TEST(Evidence, AFaultThatWasNotNoticedOrNotTriedIsNamed) {
  const std::vector<Way> ways{{"none", [](Json& f) { f["results"] = Json::array(); }},
                              {"not noticed", [](Json& f) { f["results"][0]["failed"] = Json::array(); }},
                              {"not by the property", [](Json& f) { f["results"][0]["by_property"] = Json::array(); }},
                              {"trouble", [](Json& f) { f["results"][0]["trouble"] = "does not build"; }},
                              {"without a name", [](Json& f) { f["results"][0].erase("name"); }}};
  Place place;
  const fs::path file = place.path / "faults.json";
  for (const Way& way : ways) {
    Json spoilt = json_of(reference("faults.json"));
    way.spoil(spoilt);
    seal(spoilt);
    write(file, spoilt);
    EXPECT_NE(unusable_faults(file), "") << way.name;
  }
}

TEST(Evidence, FaultsOfTheListThatWereNotTriedAreCounted) {
  Json study = json_of(reference("faults.json"));
  const std::size_t before = untried_faults(study).size();
  const std::string name = study["results"][0]["name"];
  study["results"].erase(0);
  const std::vector<std::string> untried = untried_faults(study);
  EXPECT_EQ(untried.size(), before + 1);
  EXPECT_EQ(std::count(untried.begin(), untried.end(), name), 1);
}

}  // namespace
}  // namespace furrow::validation
