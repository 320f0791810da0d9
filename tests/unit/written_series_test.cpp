// The series that a run writes, read back and compared with the states that it went through.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "csv.h"
#include "output/run_files.h"
#include "written_scene.h"

namespace furrow {
namespace {

using namespace test;

constexpr double round_off = 1e-9;  // relative: an overlap of 1e-3 m is a difference of numbers of 1 m

class WrittenSeries : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    known_ = new KnownRun(written_scene());
    directory_ = new OwnDirectory;
    const RunOutcome outcome = run_with_files(
        {.scene_file = "written.toml", .scene = written_scene(), .directory = directory_->path() / "run"});
    ASSERT_EQ(outcome.ended, "finished") << outcome.reason;
  }
  static void TearDownTestSuite() {
    delete known_;
    delete directory_;
  }

  static const KnownRun& known() { return *known_; }
  static Csv csv(const std::string& name) { return Csv(directory_->path() / "run" / name); }

  // Rows are due every interval; each is of the step nearest to that.
  static std::vector<const Moment*> due() {
    std::vector<const Moment*> moments;
    for (int k = 0; k <= 87; ++k) moments.push_back(&known().nearest(k * 0.02 / 87));
    return moments;
  }

  static double mass(int body) { return mass_of(known().system, body); }

  static void expect(const Csv& file, std::size_t row, const std::string& heading, double want, double scale) {
    EXPECT_NEAR(file.number(row, heading), want, round_off * scale) << heading << ", row " << row;
  }

 private:
  inline static KnownRun* known_ = nullptr;
  inline static OwnDirectory* directory_ = nullptr;
};

TEST_F(WrittenSeries, HaveARowAtTheStartEachTimeItIsDueAndAtTheEnd) {
  const std::vector<const Moment*> want = due();
  EXPECT_EQ(want.front()->t, 0);
  EXPECT_EQ(want.back()->t, 0.02);
  const Csv force = csv("plate_force.csv"), energy = csv("energy.csv"), motion = csv("motion.csv");
  ASSERT_EQ(energy.rows.size(), want.size());
  ASSERT_EQ(motion.rows.size(), want.size());
  ASSERT_EQ(force.rows.size(), 2 * want.size());
  for (std::size_t k = 0; k < want.size(); ++k) {
    EXPECT_EQ(energy.number(k, "t [s]"), want[k]->t);
    EXPECT_EQ(motion.number(k, "t [s]"), want[k]->t);
    EXPECT_EQ(force.number(2 * k, "t [s]"), want[k]->t);
    EXPECT_EQ(force.number(2 * k + 1, "t [s]"), want[k]->t);
  }
}

TEST_F(WrittenSeries, ForceIsOnThePlateThatTheRowNamesAndItsOwnWay) {
  const Csv force = csv("plate_force.csv");
  ASSERT_EQ(force.headings,
            (std::vector<std::string>{"t [s]", "plate", "displacement [m]", "Fx [N]", "Fy [N]", "F [N]"}));
  const std::vector<const Moment*> moments = due();
  bool pushed_up = false;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    Vec2 want[2];
    for (const KnownContact& c : contacts_of(known(), *moments[k])) {
      if (c.plate < 0) continue;
      want[c.plate].x += c.push * c.nx;
      want[c.plate].y += c.push * c.ny;
    }
    for (std::size_t plate : {0, 1}) {
      const std::size_t row = 2 * k + plate;
      EXPECT_EQ(force.text(row, "plate"), plate == 0 ? "tool" : "press");
      const Vec2& v = known().scene.plate[plate].velocity;
      EXPECT_NEAR(force.number(row, "displacement [m]"), std::hypot(v.x, v.y) * moments[k]->t, 1e-15);
      expect(force, row, "Fx [N]", want[plate].x, 1000);
      expect(force, row, "Fy [N]", want[plate].y, 1000);
      expect(force, row, "F [N]", std::hypot(want[plate].x, want[plate].y), 1000);
      pushed_up = pushed_up || want[plate].y != 0;
    }
  }
  EXPECT_TRUE(pushed_up);  // or the columns Fx and F could be one another
}

