#include "verification/studies/amplification.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "methods/method.h"

namespace furrow::verification {
namespace {

// y' = [a b; c d] y, of two numbers beside each other or of a position and its velocity.
class Pair final : public OdeSystem {
 public:
  Pair(double a, double b, double c, double d, bool motion) : a_(a), b_(b), c_(c), d_(d), motion_(motion) {}
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return motion_ ? 1 : 0; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = a_ * y[0] + b_ * y[1];
    dydt[1] = c_ * y[0] + d_ * y[1];
  }

 private:
  double a_, b_, c_, d_;  // 1/s
  bool motion_;
};

// In units of 1/omega and with v/omega.
Pair oscillator(double zeta, bool motion) { return {0, 1, -1, -2 * zeta, motion}; }

double greatest(const std::string& method, const OdeSystem& system, double h) {
  double most = 0;
  for (const std::complex<double>& value : step_eigenvalues(method, system, h)) most = std::max(most, std::abs(value));
  return most;
}

constexpr double angles[] = {0.2, 0.7, 1.3}, zetas[] = {0, 0.4};

bool close(double one, double other) { return std::fabs(one - other) < 1e-9 * std::max(1.0, std::fabs(other)); }

template <class Same>
bool everywhere(bool conservative, const Same& same) {
  for (const double angle : angles) {
    for (const double zeta : zetas) {
      if (!(conservative && zeta > 0) && !same(zeta, angle)) return false;
    }
  }
  return true;
}

// The least radius at which it grows, by small steps outwards from zero.
double first_growth(const std::function<bool(double)>& grows, double most) {
  double stable = 0;
  double unstable = 1e-3;
  while (!grows(unstable)) {  // outwards, so that a second region of stability further out does not count
    stable = unstable;
    unstable *= 1.05;
    if (unstable > most) return most;
  }
  while (unstable - stable > 1e-6 * unstable) {
    const double middle = 0.5 * (stable + unstable);
    (grows(middle) ? unstable : stable) = middle;
  }
  return stable;
}

}  // namespace

double own_amplification(const std::string& method, std::complex<double> z) {
  return greatest(method, Pair(z.real(), -z.imag(), z.imag(), z.real(), false), 1);
}

double own_amplification(const std::string& method, double zeta, double angle) {
  return greatest(method, oscillator(zeta, true), angle);
}

bool acts_by_eigenvalue(const std::string& method) {
  if (make_method(method)->info().conservative) return false;
  return everywhere(false, [&](double zeta, double angle) {
    return close(greatest(method, oscillator(zeta, true), angle), greatest(method, oscillator(zeta, false), angle));
  });
}

bool same_amplification(const std::string& one, const std::string& other) {
  const bool conservative = make_method(one)->info().conservative;
  if (conservative != make_method(other)->info().conservative) return false;
  return everywhere(conservative, [&](double zeta, double angle) {
    return close(own_amplification(one, zeta, angle), own_amplification(other, zeta, angle));
  });
}

double largest_stable_angle(const std::string& method, double zeta, double most) {
  return first_growth([&](double angle) { return !(own_amplification(method, zeta, angle) <= 1 + growth_seen); }, most);
}

double largest_stable_radius(const std::string& method, std::complex<double> direction, double growth, double most) {
  const std::complex<double> unit = direction / std::abs(direction);
  const auto grows = [&](double radius) {
    const double exact = std::exp(std::max(0.0, radius * unit.real()));
    return !(own_amplification(method, radius * unit) <= exact * (1 + growth));
  };
  return first_growth(grows, most);
}

}  // namespace furrow::verification
