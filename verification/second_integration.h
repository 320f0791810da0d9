// A second way to the states of the problems on whose references orders are observed: order_references.cpp.
#pragma once

#include "run/system.h"

namespace furrow::verification {

// By the classical Runge-Kutta method with 4000 steps. A first jump gives contacts their tangential springs.
inline State integrated(OdeSystem& system, State y, double from, double duration) {
  constexpr int steps = 4000;
  State room = y;
  if (auto* scene = dynamic_cast<System*>(&system)) scene->jump(0, room);
  const double h = duration / steps;
  State k[4] = {y, y, y, y};
  for (int n = 0; n < steps; ++n) {
    for (int stage = 0; stage < 4; ++stage) {
      const double reach = stage == 0 ? 0 : stage == 3 ? h : h / 2;
      for (std::size_t i = 0; i < y.size(); ++i) room[i] = y[i] + (stage == 0 ? 0 : reach * k[stage - 1][i]);
      system.rhs(from + n * h + reach, room, k[stage]);
    }
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (k[0][i] + 2 * (k[1][i] + k[2][i]) + k[3][i]);
  }
  return y;
}

}  // namespace furrow::verification