TEST_F(WrittenSeries, ForceIsOnTheWallThatTheRowNames) {
  const Csv force = csv("wall_force.csv");
  ASSERT_EQ(force.headings, (std::vector<std::string>{"t [s]", "wall", "Fx [N]", "Fy [N]", "F [N]"}));
  const std::vector<const Moment*> moments = due();
  ASSERT_EQ(force.rows.size(), moments.size());
  double most = 0;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    Vec2 want;
    for (const KnownContact& c : contacts_of(known(), *moments[k])) {
      if (c.plate >= 0 || c.b >= 0) continue;
      want.x += c.push * c.nx;
      want.y += c.push * c.ny;
    }
    EXPECT_EQ(force.text(k, "wall"), "0");
    EXPECT_EQ(force.number(k, "t [s]"), moments[k]->t);
    expect(force, k, "Fx [N]", want.x, 1000);
    expect(force, k, "Fy [N]", want.y, 1000);
    expect(force, k, "F [N]", std::hypot(want.x, want.y), 1000);
    most = std::max(most, std::hypot(want.x, want.y));
  }
  EXPECT_GT(most, 1);
}

TEST_F(WrittenSeries, EnergyIsThatOfTheState) {
  const Csv energy = csv("energy.csv");
  const System& s = known().system;
  const Parts& parts = s.parts();
  const std::vector<const Moment*> moments = due();
  double least = 1e9, most = 0;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const State& y = moments[k]->y;
    double kinetic = 0, gravity = 0, springs = 0, contact = 0;
    for (int body = 0; body < parts.bodies(); ++body) {
      kinetic += 0.5 * mass(body) * (y[s.vx_of(body)] * y[s.vx_of(body)] + y[s.vy_of(body)] * y[s.vy_of(body)]);
      gravity += mass(body) * 9.81 * y[s.y_of(body)];
    }
    const NodeMotion nodes = s.nodes(0, y);
    for (int link = 0; link < parts.link.count(); ++link) {
      const int a = parts.link.a[link], b = parts.link.b[link];
      const double stretch = std::hypot(nodes.x[a] - nodes.x[b], nodes.y[a] - nodes.y[b]) - parts.link.rest[link];
      if (known().intact(link, moments[k]->t)) springs += 0.5 * parts.link.stiffness[link] * stretch * stretch;
    }
    for (const KnownContact& c : contacts_of(known(), *moments[k])) contact += c.energy;
    const int loaded = parts.node.body[5];
    const double load = -40 * (y[s.x_of(loaded)] - parts.node.x[5]) + 5 * (y[s.y_of(loaded)] - parts.node.y[5]);
    expect(energy, k, "kinetic [J]", kinetic, 100);
    expect(energy, k, "gravity [J]", gravity, 100);
    expect(energy, k, "load [J]", load, 100);
    expect(energy, k, "springs [J]", springs, 100);
    expect(energy, k, "contact elastic [J]", contact, 100);
    least = std::min(least, springs);
    most = std::max(most, springs);
  }
  EXPECT_GT(most, 10 * least);
}

