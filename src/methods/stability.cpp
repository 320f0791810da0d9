#include "methods/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "methods/method.h"

namespace furrow {
namespace {

// In units of 1/omega, with q = x and v = x'/omega, so that the numbers stay near one.
class UnitOscillator final : public OdeSystem {
 public:
  explicit UnitOscillator(double zeta) : zeta_(zeta) {}
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = -2 * zeta_ * y[1] - y[0];
  }

 private:
  double zeta_;
};

// Growth over the later half of some thousand steps. A method that keeps the amplitude, like Verlet, swings by a
// bounded factor; one that is unstable by more than 0.1 % of its limit has grown far beyond it. Most runs end sooner:
// no method here lets a stable solution swell by 1e8 on its way, and one that has shrunk to 1e-12 in all directions is
// not growing.
bool grows(const std::string& name, double zeta, double h) {
  const auto method = make_method(name);
  const UnitOscillator system(zeta);
  constexpr int steps = 4000;
  State y{1, 1};
  double early = 0;
  double late = 0;
  for (int n = 0; n < steps; ++n) {
    method->step(system, n * h, y, h);
    const double size = std::fabs(y[0]) + std::fabs(y[1]);
    if (!(size < 1e8)) return true;
    if (size < 1e-12) return false;
    if (n < steps / 2) early = std::max(early, size);
    if (n >= steps / 2) late = std::max(late, size);
  }
  return late > early * std::exp(growth_seen * steps / 2);
}

// In units of 1/omega. Steps lengthen until one grows: a region of stability need not begin at zero, and what lies
// beyond its first end does not count.
double first_growing_step(const std::string& name, double zeta) {
  constexpr double stride = 1.15, most = 10;  // above the limit of every explicit method here
  double stable = 0;
  double next = 1e-3 / std::max(1.0, 2 * zeta);
  for (; !grows(name, zeta, next); next *= stride) {
    if (next > most) return std::numeric_limits<double>::infinity();
    stable = next;
  }
  if (stable == 0) return 0;
  while (next - stable > 5e-4 * next) {
    const double middle = 0.5 * (stable + next);
    (grows(name, zeta, middle) ? next : stable) = middle;
  }
  return stable;
}

}  // namespace

double largest_stable_step(const std::string& name, const Oscillator& o) {
  if (make_method(name)->info().controlled || o.omega == 0) return std::numeric_limits<double>::infinity();
  // A scene asks again and again for the damping ratios of its contacts.
  static std::mutex mutex;
  static std::map<std::pair<std::string, double>, double> known;
  const std::scoped_lock lock(mutex);
  const auto [found, fresh] = known.try_emplace({name, o.zeta}, 0);
  if (fresh) found->second = first_growing_step(name, o.zeta);
  return found->second / o.omega;
}

}  // namespace furrow
