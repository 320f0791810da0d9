// A mass on a spring, in every regime of damping, by every method.
//
//   m x'' + c x' + k x = 0; the solutions below, at and above critical damping are those of spring.h
//   A method whose local error is C h^(p+1) y^(p+1) is off by C h^p t x^(p+1)(t) at time t, to leading order.
//
// Source: any textbook of mechanics, for example Meirovitch, Fundamentals of Vibrations, chapter 2; for the error of a
// one-step method on a linear system Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.8.
#include <cmath>
#include <string>
#include <vector>

#include "run/observe.h"
#include "verification/spring_series.h"

namespace furrow::verification::single_spring {
namespace {

struct Error {
  const char* method;
  int order;
  double constant;  // C
  const char* source;
  double slope;  // what the next term of the error adds to the observed order
};
constexpr Error errors[] = {
    {"pece", 2, 1.0 / 12, "the trapezoid rule's 1/12", 0.06},
    {"verlet", 2, 1.0 / 24, "1/24 from cos(theta) = 1 - q^2/2, with damping (1 + 12 zeta^2)/24", 0.01},
    {"rk4", 4, 1.0 / 120, "1/120 of the fifth-order term left out", 0.027}};

// Verlet's velocity is predicted where the force needs it, which costs more the stronger the damping; the factor of
// zeta^2 is measured, once.
double constant_of(const Error& e, double zeta) {
  return std::string(e.method) == "verlet" ? e.constant * (1 + 12 * zeta * zeta) : e.constant;
}

TEST(SingleSpring, ClosedFormsAgreeWithTheirTaylorSeries) {
  requirement("spring.damped");
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0}) {
    expect("x(1 s) / x0 by series, damping ratio " + std::to_string(zeta), series_position(zeta, end),
           exact_position(zeta, end), absolute(5e-15, "round-off of a few exponentials in double precision"));
  }
}

TEST(SingleSpring, FollowsTheExactSolutionInEveryRegimeOfDamping) {
  requirement("spring.damped");
  constexpr double step = 1e-3;  // s
  for (const Error& e : errors) {
    for (const double zeta : {0.0, 0.05, 0.5, 1.0, 2.0}) {
      const double leading =
          constant_of(e, zeta) * std::pow(omega * step, e.order) * omega * end * derivative(zeta, e.order + 1);
      const State y = run_scene(spring_scene(zeta), e.method, step, end).y;
      const auto truncation = absolute(2 * leading, std::string("C h^p t x^(p+1), doubled; C is ") + e.source);
      const std::string what = std::string(e.method) + ", damping ratio " + std::to_string(zeta);
      expect(what + ": x(1 s) / x0", position(y), exact_position(zeta, end), truncation);
      expect(what + ": x'(1 s) / (omega x0)", velocity(y), exact_velocity(zeta, end), truncation);
    }
  }
}

TEST(SingleSpring, ConvergesWithTheOrderOfTheMethod) {
  requirement("spring.damped");
  for (const Error& e : errors) {
    for (const double zeta : {0.0, 0.5, 1.0}) {
      std::vector<double> lengths, off;
      for (int n = e.order == 4 ? 100 : 200, last = 8 * n; n <= last; n *= 2) {  // rk4 soon meets round-off
        const State y = run_scene(spring_scene(zeta), e.method, end / n, end).y;
        lengths.push_back(end / n);
        off.push_back(std::hypot(position(y) - exact_position(zeta, end), velocity(y) - exact_velocity(zeta, end)));
      }
      expect(std::string(e.method) + ", damping ratio " + std::to_string(zeta) + ": observed order",
             fitted_slope(lengths, off), e.order,
             absolute(2 * e.slope, "what the next term of the error adds, measured, doubled"));
    }
  }
}

TEST(SingleSpring, DamperTakesTheEnergyThatIsMissing) {
  requirement("spring.damped");
  for (const double zeta : {0.05, 0.5, 1.0, 2.0}) {
    const Ran ran = run_scene(spring_scene(zeta), "rk4", 1e-3, end);
    const double x = exact_position(zeta, end);
    const double v = exact_velocity(zeta, end);
    expect("energy in the damper over k x0^2/2, damping ratio " + std::to_string(zeta),
           observe(ran.system, end, ran.y).energy.link_damping / (0.5 * stiffness * stretch * stretch),
           1 - x * x - v * v, absolute(0.4e-8 * zeta, "truncation of rk4, C (omega h)^4 zeta, C measured, doubled"));
  }
}

}  // namespace
}  // namespace furrow::verification::single_spring
