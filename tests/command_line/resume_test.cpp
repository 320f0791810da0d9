// A run that was ended and goes on leaves what a run leaves that was never ended, to the byte.
#include <random>

#include "program.h"

namespace furrow::test {
namespace {

// A bed that settles, with friction and a plate that comes through: contacts begin, slide and end all the time.
constexpr const char* bed = R"(title = "bed"
[model]
gravity = 9.81
[time]
step = 1e-4
end = 1.2
[settle]
speed = 0.05
limit = 20.0
[contact]
friction = 0.5
damping_factor = 5.0
[[material]]
name = "sand"
young = 2e6
poisson = 0.3
[[packing]]
material = "sand"
count = 30
radius_min = 0.01
radius_max = 0.012
lower_left = [0.0, 0.0]
upper_right = [0.2, 0.4]
seed = 1
[[wall]]
point = [0.0, 0.0]
normal = [0.0, 1.0]
material = "sand"
[[wall]]
point = [0.0, 0.0]
normal = [1.0, 0.0]
material = "sand"
[[wall]]
point = [0.2, 0.0]
normal = [-1.0, 0.0]
material = "sand"
[[plate]]
material = "sand"
left_edge = -0.02
width = 0.01
height = 0.3
working_depth = 0.05
velocity = [0.05, 0.0]
[output]
interval = 1e-3
frames = [0.0, 0.1, 0.2, 0.3, 1.2]
)";

class Resume : public Program {
 protected:
  void SetUp() override {
    put("bed.toml", bed);
    put("bed_saved.toml", std::string(bed) + "checkpoint = 0.02\n");
    std::string lattice = text_of(FURROW_SOURCE_DIR "/validation/scenes/scenario_1.toml");
    const std::size_t frames = lattice.find("frames = [");
    lattice.replace(frames, lattice.find(']', frames) - frames, "frames = [0.0, 0.1, 0.2, 0.4");
    put("lattice.toml", lattice);
  }

  // run.json and all files, but for what the clock says.
  std::map<std::string, std::string> bytes(const std::string& below) const {
    std::map<std::string, std::string> all = bits(below);
    auto json = nlohmann::json::parse(text(below + "/run.json"));
    for (const char* time : {"settling_cpu_seconds", "cpu_seconds", "wall_seconds", "seal"}) json.erase(time);
    all["run.json"] = json.dump(1);
    return all;
  }

  void expect_same_files(const std::string& one, const std::string& other) const {
    const auto a = bytes(one), b = bytes(other);
    for (const auto& [name, text] : a) {
      ASSERT_TRUE(b.contains(name)) << name;
      EXPECT_TRUE(b.at(name) == text) << name << " differs";
    }
    EXPECT_EQ(a.size(), b.size());
    EXPECT_GT(a.size(), 10U);
  }

  // Starts the run, and ends it by the signal when plate_force.csv has so many lines.
  int ended_by(int signal_number, const std::string& arguments, const std::string& out, std::size_t lines) const {
    Process run(directory_, started(arguments));
    const auto far_enough = [&] {
      return run.has_ended() || lines_of(directory_ / out / "plate_force.csv.partial") >= lines;
    };
    EXPECT_TRUE(comes_true(far_enough));
    run.send(signal_number);
    return run.code();
  }
};

TEST_F(Resume, AnInterruptedRunGoesOnToTheSameBytes) {
  ASSERT_EQ(furrow("run bed.toml --out whole").code, 0) << text("stderr.txt");
  std::mt19937 random(20);
  int interrupted = 0;
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const std::size_t lines = 2 + random() % 250;
    const int code = ended_by(signal_number, "run bed.toml --out here", "here", lines);
    ASSERT_TRUE(code == 130 || code == 0) << code << text("stderr.txt");  // it may have been quicker
    if (code == 130) {
      ++interrupted;
      EXPECT_NE(text("stderr.txt").find("--resume here"), std::string::npos) << text("stderr.txt");
    }
    const Result r = furrow("run bed.toml --resume here");
    ASSERT_EQ(r.code, 0) << r.err;
    expect_same_files("whole", "here");
    fs::remove_all(directory_ / "here");
  }
  EXPECT_GT(interrupted, 0);
}

TEST_F(Resume, AKilledRunGoesOnFromItsLastCheckpointToTheSameBytes) {
  ASSERT_EQ(furrow("run bed_saved.toml --out whole").code, 0) << text("stderr.txt");
  std::mt19937 random(21);
  int killed = 0;
  for (int times = 0; times < 4; ++times) {
    // Killed more than once, and in its later lives too.
    killed += ended_by(SIGKILL, "run bed_saved.toml --out here", "here", 2 + random() % 200) == -SIGKILL ? 1 : 0;
    killed += ended_by(SIGKILL, "run bed_saved.toml --resume here", "here", 250 + random() % 400) == -SIGKILL ? 1 : 0;
    const Result r = furrow("run bed_saved.toml --resume here");
    ASSERT_EQ(r.code, 0) << r.err;
    expect_same_files("whole", "here");
    fs::remove_all(directory_ / "here");
  }
  EXPECT_GT(killed, 0);
}

TEST_F(Resume, AFinishedRunGoesOnToALaterEndAsIfItHadNeverStopped) {
  for (const std::string method : {"pece", "pec", "odeint_abm3", "pece_adaptive", "odeint_bulirsch_stoer"}) {
    const std::string with = "run lattice.toml --method " + method;
    ASSERT_EQ(furrow(with + " --until 0.45 --out whole").code, 0) << text("stderr.txt");
    ASSERT_EQ(furrow(with + " --until 0.21234 --out here").code, 0) << text("stderr.txt");
    ASSERT_EQ(furrow(with + " --until 0.3 --resume here").code, 0) << text("stderr.txt");
    ASSERT_EQ(furrow(with + " --until 0.45 --resume here").code, 0) << text("stderr.txt");
    expect_same_files("whole", "here");
    ASSERT_EQ(furrow(with + " --until 0.45 --resume here").code, 0) << text("stderr.txt");  // nothing is left to do
    expect_same_files("whole", "here");
    for (const char* done : {"whole", "here"}) fs::remove_all(directory_ / done);
  }
}

