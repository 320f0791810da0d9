// Faults and judgements are as old as what decides them: the solver, the tests, the judge, the fault or case itself.
#include "validation/page/kept_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "report/inputs.h"
#include "report/seal.h"
#include "tests/files.h"
#include "validation/page/age_words.h"
#include "validation/page/faults.h"
#include "validation/page/judgements.h"
#include "validation/page/studies.h"

namespace furrow::validation {
namespace {

const std::string of_physics = "src/physics/contact.h", of_page = "verification/bounce.cpp",
                  of_judge = "verification/engines/judge.cpp", of_adapter = "verification/engines/adapters/lammps.py",
                  of_independent = "verification/engines/independent.cpp", of_writing = "src/program/usage.cpp";

// What made it, where `file` was another one; empty: as it is today.
Json maker(const std::string& what, const std::string& file) {
  Sources sources = that_decide(what);
  if (sources.contains(file)) sources[file] = "another";
  return json_of(this_maker(sources));
}

std::string some_fault() { return inputs_of_faults().begin()->first; }

Json faults(const std::string& changed) {
  const std::string name = some_fault();
  return {{"makers", Json::array({maker("faults", changed)})},
          {"groups", Json::object()},
          {"results", Json::array({Json{{"name", name},
                                        {"says", "x"},
                                        {"file", "src/kernel/a.cpp"},
                                        {"kind", "fault"},
                                        {"input", inputs_of_faults().at(name)},
                                        {"maker", 0u},
                                        {"failed", Json::array({"A.B"})},
                                        {"left_out", Json::array()},
                                        {"by_property", Json::array({"C.D"})},
                                        {"property_maker", 0u}}})},
          {"noticed_nothing", Json::object()}};
}

Json judgements(const std::string& changed) {
  const Json verdicts{{"spring", {"right", ""}}};
  const auto engine = [&](const char* name, bool foreign, unsigned place) {
    return Json{{"engine", name}, {"method", ""}, {"foreign", foreign}, {"maker", place}, {"verdicts", verdicts}};
  };
  return {
      {"makers",
       {maker("judged_furrow", changed), maker("judged_independent", changed), maker("judged_others", changed)}},
      {"cases", {{"spring", "A mass on a spring"}}},
      {"inputs", {{"spring", input_of_case("spring")}}},
      {"engines", {engine("furrow 1", false, 0u), engine("independent 1", false, 1u), engine("LAMMPS 1", true, 2u)}}};
}

TEST(AgeOfFaults, IsOfTheSolverAndOfTheTestsThatNoticeThem) {
  EXPECT_EQ(age_of_faults(faults("")).old, 0u);
  EXPECT_EQ(age_of_faults(faults("")).results, 2u) << "by the pages, and by the property";
  for (const std::string& file : {of_physics, of_page}) {
    const Age age = age_of_faults(faults(file));
    EXPECT_EQ(age.old, 2u) << file;
    EXPECT_EQ(age.changed, std::vector<std::string>{file});
  }
  for (const std::string& file : {of_judge, of_adapter, of_writing}) EXPECT_EQ(age_of_faults(faults(file)).old, 0u);
}

TEST(AgeOfFaults, IsOfTheFaultItself) {
  Json kept = faults("");
  kept["results"][0]["input"] = input_of_fault("a", "b", "c");
  const Age age = age_of_faults(kept);
  EXPECT_EQ(age.old, 2u);
  EXPECT_EQ(age.inputs, (std::vector<std::string>{some_fault(), some_fault() + " by property"}));
}

// A constant of the law makes old what is said of furrow, and nothing that is said of others.
TEST(AgeOfJudgements, IsOfTheEngineAndOfTheJudge) {
  EXPECT_EQ(age_of_judgements(judgements("")).old, 0u);
  for (const auto& [file, old] :
       {std::pair{of_physics, 1u}, {of_independent, 1u}, {of_adapter, 1u}, {of_judge, 3u}, {of_page, 0u}}) {
    const Age age = age_of_judgements(judgements(file));
    EXPECT_EQ(age.old, old) << file;
    EXPECT_EQ(age.changed, old == 0 ? std::vector<std::string>{} : std::vector<std::string>{file});
  }
  Json kept = judgements("");
  kept["inputs"]["spring"] = "another";
  EXPECT_EQ(age_of_judgements(kept).old, 3u) << "the case";
}

// Each file that was named is there: one that has moved would decide nothing.
TEST(AgeOfKeptFiles, NamesFilesThatAreThere) {
  EXPECT_TRUE(that_decide("judged_furrow").contains(of_physics));
  for (const auto& [what, file] : {std::pair{"faults", of_page},
                                   {"judged_furrow", of_judge},
                                   {"judged_independent", of_independent},
                                   {"judged_others", of_adapter},
                                   {"times", of_physics}})
    EXPECT_TRUE(that_decide(what).contains(file)) << what;
  EXPECT_TRUE(sources_of_this_program().contains(of_writing));
  EXPECT_THROW(that_decide("nothing"), std::invalid_argument);
}

TEST(AgeOfKeptFiles, OfAnEarlierFormIsOld) {
  Json kept = judgements("");
  kept.erase("makers"), kept.erase("inputs");
  kept["commit"] = "63b8b18", kept["when"] = "2026-01-31T12:00:00Z", kept["machine"] = "AMD EPYC";
  const Age age = age_of_judgements(kept);
  EXPECT_EQ(age.old, 3u);
  EXPECT_EQ(age.unknown, 3u);
  EXPECT_EQ(age.commits, std::vector<std::string>{"63b8b18"});
  EXPECT_NE(why_old(age).find("made by an earlier form"), std::string::npos) << why_old(age);
  Json tried = faults("");
  tried.erase("makers");
  tried["commit"] = "63b8b18";
  tried["results"][0]["property_commit"] = "d1151cc";
  EXPECT_EQ(age_of_faults(tried).unknown, 2u);
  EXPECT_EQ(age_of_faults(tried).commits, (std::vector<std::string>{"63b8b18", "d1151cc"}));
}

// The page, the line of `furrow report` and the section say it in the same words.
TEST(AgeOfKeptFiles, IsOnThePage) {
  const test::OwnDirectory place;
  const auto left = [&](const char* name, Json kept) {
    seal(kept);
    std::ofstream(place.path() / name) << kept.dump();
    return place.path() / name;
  };
  Evidence evidence;
  evidence.faults = left("faults.json", faults(of_physics));
  evidence.judgements = left("judgements.json", judgements(of_physics));
  EXPECT_EQ(missing_evidence(evidence), std::vector<std::string>{});
  EXPECT_EQ(ages_in_words(evidence), "faults: 0 of 2 of today's sources; judgements: 2 of 3 of today's sources");
  Page page;
  for (const std::string& html :
       {faults_part(faults(of_physics), page), judgements_section(evidence.judgements, "1", page)})
    EXPECT_NE(html.find("before these sources changed: " + of_physics), std::string::npos) << html;
}

// Checks of a build before the last change do not stand as today's.
TEST(AgeOfKeptFiles, ChecksAreAsOldAsTheBuildThatMadeThem) {
  const test::OwnDirectory place;
  const Json check{{"test", "A.B"}, {"requirement", "a.b"}, {"good", true}, {"error", 0.5}, {"tolerance", 1}};
  Json all{{"tests", 1}, {"missing", Json::array()}, {"checks", {check, check}}};
  const auto age = [&] {
    Evidence evidence;
    evidence.checks = place.path() / "checks.json";
    Json kept = all;
    seal(kept);
    std::ofstream(evidence.checks) << kept.dump();
    EXPECT_EQ(unusable_checks(evidence.checks), "");
    return ages_in_words(evidence);
  };
  EXPECT_EQ(age(), "checks: 0 of 2 of today's sources") << "of an earlier form, which does not say what made them";
  all["made_by"] = json_of(this_maker({{"src/physics/contact.h", "another"}}));
  EXPECT_EQ(age(), "checks: 0 of 2 of today's sources");
  all["made_by"] = json_of(this_maker(that_decide("faults")));
  EXPECT_EQ(age(), "checks: 2 of 2 of today's sources");
}

TEST(AgeOfKeptFiles, AFileWhoseMakerIsNotThereIsNotShown) {
  const test::OwnDirectory place;
  const std::filesystem::path file = place.path() / "kept.json";
  for (Json kept : {faults(""), judgements("")}) {
    const bool of_faults = kept.contains("results");
    kept["makers"] = Json::array();
    seal(kept);
    std::ofstream(file) << kept.dump();
    EXPECT_NE(of_faults ? unusable_faults(file) : unusable_judgements(file), "");
  }
}

}  // namespace
}  // namespace furrow::validation
