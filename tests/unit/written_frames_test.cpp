// The pictures and the end of a run, read back (.vtp by VTK's own reader) and compared with the states that it went
// through.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "csv.h"
#include "output/build_info.h"
#include "output/machine.h"
#include "output/run_files.h"
#include "scene/read.h"
#include "written_contacts.h"

namespace furrow {
namespace {

using namespace test;

class WrittenFrames : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    known_ = new KnownRun(written_scene());
    directory_ = new OwnDirectory;
    outcome_ = new RunOutcome(run_with_files(
        {.scene_file = "written.toml", .scene = written_scene(), .directory = directory_->path() / "run"}));
    ASSERT_EQ(outcome_->ended, "finished") << outcome_->reason;
  }
  static void TearDownTestSuite() {
    delete known_;
    delete directory_;
    delete outcome_;
  }

  static const KnownRun& known() { return *known_; }
  static const System& system() { return known_->system; }
  static std::filesystem::path file(const std::string& name) { return directory_->path() / "run" / name; }
  static const RunOutcome& outcome() { return *outcome_; }

  // x, y, radius, vx, vy, spin, von Mises of each disc; the stress from the contacts' closed forms.
  static std::vector<std::vector<double>> discs(const Moment& m) {
    std::vector<std::vector<double>> rows;
    std::vector<double> xx(3), yy(3), xy(3);
    for (const KnownContact& c : contacts_of(known(), m)) {
      for (const auto& [disc, arm] : {std::pair{c.a, c.arm_a}, {c.b, c.arm_b}}) {
        if (disc < 0) continue;
        const double radius = known().scene.disc[disc].radius;
        const double each = -arm * c.push / (std::numbers::pi * radius * radius * 0.5);
        xx[disc] += each * c.nx * c.nx;
        yy[disc] += each * c.ny * c.ny;
        xy[disc] += each * c.nx * c.ny;
      }
    }
    for (int i = 0; i < 3; ++i) {
      const double mises = std::sqrt(xx[i] * xx[i] - xx[i] * yy[i] + yy[i] * yy[i] + 3 * xy[i] * xy[i]);
      rows.push_back({m.y[system().x_of(i)], m.y[system().y_of(i)], known().scene.disc[i].radius,
                      m.y[system().vx_of(i)], m.y[system().vy_of(i)], 0, mises});
    }
    return rows;
  }

  // x1, y1, x2, y2, force, kind of each link that is not torn.
  static std::vector<std::vector<double>> links(const Moment& m) {
    const LinkArrays& link = system().parts().link;
    const NodeMotion nodes = system().nodes(m.t, m.y);
    std::vector<std::vector<double>> rows;
    for (int k = 0; k < link.count(); ++k) {
      if (!known().intact(k, m.t)) continue;
      const int a = link.a[k], b = link.b[k];
      const double length = std::hypot(nodes.x[a] - nodes.x[b], nodes.y[a] - nodes.y[b]);
      // 2 x 3 nodes, 0.5 m apart: what is not a diagonal and not 1 m long is structural.
      const double kind = link.rest[k] > 0.9 ? 2 : link.rest[k] > 0.6 ? 1 : 0;
      const double stiffness = kind == 0 ? 100 : kind == 1 ? 50 : 20;
      rows.push_back({nodes.x[a], nodes.y[a], nodes.x[b], nodes.y[b], stiffness * (length - link.rest[k]), kind});
    }
    return rows;
  }

  // left, lower, width, height, vx, vy of each plate.
  static std::vector<std::vector<double>> plates(double t) {
    std::vector<std::vector<double>> rows;
    for (const Plate& p : known().scene.plate) {
      rows.push_back({p.left_edge + p.velocity.x * t, *p.lower_edge + p.velocity.y * t, p.width, p.height, p.velocity.x,
                      p.velocity.y});
    }
    return rows;
  }

 private:
  inline static KnownRun* known_ = nullptr;
  inline static OwnDirectory* directory_ = nullptr;
  inline static RunOutcome* outcome_ = nullptr;
};

