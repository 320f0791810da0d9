// What the files of a run say of spins, of methods that choose their steps, of settling, of located events and of the
// moment when a plate meets a lattice.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "csv.h"
#include "output/run_files.h"
#include "scene/packing.h"
#include "written_scene.h"

namespace furrow {
namespace {

using namespace test;

struct Written {
  explicit Written(const Scene& scene)
      : outcome(run_with_files({.scene_file = "s.toml", .scene = scene, .directory = directory.path() / "run"})),
        json(nlohmann::json::parse(outcome.json)) {}
  Csv csv(const std::string& name) const { return Csv(directory.path() / "run" / name); }

  OwnDirectory directory;
  RunOutcome outcome;
  nlohmann::json json;
};

// A disc thrown along a floor with spin, and one that falls on it.
Scene spinning() {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.friction = 0.4;
  scene.contact.rolling_friction = 0.1;
  scene.contact.damping_factor = 0.2;
  scene.disc = {disc({0, 0.0499}, 0.05, {1, 0}, 7), disc({0.03, 0.13}, 0.04, {0, -1}, -3)};
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.time = {.end = 0.02, .step = 1e-4, .method = "pece"};
  scene.output.interval = 1e-3;
  scene.output.frames = {0, 0.01};
  return scene;
}

// A disc of 0.01 m that comes to a wall in steps of a tenth of the contact, and 20 that rest far away. Of so many each 14th step
// is looked at without a row, and what verlet is off in the middle of the contact is gone by then.
TEST(WrittenRuns, TheEnergyIsWatchedInEveryRow) {
  Scene scene = empty_scene();
  scene.material[0].young = 8e9;
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.disc = {disc({0, 0.0105}, 0.01, {0, -1})};
  for (int k = 1; k <= 20; ++k) scene.disc.push_back(disc({1.0 * k, 0.5}, 0.01));
  scene.time = {.end = 0.012, .step = 2e-4, .method = "verlet"};
  scene.output.interval = 2e-4;
  scene.allow = {.energy_made = 1, .energy_lost = 1, .overlap = 1, .step = 10};
  const Written written(scene);
  const Csv energy = written.csv("energy.csv");
  double worst = 0;
  for (int row = 0; row < 60; ++row)
    worst = std::max(worst, energy.number(row, "residual [J]") / energy.number(0, "kinetic [J]"));
  ASSERT_GT(worst, 0.1) << "or nothing was tried";
  EXPECT_NEAR(written.json["validity"]["energy_made"]["worst"].get<double>(), worst, 1e-9);
}

TEST(WrittenRuns, SpinsAndWhatFrictionTookAreThoseOfTheState) {
  const KnownRun known(spinning());
  const Written written(spinning());
  const State& y = known.moments.back().y;
  const Csv state = written.csv("state.csv"), picture = written.csv("frames/discs_001.csv");
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(state.number(i, "spin [rad/s]"), y[known.system.spin_of(i)]);
    EXPECT_EQ(picture.number(i, "spin [rad/s]"), known.nearest(0.01).y[known.system.spin_of(i)]);
    EXPECT_NE(state.number(i, "spin [rad/s]"), picture.number(i, "spin [rad/s]"));
  }
  EXPECT_EQ(written.csv("frames/discs_000.csv").number(0, "spin [rad/s]"), 7);
  const Csv energy = written.csv("energy.csv");
  EXPECT_EQ(energy.number(20, "friction [J]"), y[known.system.ledger_of(friction_work)]);
  EXPECT_EQ(energy.number(20, "rolling [J]"), y[known.system.ledger_of(rolling_work)]);
  EXPECT_GT(energy.number(20, "friction [J]"), 1e-2);
  EXPECT_GT(energy.number(20, "rolling [J]"), 1e-3);
}

TEST(WrittenRuns, AMethodThatChoosesItsStepsLandsOnEveryRowAndFrame) {
  Scene scene = spinning();
  scene.time.method = "pece_adaptive";
  scene.time.max_step = 4e-4;
  scene.time.end = 0.0105;
  scene.output.frames = {0, 0.00333, 0.0105};
  const Written written(scene);
  ASSERT_EQ(written.outcome.ended, "finished") << written.outcome.reason;
  const Csv motion = written.csv("motion.csv"), frames = written.csv("frames/frames.csv");
  ASSERT_EQ(motion.rows.size(), 12u);
  EXPECT_EQ(motion.number(11, "t [s]"), 0.0105) << "the end is a row";
  for (std::size_t k = 0; k < 11; ++k) EXPECT_EQ(motion.number(k, "t [s]"), static_cast<double>(k) * 1e-3);
  ASSERT_EQ(frames.rows.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(frames.number(k, "t [s]"), scene.output.frames[k]);
  EXPECT_EQ(written.json["ended_at"], 0.0105);
  EXPECT_EQ(written.json["method"], "pece_adaptive");
}

TEST(WrittenRuns, ControlledStepsAreAtMostMaxStepAndCountedWithThoseRejected) {
  Scene scene = spinning();
  scene.time.method = "pece_adaptive";
  scene.time.max_step = 4e-4;
  scene.time.relative_tolerance = 1e-4;
  scene.time.absolute_tolerance = 1e-7;
  const Written written(scene);
  Prepared prepared = prepare(scene);
  const auto method = make_method("pece_adaptive", {1e-4, 1e-7, 1e-4});
  // The rows, of which each ends a step, are the only stops here but the frame at 0.01, which is one of them.
  const RunPlan plan{.start = 0, .end = 0.02, .step = 4e-4, .stop = [](double t) {
                       return std::min(0.02, (std::floor(t / 1e-3 + 1e-9) + 1) * 1e-3);
                     }};
  double longest = 0, last = 0;
  const RunEnd end = run(prepared.system, *method, prepared.y, plan, [&](double t, const State&, const JumpReport&) {
    longest = std::max(longest, t - last);
    last = t;
    return true;
  });
  EXPECT_LE(longest, 4e-4 * (1 + 1e-12));
  EXPECT_GT(method->rejections(), 0);
  EXPECT_EQ(written.json["rejected"], method->rejections());
  EXPECT_EQ(written.json["steps"], end.steps);
  EXPECT_EQ(written.json["rhs_evaluations"], method->evaluations());
}

TEST(WrittenRuns, LocatedEventsAreCountedWithTheirEvaluations) {
  Scene scene = spinning();
  scene.time.locate = Locate::all;
  scene.time.step = 1e-5;
  scene.disc.erase(scene.disc.begin());  // one touch, one release
  scene.disc[0].position = {0, 0.041};
  const Written written(scene);
  Prepared prepared = prepare(scene);
  const auto method = make_method("pece");
  const RunPlan plan{.start = 0, .end = 0.02, .step = 1e-5, .locate = Locate::all};
  const RunEnd end =
      run(prepared.system, *method, prepared.y, plan, [](double, const State&, const JumpReport&) { return true; });
  EXPECT_GE(end.events, 1);
  EXPECT_GT(end.event_evaluations, 0);
  EXPECT_EQ(written.json["events"], end.events);
  EXPECT_EQ(written.json["rhs_evaluations"], method->evaluations() + end.event_evaluations);
}

// The plate's right edge starts 0.01 m short of the free node and gains 1 m/s: it has passed it strictly first at the
// step after 0.01 s. The fixed node is passed before, and does not count.
TEST(WrittenRuns, APlateMeetsALatticeWhenAFreeNodeIsInIt) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0.05}, 1, 2, 0.0025);
  l.fixed_columns = {0};
  l.material = "soft";
  l.node_mass = 1e9;  // it stays where it is
  l.structural = link_kind(1, 0);
  scene.lattice = {l};
  scene.plate = {plate({-5, 0}, 0.01, 0.1, {0, 0}), plate({-0.1175, 0}, 0.11, 0.1, {1, 0})};
  scene.time = {.end = 0.02, .step = 3e-4, .method = "pece"};
  EXPECT_NEAR(Written(scene).json["plate_meets_lattice"].get<double>(), 34 * 3e-4, 1e-12);
  scene.plate[1].lower_edge = 0.0501;  // passes above
  EXPECT_TRUE(Written(scene).json["plate_meets_lattice"].is_null());
  scene.plate[1].lower_edge = -0.0501;  // passes below
  EXPECT_TRUE(Written(scene).json["plate_meets_lattice"].is_null());
  scene.plate[1] = plate({-0.1175, 0}, 0.11, 0.1, {1, 0});
  scene.time.end = 0.0099;
  EXPECT_TRUE(Written(scene).json["plate_meets_lattice"].is_null());
}

