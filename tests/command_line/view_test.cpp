// `furrow view`: one page that plays a run, or a word on why not.
#include <gtest/gtest.h>

#include <fstream>

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

TEST_F(View, ASeriesThatWasCutIsNoFilm) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here").code, 0) << err();
  const std::string whole = text_of(directory_ / "here/plate_force.csv");
  std::ofstream(directory_ / "here/plate_force.csv") << whole.substr(0, whole.find('\n') + 1);
  EXPECT_EQ(furrow("view here").code, 4);
  EXPECT_NE(err().find("plate_force.csv ends at t = 0 s: its files are not whole"), std::string::npos) << err();
}

TEST_F(View, ANumberThatIsNotFiniteIsNoFilm) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here").code, 0) << err();
  std::string text = text_of(directory_ / "here/plate_force.csv");
  text.replace(text.find(",0,0,0\n"), 7, ",nan,0,0\n");
  std::ofstream(directory_ / "here/plate_force.csv") << text;
  EXPECT_EQ(furrow("view here").code, 4);
  EXPECT_NE(err().find("plate_force.csv has a number that is not finite"), std::string::npos) << err();
}

TEST_F(View, APageThatDidNotFitLeavesNothingInTheWayOfTheNext) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here").code, 0) << err();
  EXPECT_EQ(furrow("view here --out page.html", "ulimit -f 8;").code, 4);
  EXPECT_NE(err().find("File too large"), std::string::npos) << err();
  for (const std::string& name : files(".")) EXPECT_FALSE(name.starts_with("page.html")) << name;
  EXPECT_EQ(furrow("view here --out page.html").code, 0) << err();
}

TEST_F(View, OfAFileThatIsNoRunSaysWhichFile) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.02 --frames 3 --out here").code, 0) << err();
  put("here/run.json", "");
  EXPECT_EQ(furrow("view here").code, 4);
  EXPECT_NE(err().find("here/run.json: is empty: it is not what a run wrote"), std::string::npos) << err();
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
