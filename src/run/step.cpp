#include "run/step.h"

#include <algorithm>
#include <mutex>

#include "kernel/parallel.h"
#include "kernel/wide.h"

namespace furrow {
namespace {

// `before` and `y`: of body `first`; `n`: bodies in all, between the coordinates of one body.
FURROW_WIDE Motion motion_lanes(const double* before, const double* y, std::size_t n, std::size_t count) {
  constexpr int lanes = 8;
  double speed[lanes] = {}, move[lanes] = {};
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t last = std::min(count, first + lanes);
    for (std::size_t i = first; i < last; ++i) {
      const double dx = y[i] - before[i], dy = y[n + i] - before[n + i];
      const double moved = dx * dx + dy * dy;
      const double squared = y[2 * n + i] * y[2 * n + i] + y[3 * n + i] * y[3 * n + i];
      move[i - first] = moved > move[i - first] ? moved : move[i - first];
      speed[i - first] = squared > speed[i - first] ? squared : speed[i - first];
    }
  }
  return {*std::max_element(move, move + lanes), *std::max_element(speed, speed + lanes)};
}
FURROW_WIDTHS(Motion, motion, (const double* before, const double* y, std::size_t n, std::size_t count),
              (before, y, n, count))

}  // namespace

Step step_of(const System& system, double t, double h, const State& before, const State& after) {
  const auto bodies = static_cast<std::size_t>(system.parts().bodies());
  Motion all;
  std::mutex mutex;
  in_ranges(system.threads(), bodies, [&](std::size_t first, std::size_t last) {
    const Motion one = motion(before.data() + first, after.data() + first, bodies, last - first);
    const std::scoped_lock lock(mutex);
    all.moved_squared = std::max(all.moved_squared, one.moved_squared);
    all.speed_squared = std::max(all.speed_squared, one.speed_squared);
  });
  return {t, h, before, after, all};
}

}  // namespace furrow
