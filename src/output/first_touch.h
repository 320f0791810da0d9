// When a plate first touches a lattice: when a free node, which has no size, is in the plate.
#pragma once

#include <limits>

#include "system/system.h"

namespace furrow {

class FirstTouch {
 public:
  // After each accepted step.
  void see(const System& system, double t, const State& y) {
    if (time_ <= t || system.parts().plate.empty()) return;
    const System::Nodes node = system.nodes(y);
    for (std::size_t k = 0; k < system.parts().plate.size(); ++k) {
      const PlatePart& plate = system.parts().plate[k];
      const System::PlateAt at = system.plate_at(static_cast<int>(k), t);
      for (std::size_t i = 0; i < node.x.size(); ++i) {
        const bool beside = node.x[i] <= at.left || node.x[i] >= at.left + plate.width;
        const bool above_or_below = node.y[i] <= at.lower || node.y[i] >= at.lower + plate.height;
        if (system.parts().node.body[i] >= 0 && !beside && !above_or_below) time_ = std::min(time_, t);
      }
    }
  }

  double time() const { return time_; }  // s; infinity: not yet

 private:
  double time_ = std::numeric_limits<double>::infinity();
};

}  // namespace furrow
