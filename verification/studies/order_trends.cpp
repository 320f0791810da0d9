#include "verification/studies/order_trends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "verification/studies/published_schemes.h"

namespace furrow::verification {
namespace {

constexpr double pi = std::numbers::pi;

class UnitSpring final : public OdeSystem {
 public:
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = -y[0];
  }
};

}  // namespace

Count evaluations(const std::string& method) {
  constexpr int started = 20, more = 100;  // steps
  const auto run = make_method(method);
  const UnitSpring spring;
  State y{1, 0};
  long first = 0;
  for (int n = 0; n < started + more; ++n) {
    if (n == started) first = run->evaluations();
    run->step(spring, n * 1e-3, y, 1e-3);
  }
  const double per_step = static_cast<double>(run->evaluations() - first) / more;
  return {per_step, static_cast<double>(first) - started * per_step};
}

double true_angle(double angle) { return 2 * pi / std::round(2 * pi / angle); }

double energy_drift(const std::string& method, double angle) {
  constexpr int periods = 64, window = 8;
  const auto run = make_method(method);
  const UnitSpring spring;
  State y{1, 0};
  const double h = true_angle(angle);
  const int steps = static_cast<int>(std::lround(2 * pi / h));
  double first = 0, last = 0;
  for (int n = 0; n < periods * steps; ++n) {
    try {
      run->step(spring, n * h, y, h);
    } catch (const Divergence&) {
      return NAN;
    }
    const double energy = 0.5 * (y[0] * y[0] + y[1] * y[1]);
    if (n < window * steps) first += energy;
    if (n >= (periods - window) * steps) last += energy;
  }
  return std::log(last / first) / (periods - window);
}

// From the principal root r of the characteristic equation, with z = i angle: |r| a step, so |r|^(4 pi/angle) a period.
//   pece    r^2 = r (1 + z + 3/4 z^2) - 1/4 z^2             r = e^z (1 + z^3/12 - z^4/4 ...)
//   pec     2 r^3 - 2 r^2 = z (4 r^2 - 3 r + 1)             r = e^z (1 + z^3/12 - z^4/2 ...)
//   pecece  r^2 = r (1 + z + z^2/2 + 3/8 z^3) - z^3/8       |r|^2 = 1 - angle^6/4 ...
//   ab2     r^2 = r (1 + 3/2 z) - 1/2 z                     r = e^z (1 - 5/12 z^3 + z^4/4 ...)
//   rk4     r = 1 + z + z^2/2 + z^3/6 + z^4/24              |r|^2 = 1 - angle^6/72 + angle^8/576
//   euler   r = 1 + z                                       |r|^2 = 1 + angle^2
// Verlet and symplectic Euler turn on an ellipse: no trend.
std::optional<Drift> predicted_drift(const std::string& method) {
  static const std::map<std::string, Drift> known{{"pece", {-pi, 3}},
                                                  {"odeint_abm2", {-pi, 3}},
                                                  {"pec", {-2 * pi, 3}},
                                                  {"pecece", {-pi / 2, 5}},
                                                  {"ab2", {pi, 3}},
                                                  {"odeint_ab2", {pi, 3}},
                                                  {"rk4", {-pi / 36, 5}},
                                                  {"odeint_rk4", {-pi / 36, 5}},
                                                  {"odeint_euler", {2 * pi, 1}},
                                                  {"odeint_ab1", {2 * pi, 1}},
                                                  {"verlet", {0, 3}},
                                                  {"symplectic_euler", {0, 3}},
                                                  {"odeint_velocity_verlet", {0, 3}},
                                                  {"odeint_symplectic_euler", {0, 3}}};
  const auto found = known.find(method);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> amplified_drift(const std::string& method, double angle) {
  const Scheme* scheme = scheme_of(method);
  if (!scheme || !scheme->by_eigenvalue) return std::nullopt;
  const double h = true_angle(angle);
  return 2 * std::log(amplification(*scheme, std::complex<double>(0, h))) * 2 * pi / h;
}

bool returns_exactly(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [](const Point& p) { return p.position < 1e-12; });
}

std::optional<double> predicted_return(const MethodInfo& method) {
  if (method.controlled) return std::nullopt;
  if (method.name.ends_with("verlet") || method.name.ends_with("symplectic_euler"))
    return std::numeric_limits<double>::infinity();
  if (method.name.find("symplectic_rkn") != std::string::npos) return std::numeric_limits<double>::infinity();
  if (method.name == "pecece" || method.name == "odeint_modified_midpoint") return 5;
  return method.order % 2 == 0 ? method.order + 1 : method.order;
}

}  // namespace furrow::verification
