// What the program shows on a terminal while it works: how far it is, and nothing of it afterwards.
#include <fcntl.h>
#include <unistd.h>

#include <regex>

#include "program.h"

namespace {

class Terminal : public furrow::test::Program {
 protected:
  // Runs with standard error on a terminal, with `all` standard output too; returns all that was written there.
  std::string shown(const std::string& arguments, int& code, bool all = false) const {
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_EQ(grantpt(master), 0);
    EXPECT_EQ(unlockpt(master), 0);
    const std::string name = ptsname(master);
    const pid_t child = fork();
    if (child == 0) {
      const std::string line = "cd '" + directory_.string() + "' && exec '" FURROW_PROGRAM "' " + arguments +
                               (all ? " >" + name : " >stdout.txt") + " 2>" + name + " </dev/null";
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    const int kept_open = open(name.c_str(), O_RDWR | O_NOCTTY);  // or reading fails before the child has opened it
    std::string text;
    int status = 0;
    bool ended = false;
    fcntl(master, F_SETFL, O_NONBLOCK);
    for (;;) {
      char part[4096];
      const ssize_t n = read(master, part, sizeof part);
      if (n > 0) {
        text.append(part, static_cast<std::size_t>(n));
      } else if (ended) {
        break;
      } else {
        ended = waitpid(child, &status, WNOHANG) == child;
        usleep(1000);
      }
    }
    close(kept_open);
    close(master);
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return text;
  }
};

TEST_F(Terminal, ShowsABarThatFillsAndTheTimeThatIsLeft) {
  int code = -1;
  const std::string text = shown("run " + scene("scenario_1") + " --until 40 --out here", code);  // for a second or so
  ASSERT_EQ(code, 0) << text;
  const std::regex drawn("\r\033\\[Kscenario_1 running \\[(#*)(\\.*)\\] (?:(-?\\d+) s left )? ");
  std::size_t filled = 0, draws = 0, estimates = 0;
  for (std::sregex_iterator one(text.begin(), text.end(), drawn), end; one != end; ++one) {
    EXPECT_EQ((*one)[1].length() + (*one)[2].length(), 16);
    EXPECT_GE(static_cast<std::size_t>((*one)[1].length()), filled) << "a bar does not shrink";
    filled = static_cast<std::size_t>((*one)[1].length());
    ++draws;
    if ((*one)[3].matched) {
      EXPECT_GE(std::stol((*one)[3].str()), 0);
      EXPECT_LT(std::stol((*one)[3].str()), 300);
      ++estimates;
    }
  }
  EXPECT_GE(draws, 3u) << text;
  EXPECT_GE(estimates, 2u) << text;
  EXPECT_GE(filled, 8u) << "it was drawn ten times a second";
  EXPECT_EQ(text.substr(text.size() - 4), "\r\033[K") << "the line is cleared";
}

TEST_F(Terminal, SaysWhatSettlesWithoutAGuessOfTheTimeLeft) {
  int code = -1;
  const std::string text = shown("explain " + scene("scenario_2"), code);
  ASSERT_EQ(code, 0) << text;
  const std::size_t at = text.find(" settling [");
  ASSERT_NE(at, std::string::npos) << text;
  EXPECT_EQ(text.find("s left"), std::string::npos) << text;
  EXPECT_EQ(text.find("running"), std::string::npos) << text;
}

TEST_F(Terminal, ARunEndsWithFourLinesForPeople) {
  int code = -1;
  const std::string first = shown("run " + scene("scenario_1") + " --until 0.05 --out here", code, true);
  ASSERT_EQ(code, 0) << first;
  const std::string text = first.substr(first.rfind("\033[K") == std::string::npos ? 0 : first.rfind("\033[K") + 3);
  EXPECT_TRUE(
      std::regex_search(text, std::regex("^finished at t = 0.05 s: 500 steps of pece in [0-9.e-]+ s of CPU time\r\n"
                                         "largest force [0-9.]+ N on [a-z0-9]+ at t = [0-9.]+ s\r\n"
                                         "links torn 0, greatest overlap [^\r]*\r\n"
                                         "files in here; furrow view here plays it, --json prints run.json\r\n$")))
      << text;
  const std::string second = shown("run " + scene("scenario_1") + " --until 0.05 --out here", code, true);
  EXPECT_NE(second.find("files in here, in place of those of an earlier run"), std::string::npos) << second;
  const std::string json = shown("run " + scene("scenario_1") + " --until 0.05 --out here --json", code, true);
  EXPECT_NE(json.find("\"ended\": \"finished\""), std::string::npos) << json;
  EXPECT_EQ(json.find("furrow view"), std::string::npos) << json;
}

TEST_F(Terminal, SettlingSaysWhatItWaitsFor) {
  int code = -1;
  const std::string text = shown("run " + scene("scenario_2") + " --until 0.001 --out here", code);
  ASSERT_EQ(code, 0) << text;
  const std::regex waits("settling \\[#*\\.*\\]  ?[0-9.]+ s of the model, fastest [0-9.]+ mm/s, waits for 5 mm/s");
  EXPECT_TRUE(std::regex_search(text, waits)) << text;
}

TEST_F(Terminal, AFileGetsNoBar) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 2 --out here").code, 0);
  EXPECT_EQ(err(), "");
}

}  // namespace
