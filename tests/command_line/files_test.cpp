// What a command may write over and remove, and what it leaves when it ends in a way that nobody wants.
#include "program.h"

namespace furrow::test {
namespace {

class ProgramFiles : public Program {
 protected:
  std::string short_run(const std::string& out, const std::string& until = "0.05") const {
    return "run " + scene("scenario_1") + " --until " + until + " --out " + out;
  }
  static std::string no_room() {
    return "title = \"full\"\n[model]\ngravity = 9.81\n[time]\nstep = 1e-4\nend = 1e-3\n"
           "[[material]]\nname = \"sand\"\nyoung = 1e6\npoisson = 0.3\n"
           "[[packing]]\nmaterial = \"sand\"\ncount = 50\nradius_min = 0.01\nradius_max = 0.01\n"
           "lower_left = [0.0, 0.0]\nupper_right = [0.05, 0.05]\nseed = 1\n";
  }
};

TEST_F(ProgramFiles, AForeignDirectoryIsNotTouched) {
  put("mine/letter.txt");
  const Result r = furrow(short_run("mine"));
  EXPECT_EQ(r.code, 4);
  EXPECT_NE(r.err.find("choose another --out"), std::string::npos) << r.err;
  EXPECT_EQ(files("mine"), std::vector<std::string>{"letter.txt"});
  put("other/run.json", "{}");
  put("other/frames/mine.csv");
  EXPECT_EQ(furrow(short_run("other")).code, 4) << "run.json alone does not show that furrow wrote it";
  EXPECT_EQ(text("other/frames/mine.csv"), "mine");
}

TEST_F(ProgramFiles, AnEarlierRunIsReplacedAndWhatAUserPutThereStays) {
  ASSERT_EQ(furrow(short_run("here", "0.4")).code, 0);
  ASSERT_TRUE(has("here/frames/links_001.csv"));
  put("here/notes.txt");
  put("here/frames/mine.csv");
  ASSERT_EQ(furrow(short_run("here")).code, 0);
  EXPECT_FALSE(has("here/frames/links_001.csv"));
  EXPECT_EQ(text("here/notes.txt"), "mine");
  EXPECT_EQ(text("here/frames/mine.csv"), "mine");
}

// The same scene again is what one expects; that of another one is said.
TEST_F(ProgramFiles, AFinishedRunOfAnotherSceneIsNotReplacedWithoutAWord) {
  const std::string replaced = "is replaced";
  EXPECT_EQ(furrow(short_run("here")).err.find(replaced), std::string::npos);
  EXPECT_EQ(furrow(short_run("here")).err.find(replaced), std::string::npos) << "its own";
  put("other.toml", text_of(FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml"));
  const Result r = furrow("run other.toml --until 0.05 --out here");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("scenario_1.toml in here is replaced"), std::string::npos) << r.err;
}

TEST_F(ProgramFiles, ASceneWhoseNameIsADirectoryAboveNeedsOne) {
  for (const char* name : {"..toml", "...toml"}) {
    put(name, text_of(FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml"));
    const Result r = furrow(std::string("run ") + name + " --until 0.05");
    EXPECT_EQ(r.code, 2) << name;
    EXPECT_NE(r.err.find("say --out DIR"), std::string::npos) << r.err;
  }
}

TEST_F(ProgramFiles, ALinkInPlaceOfAFileIsNotFollowed) {
  ASSERT_EQ(furrow(short_run("here")).code, 0);
  put("precious");
  fs::remove(directory_ / "here/state.csv");
  fs::create_symlink(directory_ / "precious", directory_ / "here/state.csv");
  const auto before = bits("here");
  const Result r = furrow(short_run("here"));
  EXPECT_EQ(r.code, 4);
  EXPECT_NE(r.err.find("state.csv is in the way"), std::string::npos) << r.err;
  EXPECT_EQ(text("precious"), "mine");
  EXPECT_EQ(bits("here"), before);
}

TEST_F(ProgramFiles, AnUnwritablePlaceExitsFour) {
  put("file");
  EXPECT_EQ(furrow(short_run("file/below")).code, 4);
  EXPECT_EQ(furrow(short_run("file")).code, 4);
  EXPECT_EQ(furrow("golden --quick --remake --reason x --goldens file/below").code, 2) << "--quick";
}

TEST_F(ProgramFiles, ADirectoryThatALivingRunHoldsIsRefused) {
  Process first(directory_, started(short_run("here", "1000")));
  ASSERT_TRUE(comes_true([&] { return has("here/plate_force.csv.partial"); }));
  const Result second = furrow(short_run("here"));
  EXPECT_EQ(second.code, 4);
  EXPECT_NE(second.err.find("is in use by process " + std::to_string(first.pid())), std::string::npos) << second.err;
  EXPECT_TRUE(has("here/plate_force.csv.partial"));
}

TEST_F(ProgramFiles, AKilledRunIsReplacedByTheSameCommand) {
  ASSERT_EQ(furrow(short_run("whole", "0.3")).code, 0);
  {
    Process run(directory_, started(short_run("here", "1000")));
    ASSERT_TRUE(comes_true([&] { return lines_of(directory_ / "here/plate_force.csv.partial") > 3; }));
    run.send(SIGKILL);
    EXPECT_EQ(run.code(), -SIGKILL);
  }
  const Result again = furrow(short_run("here", "0.3"));
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(bits("here"), bits("whole"));
}

TEST_F(ProgramFiles, ADiskThatIsFullEndsTheRunWhereItIsAndTheNextOneRuns) {
  const Result r = furrow(short_run("here", "1000"), "ulimit -f 16;");  // 8 KiB a file
  EXPECT_EQ(r.code, 4);
  EXPECT_NE(r.err.find(": File too large"), std::string::npos) << r.err;
  EXPECT_FALSE(has("here/run.json"));
  EXPECT_LT(lines_of(directory_ / "here/plate_force.csv.partial"), 500U) << "it went on after that";
  EXPECT_EQ(furrow(short_run("here")).code, 0);
}

TEST_F(ProgramFiles, APackingWithoutRoomLeavesADirectoryThatCanBeUsedAgain) {
  put("full.toml", no_room());
  const Result first = furrow("run full.toml --out here"), second = furrow("run full.toml --out here");
  EXPECT_NE(first.code, 0);
  EXPECT_EQ(second.code, first.code);
  EXPECT_EQ(second.err, first.err);
  EXPECT_NE(second.err.find("no room"), std::string::npos) << second.err;
  EXPECT_EQ(furrow(short_run("here")).code, 0);
}

TEST_F(ProgramFiles, WantOfMemoryLeavesADirectoryThatCanBeUsedAgain) {
  std::string many = no_room();
  many.replace(many.find("count = 50"), 10, "count = 400000");
  many.replace(many.find("[0.05, 0.05]"), 12, "[20.0, 20.0]");
  put("many.toml", many);
  EXPECT_NE(furrow("run many.toml --out here", "ulimit -v 60000;").code, 0);
  EXPECT_TRUE(has("here/.furrow.json"));
  EXPECT_EQ(furrow(short_run("here")).code, 0);
}

// Before anything is run: each of these would take minutes.
TEST_F(ProgramFiles, AResultReplacesOnlyOneOfItsKind) {
  const std::string study = "study order --out kept", golden = "golden --remake --reason why --goldens kept";
  for (const auto& [command, file] :
       {std::pair{study, "order.json"}, {study, "order.runs.jsonl"}, {golden, "scenario_1_disc.json"}}) {
    const std::string place = "kept/" + std::string(file);
    for (const char* words : {"mine", "{\"mine\": 1}", ""}) {
      if (*words == '\0' && command == study && place.ends_with("jsonl")) continue;  // an empty list is one
      fs::remove_all(directory_ / "kept");
      put(place, words);
      const Result r = furrow(command);
      EXPECT_EQ(r.code, 4) << command << place;
      EXPECT_NE(r.err.find(file), std::string::npos) << r.err;
      EXPECT_EQ(text(place), words);
    }
    put("precious");
    fs::remove(directory_ / place);
    fs::create_symlink(directory_ / "precious", directory_ / place);
    EXPECT_EQ(furrow(command).code, 4) << command << place;
    EXPECT_EQ(text("precious"), "mine");
  }
}

// Two plates of different speeds, one with a name that needs quotes and one with none.
TEST_F(ProgramFiles, EachRowHasTheDisplacementOfItsOwnPlate) {
  std::string toml = text_of(FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml");
  toml +=
      "\n[[plate]]\nname = \"fast, \\\"2\\\"\"\nwidth = 0.01\nheight = 0.1\nleft_edge = -5.0\nlower_edge = 1.0\n"
      "velocity = [0.3, 0.4]\nmaterial = \"common\"\n";
  put("two.toml", toml);
  const Result r = furrow("run two.toml --until 0.1 --out here");
  ASSERT_EQ(r.code, 0) << r.err;
  const std::string force = text("here/plate_force.csv");
  EXPECT_NE(force.find("\n0.1,\"fast, \"\"2\"\"\",0.05"), std::string::npos) << force;  // 0.5 m/s
  EXPECT_NE(force.find(",0.01,"), std::string::npos) << "0.1 m/s: " << force;
}

}  // namespace
}  // namespace furrow::test