TEST(WrittenRuns, SettlingIsRecordedWithItsSurfaceSeedsTimeAndSteps) {
  Scene scene = spinning();
  scene.disc.clear();
  scene.contact.damping_factor = 0.9;
  scene.wall.push_back(wall({-0.1, 0}, {1, 0}));
  scene.wall.push_back(wall({0.1, 0}, {-1, 0}));
  Packing p{.count = 3,
            .radius_min = 0.02,
            .radius_max = 0.02,
            .lower_left = {-0.1, 0},
            .upper_right = {0, 0.3},
            .material = "soft",
            .seed = 77};
  scene.packing = {p};
  p.lower_left = {0, 0};
  p.upper_right = {0.1, 0.3};
  p.seed = 5;
  scene.packing.push_back(p);
  scene.settle = Settle{.speed = 1e-2, .hold = 0.05, .limit = 5};
  const Prepared prepared = prepare(scene);
  std::vector<std::string> doing;
  std::vector<double> total;
  OwnDirectory directory;
  const RunOutcome outcome = run_with_files({.scene_file = "s.toml",
                                             .scene = scene,
                                             .directory = directory.path() / "run",
                                             .progress = [&](const std::string& what, double done, double all) {
                                               // Settling says how far it is and what it waits for.
                                               const std::string word = what.substr(0, what.find(' '));
                                               if (doing.empty() || doing.back() != word) {
                                                 doing.push_back(word);
                                                 total.push_back(all);
                                               }
                                               EXPECT_LE(done, all);
                                               return true;
                                             }});
  const auto json = nlohmann::json::parse(outcome.json);
  EXPECT_EQ(json["seed"], (nlohmann::json{77, 5}));
  EXPECT_EQ(json["surface"], prepared.surface.value());
  EXPECT_EQ(json["settling_time"], prepared.settling_time);
  EXPECT_EQ(json["settling_steps"], prepared.settling_steps);
  EXPECT_GT(prepared.settling_steps, 100);
  EXPECT_EQ(json["discs"], 6);
  EXPECT_EQ(doing, (std::vector<std::string>{"settling", "running"}));
  EXPECT_EQ(total, (std::vector<double>{5, 0.02}));
}

TEST(WrittenRuns, WithoutALedgerEnergyHasNoRowsAndTheRestIsThere) {
  Scene scene = spinning();
  scene.output.energy = false;
  const Written written(scene);
  EXPECT_EQ(written.csv("energy.csv").rows.size(), 0u);
  EXPECT_EQ(written.csv("motion.csv").rows.size(), 21u);
}

}  // namespace
}  // namespace furrow
