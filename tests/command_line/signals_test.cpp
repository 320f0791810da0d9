// Requests to stop, and what must not outlive the program.
#include "program.h"

namespace furrow::test {
namespace {

class Signals : public Program {
 protected:
  // A bed that takes minutes to place or to settle.
  void put_large_bed(const std::string& count, const std::string& side, const std::string& more = "") const {
    put("large.toml", "title = \"large\"\n[model]\ngravity = 9.81\n[time]\nstep = 1e-5\nend = 1.0\n" + more +
                          "[contact]\nfriction = 0.5\ndamping_factor = 1.0\n[[material]]\nname = \"sand\"\nyoung = "
                          "1e8\npoisson = 0.3\n"
                          "[[packing]]\nmaterial = \"sand\"\ncount = " +
                          count + "\nradius_min = 0.01\nradius_max = 0.01\nlower_left = [0.0, 0.0]\nupper_right = [" +
                          side + ", " + side +
                          "]\nseed = 1\n[[wall]]\npoint = [0.0, 0.0]\nnormal = [0.0, 1.0]\nmaterial = \"sand\"\n");
  }

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
  put_large_bed("3000", "2.0", "[settle]\nspeed = 1e-6\nlimit = 1000.0\n");
  Process run(directory_, started("run large.toml --out here"));
  ASSERT_TRUE(comes_true([&] { return has("here/scene.toml") && run.cpu_seconds() > 0.5; }));
  run.send(SIGTERM);
  EXPECT_EQ(run.code(), 130);
  EXPECT_EQ(nlohmann::json::parse(text("here/run.json"))["ended"], "interrupted");
}

TEST_F(Signals, APackingHearsThem) {
  put_large_bed("2000000", "39.0");  // far beyond what random placing reaches
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

TEST_F(Signals, EveryOtherCommandHearsThem) {
  put_large_bed("2000000", "39.0");
  ASSERT_EQ(std::system(("mkfifo '" + directory_.string() + "/pipe.toml'").c_str()), 0);
  for (const std::string command :
       {"check pipe.toml", "explain large.toml", "stability large.toml", "study order --out kept",
        "golden --goldens '" FURROW_SOURCE_DIR "/reference_data/golden'"}) {
    Process run(directory_, started(command));
    // One that waits for its input takes no CPU time.
    const double work = command.starts_with("check") ? -1 : 0.5;
    ASSERT_TRUE(comes_true([&] { return run.has_ended() || (run.hears(SIGTERM) && run.cpu_seconds() > work); }));
    ASSERT_FALSE(run.has_ended()) << command << text("stderr.txt");
    const auto asked = std::chrono::steady_clock::now();
    run.send(SIGTERM);
    EXPECT_EQ(run.code(), 130) << command;
    // Half a second by the program's own clock; a machine that is twenty times overloaded stretches it.
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(10)) << command;
    EXPECT_NE(text("stderr.txt").find("interrupted by SIGTERM"), std::string::npos) << command << text("stderr.txt");
  }
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
