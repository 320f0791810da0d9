// The program from outside: exit codes, what goes to which stream, which files are left.
#include "program.h"

#include <sys/resource.h>

#include <list>
#include <thread>

namespace furrow::test {
namespace {

TEST_F(Program, RunWritesEveryFileAndPrintsOnlyRunJson) {
  const Result r = furrow("run " + scene("scenario_1") + " --until 0.4 --out here");
  ASSERT_EQ(r.code, 0) << r.err;
  for (const char* name : {"plate_force.csv", "energy.csv", "motion.csv", "events.csv", "state.csv", "scene.toml",
                           "run.pvd", "run.json", "frames/frames.csv", "frames/links_001.csv", "frames/links_001.vtp",
                           "frames/discs_000.vtp", "frames/plates_000.vtp"}) {
    EXPECT_TRUE(has(std::string("here/") + name)) << name;
  }
  for (const std::string& name : files("here")) EXPECT_EQ(name.find(".partial"), std::string::npos) << name;
  const auto json = nlohmann::json::parse(r.out);
  EXPECT_EQ(json, nlohmann::json::parse(text_of(directory_ / "here/run.json")));
  EXPECT_EQ(json["ended"], "finished");
  EXPECT_EQ(json["steps"], 4000);
  EXPECT_EQ(json["rhs_evaluations"], 8000);
  EXPECT_EQ(json["method"], "pece");
  EXPECT_EQ(json["state_hash"].get<std::string>().size(), 16U);
}

TEST_F(Program, RunSaysWhereItsFilesAreIfNobodySaidIt) {
  const std::string words =
      "furrow: disc_on_wall finished; its files are in runs/disc_on_wall (--out DIR puts them elsewhere)\n";
  EXPECT_EQ(furrow("run " + scene("disc_on_wall")).err, words);
  EXPECT_TRUE(has("runs/disc_on_wall/run.json"));
  EXPECT_EQ(furrow("run " + scene("disc_on_wall") + " --out here").err, "");
  EXPECT_EQ(furrow("run " + scene("disc_on_wall") + " --resume here").err, "");
}

TEST_F(Program, HeadingsCarryUnits) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.01 --out here").code, 0);
  std::istringstream force(text_of(directory_ / "here/plate_force.csv"));
  std::string heading;
  std::getline(force, heading);
  EXPECT_EQ(heading, "t [s],plate,displacement [m],Fx [N],Fy [N],F [N]");
}

TEST_F(Program, RunTwiceGivesTheSameBytes) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.4 --out one").code, 0);
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.4 --out two").code, 0);
  for (const char* name : {"plate_force.csv", "energy.csv", "events.csv", "state.csv", "frames/links_001.vtp"}) {
    EXPECT_EQ(text_of(directory_ / "one" / name), text_of(directory_ / "two" / name)) << name;
  }
}

TEST_F(Program, OverridesAreTakenAndRecorded) {
  const Result r = furrow("run " + scene("scenario_1") + " --until 0.05 --method rk4 --dt 2e-4 --out here");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = nlohmann::json::parse(r.out);
  EXPECT_EQ(json["method"], "rk4");
  EXPECT_EQ(json["steps"], 250);
  EXPECT_EQ(json["rhs_evaluations"], 1000);
}

TEST_F(Program, ControlledOdeintMethodRunsAPaperScene) {
  const Result r = furrow("run " + scene("scenario_1") + " --until 0.1 --method odeint_dopri5 --out here");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NEAR(nlohmann::json::parse(r.out)["ended_at"].get<double>(), 0.1, 1e-12);
}

