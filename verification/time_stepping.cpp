// The methods themselves, on problems whose errors are known before they are run: at what time a stage is taken, with
// what weights, and what is remembered.
//
//   z' = l (z - phi) + phi', z(0) = phi(0):  z = phi.  A method of order p whose local error is h^(p+1) D(t) has
//   z(T) - phi(T) = h^p int_0^T e^(l (T-s)) D(s) ds + O(h^(p+1)).  With phi = sin, so that phi''(0) = 0:
//     trapezoid rule on a prediction of order 2          D = phi''' / 12;  of steps h and 2 h in turn 3 times as much
//     two-step Adams-Bashforth, r = h/h_before           D = -(1/6 + 1/(4 r)) phi'''
//     Verlet, trapezoid on two predictions of Euler's    D = phi''' / 12 - l phi'' / 2;  in turn 3 and 2.5 times
//     symplectic Euler                                   D = -phi'' / 2
//   z' = e^t by Simpson's rule (rk4):                    z(1) - (e - 1) = h^4/2880 (e - 1)
//   z'' = -z undamped, kept by symplectic Euler:         v^2 + z^2 - h z v
//                        kept by Verlet:                 v^2 + (1 - h^2/4) z^2
//
// Sources: Hairer, Norsett and Wanner, Solving ODEs I, II.3 and III.5.
#include <cmath>
#include <numbers>
#include <string>

#include "verification/check.h"
#include "verification/known_errors.h"

namespace furrow::verification::time_stepping {
namespace {

struct Spring : OdeSystem {
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override { dydt = {y[1], -y[0]}; }
};

struct Expected {
  std::string method;
  int order, evaluations;
  double equal, alternating;  // error over h^order, of steps all h, or h and 2 h in turn
};

TEST(TimeStepping, ErrorsAreThoseOfTheFormulas) {
  requirement("methods.error");
  constexpr double bashforth = (8 * (1 / 6.0 + 1 / 8.0) + (1 / 6.0 + 1 / 2.0)) / 3;  // r = 2 and 1/2
  const Expected table[] = {{"pece", 2, 2, third / 12, third / 4},
                            {"pec", 2, 1, third / 12, third / 4},
                            {"pecece", 2, 3, third / 12, third / 4},
                            {"ab2", 2, 1, -5 * third / 12, -bashforth * third},
                            {"verlet", 2, 1, third / 12 - rate * second / 2, third / 4 - 5 * rate * second / 4},
                            {"symplectic_euler", 1, 1, -second / 2, -5 * second / 6}};
  constexpr int pairs = 20000;
  for (const Expected& e : table) {
    for (const double ratio : {1.0, 2.0}) {
      const auto method = make_method(e.method);
      const double h = end / pairs / (1 + ratio);
      const std::string name = ", " + e.method + (ratio == 1 ? "" : ", steps h and 2 h");
      expect("error over h^" + std::to_string(e.order) + name,
             error_after(*method, follows_sine, pairs, ratio) / std::pow(h, e.order),
             ratio == 1 ? e.equal : e.alternating, absolute(h, "the next term, of h with a factor below one"));
      expect("evaluations a step" + name, static_cast<double>(method->evaluations()) / (2 * pairs), e.evaluations,
             absolute(1.0 / pairs, "one or two more at the start"));
    }
  }
  constexpr int steps = 32;
  const auto method = make_method("rk4");
  State z = zero;
  for (int k = 0; k < steps; ++k) method->step(exponential, k / double(steps), z, 1.0 / steps);
  expect("error over h^4, rk4", (z[0] - (std::numbers::e - 1)) * std::pow(steps, 4), (std::numbers::e - 1) / 2880,
         relative(1.0 / (30.0 * steps * steps), "the next term: h^2/33.6"));
}

TEST(TimeStepping, UndampedMotionKeepsTheInvariants) {
  requirement("methods.invariant");
  constexpr double h = 0.3;
  for (const std::string name : {"symplectic_euler", "verlet"}) {
    const auto method = make_method(name);
    State y{1, 0.5};
    const auto kept = [&] {
      return y[1] * y[1] + y[0] * y[0] - (name == "verlet" ? h * h / 4 * y[0] * y[0] : h * y[0] * y[1]);
    };
    const double start = kept();
    for (int k = 0; k < 1000; ++k) method->step(Spring(), k * h, y, h);
    expect("the method's own energy, " + name, kept(), start, relative(2e-13, "round-off of 1000 steps"));
  }
}

}  // namespace
}  // namespace furrow::verification::time_stepping
