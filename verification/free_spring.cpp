// A mass on an undamped spring: its motion and its period, with each method's own error, known in closed form.
//
//   x = x0 cos(omega t),  T = 2 pi/omega,  q = omega h
//   y = x + i x'/omega,  y' = -i omega y,  z = -i q
//   rk4     y_n = R^n,  R = 1 + z + z^2/2 + z^3/6 + z^4/24         T (1 + q^4/120),  energy R conj(R) a step
//   pece    y_(n+1) = (1 + z + 3/4 z^2) y_n - 1/4 z^2 y_(n-1)      T (1 + q^2/12),   amplitude 1 - q^4/4 a step
//           y_1 = (1 + z + z^2/2) y_0
//   verlet  x_n = cos(n theta),  cos(theta) = 1 - q^2/2            T (1 - q^2/24),   energy 1 - q^2/4 sin^2(n theta)
//
// Source: linear difference equations, worked out here; the leading terms after Hairer, Lubich and Wanner, Geometric
// Numerical Integration, and, for pece, from the roots of r^2 = r (1 + z + 3/4 z^2) - 1/4 z^2.
#include <cmath>
#include <string>

#include "verification/discrete_spring.h"

namespace furrow::verification::free_spring {
namespace {

TEST(FreeSpring, ClosedFormsOfTheMethodsAgreeWithTheirRecurrences) {
  requirement("spring.free");
  for (const char* method : {"pece", "rk4", "verlet"}) {
    for (const double q : {0.01, 0.3}) {
      const Complex difference = discrete_solution(method, q, steps) - recurrence(method, q, steps);
      expect(std::string(method) + ": difference after 1000 steps, omega h = " + std::to_string(q),
             static_cast<double>(std::abs(difference)), 0, absolute(2e-16, "round-off of 1000 steps in long double"));
    }
  }
  // The amplitude: pece damps by q^4/4 a step.
  for (const double q : {0.01, 0.05}) {
    const double ratio = static_cast<double>(std::abs(discrete_solution("pece", q, 2 * steps)) /
                                             std::abs(discrete_solution("pece", q, steps)));
    expect("pece: damping a step over q^4/4, q = " + std::to_string(q), -std::log(ratio) / steps / (q * q * q * q / 4),
           1, absolute(2 * q * q, "the next term, q^2, doubled"));
  }
}

TEST(FreeSpring, EveryStepIsThatOfTheMethod) {
  requirement("spring.free");
  for (const char* method : {"pece", "rk4", "verlet"}) {
    for (const double q : {0.01, 0.3}) {
      const State y = run_scene(spring_scene(0), method, q / omega, steps * q / omega).y;
      const Complex want = discrete_solution(method, q, steps);
      const auto round_off = absolute(1e-13, "round-off of 1000 steps, each of 1e-16 l/x0");
      const std::string what = std::string(method) + ", omega h = " + std::to_string(q);
      expect(what + ": x / x0 after 1000 steps", position(y), static_cast<double>(want.real()), round_off);
      expect(what + ": x' / (omega x0)", velocity(y), static_cast<double>(want.imag()), round_off);
    }
  }
}

TEST(FreeSpring, PeriodIsExactButForTheShiftOfTheMethod) {
  requirement("spring.free");
  constexpr double q = 0.05;
  struct Shift {
    const char* method;
    double of_period, next;
  };
  const double q2 = q * q;
  for (const Shift& s : {Shift{"pece", q2 / 12, q2 * q2 / 4},
                         {"verlet", -q2 / 24, q2 * q2 / 339},
                         {"rk4", q2 * q2 / 120, q2 * q2 * q2 / 336}}) {
    const double period = measured_period(s.method, q / omega, 20) / (2 * pi / omega);
    expect(std::string(s.method) + ": period over 2 pi/omega", period, 1,
           absolute(2 * std::fabs(s.of_period), "the shift of the method, doubled"));
    expect(std::string(s.method) + ": shift of the period", period - 1, s.of_period,
           absolute(2 * s.next, "the next term of the series, doubled"));
  }
}

}  // namespace
}  // namespace furrow::verification::free_spring
