#include "system/locate.h"

#include <cmath>

namespace furrow {

double greatest_load(const System& system, const State& y) {
  const Parts& parts = system.parts();
  const NodeArrays& node = parts.node;
  const auto x_of = [&](int n) { return node.body[n] < 0 ? node.x[n] : y[system.x_of(node.body[n])]; };
  const auto y_of = [&](int n) { return node.body[n] < 0 ? node.y[n] : y[system.y_of(node.body[n])]; };
  const LinkArrays& link = parts.link;
  double greatest = 0;
  for (int k = 0; k < link.count(); ++k) {
    if (system.torn(k)) continue;
    const double rx = x_of(link.a[k]) - x_of(link.b[k]);
    const double ry = y_of(link.a[k]) - y_of(link.b[k]);
    const double force = link.stiffness[k] * (std::sqrt(rx * rx + ry * ry) - link.rest[k]);
    const double load = (link.in_magnitude[k] != 0 ? std::fabs(force) : force) / link.strength[k];
    if (load > greatest) greatest = load;
  }
  return greatest;
}

double go_back_to_first_tear(const System& system, double t, const State& before, double reached, State& y) {
  if (!(greatest_load(system, y) > 1)) return reached;
  const double h = reached - t;
  const State after = y;
  State leaving(y.size()), arriving(y.size());
  system.rhs(t, before, leaving);
  system.rhs(reached, after, arriving);
  const auto place = [&](double s) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double rise = after[i] - before[i];
      const double bend = (1 - 2 * s) * rise + h * ((s - 1) * leaving[i] + s * arriving[i]);
      y[i] = before[i] + s * rise + s * (s - 1) * bend;
    }
  };
  double whole = 0, torn = 1;  // of the step
  for (int halvings = 0; halvings < 40; ++halvings) {
    const double middle = 0.5 * (whole + torn);
    place(middle);
    (greatest_load(system, y) > 1 ? torn : whole) = middle;
  }
  place(torn);
  return t + torn * h;
}

}  // namespace furrow