void expect_equal(const std::vector<double>& got, const std::vector<double>& want, const std::string& what) {
  ASSERT_EQ(got.size(), want.size()) << what;
  for (std::size_t k = 0; k < got.size(); ++k)
    EXPECT_NEAR(got[k], want[k], 1e-9 * std::max(1.0, std::fabs(want[k]))) << what << ", number " << k;
}

void expect_rows(const Csv& file, const std::vector<std::string>& headings,
                 const std::vector<std::vector<double>>& want, const std::string& what) {
  ASSERT_GE(file.headings.size(), headings.size()) << what;
  ASSERT_EQ(file.rows.size(), want.size()) << what;
  for (std::size_t row = 0; row < want.size(); ++row) {
    for (std::size_t k = 0; k < headings.size(); ++k) {
      EXPECT_NEAR(file.number(row, headings[k]), want[row][k], 1e-9 * std::max(1.0, std::fabs(want[row][k])))
          << what << ", row " << row << ", " << headings[k];
    }
  }
}

TEST_F(WrittenFrames, AsCsvAreTheStateAtTheirTimeAndTheLastOneAtTheEnd) {
  const Csv list(file("frames/frames.csv"));
  ASSERT_EQ(list.rows.size(), 3u);
  const double times[] = {0, 0.0051, 0.02};  // 0.00512 is nearest to step 51
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string index = "00" + std::to_string(k) + ".csv";
    const Moment& m = known().nearest(times[k]);
    EXPECT_EQ(list.number(k, "index"), static_cast<double>(k));
    EXPECT_EQ(list.number(k, "t [s]"), m.t);
    EXPECT_NEAR(list.number(k, "t [s]"), times[k], 1e-15);
    EXPECT_NEAR(list.number(k, "displacement [m]"), 0.5 * m.t, 1e-15);  // of the first plate
    expect_rows(Csv(file("frames/discs_" + index)),
                {"x [m]", "y [m]", "radius [m]", "vx [m/s]", "vy [m/s]", "spin [rad/s]", "von Mises [Pa]"}, discs(m),
                index);
    const Csv links_file(file("frames/links_" + index));
    expect_rows(links_file, {"x1 [m]", "y1 [m]", "x2 [m]", "y2 [m]", "force [N]"}, links(m), index);
    for (std::size_t row = 0; row < links_file.rows.size(); ++row) {
      const char* kinds[] = {"structural", "shear", "bending"};
      EXPECT_EQ(links_file.text(row, "kind"), kinds[static_cast<int>(links(m)[row][5])]);
    }
    expect_rows(Csv(file("frames/plates_" + index)),
                {"left [m]", "lower [m]", "width [m]", "height [m]", "vx [m/s]", "vy [m/s]"}, plates(m.t), index);
  }
  EXPECT_LT(links(known().nearest(0.02)).size(), links(known().nearest(0)).size());  // some are torn
}

