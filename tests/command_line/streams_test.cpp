// Standard streams that fail.
#include "program.h"

namespace furrow::test {
namespace {

using Streams = Program;

const std::vector<std::string>& commands_that_print() {
  static const std::vector<std::string> all{"--help",
                                            "--version",
                                            "run --help",
                                            "methods",
                                            "study",
                                            "check '" FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml'",
                                            "explain '" FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml'",
                                            "stability '" FURROW_SOURCE_DIR "/validation/scenes/single_spring.toml'",
                                            "run '" FURROW_SOURCE_DIR
                                            "/validation/scenes/scenario_1.toml' --until 0.01 --out here"};
  return all;
}

TEST_F(Streams, EachCommandThatCannotPrintExitsFour) {
  for (const std::string& command : commands_that_print()) {
    for (const char* to : {" >/dev/full", " >&-"}) {
      EXPECT_EQ(code_of_line(command + to + " 2>stderr.txt"), 4) << command << to;
      EXPECT_NE(text("stderr.txt").find("cannot write to standard output"), std::string::npos) << command << to;
    }
    EXPECT_EQ(code_of_line(command + " >/dev/null 2>stderr.txt"), 0) << command << text("stderr.txt");
  }
}

TEST_F(Streams, AReaderThatWentAwayIsAnErrorToo) {
  // The shell reports the program's own code; the reader ends before it can print.
  const std::string line = "cd '" + directory_.string() +
                           "' && { { sleep 0.2; '" FURROW_PROGRAM "' methods; echo $? >code; } | true; } 2>stderr.txt";
  ASSERT_EQ(std::system(line.c_str()), 0);
  EXPECT_EQ(text("code"), "4\n");
  EXPECT_NE(text("stderr.txt").find("cannot write to standard output: Broken pipe"), std::string::npos);
}

TEST_F(Streams, AClosedStreamTakesNothingThatGoesToAFile) {
  EXPECT_EQ(code_of_line("run " + scene("scenario_1") + " --until 0.01 --out here >&- 2>&- <&-"), 4);
  for (const std::string& file : files("here")) EXPECT_EQ(file.find(".partial"), std::string::npos) << file;
  EXPECT_EQ(text("here/scene.toml").find("state_hash"), std::string::npos);
  EXPECT_EQ(text("here/plate_force.csv").rfind("t [s],plate", 0), 0U);
}

TEST_F(Streams, AStandardErrorThatFailsChangesNothing) {
  for (const char* to : {" 2>/dev/full", " 2>&-"}) {
    EXPECT_EQ(code_of_line("check " + bad_scene("not_toml") + " >/dev/null" + to), 2);
    EXPECT_EQ(code_of_line("run " + scene("scenario_1") + " --until 0.01 --out here >/dev/null" + to), 0);
  }
}

}  // namespace
}  // namespace furrow::test
