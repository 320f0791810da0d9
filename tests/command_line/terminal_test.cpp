// What the program shows on a terminal while it works: how far it is, and nothing of it afterwards.
#include <fcntl.h>
#include <unistd.h>

#include <regex>

#include "program.h"

namespace {

class Terminal : public furrow::test::Program {
 protected:
  // Runs with standard error on a terminal; returns all that was written there.
  std::string shown(const std::string& arguments, int& code) const {
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_EQ(grantpt(master), 0);
    EXPECT_EQ(unlockpt(master), 0);
    const std::string name = ptsname(master);
    const pid_t child = fork();
    if (child == 0) {
      const std::string line = "cd '" + directory_.string() + "' && exec '" FURROW_PROGRAM "' " + arguments +
                               " >stdout.txt 2>" + name + " </dev/null";
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

TEST_F(Terminal, AFileGetsNoBar) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 20 --out here").code, 0);
  EXPECT_EQ(err(), "");
}

}  // namespace
