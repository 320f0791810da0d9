// A mass on an undamped spring: its period, its energy, and each method's own error in both, known in closed form.
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
#include <algorithm>
#include <cmath>
#include <string>

#include "run/observe.h"
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

TEST(FreeSpring, EnergyIsKeptButForWhatTheMethodDoes) {
  requirement("spring.free");
  constexpr double q = 0.05;
  const Scene scene = spring_scene(0);
  for (const char* method : {"pece", "rk4", "verlet"}) {
    const Ran ran = run_scene(scene, method, q / omega, steps * q / omega);
    const double energy =
        observe(ran.system, ran.end.time, ran.y).energy.stored() / (0.5 * stiffness * stretch * stretch);
    expect(std::string(method) + ": energy over k x0^2/2 after 1000 steps", energy,
           static_cast<double>(std::norm(discrete_solution(method, q, steps))),
           absolute(5e-14, "round-off of 1000 steps, each of 1e-16 l/x0"));
  }
  // What that comes to: rk4 loses q^6/72 a step, pece q^4/2, Verlet swings by q^2/4.
  struct Change {
    const char* method;
    double greatest, beyond;
    const char* why;
  };
  const double q2 = q * q;
  for (const Change& c :
       {Change{"pece", steps * q2 * q2 / 2, 4 * q2, "terms of order q^2 and half of the change itself"},
        {"rk4", steps * q2 * q2 * q2 / 72, q2 / 4, "the next term, q^2/8, doubled"},
        {"verlet", q2 / 4, q2 * q2 / 4, "a step may miss the turn by q/2"}}) {
    double greatest = 0;
    run_scene(scene, c.method, q / omega, steps * q / omega, [&](double, const State& y, const JumpReport&) {
      const double energy = position(y) * position(y) + velocity(y) * velocity(y);
      greatest = std::max(greatest, std::fabs(energy - 1));
      return true;
    });
    expect(std::string(c.method) + ": greatest change of energy over the run", greatest, c.greatest,
           relative(c.beyond, c.why));
  }
}

}  // namespace
}  // namespace furrow::verification::free_spring
