#include "methods/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  return late > 1.01 * early;
}

}  // namespace

double largest_stable_step(const std::string& name, const Oscillator& o) {
  if (make_method(name)->info().controlled || o.omega == 0) return std::numeric_limits<double>::infinity();
  double stable = 0;
  double unstable = 10;  // times 1/omega: above the limit of every explicit method here
  if (!grows(name, o.zeta, unstable)) return std::numeric_limits<double>::infinity();
  while (unstable - stable > 5e-4 * unstable) {
    const double middle = stable > 0 ? 0.5 * (stable + unstable) : 0.1 * unstable;
    (grows(name, o.zeta, middle) ? unstable : stable) = middle;
    if (unstable < 1e-9) return 0;
  }
  return stable / o.omega;
}

}  // namespace furrow
