// A stem on two supports, pushed by a third plate between them.
#pragma once

#include <cmath>

#include "run/observe.h"
#include "verification/stem_scenes.h"

namespace furrow::verification::stem {

inline constexpr double length = 0.12, strength = 5e6, speed = 0.01;  // m, Pa, m/s
inline constexpr int below = 3, middle = 20, above = 37;              // rows; 3 mm between them
inline constexpr double s = 0.003, span = (above - below) * s;        // m

inline Plate plate_at(int row, double left, double velocity) {
  Plate p;
  p.left_edge = left;
  p.lower_edge = (row - 0.4) * s;
  p.width = 0.01;
  p.height = 0.8 * s;
  p.velocity = {velocity, 0};
  p.material = "rigid";
  return p;
}

// The plates begin one micrometre in the stem. A roller keeps it from drifting along itself.
inline Scene on_supports() {
  Scene scene = scene_of({3, 1.0 / 3, length, strength});
  scene.material[0].young = young;
  scene.material.push_back({.name = "rigid", .rigid = true});
  scene.lattice[0].fixed_rows.clear();
  scene.lattice[0].node = {{.row = middle, .column = 1, .fixed_y = true}};
  scene.plate = {plate_at(below, -0.01 + 1e-6, 0), plate_at(above, -0.01 + 1e-6, 0),
                 plate_at(middle, diameter - 1e-6, -speed)};
  return scene;
}

// The stem between the plates, pushed further and further.
class Press {
 public:
  void to(double travel) {
    const State before = rest.y;
    if (travel_ > 0)  // from where the last two states point to
      for (std::size_t k = 0; k < before.size(); ++k)
        rest.y[k] += (before[k] - last_[k]) * (travel - travel_) / (travel_ - last_travel_);
    rest.y = verification::at_rest(rest.system, travel / speed, rest.y, 1e-9);
    last_ = before;
    last_travel_ = travel_;
    travel_ = travel;
  }
  double force() const { return observe(rest.system, travel_ / speed, rest.y).plate[2].x; }  // N
  double bend() const {                                                                      // m
    return 0.5 * (rest.at(below, 1).x + rest.at(above, 1).x) - rest.at(middle, 1).x;
  }
  bool tears() const {
    State y = rest.y;
    return !System(rest.system).jump(travel_ / speed, y).torn.empty();
  }
  double travel() const { return travel_; }

  Rest rest{System(on_supports()), System(on_supports()).initial_state()};

 private:
  State last_ = rest.y;
  double travel_ = 0, last_travel_ = 0;  // m
};

}  // namespace furrow::verification::stem