TEST_F(WrittenSeries, LedgerIsThatOfTheStateAndItsResidualBeginsAtZero) {
  const Csv energy = csv("energy.csv");
  const System& s = known().system;
  const std::vector<const Moment*> moments = due();
  const auto stored = [&](std::size_t k) {
    double sum = 0;
    for (const char* of : {"kinetic [J]", "gravity [J]", "load [J]", "springs [J]", "contact elastic [J]"})
      sum += energy.number(k, of);
    return sum;
  };
  for (std::size_t k = 0; k < moments.size(); ++k) {
    double lost = 0, given = 0;
    for (const auto& [heading, entry, is_lost] : {std::tuple{"link damping [J]", link_damping, true},
                                                  {"contact viscous [J]", contact_viscous, true},
                                                  {"friction [J]", friction_work, true},
                                                  {"rolling [J]", rolling_work, true},
                                                  {"tear [J]", tear_energy, true},
                                                  {"plate work [J]", plate_work, false},
                                                  {"stiffening [J]", stiffening, false}}) {
      const double want = moments[k]->y[s.ledger_of(entry)];
      expect(energy, k, heading, want, 1);
      (is_lost ? lost : given) += want;
    }
    expect(energy, k, "residual [J]", stored(k) - stored(0) + lost - given, 100);
  }
  EXPECT_EQ(energy.number(0, "residual [J]"), 0);
  const std::size_t last = moments.size() - 1;
  for (const char* at_work : {"link damping [J]", "contact viscous [J]", "tear [J]"})
    EXPECT_GT(energy.number(last, at_work), 1e-3) << at_work;
  EXPECT_LT(std::fabs(energy.number(last, "residual [J]")), 0.01 * energy.number(last, "contact viscous [J]"));
}

TEST_F(WrittenSeries, MotionIsThatOfTheState) {
  const Csv motion = csv("motion.csv");
  const System& s = known().system;
  const std::vector<const Moment*> moments = due();
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const State& y = moments[k]->y;
    double px = 0, py = 0, angular = 0, fastest = 0;
    for (int body = 0; body < s.parts().bodies(); ++body) {
      const double m = mass(body), vx = y[s.vx_of(body)], vy = y[s.vy_of(body)];
      px += m * vx;
      py += m * vy;
      angular += m * (y[s.x_of(body)] * vy - y[s.y_of(body)] * vx);
      fastest = std::max(fastest, std::hypot(vx, vy));
    }
    double relative = 0, depth = 0;
    const std::vector<KnownContact> contacts = contacts_of(known(), *moments[k]);
    for (const KnownContact& c : contacts) {
      if (const double r = c.overlap / known().scene.disc[c.a].radius; r > relative) {
        relative = r;
        depth = c.overlap;
      }
    }
    expect(motion, k, "px [kg m/s]", px, 10);
    expect(motion, k, "py [kg m/s]", py, 10);
    expect(motion, k, "L [kg m^2/s]", angular, 10);
    EXPECT_EQ(motion.number(k, "contacts"), static_cast<double>(contacts.size()));
    expect(motion, k, "overlap [m]", depth, 1e-3);
    expect(motion, k, "relative overlap [-]", relative, 1e-2);
    expect(motion, k, "speed [m/s]", fastest, 1);
  }
}

TEST_F(WrittenSeries, EventsAreTheTearsWithTheirPlaceAndForce) {
  const Csv events = csv("events.csv");
  const Parts& parts = known().system.parts();
  std::size_t row = 0;
  for (const Moment& m : known().moments) {
    for (const Tear& tear : m.torn) {
      const int a = parts.link.a[tear.link], b = parts.link.b[tear.link];
      EXPECT_EQ(events.number(row, "t [s]"), m.t);
      EXPECT_NEAR(events.number(row, "displacement [m]"), 0.5 * m.t, 1e-15);  // of the first plate
      EXPECT_EQ(events.text(row, "kind"), "structural");
      EXPECT_EQ(events.text(row, "lattice"), "stem");
      // 2 rows by 3 columns: node n is in row n / 3 and column n % 3; those of column 0 are fixed.
      EXPECT_EQ(events.number(row, "row a"), a / 3);
      EXPECT_EQ(events.number(row, "column a"), a % 3);
      EXPECT_EQ(events.number(row, "row b"), b / 3);
      EXPECT_EQ(events.number(row, "column b"), b % 3);
      EXPECT_EQ(events.number(row, "fixed"), (a % 3 == 0) + (b % 3 == 0));
      const NodeMotion nodes = known().system.nodes(m.t, m.y);
      const double length = std::hypot(nodes.x[a] - nodes.x[b], nodes.y[a] - nodes.y[b]);
      EXPECT_NEAR(events.number(row, "force [N]"), 100 * (length - 0.5), 1e-9);
      ++row;
    }
  }
  EXPECT_GE(row, 2u);
  EXPECT_EQ(events.rows.size(), row);
}

