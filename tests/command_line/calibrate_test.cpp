// `furrow calibrate` from outside: what it leaves, and what it says of a wrong call.
#include "program.h"
#include "tests/bent_stem.h"

namespace {

const std::string stem = R"(title = "Stem"
time = { end = 0.1, step = 1e-4 }
contact = { damping_factor = 0.5 }
material = [{ name = "wood", young = 2e5, poisson = 0.3 }]
)" + furrow::test::bent_stem(3, "0.012", "wood");

class Calibrate : public furrow::test::Program {
 protected:
  Calibrate() {
    put("stem.toml", stem);
    put("to.toml", "[[target]]\nobservable = \"largest_force\"\nvalue = 5.0\ntolerance = 0.1\n");
  }
  int calibrate(const std::string& options) const { return furrow("calibrate stem.toml --to to.toml " + options).code; }
};

TEST_F(Calibrate, LeavesAResultAndASceneThatRuns) {
  ASSERT_EQ(calibrate("--vary 'lattice[0].structural.stiffness=1e3,2e3,4e3' --out fitted"), 0) << err();
  const auto json = nlohmann::json::parse(text("fitted/calibration.json"));
  EXPECT_EQ(json.at("search").at("points"), 3);
  EXPECT_EQ(furrow("run fitted/best/stem.toml --out run").code, 0) << err();
}

TEST_F(Calibrate, AnswersAWrongKeyInOneLineAndRunsNothing) {
  EXPECT_EQ(calibrate("--vary lattice[0].stifness=1:2 --out fitted"), 2);
  const std::string said = err();
  EXPECT_NE(said.find("--vary lattice[0].stifness"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_FALSE(has("fitted"));
}

TEST_F(Calibrate, RefusesPackingsWhereNoSceneHasOne) {
  const std::string keys = "--vary 'lattice[0].structural.stiffness=1e3,2e3' --out fitted ";
  for (const std::string option : {"--packings 2", "--fresh 5"}) {
    EXPECT_EQ(calibrate(keys + option), 2);
    EXPECT_NE(err().find("furrow: error: " + option + ": no scene has a packing"), std::string::npos) << err();
    EXPECT_FALSE(has("fitted"));
  }
  EXPECT_EQ(calibrate(keys + "--packings 1"), 0) << err();
}

TEST_F(Calibrate, DoesNotWriteIntoWhatIsNotItsOwn) {
  put("fitted/runs.jsonl", "notes of mine\n");
  EXPECT_EQ(calibrate("--vary 'lattice[0].structural.stiffness=1e3,2e3' --out fitted"), 4) << err();
  EXPECT_EQ(text("fitted/runs.jsonl"), "notes of mine\n");
}

TEST_F(Calibrate, RefusesADirectoryThatIsNotItsOwnBeforeAnyRun) {
  const std::string keys = "--vary 'lattice[0].structural.stiffness=1e3,2e3' ";
  put("mine/calibration.json", "mine");
  put("mine/notes.txt");
  ASSERT_EQ(furrow("run stem.toml --out ran").code, 0) << err();
  const auto ran = bits("ran");
  EXPECT_EQ(calibrate(keys + "--out mine"), 4);
  EXPECT_NE(err().find("mine is not empty and has no marker"), std::string::npos) << err();
  EXPECT_EQ(text("mine/calibration.json"), "mine");
  EXPECT_FALSE(has("mine/runs.jsonl"));
  EXPECT_EQ(calibrate(keys + "--out ran"), 4);
  EXPECT_NE(err().find("ran belongs to a run of furrow's, not to a calibration"), std::string::npos) << err();
  EXPECT_EQ(bits("ran"), ran);
}

TEST_F(Calibrate, GoesOnInItsOwnDirectoryButDoesNotReplaceWhatItReads) {
  const std::string keys = "--vary 'lattice[0].structural.stiffness=1e3,2e3' ";
  ASSERT_EQ(calibrate(keys + "--out fitted"), 0) << err();
  ASSERT_EQ(calibrate(keys + "--out fitted"), 0) << err();
  EXPECT_NE(out().find(" 0 runs made, 2 replayed"), std::string::npos) << out();
  const std::string best = text("fitted/best/stem.toml");
  EXPECT_EQ(furrow("calibrate fitted/best/stem.toml --to to.toml " + keys + "--out fitted").code, 2);
  EXPECT_NE(err().find("the result would replace fitted/best/stem.toml, which is read"), std::string::npos) << err();
  EXPECT_EQ(text("fitted/best/stem.toml"), best);
  put("fitted/mine.txt");
  EXPECT_EQ(calibrate(keys + "--out fitted"), 0) << err();
  EXPECT_EQ(text("fitted/mine.txt"), "mine");
}

// The exit code tells what could not be compared from what could not be run.
TEST_F(Calibrate, RecommendsNothingWhereNothingIsCompared) {
  put("to.toml", "[[target]]\nobservable = \"first_tear\"\nvalue = 5.0\ntolerance = 0.1\n");
  EXPECT_EQ(calibrate("--vary 'lattice[0].structural.stiffness=1e3,2e3' --out fitted"), 1);
  EXPECT_NE(err().find("furrow: error: no run says target \"first_tear\" of stem"), std::string::npos) << err();
  EXPECT_FALSE(has("fitted/calibration.json"));
  EXPECT_EQ(calibrate("--vary 'lattice[0].structural.stiffness=1e12,2e12' --out blown"), 3);
  EXPECT_NE(err().find("every setting failed"), std::string::npos) << err();
}

TEST_F(Calibrate, SaysWhichKeyMovesNothing) {
  const std::string keys =
      "--vary 'lattice[0].structural.stiffness=1e3,2e3' --vary lattice[0].structural.strength=1e6,2e6 ";
  ASSERT_EQ(calibrate(keys + "--out fitted"), 0) << err();
  EXPECT_NE(out().find("lattice[0].structural.strength moves no target"), std::string::npos) << out();
  EXPECT_EQ(out().find("stiffness moves no target"), std::string::npos) << out();
}

TEST_F(Calibrate, SaysWhichDirectoryCannotBeMade) {
  EXPECT_EQ(calibrate("--vary 'lattice[0].structural.stiffness=1e3,2e3' --out /proc/none"), 4);
  EXPECT_NE(err().find("cannot make /proc/none: "), std::string::npos) << err();
}

}  // namespace