TEST_F(Program, BadSceneGetsItsErrorsExitTwoAndNoFiles) {
  for (const char* name : {"missing_key", "misspelt_key", "not_utf8", "not_toml", "nothing_moves", "out_of_range",
                           "table_or_list", "two_rigid", "unknown_material", "unknown_word", "wrong_type"}) {
    for (const char* command : {"run ", "check ", "explain "}) {
      const Result r = furrow(command + bad_scene(name));
      EXPECT_EQ(r.code, 2) << command << name;
      EXPECT_NE(r.err.find(std::string(name) + ".toml:"), std::string::npos) << r.err;
      EXPECT_NE(r.err.find(": error: "), std::string::npos) << r.err;
      EXPECT_EQ(r.out, "") << command << name;
    }
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(Program, CheckGoesOnAfterABadFile) {
  const Result r = furrow("check " + bad_scene("not_toml") + " " + scene("scenario_2") + " nowhere.toml");
  EXPECT_EQ(r.code, 2);
  EXPECT_NE(r.out.find("scenario_2.toml: ok"), std::string::npos);
  EXPECT_NE(r.err.find("nowhere.toml"), std::string::npos);
}

TEST_F(Program, AMethodThatCannotCarryTheSceneSaysWhyAndWritesNothing) {
  const Result damped = furrow("run " + scene("scenario_1") + " --method odeint_symplectic_euler");
  EXPECT_EQ(damped.code, 2);
  EXPECT_NE(damped.err.find("depend on velocity"), std::string::npos) << damped.err;
  EXPECT_NE(damped.err.find("links of lattice stem"), std::string::npos) << damped.err;
  const Result large = furrow("run " + scene("scenario_2") + " --method odeint_rosenbrock4");
  EXPECT_EQ(large.code, 2);
  EXPECT_NE(large.err.find("at most 200"), std::string::npos) << large.err;
  EXPECT_TRUE(files().empty());
}

TEST_F(Program, UsageErrorsExitTwo) {
  EXPECT_EQ(furrow("").code, 2);
  EXPECT_EQ(furrow("rum x").code, 2);
  EXPECT_EQ(furrow("run " + scene("scenario_1") + " --dt -1").code, 2);
  EXPECT_EQ(furrow("run " + scene("scenario_1") + " --dt 5").code, 2);  // longer than the run
  EXPECT_EQ(furrow("run").code, 2);
  EXPECT_EQ(furrow("--help").code, 0);
  EXPECT_EQ(furrow("--version").code, 0);
}

// Without a ledger nothing sees the energy that is made before bodies outrun their size.
TEST_F(Program, DivergedRunExitsThreeNamesTheCulpritAndKeepsTheLastGoodState) {
  std::ofstream(directory_ / "scenario_1.toml")
      << text_of(FURROW_SOURCE_DIR "/validation/scenes/literal/scenario_1.toml") << "energy = false\n";
  const Result r = furrow("run scenario_1.toml --dt 0.05 --until 1.2 --out here");
  EXPECT_EQ(r.code, 3);
  EXPECT_NE(r.err.find("scenario_1 diverged: node (row "), std::string::npos) << r.err;
  const auto json = nlohmann::json::parse(r.out);
  EXPECT_EQ(json["ended"], "diverged");
  EXPECT_NE(json["reason"].get<std::string>().find("moved"), std::string::npos);
  EXPECT_TRUE(has("here/state.csv"));
  EXPECT_TRUE(has("here/plate_force.csv"));
  EXPECT_EQ(text_of(directory_ / "here/state.csv").find("nan"), std::string::npos);
}

TEST_F(Program, ExplainNamesWhatIsModelledLeftOutAndTheStableStep) {
  const Result r = furrow("explain " + scene("scenario_1"));
  ASSERT_EQ(r.code, 0) << r.err;
  for (const char* part : {"24 free", "6 fixed", "117: ", "E* = 133333 Pa, G* = 40000 Pa", "damping ratio 18.26",
                           "has no weight (gravity = false)", "neighbour search", "pece", "<- the scene's method"}) {
    EXPECT_NE(r.out.find(part), std::string::npos) << part << "\n" << r.out;
  }
}

// The sphere reading has 75 times less mass: the paper's step is far beyond what its contact damping allows.
class SphereReading : public Program {
 protected:
  void write_scene(const std::string& settle, const std::string& discs, const std::string& depth) const {
    std::string text = text_of(FURROW_SOURCE_DIR "/validation/scenes/literal/scenario_2.toml");
    const auto replace = [&](const std::string& old, const std::string& with) {
      text.replace(text.find(old), old.size(), with);
    };
    replace("disc_mass = \"disc\"", "disc_mass = \"sphere\"");
    replace("count = 230", "count = " + discs);
    replace("working_depth = 0.04", "working_depth = " + depth);
    replace("limit = 20.0", settle);
    std::ofstream(directory_ / "sphere.toml") << text;
  }
};

TEST_F(SphereReading, ExplainAndRunWarnOfTheStep) {
  write_scene("limit = 20.0\nstep = 1e-5", "40", "0.01");
  const Result explained = furrow("explain sphere.toml");
  ASSERT_EQ(explained.code, 0) << explained.err;
  EXPECT_NE(explained.out.find("NOT safely inside"), std::string::npos) << explained.out;
  const Result r = furrow("run sphere.toml --until 0.001 --out here");
  EXPECT_NE(r.err.find("warning: while settling, at t = "), std::string::npos) << r.err;
  EXPECT_NE(r.err.find("warning: at t = 0 s the step is 3.8 times the largest stable one (pece allows"),
            std::string::npos)
      << r.err;
  EXPECT_EQ(nlohmann::json::parse(text_of(directory_ / "here/run.json"))["warnings"].size(), 2U);
}

TEST_F(SphereReading, BedThatCannotSettleAtThePapersStepFailsAndSaysWhy) {
  write_scene("limit = 3.0", "230", "0.04");
  const Result r = furrow("run sphere.toml --out here");
  EXPECT_EQ(r.code, 3);
  EXPECT_NE(r.err.find("while settling, at t = "), std::string::npos) << r.err;
  EXPECT_NE(r.err.find("the method or a law has made"), std::string::npos) << r.err;
  EXPECT_EQ(nlohmann::json::parse(r.out)["ended"], "diverged");
}

TEST_F(Program, LocateIsAKeyAndAnOption) {
  EXPECT_EQ(furrow("run " + scene("disc_on_wall") + " --locate here --out here").code, 2);
  const Result r = furrow("run " + scene("disc_on_wall") + " --locate all --out here");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(nlohmann::json::parse(r.out)["events"], 2);  // it touches and lets go
  EXPECT_NE(text_of(directory_ / "here" / "scene.toml").find("locate = \"all\""), std::string::npos);
}

TEST_F(Program, ThreadsAreForLargeBeds) {
  const std::string wide = (directory_ / "wide.toml").string();
  std::ofstream(wide)
      << "title = \"wide\"\n[model]\ngravity = 9.81\n[time]\nstep = 1e-4\nend = 1e-3\n[contact]\nfriction = 0.5\n"
         "[[material]]\nname = \"sand\"\nyoung = 1e6\npoisson = 0.3\n"
         "[[packing]]\nmaterial = \"sand\"\ncount = 4500\nradius_min = 0.01\nradius_max = 0.01\n"
         "lower_left = [0.0, 0.0]\nupper_right = [2.0, 2.0]\nseed = 1\n"
         "[[wall]]\npoint = [0.0, 0.0]\nnormal = [0.0, 1.0]\nmaterial = \"sand\"\n";
  std::vector<nlohmann::json> hashes;
  for (const char* threads : {"1", "2"}) {
    const Result r = furrow("run wide.toml --threads " + std::string(threads) + " --out threads_" + threads);
    ASSERT_EQ(r.code, 0) << r.err;
    hashes.push_back(nlohmann::json::parse(r.out)["state_hash"]);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(furrow("run wide.toml --threads 0").code, 2);
  EXPECT_NE(text_of(directory_ / "threads_2/scene.toml").find("threads = 2"), std::string::npos);
}

// Of the whole process, as the operating system counts it: the first thread alone has half of that.
TEST_F(Program, SecondsOfARunOnTwoThreadsAreThoseOfBoth) {
  put("bed.toml", bed_on_two_threads(9000, "2.4e-2", "2.2"));

  const auto used = [] {
    rusage all{};
    getrusage(RUSAGE_CHILDREN, &all);
    return static_cast<double>(all.ru_utime.tv_sec + all.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(all.ru_utime.tv_usec + all.ru_stime.tv_usec);
  };
  const double before = used();
  const Result r = furrow("run bed.toml --out bed");
  const double process = used() - before;
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = nlohmann::json::parse(r.out);
  const double reported = json["settling_cpu_seconds"].get<double>() + json["cpu_seconds"].get<double>();
  EXPECT_GT(reported, 0.75 * process) << "the scene is read and judged in less than the rest";
  EXPECT_LT(reported, 1.01 * process);
}

// Threads that wait in a loop burn the time of whatever else runs: beside a busy program a processor, two threads of
// libgomp took 14 to 37 times the CPU time of one. A waiting thread gives up after 20 microseconds, some sixteen times a
// step: twice the time of one leaves room for that. The busy ones work before the runs begin and after they have ended.
TEST_F(Program, BesideBusyProgramsTwoThreadsTakeLittleMoreTimeThanOne) {
  put("bed.toml", bed_on_two_threads(9000, "6e-3", "2.2"));
  std::list<Process> busy;
  for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k)
    busy.emplace_back(directory_, "sh -c 'ulimit -t 600; while :; do :; done'");
  const auto work = [&] {
    return std::all_of(busy.begin(), busy.end(),
                       [](Process& one) { return !one.has_ended() && one.cpu_seconds() > 0; });
  };
  ASSERT_TRUE(comes_true(work));
  const auto seconds_with = [&](const std::string& threads) {
    const Result r = furrow("run bed.toml --out busy_" + threads + " --threads " + threads);
    EXPECT_EQ(r.code, 0) << r.err;
    return nlohmann::json::parse(text("busy_" + threads + "/run.json"))["cpu_seconds"].get<double>();
  };
  const double one = seconds_with("1"), two = seconds_with("2");
  EXPECT_LT(two, 2 * one);
  EXPECT_TRUE(work());
}

TEST_F(Program, MethodsListsTheCatalogue) {
  const Result r = furrow("methods");
  ASSERT_EQ(r.code, 0);
  for (const char* name : {"pece", "verlet", "rk4", "odeint_rk4", "odeint_abm2", "odeint_dopri5"}) {
    EXPECT_NE(r.out.find(std::string("\n") + name + " "), std::string::npos) << name;
  }
}

// Below the limit that `stability` prints a run holds; above it the beam's energy grows, and the run says so.
TEST_F(Program, StabilityPrintsTheStepThatARunSurvives) {
  const Result r = furrow("stability " + scene("cantilever") + " --method pece");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.out.find("driven by        structural link from node"), std::string::npos) << r.out;
  std::istringstream row(r.out.substr(r.out.find("\npece ")));
  std::string method;
  double predicted = 0, measured = 0;
  row >> method >> predicted >> measured;
  EXPECT_NEAR(measured / predicted, 1, 0.02) << r.out;
  const auto run_at = [&](double step) {
    return furrow("run " + scene("cantilever") + " --dt " + std::to_string(step) + " --out beam");
  };
  EXPECT_EQ(run_at(0.97 * predicted).code, 0);
  const Result above = run_at(1.03 * predicted);
  EXPECT_EQ(above.code, 3) << above.err;
  EXPECT_NE(above.err.find("cantilever is invalid: at t = "), std::string::npos) << above.err;
  EXPECT_NE(above.err.find("the method or a law has made"), std::string::npos) << above.err;
  EXPECT_NE(above.err.find("the stiffest that acts there is the structural link from node"), std::string::npos)
      << above.err;
}

TEST_F(Program, ARunThatMadeItsEnergyIsInvalidAndNamesWhatDrivesIt) {
  const Result r = furrow("run " + scene("scenario_1") + " --dt 0.01 --out here");
  EXPECT_EQ(nlohmann::json::parse(r.out)["ended"], "invalid");
  EXPECT_EQ(nlohmann::json::parse(r.out)["validity"]["energy_made"]["verdict"], "broken");
  EXPECT_EQ(r.code, 3) << r.err;
  EXPECT_NE(r.err.find("the stiffest that acts there is the contact of node"), std::string::npos) << r.err;
}

TEST_F(Program, StabilityRefusesWhatHasNoLimit) {
  EXPECT_EQ(furrow("stability " + scene("cantilever") + " --method odeint_dopri5").code, 2);
  EXPECT_EQ(furrow("stability " + scene("cantilever") + " --at 99").code, 2);
}

}  // namespace
}  // namespace furrow::test
