#include <cmath>
#include <fstream>
#include <stdexcept>

#include "benchmarks/tracking/kernels.h"
#include "output/files.h"
#include "run/prepare.h"
#include "run/run.h"
#include "scene/packing.h"
#include "scene/read.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

// Nearly at rest is enough: the contacts are there, and it takes a fraction of the time.
constexpr Settle nearly{.speed = 0.05, .hold = 0.1, .step = {}, .limit = 20};

// The lower edge of the plate, then a line a disc. Not a scene file: in the paper's soft soil the weight of the bed
// pushes some centres through the floor, where a scene may not start.
void write(const fs::path& file, const Scene& scene, const System& system, const State& y) {
  OutputFile out = OutputFile::replacing(file);
  out << (scene.plate.empty() ? 0.0 : *scene.plate[0].lower_edge) << "\n";
  for (int i = 0; i < system.parts().disc.count(); ++i) {
    for (const int at : {system.x_of(i), system.y_of(i), system.vx_of(i), system.vy_of(i), system.spin_of(i)})
      out << y[at] << " ";
    out << "\n";
  }
  out.finish();
}

void settle(const fs::path& file, Scene scene) {
  scene.settle = nearly;
  const Prepared p = prepare(scene);
  write(file, p.scene, p.system, p.y);
}

// The packing of the scene after some fall, most discs in the middle of an impact.
void fall(const fs::path& file, Scene scene, double until) {
  scene.plate.clear();
  scene = place_packings(scene);
  System system(scene);
  State y = system.initial_state();
  run(system, *make_method("pece"), y, {.start = 0, .end = until, .step = scene.time.step, .stop = {}},
      [](double, const State&, const JumpReport&) { return true; });
  write(file, scene, system, y);
}

}  // namespace

Scene paper_scene(const std::string& name) {
  return read_scene(fs::path(FURROW_SOURCE_DIR) / "validation/scenes" / (name + ".toml"));
}

Scene with_bed(Scene scene, const fs::path& file) {
  std::ifstream in(file);
  double lower = 0;
  in >> lower;
  for (Plate& plate : scene.plate) {
    plate.lower_edge = lower;
    plate.working_depth.reset();
  }
  scene.settle.reset();
  const Packing packing = scene.packing.at(0);
  scene.packing.clear();
  Disc d{.radius = packing.radius_max, .material = packing.material};
  while (in >> d.position.x >> d.position.y >> d.velocity.x >> d.velocity.y >> d.spin) scene.disc.push_back(d);
  if (static_cast<int>(scene.disc.size()) != packing.count)
    throw std::runtime_error("no bed in " + file.string() + "; make it with: track_kernels beds DIRECTORY");
  return scene;
}

Scene repeated(const Scene& scene, int copies) {
  const double width = scene.wall.back().point.x;  // m
  Scene wide = scene;
  wide.plate.clear();
  wide.disc.clear();
  wide.wall.back().point.x *= copies;
  for (int k = 0; k < copies; ++k) {
    for (Disc d : scene.disc) {
      d.position.x += k * width;
      wide.disc.push_back(d);
    }
  }
  return wide;
}

void make_beds(const fs::path& directory) {
  fs::create_directories(directory);
  settle(directory / "scenario_2", paper_scene("scenario_2"));
  settle(directory / "scenario_3", paper_scene("scenario_3"));
  fall(directory / "falling", paper_scene("scenario_2"), 0.2);
}

}  // namespace furrow::benchmarks
