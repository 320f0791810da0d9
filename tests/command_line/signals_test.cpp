// Requests to stop, and what must not outlive the program.
#include <fcntl.h>

#include <thread>

#include "tests/command_line/commands.h"

namespace furrow::test {
namespace {

class Signals : public Commands {
 protected:
  // A gnuplot that never ends, and says who it and its child are.
  std::string with_hanging_gnuplot() const {
    put("bin/gnuplot", "#!/bin/sh\nsleep 1000 &\necho $$ $! >'" + directory_.string() + "/pids'\nwait\n");
    fs::permissions(directory_ / "bin/gnuplot", fs::perms::owner_all);
    return "env PATH='" + directory_.string() + "/bin':\"$PATH\" ";
  }
  bool is_alive(long pid) const { return kill(static_cast<pid_t>(pid), 0) == 0; }

  // Three scenes that take no time.
  void put_short_scenes() const {
    std::string toml = text_of(FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml");
    toml.replace(toml.find("end = 1.2"), 9, "end = 0.01");
    const std::size_t frames = toml.find("frames = [");
    toml.replace(frames, toml.find(']', frames) + 1 - frames, "frames = [0.0]");
    for (const char* name : {"scenario_1", "scenario_2", "scenario_3"})
      put("scenes/" + std::string(name) + ".toml", toml);
  }
};

TEST_F(Signals, EachOfThemEndsARunWellAndIsNamed) {
  for (const auto& [number, name] :
       {std::pair{SIGINT, std::string("SIGINT")}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}}) {
    Process run(directory_, started("run " + scene("scenario_1") + " --until 50000 --out " + name));
    const fs::path force = directory_ / name / "plate_force.csv.partial";
    ASSERT_TRUE(comes_true([&] { return lines_of(force) > 3; }));
    run.send(number);
    EXPECT_EQ(run.code(), 130);
    EXPECT_NE(text("stderr.txt").find("was interrupted by " + name + " in " + name), std::string::npos)
        << text("stderr.txt");
    const auto json = nlohmann::json::parse(text(name + "/run.json"));
    EXPECT_EQ(json["ended"], "interrupted");
    EXPECT_EQ(json["reason"], "interrupted by " + name);
    // What grows with the run is not complete, what is whole in itself is.
    for (const char* file : {"plate_force.csv", "wall_force.csv", "energy.csv", "motion.csv", "events.csv", "run.pvd",
                             "frames/frames.csv"}) {
      EXPECT_TRUE(has(name + "/" + file + ".partial")) << file;
      EXPECT_FALSE(has(name + "/" + file)) << file;
      EXPECT_EQ(text(name + "/" + file + ".partial").back(), '\n') << file;
    }
    for (const char* file : {"state.csv", "scene.toml", "run.json", "frames/discs_000.vtp"}) {
      EXPECT_TRUE(has(name + "/" + file)) << file;
      EXPECT_FALSE(has(name + "/" + file + ".partial")) << file;
    }
    EXPECT_NE(text(name + "/run.pvd.partial").find("</VTKFile>"), std::string::npos);
    EXPECT_NE(text(name + "/.furrow.json").find("\"interrupted\""), std::string::npos);
  }
}

TEST_F(Signals, ARunThatSettlesHearsThem) {
  put_large_bed("large.toml", "3000", "2.0", "[settle]\nspeed = 1e-6\nlimit = 1000.0\n");
  Process run(directory_, started("run large.toml --out here"));
  ASSERT_TRUE(comes_true([&] { return has("here/scene.toml") && run.cpu_seconds() > 0.5; }));
  run.send(SIGTERM);
  EXPECT_EQ(run.code(), 130);
  EXPECT_EQ(nlohmann::json::parse(text("here/run.json"))["ended"], "interrupted");
}

TEST_F(Signals, APackingHearsThem) {
  put_what_takes_long();
  Process run(directory_, started("run large.toml --out here"));
  ASSERT_TRUE(comes_true([&] { return has("here/scene.toml") && run.cpu_seconds() > 0.5; }));
  run.send(SIGTERM);
  EXPECT_EQ(run.code(), 130);
}

// The engine says that it cannot do the first case, and sleeps in the second.
TEST_F(Signals, AJudgeKeepsWhatItHasAndMarksIt) {
  put("engine",
      "cat >/dev/null\nif [ -e asked ]; then touch again; sleep 60; fi\ntouch asked\n"
      "echo '{\"engine\": \"x\", \"cannot\": \"nothing\"}'\n");
  Process run(directory_, started("judge --engine 'sh ./engine' --json kept.json --junit kept.xml"));
  ASSERT_TRUE(comes_true([&] { return has("again"); }));
  run.send(SIGTERM);
  EXPECT_EQ(run.code(), 130);
  const auto kept = nlohmann::json::parse(text("kept.json"));
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_TRUE(kept[0]["partial"].get<std::string>().starts_with("1 of ")) << kept[0];
  EXPECT_EQ(kept[0]["command"], "sh ./engine");
  EXPECT_NE(text("kept.xml").find("interrupted: 1 of "), std::string::npos);
}

// A new command must say here how it is made to last, or that it ends by itself within what is asked of the others.
TEST_F(Signals, EveryCommandOfTheProgramIsTried) {
  std::vector<std::string> tried;
  for (const auto& [name, call] : calls_) tried.push_back(name);
  std::vector<std::string> commands = commands_in(furrow("--help").out);
  std::sort(commands.begin(), commands.end());
  EXPECT_EQ(tried, commands);
}

// A second must be enough, on a machine that has time for the program. On one that has not, its clock says nothing, so
// two things are measured that stretch with it:
// - the CPU time from the signal to the end, of a second's worth at most: what as many threads as there are processors
//   can use of it. It catches what goes on computing.
// - whether it ends before a shell that was started with the signal has slept a hundred times for 10 ms. That takes a
//   second, and longer where one waits for a processor: the shell needs one a hundred times, a program that ends once or
//   twice. It catches what goes on waiting.
TEST_F(Signals, EveryCommandEndsWithinASecond) {
  const double a_second = std::max(1U, std::thread::hardware_concurrency());  // s of CPU time
  put_what_takes_long();
  const int pipe = open((directory_ / "pipe.toml").c_str(), O_RDWR);  // or a shell would wait to open it
  for (const auto& [name, call] : calls_) {
    Process run(directory_, started(call.arguments, call.input));
    if (call.kind == Call::Kind::ends_at_once) {
      EXPECT_EQ(run.code(), 0) << name;
      EXPECT_LT(run.cpu_seconds(), a_second) << name << " ends by itself before a signal would have to end it";
      continue;
    }
    // One that waits takes no CPU time.
    const double work = call.kind == Call::Kind::waits ? -1 : 0.3;
    ASSERT_TRUE(comes_true([&] { return run.has_ended() || (run.hears(SIGTERM) && run.cpu_seconds() > work); }))
        << name;
    ASSERT_FALSE(run.has_ended()) << name << text("stderr.txt");
    const double before = run.cpu_seconds();
    Process control(directory_, "sh -c 'for k in $(seq 100); do sleep 0.01; done'");
    run.send(SIGTERM);
    ASSERT_TRUE(comes_true([&] { return run.has_ended() || control.has_ended(); })) << name;
    EXPECT_TRUE(run.has_ended()) << name << " outlasts a hundred sleeps of 10 ms";
    EXPECT_EQ(run.code(), 130) << name;
    EXPECT_LT(run.cpu_seconds() - before, a_second) << name;
    EXPECT_NE(text("stderr.txt").find("interrupted by SIGTERM"), std::string::npos) << name << text("stderr.txt");
  }
  close(pipe);
}

TEST_F(Signals, NothingThatHangsOutlivesTheProgram) {
  put_short_scenes();
  ASSERT_EQ(furrow("report --scenes scenes --out page").code, 0) << text("stderr.txt");
  for (const int number : {SIGTERM, SIGKILL}) {
    fs::remove(directory_ / "pids");
    Process report(directory_, with_hanging_gnuplot() + started("report --scenes scenes --out page --reuse"));
    ASSERT_TRUE(comes_true([&] { return lines_of(directory_ / "pids") == 1; })) << text("stderr.txt");
    long gnuplot = 0, its_child = 0;
    std::istringstream(text("pids")) >> gnuplot >> its_child;
    report.send(number);
    EXPECT_EQ(report.code(), number == SIGKILL ? -SIGKILL : 130);
    EXPECT_TRUE(comes_true([&] { return !is_alive(gnuplot); }));
    if (number == SIGTERM) {
      EXPECT_TRUE(comes_true([&] { return !is_alive(its_child); }));
    } else {
      kill(static_cast<pid_t>(its_child), SIGKILL);  // nobody is notified of a grandchild any more
    }
  }
  EXPECT_EQ(furrow("report --scenes scenes --out page --reuse").code, 0) << text("stderr.txt");
}

TEST_F(Signals, AnIgnoredHangupStaysIgnored) {
  Process run(directory_, "nohup " + started("run " + scene("scenario_1") + " --until 1000 --out here"));
  ASSERT_TRUE(comes_true([&] { return lines_of(directory_ / "here/plate_force.csv.partial") > 3; }));
  run.send(SIGHUP);
  const std::size_t rows = lines_of(directory_ / "here/plate_force.csv.partial");
  EXPECT_TRUE(comes_true([&] { return lines_of(directory_ / "here/plate_force.csv.partial") > rows + 10; }));
  EXPECT_FALSE(run.has_ended());
}

}  // namespace
}  // namespace furrow::test