TEST_F(WrittenFrames, AsVtkAreWhatTheCsvSaysByNameOrderAndCorner) {
  const std::string command =
      "/usr/bin/python3 '" FURROW_SOURCE_DIR "/tests/vtk/read_back.py' '" + file("").string() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string text;
  char part[4096];
  while (const std::size_t n = std::fread(part, 1, sizeof part, pipe)) text.append(part, n);
  const int status = pclose(pipe);
  if (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) GTEST_SKIP() << "no python3-vtk9 to read with";
  ASSERT_EQ(status, 0);
  using Json = nlohmann::json;
  const Json read = Json::parse(text);
  ASSERT_EQ(read.size(), 12u);
  const double times[] = {0, 0.0051, 0.02};
  const auto numbers = [](const Json& array) {
    std::vector<double> all;
    for (const Json& tuple : array)
      for (const Json& value : tuple) all.push_back(value.get<double>());
    return all;
  };
  const auto in_order = [](std::size_t cells, std::size_t corners) {
    std::vector<std::vector<int>> want(cells);
    for (std::size_t k = 0; k < cells * corners; ++k) want[k / corners].push_back(static_cast<int>(k));
    return want;
  };
  for (std::size_t k = 0; k < 12; ++k) {
    const Json& set = read[k];
    const char* names[] = {"discs", "links", "plates", "contacts"};
    const std::string name = names[k % 4];
    const Moment& m = known().nearest(times[k / 4]);
    EXPECT_EQ(set["name"], name);
    EXPECT_EQ(set["file"], "frames/" + name + "_00" + std::to_string(k / 4) + ".vtp");
    EXPECT_EQ(set["part"], k % 4);
    EXPECT_NEAR(set["time"].get<double>(), m.t, 1e-6 * m.t);
    const Json& data = name == "discs" ? set["point_data"] : set["cell_data"];
    std::map<std::string, std::vector<double>> want;
    std::vector<double> points;
    std::size_t cells = 0, corners = 0;
    if (name == "discs") {
      corners = 1;
      for (const std::vector<double>& d : discs(m)) {
        points.insert(points.end(), {d[0], d[1], 0});
        want["radius [m]"].push_back(d[2]);
        want["velocity [m/s]"].insert(want["velocity [m/s]"].end(), {d[3], d[4], 0});
        want["spin [rad/s]"].push_back(d[5]);
        want["von Mises [Pa]"].push_back(d[6]);
        ++cells;
      }
    } else if (name == "links") {
      corners = 2;
      for (const std::vector<double>& l : links(m)) {
        points.insert(points.end(), {l[0], l[1], 0, l[2], l[3], 0});
        want["force [N]"].push_back(l[4]);
        want["kind"].push_back(l[5]);
        ++cells;
      }
    } else if (name == "contacts") {
      corners = 2;
      cells = add_contacts(contact_rows(known(), m), points, want);
    } else {
      corners = 4;
      for (const std::vector<double>& p : plates(m.t)) {
        const double right = p[0] + p[2], upper = p[1] + p[3];
        points.insert(points.end(), {p[0], p[1], 0, right, p[1], 0, right, upper, 0, p[0], upper, 0});
        ++cells;
      }
    }
    expect_equal(numbers(set["points"]), points, name + " points");
    EXPECT_EQ(data.size(), want.size() + (name == "contacts" ? 1 : 0)) << name;  // and their slip
    for (const auto& [array, values] : want) {
      ASSERT_TRUE(data.contains(array)) << name << " has no array " << array;
      EXPECT_EQ(data[array]["tuples"].size(), cells) << array;
      expect_equal(numbers(data[array]["tuples"]), values, name + " " + array);
      EXPECT_EQ(data[array]["type"], array == "kind" || array.size() == 1 ? "int" : "double");
    }
    for (const auto& [shape, of] :
         {std::pair{"verts", "discs"}, {"lines", name == "contacts" ? "contacts" : "links"}, {"polys", "plates"}}) {
      const auto cells_there = set[shape].get<std::vector<std::vector<int>>>();
      EXPECT_EQ(cells_there, of == name ? in_order(cells, corners) : std::vector<std::vector<int>>{}) << name << shape;
    }
  }
}

TEST_F(WrittenFrames, StateIsEveryBodyAtTheEnd) {
  const Csv state(file("state.csv"));
  const Moment& last = known().moments.back();
  const NodeMotion nodes = system().nodes(last.t, last.y);
  ASSERT_EQ(state.rows.size(), 9u);
  const std::vector<std::vector<double>> disc_rows = discs(last);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(state.text(k, "body"), "disc");
    EXPECT_EQ(state.number(k, "index"), static_cast<double>(k));
    const char* headings[] = {"x [m]", "y [m]", "radius [m]", "vx [m/s]", "vy [m/s]", "spin [rad/s]"};
    for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(state.number(k, headings[c]), disc_rows[k][c]) << headings[c];
    EXPECT_NEAR(state.number(k, "von Mises [Pa]"), disc_rows[k][6], 1e-9 * disc_rows[k][6]);
  }
  for (std::size_t n = 0; n < 6; ++n) {
    EXPECT_EQ(state.text(3 + n, "body"), n % 3 == 0 ? "fixed node" : "node");
    EXPECT_EQ(state.number(3 + n, "index"), static_cast<double>(n));
    EXPECT_EQ(state.number(3 + n, "x [m]"), nodes.x[n]);
    EXPECT_EQ(state.number(3 + n, "y [m]"), nodes.y[n]);
    EXPECT_EQ(state.number(3 + n, "vx [m/s]"), nodes.vx[n]);
    EXPECT_EQ(state.number(3 + n, "vy [m/s]"), nodes.vy[n]);
    for (const char* of_discs : {"spin [rad/s]", "radius [m]", "von Mises [Pa]"})
      EXPECT_EQ(state.text(3 + n, of_discs), "") << of_discs;
  }
}

