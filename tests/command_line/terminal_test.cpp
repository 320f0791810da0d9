// What the program shows on a terminal while it works: how far it is, and nothing of it afterwards.
#include <fcntl.h>
#include <unistd.h>

#include <regex>

#include "tests/command_line/commands.h"

namespace {

// A terminal that nobody sits at.
class Screen {
 public:
  Screen() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_EQ(grantpt(master_), 0);
    EXPECT_EQ(unlockpt(master_), 0);
    name_ = ptsname(master_);
    kept_open_ = open(name_.c_str(), O_RDWR | O_NOCTTY);  // or reading fails before the program has opened it
    fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  ~Screen() {
    close(kept_open_);
    close(master_);
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  const std::string& name() const { return name_; }
  // All that was written there so far.
  const std::string& text() {
    char part[4096];
    for (ssize_t n = 0; (n = read(master_, part, sizeof part)) > 0;) text_.append(part, static_cast<std::size_t>(n));
    return text_;
  }

 private:
  int master_, kept_open_ = -1;
  std::string name_, text_;
};

class Terminal : public furrow::test::Commands {
 protected:
  // With standard error on the terminal, with `all` standard output too.
  static std::string on(const Screen& screen, const std::string& arguments, bool all = false) {
    return "'" FURROW_PROGRAM "' " + arguments + " >" + (all ? screen.name() : "stdout.txt") + " 2>" + screen.name() +
           " </dev/null";
  }

  // All that is written there by a command that ends.
  std::string shown(const std::string& arguments, int& code, bool all = false) const {
    Screen screen;
    furrow::test::Process program(directory_, on(screen, arguments, all));
    furrow::test::comes_true([&] { return screen.text(), program.has_ended(); });
    code = program.code();
    return screen.text();
  }
};

// Whoever waits for longer than a second knows for what.
TEST_F(Terminal, EveryCommandThatWorksLongSaysSoWithinASecondOfItsWork) {
  put_what_takes_long();
  for (const auto& [name, call] : calls_) {
    if (call.kind != furrow::test::Call::Kind::works) continue;
    Screen screen;
    furrow::test::Process program(directory_, on(screen, call.arguments));
    ASSERT_TRUE(furrow::test::comes_true([&] {
      return !screen.text().empty() || program.has_ended() || program.cpu_seconds() > 1;
    })) << name;
    EXPECT_NE(screen.text(), "") << name;
    EXPECT_FALSE(program.has_ended()) << name << screen.text();
  }
}

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
                                         "largest force [0-9.]+ N on plate [a-z0-9]+ at t = [0-9.]+ s\r\n"
                                         "links torn 0, greatest overlap [^\r]*\r\n"
                                         "files in here; furrow view here plays it, --json prints run.json\r\n$")))
      << text;
  const std::string second = shown("run " + scene("scenario_1") + " --until 0.05 --out here", code, true);
  EXPECT_NE(second.find("files in here, in place of those of an earlier run"), std::string::npos) << second;
  const std::string json = shown("run " + scene("scenario_1") + " --until 0.05 --out here --json", code, true);
  EXPECT_NE(json.find("\"ended\": \"finished\""), std::string::npos) << json;
  EXPECT_EQ(json.find("furrow view"), std::string::npos) << json;
}

// A plate without a name is called by its index, in words as in files.
TEST_F(Terminal, APlateWithoutANameIsCalledAsFilesCallIt) {
  int code = -1;
  const std::string text =
      shown("run " + scene("scenario_1") + " --set plate[0].name= --until 0.05 --out here", code, true);
  ASSERT_EQ(code, 0) << text;
  EXPECT_NE(text.find(" N on plate 0 at t = "), std::string::npos) << text;
  EXPECT_EQ(nlohmann::json::parse(this->text("here/run.json"))["largest_force"][0]["plate"], "0");
  const std::string rows = this->text("here/plate_force.csv");
  EXPECT_EQ(rows.substr(rows.find('\n') + 1, 4), "0,0,");
}

TEST_F(Terminal, SettlingSaysWhatItWaitsFor) {
  int code = -1;
  const std::string text = shown("run " + scene("scenario_2") + " --until 0.001 --out here", code);
  ASSERT_EQ(code, 0) << text;
  const std::regex words("settling \\[#*\\.*\\]  ?[0-9.]+ s of the model, fastest [0-9.]+ mm/s, waits for 5 mm/s");
  EXPECT_TRUE(std::regex_search(text, words)) << text;
}

TEST_F(Terminal, AnEngineSaysWhatItWaitsFor) {
  Screen screen;
  const furrow::test::Process engine(
      directory_, "'" FURROW_PROGRAM "' engine <" + screen.name() + " >stdout.txt 2>" + screen.name());
  EXPECT_TRUE(furrow::test::comes_true([&] {
    return screen.text().find("waits for a request, JSON") != std::string::npos;
  })) << screen.text();
}

TEST_F(Terminal, AFileGetsNoBar) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 2 --out here").code, 0);
  EXPECT_EQ(err(), "");
}

}  // namespace
