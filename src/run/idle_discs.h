// The energy of discs that have met nothing. It hides nothing that happens to others: the watch of run/validity.h takes it
// from what a scene was given, or one heavy disc in free flight would be the measure of all.
#pragma once

#include <cmath>
#include <vector>

#include "run/system.h"

namespace furrow {

// A disc in free flight keeps what it has of its own, kinetic and of its height (J).
class IdleDiscs {
 public:
  // y: null where no state is known; then there are none.
  void begin(const System& system, const State* y) {
    own_.clear();
    for (int i = 0; y && i < system.parts().disc.count(); ++i)
      own_.push_back(kinetic(system, *y, i) + height(system, *y, i));
  }

  // J, kinetic, of those that have by now what they began with.
  double kinetic(const System& system, const State* y) const {
    constexpr double rounded = 1e-9;  // of the energies that are added: sums of a million steps
    double sum = 0;
    for (std::size_t i = 0; y && i < own_.size(); ++i) {
      const int disc = static_cast<int>(i);
      const double moving = kinetic(system, *y, disc), high = height(system, *y, disc);
      if (std::fabs(moving + high - own_[i]) <= rounded * (moving + std::fabs(high))) sum += moving;
    }
    return sum;
  }

  void history(HistoryVisitor& visit) {
    visit.list("own energies", own_, [&](double& energy) { visit("own energy", energy); });
  }

 private:
  static double kinetic(const System& system, const State& y, int i) {
    const DiscArrays& disc = system.parts().disc;
    const double vx = y[system.vx_of(i)], vy = y[system.vy_of(i)], spin = system.spin(y, i);
    return 0.5 * disc.mass[i] * (vx * vx + vy * vy) + 0.5 * disc.inertia[i] * spin * spin;
  }
  static double height(const System& system, const State& y, int i) {
    return system.parts().disc.mass[i] * system.gravity() * y[system.y_of(i)];
  }

  std::vector<double> own_;  // by disc, at the start
};

}  // namespace furrow