TEST_F(Resume, ADivergedRunDivergesAgainInTheSameStep) {
  ASSERT_EQ(furrow("run lattice.toml --dt 0.05 --until 1.2 --out here").code, 3);
  const auto before = bytes("here");
  ASSERT_EQ(furrow("run lattice.toml --dt 0.05 --until 1.2 --resume here").code, 3);
  EXPECT_EQ(bytes("here"), before);
}

class RefusedResume : public Resume {
 protected:
  void SetUp() override {
    Resume::SetUp();
    ASSERT_EQ(furrow("run lattice.toml --until 0.1 --out here").code, 0) << text("stderr.txt");
    before_ = bits("here");
  }
  // One line, and nothing has changed.
  void expect_refused(const std::string& arguments, int code, const std::string& words) const {
    const Result r = furrow("run " + arguments);
    EXPECT_EQ(r.code, code) << r.err;
    EXPECT_NE(r.err.find(words), std::string::npos) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_EQ(r.out, "");
    if (has("here/checkpoint")) {
      EXPECT_EQ(bits("here"), before_);
    }
  }
  std::map<std::string, std::string> before_;
};

TEST_F(RefusedResume, OfAnotherSceneMethodOrStep) {
  expect_refused("bed.toml --resume here", 2, "its scene is another one");
  expect_refused("lattice.toml --until 0.1 --method rk4 --resume here", 2,
                 "there '[time] method = \"pece\"', here 'method = \"rk4\"'");
  expect_refused("lattice.toml --until 0.1 --dt 5e-5 --resume here", 2, "step = ");
  expect_refused("lattice.toml --until 0.1 --locate tears --resume here", 2, "locate = ");
  expect_refused("lattice.toml --until 0.1 --set allow.overlap=0.9 --resume here", 2, "here '[allow] overlap = 0.9'");
}

TEST_F(RefusedResume, WhereThereIsNothingToGoOnFrom) {
  expect_refused("lattice.toml --resume nowhere", 4, "nowhere: no such directory, so no run to go on with");
  EXPECT_FALSE(has("nowhere"));
  expect_refused("lattice.toml --until 0.05 --resume here", 2, "it has come to 0.09");
  fs::remove(directory_ / "here/checkpoint");
  expect_refused("lattice.toml --resume here", 4, "no checkpoint");
}

TEST_F(RefusedResume, FromACheckpointThatIsNotWhatWasWritten) {
  const std::string good = text("here/checkpoint");
  const auto spoilt = [&](const std::string& bytes, const std::string& words) {
    put("here/checkpoint", bytes);
    const Result r = furrow("run lattice.toml --until 0.2 --resume here");
    EXPECT_EQ(r.code, 4) << r.err;
    EXPECT_NE(r.err.find(words), std::string::npos) << r.err;
  };
  spoilt(good.substr(0, good.size() / 2), "cut short");
  std::string bad = good;
  bad[good.size() / 2] = static_cast<char>(bad[good.size() / 2] ^ 1);
  spoilt(bad, "is damaged");
  bad = good;
  bad[8] = 9;
  spoilt(bad, "format 9");
  spoilt("", "not a checkpoint");
  put("here/checkpoint", good);
  EXPECT_EQ(furrow("run lattice.toml --until 0.2 --resume here").code, 0) << text("stderr.txt");
}

// Of as many bytes as before, so that only their hash tells.
TEST_F(RefusedResume, WhereARowThatWasWrittenIsAnotherNow) {
  for (const char* name : {"energy.csv", "plate_force.csv", "frames/links_000.csv", "frames/links_000.vtp"}) {
    const std::string file = std::string("here/") + name, good = text(file);
    std::string bad = good;
    char& digit = bad[bad.find_first_of("123456789", bad.find('\n'))];
    digit = digit == '1' ? '2' : '1';
    put(file, bad);
    before_ = bits("here");
    expect_refused("lattice.toml --until 0.2 --resume here", 4, "bytes are not those that the run wrote");
    put(file, good);
  }
  const std::string picture = text("here/frames/links_000.csv");
  put("here/frames/links_000.csv", picture + "1,2,3\n");
  before_ = bits("here");
  expect_refused("lattice.toml --until 0.2 --resume here", 4, "links_000.csv: it has ");
  put("here/frames/links_000.csv", picture);
  fs::remove(directory_ / "here/motion.csv");
  before_ = bits("here");
  expect_refused("lattice.toml --until 0.2 --resume here", 4, "motion.csv: No such file");
}

TEST_F(RefusedResume, WhileTheRunIsAlive) {
  Process run(directory_, "'" FURROW_PROGRAM "' run lattice.toml --dt 1e-7 --out alive >/dev/null 2>&1 </dev/null");
  ASSERT_TRUE(comes_true([&] { return has("alive/checkpoint"); }));
  expect_refused("lattice.toml --dt 1e-7 --resume alive", 4, "in use");
  run.send(SIGTERM);
  EXPECT_EQ(run.code(), 130);
}

TEST_F(RefusedResume, TogetherWithAnotherDirectory) {
  const Result r = furrow("run lattice.toml --resume here --out there");
  EXPECT_EQ(r.code, 2);
  EXPECT_NE(r.err.find("--out"), std::string::npos) << r.err;
}

}  // namespace
}  // namespace furrow::test
