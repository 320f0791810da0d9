// When a plate first touches a lattice: when a free node, which has no size, is in the plate.
#pragma once

#include <algorithm>

#include "run/system.h"

namespace furrow {

class FirstTouch {
 public:
  // After each accepted step.
  void see(const System& system, double t, const State& y) {
    if (time_ <= t || system.parts().plate.empty()) return;
    const NodeArrays& node = system.parts().node;
    for (std::size_t k = 0; k < system.parts().plate.size(); ++k) {
      const PlatePart& plate = system.parts().plate[k];
      const PlateAt at = system.plate_at(static_cast<int>(k), t);
      for (const int body : node.body) {
        if (body < 0) continue;
        const double right = y[system.x_of(body)] - at.left, up = y[system.y_of(body)] - at.lower;
        if (right > 0 && right < plate.width && up > 0 && up < plate.height) time_ = std::min(time_, t);
      }
    }
  }

  void history(HistoryVisitor& visit) { visit("first touch", time_); }

  double time() const { return time_; }  // s; infinity: not yet

 private:
  double time_ = infinity;
};

}  // namespace furrow
