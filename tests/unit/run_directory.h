// The files of a small made-up run, for tests of what reads them: a plate at 100 mm/s, a lattice of three nodes one
// above the other, the lowest fixed.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/read.h"
#include "scenes.h"

namespace furrow::test {

inline Scene three_node_scene() {
  Scene scene = empty_scene();
  scene.title = "Three nodes";
  scene.time.end = 1;
  Plate plate;
  plate.name = "tool";
  plate.lower_edge = 0.01;
  plate.velocity = {0.1, 0};
  plate.material = "rigid";
  scene.plate = {plate};
  Lattice stem;
  stem.name = "stem";
  stem.rows = 3;
  stem.material = "soft";
  stem.fixed_rows = {0};
  stem.structural.stiffness = 1e4;
  scene.lattice = {stem};
  scene.output.frames = {0, 0.5};
  return scene;
}

// A directory of its own in the temporary directory, removed at the end of the test.
class RunDirectory {
 public:
  RunDirectory()
      : path_(std::filesystem::temp_directory_path() /
              ("furrow_run_" + std::to_string(getpid()) + "_" + std::to_string(made_++))) {
    std::filesystem::create_directories(path_ / "frames");
    write("scene.toml", canonical_text(three_node_scene()));
    facts("finished");
    force({});
    write("energy.csv", energy_heading + "0,0,0,0,0,0,0,0,0,0,0,0,0,0\n1,1,0,0,2,0,0.5,0.25,0.125,0,1,4.8,0,0.075\n");
    events("");
    write("frames/frames.csv", "index,t [s],displacement [m]\n0,0,0\n1,0.5,0.05\n");
    for (const std::string index : {"000", "001"}) {
      write("frames/discs_" + index + ".csv", discs_heading);
      write("frames/links_" + index + ".csv",
            "x1 [m],y1 [m],x2 [m],y2 [m],force [N],kind\n0,0,0,0.01,3,structural\n0,0.01,0,0.02,-3,structural\n");
      write("frames/plates_" + index + ".csv",
            "left [m],lower [m],width [m],height [m],vx [m/s],vy [m/s]\n-0.02,0.01,0.01,0.1,0.1,0\n");
    }
  }
  ~RunDirectory() { std::filesystem::remove_all(path_); }
  RunDirectory(const RunDirectory&) = delete;
  RunDirectory& operator=(const RunDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  void remove(const std::string& name) const { std::filesystem::remove(path_ / name); }

  // Force on the plate (N), {Fx, Fy}, one row a mm.
  void force(const std::vector<std::pair<double, double>>& rows) const {
    std::string text = "t [s],plate,displacement [m],Fx [N],Fy [N],F [N]\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto [x, y] = rows[k];
      const double mm = static_cast<double>(k);
      text += std::to_string(mm / 100) + ",tool," + std::to_string(mm / 1000) + "," + std::to_string(x) + "," +
              std::to_string(y) + "," + std::to_string(std::sqrt(x * x + y * y)) + "\n";
    }
    write("plate_force.csv", text);
  }

  void events(const std::string& rows) const {
    write("events.csv", "t [s],displacement [m],kind,lattice,row a,column a,row b,column b,fixed,force [N]\n" + rows);
  }

  void facts(const std::string& ended, const std::string& reason = {}) const {
    write("run.json",
          "{\"title\": \"Three nodes\", \"commit\": \"abc\", \"seed\": [], \"surface\": null, \"steps\": 10000, "
          "\"cpu_seconds\": 0.5, \"warnings\": [\"steps are <large>\"], \"ended\": \"" +
              ended + "\", \"reason\": \"" + reason + "\", \"ended_at\": 0.5}");
  }

  inline static const std::string energy_heading =
      "t [s],kinetic [J],gravity [J],load [J],springs [J],contact elastic [J],link damping [J],contact viscous "
      "[J],friction "
      "[J],rolling [J],tear [J],plate work [J],stiffening [J],residual [J]\n";
  inline static const std::string discs_heading =
      "x [m],y [m],radius [m],vx [m/s],vy [m/s],spin [rad/s],von Mises [Pa]\n";

 private:
  inline static int made_ = 0;
  std::filesystem::path path_;
};

}  // namespace furrow::test