// No row is due in the last 0.0005 s of these runs: a row every 0.003 s.
Scene ending_between_rows() {
  Scene scene = written_scene();
  scene.time.end = 0.0155;
  scene.output.interval = 0.003;
  scene.output.frames = {};
  return scene;
}

RunOutcome written(const Scene& scene, const OwnDirectory& directory, bool goes_on) {
  RunRequest request{.scene_file = "s.toml", .scene = scene, .directory = directory.path() / "run"};
  request.progress = [goes_on](const std::string&, double, double) { return goes_on; };
  return run_with_files(request);
}

TEST(LastRow, IsTheEndOfARunThatEndsWhereNoneIsDue) {
  const KnownRun known(ending_between_rows());
  const OwnDirectory directory;
  ASSERT_EQ(written(ending_between_rows(), directory, true).ended, "finished");
  const Csv force(directory.path() / "run/plate_force.csv"), energy(directory.path() / "run/energy.csv"),
      motion(directory.path() / "run/motion.csv");
  const std::vector<double> want{0, 0.003, 0.006, 0.009, 0.012, 0.015, 0.0155};  // s
  ASSERT_EQ(motion.rows.size(), want.size());
  ASSERT_EQ(energy.rows.size(), want.size());
  ASSERT_EQ(force.rows.size(), 2 * want.size());
  for (std::size_t k = 0; k < want.size(); ++k) EXPECT_NEAR(motion.number(k, "t [s]"), want[k], 1e-15);
  EXPECT_EQ(force.number(force.rows.size() - 1, "t [s]"), 0.0155);
  EXPECT_EQ(motion.number(6, "speed [m/s]"), greatest_speed(known.system, known.moments.back().y));
}

TEST(LastRow, IsWhereARunWasStopped) {
  const OwnDirectory directory;
  ASSERT_EQ(written(ending_between_rows(), directory, false).ended, "interrupted");
  const Csv motion(directory.path() / "run/motion.csv.partial");
  ASSERT_EQ(motion.rows.size(), 4u);
  EXPECT_NEAR(motion.number(3, "t [s]"), 0.0063, 1e-15);  // asked after each 64 states; the start is the first
}

// A disc falls ever faster, until it is above a thin plate before a step and below it after.
TEST(LastRow, IsTheLastGoodStateOfARunThatDiverged) {
  Scene scene = empty_scene();
  scene.model.gravity = 1e5;
  scene.disc = {disc({0, 0}, 0.05)};
  scene.plate = {plate({-0.5, -10.016}, 1, 0.01)};
  scene.time = {.end = 0.1, .step = 1e-4, .method = "pece"};
  scene.output.interval = 0.0037;
  const OwnDirectory directory;
  const RunOutcome outcome = written(scene, directory, true);
  ASSERT_EQ(outcome.ended, "diverged");
  const double end = nlohmann::json::parse(outcome.json).at("ended_at");
  const Csv motion(directory.path() / "run/motion.csv");
  const std::size_t last = motion.rows.size() - 1;
  EXPECT_EQ(motion.number(last, "t [s]"), end);
  EXPECT_NEAR(motion.number(last, "speed [m/s]"), 1e5 * end, 1e-6 * 1e5 * end);  // exact but for round-off
  EXPECT_GT(motion.number(last, "t [s]"), motion.number(last - 1, "t [s]"));
}

}  // namespace
}  // namespace furrow