TEST_F(WrittenFrames, SceneReadsBackAsTheOneThatWasRun) {
  EXPECT_EQ(canonical_text(read_scene(file("scene.toml"))), canonical_text(written_scene()));
}

TEST_F(WrittenFrames, RunJsonSaysWhatWasRunAndHowItEnded) {
  const auto json = nlohmann::json::parse(text_of_file(file("run.json")));
  EXPECT_EQ(json, nlohmann::json::parse(outcome().json));
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(scene_hash(written_scene())));
  EXPECT_EQ(json["scene_hash"], hash);
  std::snprintf(hash, sizeof hash, "%016llx",
                static_cast<unsigned long long>(system().state_hash(known().moments.back().y)));
  EXPECT_EQ(json["state_hash"], hash);
  EXPECT_EQ(json["scene"], "written.toml");
  EXPECT_EQ(json["title"], "Written and read back");
  EXPECT_EQ(json["method"], "pece");
  EXPECT_EQ(json["step"], 1e-4);
  EXPECT_EQ(json["end"], 0.02);
  EXPECT_EQ(json["commit"], build_info().commit);
  EXPECT_EQ(json["compiler"], build_info().compiler);
  EXPECT_EQ(json["flags"], build_info().flags);
  EXPECT_EQ(json["build_type"], build_info().build_type);
  EXPECT_EQ(json["machine"], processor_name());
  EXPECT_EQ(json["seed"], nlohmann::json::array());
  EXPECT_EQ(json["discs"], 3);
  EXPECT_EQ(json["nodes"], 6);
  EXPECT_EQ(json["links"], 7 + 4 + 2);
  EXPECT_EQ(json["state_size"], 4 * (3 + 4) + 7);  // x, y, vx, vy of discs and free nodes; the ledger
  EXPECT_EQ(json["steps"], 200);
  EXPECT_EQ(json["rhs_evaluations"], 400);
  EXPECT_EQ(json["rejected"], 0);
  EXPECT_FALSE(json.contains("events"));  // none were located
  EXPECT_EQ(json["settling_time"], 0);
  EXPECT_EQ(json["settling_steps"], 0);
  EXPECT_TRUE(json["surface"].is_null());
  EXPECT_TRUE(json["plate_meets_lattice"].is_null());
  // What the scene gives for nothing, and, of soft discs, the watch over validity.
  const std::vector<std::string> parts{"5 contacts overlap at the start", "material[1]: no part is of it",
                                       "the overlap is"};
  ASSERT_EQ(json["warnings"].size(), parts.size()) << json["warnings"];
  for (std::size_t k = 0; k < parts.size(); ++k)
    EXPECT_NE(json["warnings"][k].get<std::string>().find(parts[k]), std::string::npos) << json["warnings"];
  EXPECT_EQ(json["ended"], "finished");
  EXPECT_EQ(json["reason"], "");
  EXPECT_EQ(json["ended_at"], 0.02);
  for (const char* time : {"cpu_seconds", "wall_seconds", "settling_cpu_seconds"})
    EXPECT_TRUE(json[time].get<double>() >= 0 && json[time].get<double>() < 600) << time << " " << json[time];
}

}  // namespace
}  // namespace furrow
