// The help of each command ends with examples of its own, which run as they stand.
#include <set>

#include "tests/command_line/commands.h"

namespace furrow::test {
namespace {

// A copy of the source tree as far as examples read it; what they write stands beside.
class Examples : public Program {
 protected:
  void SetUp() override {
    for (const char* folder : {"validation", "src", "reference_data"})
      fs::create_directory_symlink(fs::path(FURROW_SOURCE_DIR) / folder, directory_ / folder);
    const std::string path = fs::path(FURROW_PROGRAM).parent_path().string() + ":" + std::getenv("PATH");
    ASSERT_EQ(setenv("PATH", path.c_str(), 1), 0);
  }

  std::string help_of(const std::string& command) const {
    const Result help = furrow(command + " --help");
    EXPECT_EQ(help.code, 0) << command;
    return help.out;
  }

  // To its end; what takes long is asked to stop once it works, and has by then taken its command line.
  void expect_to_run(const std::string& line) const {
    constexpr double long_enough = 3;  // s of CPU time
    Process program(directory_, line + " >>stdout.txt 2>stderr.txt");
    ASSERT_TRUE(comes_true([&] {
      return program.has_ended() || (program.hears(SIGTERM) && program.cpu_seconds() > long_enough);
    })) << line;
    if (!program.has_ended()) program.send(SIGTERM);
    const int code = program.code();  // 1: what is compared differs, which is no matter of the command line
    EXPECT_TRUE(code == 0 || code == 1 || code == 130) << line << "\n" << code << text("stderr.txt");
  }
};

TEST_F(Examples, EachCommandHasItsOwnAndTheyRun) {
  std::set<std::string> seen;
  for (const std::string& command : commands_in(furrow("--help").out)) {
    const std::vector<std::string> examples = examples_in(help_of(command));
    const auto calls_it = [&](const std::string& line) {
      return (line + " ").find("furrow " + command + " ") != line.npos;
    };
    EXPECT_TRUE(std::any_of(examples.begin(), examples.end(), calls_it)) << command;
    for (const std::string& line : examples) {
      EXPECT_TRUE(seen.insert(line).second) << command << " has an example of another command: " << line;
      expect_to_run(line);
    }
  }
  EXPECT_FALSE(seen.empty());
}

TEST_F(Examples, ThoseOfTheProgramRun) {
  const std::vector<std::string> examples = examples_in(furrow("--help").out);
  EXPECT_GE(examples.size(), 2u);
  for (const std::string& line : examples) expect_to_run(line);
}

}  // namespace
}  // namespace furrow::test
