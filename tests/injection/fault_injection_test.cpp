// A run is ended at a random moment in a way that it cannot help; then the same command again must succeed and give the
// bits of a run that nothing ever happened to. A few of each kind, with FURROW_LONG many. A failure names its seed;
// FURROW_INJECTION_SEED tries it again.
#include <random>

#include "tests/command_line/program.h"

namespace furrow::test {
namespace {

// Scenes short enough to be run many times: a lattice that tears, and a bed that settles; both with pictures.
class FaultInjection : public Program {
 protected:
  void SetUp() override {
    std::string lattice = text_of(FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml");
    put("lattice.toml", lattice.replace(lattice.find("frames = [0.0,"), 14, "frames = [0.0, 0.1, 0.2,"));
    put("bed.toml",
        "title = \"bed\"\n[model]\ngravity = 9.81\n[time]\nstep = 1e-4\nend = 0.4\n[settle]\nspeed = 0.01\nlimit = "
        "20.0\n"
        "[contact]\nfriction = 0.5\ndamping_factor = 0.5\n[[material]]\nname = \"sand\"\nyoung = 2e6\npoisson = 0.3\n"
        "[[packing]]\nmaterial = \"sand\"\ncount = 30\nradius_min = 0.01\nradius_max = 0.012\n"
        "lower_left = [0.0, 0.0]\nupper_right = [0.2, 0.4]\nseed = 1\n"
        "[[wall]]\npoint = [0.0, 0.0]\nnormal = [0.0, 1.0]\nmaterial = \"sand\"\n"
        "[[wall]]\npoint = [0.0, 0.0]\nnormal = [1.0, 0.0]\nmaterial = \"sand\"\n"
        "[[wall]]\npoint = [0.2, 0.0]\nnormal = [-1.0, 0.0]\nmaterial = \"sand\"\n"
        "[output]\ninterval = 1e-3\nframes = [0.0, 0.1, 0.2, 0.3, 0.4]\n");
    for (const char* scene : {"lattice", "bed"}) {
      Process run(directory_, started(command(scene, scene + std::string("_whole"))));
      ASSERT_EQ(run.code(), 0) << text("stderr.txt");
      whole_[scene] = {run.cpu_seconds(), bits(scene + std::string("_whole"))};
    }
  }

  struct Whole {
    double cpu_seconds;
    std::map<std::string, std::string> bits;
  };

  static std::string command(const std::string& scene, const std::string& out) {
    return "run " + scene + ".toml --out " + out;
  }

  // fault(scene, random) does its harm to a run into the directory `here`; afterwards all must be as if it had not.
  template <class Fault>
  void inject(const Fault& fault) {
    const char* seed_given = std::getenv("FURROW_INJECTION_SEED");
    const unsigned first = seed_given ? static_cast<unsigned>(std::atoi(seed_given)) : 1;
    const unsigned count = seed_given ? 1 : std::getenv("FURROW_LONG") ? 100 : 3;
    for (unsigned seed = first; seed < first + count; ++seed) {
      std::mt19937 random(seed);
      const std::string scene = random() % 2 == 0 ? "lattice" : "bed";
      put("here/notes.txt");  // refused, until furrow owns the directory
      EXPECT_EQ(furrow(command(scene, "here")).code, 4);
      fs::remove_all(directory_ / "here");
      // Harm upon harm: what a fault leaves must stand another.
      for (unsigned long times = 1 + random() % 2; times > 0; --times) fault(scene, random);
      if (has("here")) put("here/frames_of_mine/notes.txt");
      const Result again = furrow(command(scene, "here"));
      ASSERT_TRUE(again.code == 0 || (again.code == 4 && !has("here/.furrow.json"))) << "seed " << seed << again.err;
      if (again.code == 4) {  // it was stopped before it had made the directory its own
        fs::remove_all(directory_ / "here");
        continue;
      }
      auto now = bits("here");
      EXPECT_EQ(now.erase("frames_of_mine/notes.txt"), has("here/frames_of_mine/notes.txt") ? 1U : 0U);
      EXPECT_EQ(now, whole_.at(scene).bits) << "seed " << seed;
      fs::remove_all(directory_ / "here");
    }
  }

  // A random moment of a run, of all its work: whatever else the machine does, it has then come that far, or has ended.
  bool comes_to_a_moment(Process& run, const std::string& scene, std::mt19937& random) {
    const double moment = whole_.at(scene).cpu_seconds * std::uniform_real_distribution<double>(0, 1)(random);
    const bool came = comes_true([&] { return run.has_ended() || run.cpu_seconds() >= moment; });
    alive_ += run.has_ended() ? 0 : 1;
    return came;
  }
  int alive_ = 0;  // runs that had not ended at their moment

  std::map<std::string, Whole> whole_;
};

TEST_F(FaultInjection, ARunKilledAtAnyMomentRunsAgainToTheSameBits) {
  inject([&](const std::string& scene, std::mt19937& random) {
    Process run(directory_, started(command(scene, "here")));
    ASSERT_TRUE(comes_to_a_moment(run, scene, random));
    run.send(SIGKILL);
    const int code = run.code();
    EXPECT_TRUE(code == -SIGKILL || code == 0) << code;
  });
  EXPECT_GT(alive_, 0) << "none was killed";
}

TEST_F(FaultInjection, ARunAskedToStopAtAnyMomentRunsAgainToTheSameBits) {
  inject([&](const std::string& scene, std::mt19937& random) {
    const int number = std::vector<int>{SIGINT, SIGTERM, SIGHUP}[random() % 3];
    Process run(directory_, started(command(scene, "here")));
    ASSERT_TRUE(comes_true([&] { return run.has_ended() || run.hears(number); }));
    ASSERT_TRUE(comes_to_a_moment(run, scene, random));
    run.send(number);
    const int code = run.code();
    EXPECT_TRUE(code == 130 || code == 0) << code;
    if (code == 130 && has("here/run.json")) {
      EXPECT_EQ(nlohmann::json::parse(text("here/run.json"))["ended"], "interrupted");
    }
  });
  EXPECT_GT(alive_, 0) << "none was asked";
}

// Files of this process may not grow beyond a random size: the series meet that, or a picture, or the marker.
TEST_F(FaultInjection, ARunOnADiskThatFillsUpRunsAgainToTheSameBits) {
  inject([&](const std::string& scene, std::mt19937& random) {
    const unsigned long blocks = random() % 100;  // of 512 bytes
    const Result r = furrow(command(scene, "here"), "ulimit -f " + std::to_string(blocks) + ";");
    EXPECT_TRUE(r.code == 4 || r.code == 0) << r.code << r.err;
    if (r.code == 4 && !r.err.empty()) {
      EXPECT_NE(r.err.find("File too large"), std::string::npos) << r.err;
    }
  });
}

TEST_F(FaultInjection, ARunWhoseReaderIsGoneRunsAgainToTheSameBits) {
  inject([&](const std::string& scene, std::mt19937& /*random*/) {
    EXPECT_EQ(code_of_line(command(scene, "here") + " >/dev/full 2>&1"), 4);
  });
}

// With so little memory some part of it fails: reading, packing, searching, stepping.
TEST_F(FaultInjection, ARunWithoutMemoryRunsAgainToTheSameBits) {
  inject([&](const std::string& scene, std::mt19937& random) {
    const unsigned long kilobytes = 15000 + random() % 40000;
    const Result r = furrow(command(scene, "here"), "ulimit -v " + std::to_string(kilobytes) + ";");
    EXPECT_NE(r.code, 130);
  });
}

}  // namespace
}  // namespace furrow::test
