// Oblique impact of a Hertz-Mindlin contact with Coulomb's limit, integrated without the solver.
//
// Normal motion has a closed form (Antypov and Elliott 2011, Europhys. Lett. 94, 50004), with u = d^(5/4):
//
//   d tau = a d^(1/4) dt,  a = sqrt(5 K / (4 m)),  K = 4/3 E* sqrt(R)
//   u'' + 2 beta u' + u = 0
//   Fn = K u^(1/5) (u + 2 beta u')
//
// so that only the slip vt and the spring xi are left to integrate, here in long double by Runge-Kutta over x:
//
//   m vt' = kappa Ft
//   xi' = vt
//   tau = T x^5 (126 - 420 x + 540 x^2 - 315 x^3 + 70 x^4)
//
// The polynomial takes the fifth root off both ends. T is where the contact would begin to pull.
#pragma once

#include <cmath>

namespace furrow::verification {

struct ObliqueImpact {
  long double modulus, shear_modulus;  // Pa, E* and G*
  long double radius, mass;            // m, kg; of a pair R* and m*
  long double kappa;                   // -, m over the mass of the contact point along the tangent
  long double beta, friction;          // -
  long double closing, slip;           // m/s, at touch
  bool damps_slip = true;              // whether Ft has its viscous part
};

struct ObliqueOutcome {
  double separation;  // m/s, normal speed afterwards
  double slip;        // m/s, of the contact point afterwards
};

inline ObliqueOutcome oblique_outcome(const ObliqueImpact& p, int steps) {
  const long double pi = 3.141592653589793238462643383279502884L;
  const long double k = 4 * p.modulus * std::sqrt(p.radius) / 3;
  const long double shear = 8 * p.shear_modulus * std::sqrt(p.radius);  // St = shear u^(2/5)
  const long double viscosity = (p.damps_slip ? 2 : 0) * std::sqrt(5.0L / 6) * p.beta * std::sqrt(shear * p.mass);
  const long double a = std::sqrt(5 * k / (4 * p.mass));
  const long double omega = std::sqrt(1 - p.beta * p.beta);
  const long double duration =
      (pi - std::atan2(2 * p.beta * omega, omega * omega - p.beta * p.beta)) / omega;  // of u'' < 0
  const long double start = 5 * p.closing / (4 * a);                                   // u'(0)

  struct Normal {
    long double root, force, rate;  // u^(1/5), Fn, u'
  };
  const auto normal_at = [&](long double x) -> Normal {
    const long double tau = duration * x * x * x * x * x * (126 + x * (-420 + x * (540 + x * (-315 + x * 70))));
    const long double decayed = start * std::exp(-p.beta * tau);
    const long double u = decayed * std::sin(omega * tau) / omega;
    const long double rate = decayed * (std::cos(omega * tau) - p.beta / omega * std::sin(omega * tau));
    const long double root = u > 0 ? std::pow(u, 0.2L) : 0;
    return {root, std::fmax(0.0L, k * root * (u + 2 * p.beta * rate)), rate};
  };
  struct Tangent {
    long double slip, spring;
  };
  const auto rates = [&](long double x, Tangent y, Normal n) -> Tangent {
    if (n.root == 0) return {0, 0};
    const long double limit = p.friction * n.force;
    const long double held = std::fmax(-limit, std::fmin(limit, shear * n.root * n.root * y.spring));
    const long double stick = -held - viscosity * n.root * y.slip;
    const long double force = std::fmax(-limit, std::fmin(limit, stick));
    const long double parabola = x * (1 - x);
    const long double time = duration * 630 * parabola * parabola * parabola * parabola / (a * n.root);  // dt/dx
    return {p.kappa / p.mass * force * time, y.slip * time};
  };
  Tangent y{p.slip, 0};
  Normal first = normal_at(0);
  const long double h = 1.0L / steps;
  for (int n = 0; n < steps; ++n) {
    const long double x = n * h;
    const Normal middle = normal_at(x + h / 2);
    const Normal last = normal_at(n + 1 == steps ? 1 : x + h);
    const Tangent k1 = rates(x, y, first);
    const Tangent k2 = rates(x + h / 2, {y.slip + h / 2 * k1.slip, y.spring + h / 2 * k1.spring}, middle);
    const Tangent k3 = rates(x + h / 2, {y.slip + h / 2 * k2.slip, y.spring + h / 2 * k2.spring}, middle);
    const Tangent k4 = rates(x + h, {y.slip + h * k3.slip, y.spring + h * k3.spring}, last);
    y.slip += h / 6 * (k1.slip + 2 * k2.slip + 2 * k3.slip + k4.slip);
    y.spring += h / 6 * (k1.spring + 2 * k2.spring + 2 * k3.spring + k4.spring);
    first = last;
    if (last.root == 0) continue;
    const long double longest = p.friction * last.force / (shear * last.root * last.root);
    y.spring = std::fmax(-longest, std::fmin(longest, y.spring));
  }
  return {static_cast<double>(-4 * a / 5 * normal_at(1).rate), static_cast<double>(y.slip)};
}

}  // namespace furrow::verification
