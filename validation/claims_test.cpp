// A claim that rests on times does not hold by times of another solver, in the record of a study or of one that it reads.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "report/study.h"
#include "tests/files.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/studies.h"

namespace furrow::validation {
namespace {

const Sources other_solver{{"src/physics/contact.h", "another"}};

// The times of a study are taken from what another program left; its claims hold by them.
const Study timed{
    .name = "timed",
    .measure = [](Measurement& m) { m.take({.key = "time", .timed = true, .value = 1}, this_maker(other_solver)); },
    .chapter =
        [](const Shelf&) {
          Report report("Times", "How fast?");
          report.claim({.text = "fast", .value = "1 s", .aim = "at most 2 s", .holds = true, .timed = true});
          report.claim({.text = "right", .value = "0", .aim = "0", .holds = true});
          return report;
        }};

// Makes its own numbers today, and speaks of the times of the other.
const Study reader{.name = "reader",
                   .reads = {"timed"},
                   .measure =
                       [](Measurement& m) {
                         m.run({{"number", [] { return Json(1); }}});
                       },
                   .chapter = timed.chapter};

TEST(OldTimes, DoNotCarryAClaimOfTheStudyThatKeepsThem) {
  const test::OwnDirectory place;
  const auto refuted = run_study(timed, {.directory = place.path()});
  EXPECT_EQ(refuted, std::vector<std::string>{"fast (by times that are older than the solver)"});
}

TEST(OldTimes, DoNotCarryAClaimOfAStudyThatReadsThem) {
  const test::OwnDirectory place;
  run_study(timed, {.directory = place.path()});
  EXPECT_EQ(run_study(reader, {.directory = place.path()}, {timed, reader}).size(), 1u);
  EXPECT_TRUE(run_study(reader, {.directory = place.path()}, {reader}).empty()) << "its own numbers are of today";
}

// ---- what a claim rests on ----

// A claim that names its numbers falls by the age of these alone.
TEST(OldTimes, TouchTheClaimsThatRestOnThemAlone) {
  Report report("Times", "How fast?");
  report.claim({.text = "one", .holds = true, .timed = true, .numbers = {"one.json", "other.json"}});
  report.claim({.text = "all", .holds = true, .timed = true});
  report.claim({.text = "right", .holds = true, .numbers = {"one.json"}});
  const Json said = report.json(), claims = said.at("claims");
  const auto holding = [&](const std::set<std::string>& old) {
    std::string texts;
    for (const Json& claim : claims) texts += holds_today(claim, old) ? claim.at("text").get<std::string>() + " " : "";
    return texts;
  };
  EXPECT_EQ(holding({}), "one all right ");
  EXPECT_EQ(holding({"third.json"}), "one right ");
  EXPECT_EQ(holding({"other.json"}), "right ");
}

// A name that no number has would never be old.
TEST(OldTimes, AreLookedForUnderNamesThatAreKept) {
  const std::filesystem::path all = FURROW_SOURCE_DIR "/reference_data/studies";
  const Shelf shelf(all);
  int named = 0;
  for (const Study& study : catalogue()) {
    std::set<std::string> kept;
    for (const Study& other : catalogue()) {
      const bool read = std::find(study.reads.begin(), study.reads.end(), other.name) != study.reads.end();
      if (!read && other.name != study.name) continue;
      for (const Result& result : shelf.of(other.name).results()) kept.insert(result.key);
    }
    const Json report = study.chapter(shelf).json();
    for (const char* list : {"claims", "headlines"}) {
      for (const Json& said : report.at(list)) {
        for (const Json& key : said.at("numbers")) {
          EXPECT_EQ(kept.count(key.get<std::string>()), 1u) << study.name << ": " << key;
          ++named;
        }
      }
    }
  }
  EXPECT_GE(named, 10);  // claims and headlines of the speed alone
}

// ---- what the page makes of it ----

TEST(Claims, SayTheValueThenTheAimThenTheMark) {
  Shelf none("");
  for (const bool old : {false, true}) {
    Page page;
    const std::string html = chapter_html({.name = "timed",
                                           .report = timed.chapter(none).json(),
                                           .old_times = old ? std::set<std::string>{"a"} : std::set<std::string>{}},
                                          "1", page);
    const std::size_t value = html.find("1 s"), aim = html.find("(aim: at most 2 s)"),
                      mark = html.find(old ? "times older than the solver" : "holds"), text = html.find("fast</li>");
    EXPECT_LT(value, aim) << html;
    EXPECT_LT(aim, mark) << html;
    EXPECT_LT(mark, text) << html;
    EXPECT_NE(text, std::string::npos) << html;
  }
}

TEST(Ages, AreCountedInALineWithWhichStudiesAreOld) {
  const test::OwnDirectory place;
  Evidence evidence;
  EXPECT_EQ(ages_in_words(evidence), "");
  evidence.studies = place.path();
  for (const char* name : {"order", "published"}) {
    Study study{.name = name, .measure = reader.measure, .chapter = timed.chapter};
    Numbers numbers(name, "full");
    numbers.add({.key = "a", .value = 1}, this_maker(study.sources()));
    numbers.add({.key = "b", .value = 1}, this_maker(study.name == "order" ? other_solver : study.sources()));
    numbers.write(place.path() / (study.name + ".json"));
    evidence.catalogue.push_back(std::move(study));
  }
  EXPECT_EQ(ages_in_words(evidence), "3 of 4 numbers of studies are of today's solver; older: order (1 of 2)");
}

// Without what it does not name, its chapter says the same.
TEST(Catalogue, NamesAllThatAChapterReads) {
  const std::filesystem::path all = FURROW_SOURCE_DIR "/reference_data/studies";
  for (const Study& study : catalogue()) {
    const test::OwnDirectory place;
    std::vector<std::string> read = study.reads;
    read.push_back(study.name);
    for (const std::string& name : read)
      std::filesystem::copy_file(all / (name + ".json"), place.path() / (name + ".json"));
    const Shelf some(place.path()), whole(all);
    try {
      EXPECT_EQ(study.chapter(some).json(), study.chapter(whole).json()) << study.name;
    } catch (const std::exception& error) {
      ADD_FAILURE() << study.name << ": " << error.what();
    }
  }
}

}  // namespace
}  // namespace furrow::validation
