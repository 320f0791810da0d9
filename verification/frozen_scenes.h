// Every scene of validation/scenes without stems, but no other reading of one, short: in the frozen state in which it has
// settled, with 120 discs and coarsely, and run for a while from there. Below the stability limit: at the paper's own step,
// 1e-4 s, scenes 2 and 3 are beyond it.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "run/prepare.h"
#include "run/run.h"
#include "scene/read.h"

namespace furrow::verification {

struct Case {
  std::string name;
  Scene scene;  // every disc and node listed with its place and velocity at the start
  double step;  // s, a power of two: every time is exact
  long steps;
  double end() const { return step * static_cast<double>(steps); }
};

// The present state as a start, with the plates where they are at time t.
inline Scene frozen(Scene scene, const System& system, double t, const State& y) {
  scene.settle.reset();
  scene.packing.clear();
  for (std::size_t k = 0; k < scene.plate.size(); ++k) {
    scene.plate[k].left_edge = system.plate_at(static_cast<int>(k), t).left;
    scene.plate[k].lower_edge = system.plate_at(static_cast<int>(k), t).lower;
  }
  for (int i = 0; i < system.parts().disc.count(); ++i) {
    scene.disc[i].position = {y[system.x_of(i)], y[system.y_of(i)]};
    scene.disc[i].velocity = {y[system.vx_of(i)], y[system.vy_of(i)]};
    if (system.has_friction()) scene.disc[i].spin = y[system.spin_of(i)];
  }
  const NodeArrays& node = system.parts().node;
  const NodeMotion now = system.nodes(t, y);
  for (Lattice& l : scene.lattice) l.node.clear();
  for (int n = 0; n < node.count(); ++n) {
    Lattice& l = scene.lattice[node.lattice[n]];
    NodeSetting set{.row = node.row[n], .column = node.column[n], .force = {node.load_x[n], node.load_y[n]}};
    set.displacement = {now.x[n] - (l.origin.x + set.column * l.spacing),
                        now.y[n] - (l.origin.y + set.row * l.spacing)};
    set.velocity = {now.vx[n], now.vy[n]};
    l.node.push_back(set);
  }
  return scene;
}

inline const std::filesystem::path scenes = FURROW_SOURCE_DIR "/validation/scenes";

inline Case case_of(const std::filesystem::path& file) {
  Scene scene = read_scene(file);
  const bool bed = !scene.packing.empty();
  for (Packing& packing : scene.packing) packing.count = 120;
  if (scene.settle) scene.settle = Settle{.speed = 0.3, .hold = 0.1, .limit = 5};
  const Prepared prepared = prepare(scene);
  // A bed at a quarter of its step; the others until the first links have torn.
  const double step = std::exp2(std::floor(std::log2(scene.time.step)) - (bed ? 2 : 0));
  const long steps = std::min(static_cast<long>(scene.time.end / step), bed ? 512L : 10000L);
  return {file.stem(), frozen(prepared.scene, prepared.system, 0, prepared.y), step, steps};
}

// A stem is upright and driven nodes have a motion of their own, so an observer who turns or moves sees another scene.
// Pages of their own judge those.
inline bool stands_upright(const Scene& scene) {
  return std::any_of(scene.lattice.begin(), scene.lattice.end(),
                     [](const Lattice& l) { return l.stem || !l.drive.empty(); });
}

inline const std::vector<Case>& cases() {
  static const std::vector<Case> made = [] {
    std::vector<Case> all;
    for (const auto& file : std::filesystem::directory_iterator(scenes))
      if (file.is_regular_file() && !stands_upright(read_scene(file.path()))) all.push_back(case_of(file.path()));
    std::sort(all.begin(), all.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
    return all;
  }();
  return made;
}

struct Outcome {
  System system;
  State y;
  double torn = 0;
  std::vector<State> on_the_way{};  // at each eighth
};

// `start` empty: as the scene says.
inline Outcome outcome(const Case& c, const Scene& scene, const State& start = {}) {
  Outcome o{System(scene), start};
  if (start.empty()) o.y = o.system.initial_state();
  long seen_steps = 0;
  run(o.system, *make_method(scene.time.method), o.y, {.start = 0, .end = c.end(), .step = c.step, .stop = {}},
      [&](double, const State& now, const JumpReport& jump) {
        o.torn += static_cast<double>(jump.torn.size());
        if (++seen_steps % (c.steps / 8) == 1) o.on_the_way.push_back(now);
        return true;
      });
  return o;
}

}  // namespace furrow::verification
