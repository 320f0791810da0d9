// The energy of discs that have met nothing. It hides nothing that happens to others: the watch of run/validity.h takes it
// from what a scene was given, or one heavy disc in free flight would be the measure of all.
#pragma once

#include <cmath>
#include <vector>

#include "run/energy_floor.h"
#include "run/system.h"

namespace furrow {

// A disc in free flight keeps the sum of its kinetic energy and of what it has risen by since the start (J), but for the
// rounding of its steps. How much may be rounding is a tenth of the floor below which the watch judges no energy: so what a
// disc that has just touched something gives to it is either seen, and the disc is idle no more, or too little to be judged.
// By a method that does not keep the sum, of first order, no disc is idle, and its energy counts as any other.
class IdleDiscs {
 public:
  struct Sum {
    double kinetic = 0;    // J
    double left_over = 0;  // J, of the residual: what rounding has made of theirs
  };

  // y: null where no state is known; then there are none.
  void begin(const System& system, const State* y) {
    start_.clear();
    for (int i = 0; y && i < system.parts().disc.count(); ++i)
      start_.push_back({kinetic(system, *y, i), (*y)[system.y_of(i)], 0});
  }

  // At time t (s). What is in contact then is not idle, and never will be again.
  Sum sum(const System& system, double t, const State* y) {
    constexpr double rounded = EnergyFloor::round_off / 10;  // of the energies that are added
    if (y && !start_.empty()) {
      system.for_each_contact(t, *y, [&](const Contact& c) {
        if (of_disc(c.id.kind)) start_[c.id.a].met = 1;
        if (c.id.kind == disc_disc) start_[c.id.b].met = 1;
      });
    }
    Sum sum;
    for (std::size_t k = 0; y && k < start_.size(); ++k) {
      if (start_[k].met > 0) continue;
      const int i = static_cast<int>(k);
      const double moving = kinetic(system, *y, i);
      const double risen = system.parts().disc.mass[k] * system.gravity() * ((*y)[system.y_of(i)] - start_[k].y);
      const double left_over = moving + risen - start_[k].kinetic;
      if (!(std::fabs(left_over) <= rounded * (moving + std::fabs(risen)))) continue;
      sum.kinetic += moving;
      sum.left_over += left_over;
    }
    return sum;
  }

  void history(HistoryVisitor& visit) {
    visit.list("starts of discs", start_, [&](Start& one) {
      visit("kinetic", one.kinetic);
      visit("height", one.y);
      visit("met", one.met);
    });
  }

 private:
  struct Start {
    double kinetic = 0, y = 0;  // J, m
    double met = 0;             // 1: it was seen in contact
  };
  static double kinetic(const System& system, const State& y, int i) {
    const DiscArrays& disc = system.parts().disc;
    const double vx = y[system.vx_of(i)], vy = y[system.vy_of(i)], spin = system.spin(y, i);
    return 0.5 * disc.mass[i] * (vx * vx + vy * vy) + 0.5 * disc.inertia[i] * spin * spin;
  }

  std::vector<Start> start_;  // by disc
};

}  // namespace furrow
