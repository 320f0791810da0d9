// `furrow view`: one page that plays a run, or a word on why not.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <utility>
#include <vector>

#include "program.h"

namespace {

namespace fs = std::filesystem;
using furrow::test::text_of;

class View : public furrow::test::Program {};

TEST_F(View, PlaysARunWithThePicturesThatWereAskedFor) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.05 --frames 21 --out here").code, 0) << err();
  ASSERT_EQ(furrow("view here").code, 0) << err();
  EXPECT_EQ(out(), "here/view.html\n");
  const std::string page = text_of(directory_ / "here/view.html");
  EXPECT_NE(page.find("21 pictures"), std::string::npos);
  EXPECT_NE(page.find("id=\"film\""), std::string::npos);
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.05 --out here").code, 0)
      << "the page is no obstacle, " << err();
}

TEST_F(View, PagesAreMadeAgainAndGoWithTheirRun) {
  const std::string run = "run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here";
  ASSERT_EQ(furrow(run).code, 0) << err();
  ASSERT_EQ(furrow("view here").code, 0) << err();
  ASSERT_EQ(furrow("view here").code, 0) << err();
  EXPECT_FALSE(fs::exists(directory_ / "here/view.html.partial"));
  ASSERT_EQ(furrow(run).code, 0) << err();
  EXPECT_FALSE(fs::exists(directory_ / "here/view.html")) << "of the run before";
}

TEST_F(View, WhatStandsInThePlaceOfAPageStaysAndNothingIsLeftBesideIt) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here").code, 0) << err();
  std::ofstream(directory_ / "mine.html") << "mine";
  EXPECT_EQ(furrow("view here --out mine.html").code, 4);
  EXPECT_NE(err().find("mine.html: it is there already"), std::string::npos) << err();
  EXPECT_EQ(text_of(directory_ / "mine.html"), "mine");
  EXPECT_FALSE(fs::exists(directory_ / "mine.html.partial"));
  std::ofstream(directory_ / "here/view.html") << "mine";
  EXPECT_EQ(furrow("view here").code, 4);
  EXPECT_EQ(text_of(directory_ / "here/view.html"), "mine");
}

// However a file was cut or changed after the run.
TEST_F(View, AFileThatIsNotWhatTheRunWroteIsNoFilm) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here").code, 0) << err();
  const auto head = [](const std::string& text) { return text.substr(0, text.find('\n') + 1); };
  const auto with = [](const std::string& from, const std::string& to) {
    return [=](std::string text) { return text.replace(text.find(from), from.size(), to); };
  };
  const std::vector<std::pair<std::string, std::function<std::string(const std::string&)>>> spoils{
      {"plate_force.csv", head},
      {"plate_force.csv", with(",0,0,0\n", ",nan,0,0\n")},
      {"energy.csv", [](const std::string& text) { return text + "\n"; }},
      {"events.csv", [](const std::string&) { return ""; }},
      {"frames/links_001.csv", with("0.", "1.")},
      {"frames/plates_000.csv", head},
      {"scene.toml", with("end = 0.02", "end = 0.03")},
      {"run.json", [](const std::string&) { return ""; }},
      {"run.json", [](const std::string&) { return "{}"; }},
      {"run.json", [](const std::string&) { return "null"; }},
      {"run.json", with("\"largest_force\": ", "\"largest_force\": 9")},
      {"run.json", with("\"ended\": \"finished\"", "\"ended\": []")},
      {"run.json", with("\"files\"", "\"filed\"")},
  };
  for (const auto& [name, spoil] : spoils) {
    const std::string whole = text_of(directory_ / "here" / name);
    put("here/" + name, spoil(whole));
    EXPECT_EQ(furrow("view here").code, 4) << name;
    EXPECT_NE(err().find(name + " is no"), std::string::npos) << err();
    put("here/" + name, whole);
  }
  fs::rename(directory_ / "here/events.csv", directory_ / "events.csv");
  EXPECT_EQ(furrow("view here").code, 4);
  EXPECT_NE(err().find("events.csv is missing"), std::string::npos) << err();
  fs::rename(directory_ / "events.csv", directory_ / "here/events.csv");
  EXPECT_EQ(furrow("view here").code, 0) << err();
}

TEST_F(View, APageThatDidNotFitLeavesNothingInTheWayOfTheNext) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here").code, 0) << err();
  EXPECT_EQ(furrow("view here --out page.html", "ulimit -f 8;").code, 4);
  EXPECT_NE(err().find("File too large"), std::string::npos) << err();
  for (const std::string& name : files(".")) EXPECT_FALSE(name.starts_with("page.html")) << name;
  EXPECT_EQ(furrow("view here --out page.html").code, 0) << err();
}

TEST_F(View, OfNoRunIsAnErrorOfInput) {
  EXPECT_EQ(furrow("view nowhere").code, 4);
  EXPECT_NE(err().find("nowhere: no such directory"), std::string::npos) << err();
}

TEST_F(View, OfARunWithoutPicturesSaysHowToGetSome) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.01 --set output.frames=[] --out here").code, 0) << err();
  EXPECT_NE(furrow("view here").code, 0);
  EXPECT_NE(err().find("run it again with --frames 150"), std::string::npos) << err();
  EXPECT_FALSE(fs::exists(directory_ / "here/view.html"));
}

TEST_F(View, FramesAreAWholeNumberFromTwo) {
  for (const char* bad : {"1", "many", "2.5", "-3", "100000"}) {
    EXPECT_EQ(furrow("run " + scene("scenario_1") + " --until 0.01 --out here --frames " + bad).code, 2) << bad;
    EXPECT_NE(err().find("--frames: must be a whole number from 2 to 10000"), std::string::npos) << err();
  }
}

}  // namespace
