// Below which a residual of the ledger is no energy: the watch of run/validity.h would divide round-off by round-off.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "run/observe.h"
#include "system/parts.h"

namespace furrow {

struct EnergyFloor {
  static constexpr double round_off = 1e-10;   // of the sum of all energies
  static constexpr double first_touch = 1e-6;  // of m v^2 / 2 of the lightest body at the greatest speed
  static constexpr double places = 4096;       // roundings of a node's place, summed over a long run

  double lightest = infinity;  // kg
  double drive_speed = 0;      // m/s, of the fastest driven nodes
  double stiffness = 0;        // N/m, of all links
  double farthest = 0;         // m, the greatest coordinate of a node at the start

  void add(const Parts& parts) {
    for (const double mass : parts.disc.mass) lightest = std::min(lightest, mass);
    for (const double mass : parts.node.mass) lightest = std::min(lightest, mass);
    for (const DrivePart& d : parts.drive) drive_speed = std::max(drive_speed, std::hypot(d.vx, d.vy));
    for (const double k : parts.link.stiffness) stiffness += k;
    for (const auto* axis : {&parts.node.x, &parts.node.y})
      for (const double place : *axis) farthest = std::max(farthest, std::fabs(place));
  }

  // J, at time t and a greatest speed (m/s).
  double of(const Energies& e, double t, double speed) const {
    const double all = e.live() + std::fabs(e.gravity) + std::fabs(e.load) + e.lost() + std::fabs(e.plate_work) +
                       std::fabs(e.stiffening);
    const double stretch = places * std::numeric_limits<double>::epsilon() * (farthest + drive_speed * t);
    return std::max(
        {round_off * all, first_touch * 0.5 * lightest * speed * speed, 0.5 * stiffness * stretch * stretch});
  }
};

}  // namespace furrow
