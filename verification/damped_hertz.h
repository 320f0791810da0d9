// The exact solution of a damped Hertzian impact that may pull.
//
//   m d'' = -K d^(3/2) - sqrt(5) beta sqrt(K m) d^(1/4) d',   d(0) = 0, d'(0) = v
//
// is the model's law, since 2 sqrt(5/6) beta sqrt(Sn m) with Sn = 3/2 K sqrt(d) is the factor of d'. In units of the
// impact, length L = (m v^2/K)^(2/5) and time L/v, neither K nor m nor v is left:
//
//   d'' = -d^(3/2) - sqrt(5) beta d^(1/4) d',   d(0) = 0, d'(0) = 1
//
// With p = d^(5/4) and a clock s that runs as ds = d^(1/4) dt,
//
//   dp/ds   = 5/4 d'
//   d2p/ds2 = 5/4 d''/d^(1/4) = -sqrt(5) beta dp/ds - 5/4 p
//
// is a linear oscillator of frequency w = sqrt(5)/2 and of damping ratio beta, with p(0) = 0, dp/ds(0) = 5/4.
// It is back at p = 0 after half a swing with the speed e = exp(-pi beta / sqrt(1 - beta^2)); if beta >= 1, never.
//
// Source: Antypov and Elliott 2011 (Europhys. Lett. 94, 50004), here for every beta.
#pragma once

#include <cmath>
#include <functional>

namespace furrow::verification {

// int_a^b f by the tanh-sinh rule, which does not mind singular ends; f is given the distance from each end.
inline long double integral(const std::function<long double(long double, long double)>& f, long double a,
                            long double b) {
  constexpr long double half_pi = 1.57079632679489661923132169163975144L;
  constexpr long double h = 1.0L / 64;
  long double sum = 0;
  for (int k = -288; k <= 288; ++k) {  // to 4.5: the rest is below round-off for integrands like x^(-1/5)
    const long double u = half_pi * std::sinh(k * h);
    const long double from_a = (b - a) / (1 + std::exp(-2 * u));
    const long double from_b = (b - a) / (1 + std::exp(2 * u));
    const long double weight = half_pi * std::cosh(k * h) * 2 * (from_a / (b - a)) * (from_b / (b - a)) * (b - a);
    if (from_a > 0 && from_b > 0) sum += weight * f(from_a, from_b);
  }
  return sum * h;
}

// All in units of the impact.
class DampedHertz {
 public:
  explicit DampedHertz(double beta)
      : beta_(beta), decay_(w * beta), turn_(w * std::sqrt(std::fabs(1 - beta_ * beta_))) {}

  long double p(long double s) const { return 1.25L * swing(s); }
  long double overlap(long double s) const { return std::pow(p(s), 0.8L); }
  long double speed(long double s) const {  // d'
    if (beta_ == 1) return std::exp(-decay_ * s) * (1 - decay_ * s);
    const long double even = beta_ < 1 ? std::cos(turn_ * s) : std::cosh(turn_ * s);
    return std::exp(-decay_ * s) * even - decay_ * swing(s);
  }

  // s of the greatest overlap, of the return to zero force, and of the return to zero overlap.
  long double turning() const {
    if (beta_ == 1) return 1 / decay_;
    return (beta_ < 1 ? std::acos(beta_) : std::acosh(beta_)) / turn_;
  }
  long double letting_go() const { return 2 * turning(); }
  long double release() const { return pi / turn_; }

  // t(s) = int_0^s p^(-1/5) ds. At the release p has a second zero, where it is better known from there.
  long double time(long double s) const {
    return integral([this](long double r, long double) { return std::pow(p(r), -0.2L); }, 0, s);
  }
  long double contact_time() const {
    const long double last = release();
    return integral(
        [&](long double r, long double rest) { return std::pow(r < rest ? p(r) : p_before_release(rest), -0.2L); }, 0,
        last);
  }
  long double p_before_release(long double rest) const {
    return 1.25L * std::exp(-decay_ * (release() - rest)) * std::sin(turn_ * rest) / turn_;
  }

 private:
  static constexpr long double w = 1.11803398874989484820458683436563812L;  // sqrt(5)/2
  static constexpr long double pi = 3.14159265358979323846264338327950288L;

  // e^(-decay s) sin(turn s)/turn, or its limits for beta >= 1.
  long double swing(long double s) const {
    if (beta_ == 1) return s * std::exp(-decay_ * s);
    if (beta_ < 1) return std::exp(-decay_ * s) * std::sin(turn_ * s) / turn_;
    return std::exp(-decay_ * s) * std::sinh(turn_ * s) / turn_;
  }

  long double beta_, decay_, turn_;
};

// The oracle's oracle: the equation of d itself, by the classical Runge-Kutta method in long double with steps graded
// as t = T q^4, which restores its order at the touch, where the damping starts as t^(1/4). `weight` is a constant
// force inwards, over m v^2/L.
struct Motion {
  long double overlap, speed, force;
};
inline Motion integrate_impact(double beta, long double end, int steps, long double weight = 0) {
  const long double c = std::sqrt(5.0L) * beta;
  const auto acceleration = [c, weight](long double d, long double v) {
    const long double root = std::sqrt(std::fmax(d, 0.0L));
    return weight - root * root * root - c * std::sqrt(root) * v;
  };
  long double d = 0;
  long double v = 1;
  const long double h = 1.0L / steps;
  for (int n = 0; n < steps; ++n) {
    const long double q = static_cast<long double>(n) / steps;
    const auto pace = [&](long double x) { return 4 * end * x * x * x; };
    const long double d1 = pace(q) * v;
    const long double v1 = pace(q) * acceleration(d, v);
    const long double d2 = pace(q + h / 2) * (v + h / 2 * v1);
    const long double v2 = pace(q + h / 2) * acceleration(d + h / 2 * d1, v + h / 2 * v1);
    const long double d3 = pace(q + h / 2) * (v + h / 2 * v2);
    const long double v3 = pace(q + h / 2) * acceleration(d + h / 2 * d2, v + h / 2 * v2);
    const long double d4 = pace(q + h) * (v + h * v3);
    const long double v4 = pace(q + h) * acceleration(d + h * d3, v + h * v3);
    d += h / 6 * (d1 + 2 * (d2 + d3) + d4);
    v += h / 6 * (v1 + 2 * (v2 + v3) + v4);
  }
  return {d, v, -acceleration(d, v)};
}

}  // namespace furrow::verification
