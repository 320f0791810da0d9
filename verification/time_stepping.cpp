// The methods themselves, on problems whose errors are known before they are run: at what time a stage is taken, with
// what weights, what is remembered, and what an error estimate says.
//
//   z' = l (z - phi) + phi', z(0) = phi(0):  z = phi.  A method of order p whose local error is h^(p+1) D(t) has
//   z(T) - phi(T) = h^p int_0^T e^(l (T-s)) D(s) ds + O(h^(p+1)).  With phi = sin, so that phi''(0) = 0:
//     trapezoid rule on a prediction of order 2          D = phi''' / 12;  of steps h and 2 h in turn 3 times as much
//     two-step Adams-Bashforth, r = h/h_before           D = -(1/6 + 1/(4 r)) phi'''
//     Verlet, trapezoid on two predictions of Euler's    D = phi''' / 12 - l phi'' / 2;  in turn 3 and 2.5 times
//     symplectic Euler                                   D = -phi'' / 2
//   z' = e^t by Simpson's rule (rk4):                    z(1) - (e - 1) = h^4/2880 (e - 1)
//   z'' = -z undamped:  v^2 + z^2 - h z v is kept by symplectic Euler, v^2 + (1 - h^2/4) z^2 by Verlet
//   Under error control the step settles where the estimate is half of the tolerance d:
//     z' = 3 t^2, Milne's device                         h^3 = d,  as the estimate is h^3/12 z'''
//     z' = 3 t^2, Runge-Kutta-Chebyshev, two stages      h^3 = d/(2.4 (1 - c)),  c = 1/(4 + 2/13)
//     z' = z, Milne's device, d relative                 h^3 = 6 d (1 + O(h))
//   z' = 1, then 3:  exact for a method that forgets what was before the jump
//
// Sources: Hairer, Norsett and Wanner, Solving ODEs I, II.3 and III.5; Sommeijer, Shampine and Verwer 1997.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "methods/method.h"
#include "verification/check.h"

namespace furrow::verification {
namespace {

// z' = f(t, z) in three copies, and nothing else.
class Scalar : public OdeSystem {
 public:
  explicit Scalar(double (*f)(double t, double z)) : f_(f) {}
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 0; }
  void rhs(double t, const State& y, State& dydt) const override {
    for (std::size_t i = 0; i < 3; ++i) dydt[i] = f_(t, y[i]);
  }

 private:
  double (*f_)(double t, double z);
};

struct Spring : OdeSystem {
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override { dydt = {y[1], -y[0]}; }
};

constexpr double rate = -1, stiff_rate = -2000;  // l, 1/s
const Scalar follows_sine([](double t, double z) { return rate * (z - std::sin(t)) + std::cos(t); });
const Scalar hurries_after_sine([](double t, double z) { return stiff_rate * (z - std::sin(t)) + std::cos(t); });
const Scalar exponential([](double t, double) { return std::exp(t); });
const Scalar growth([](double, double z) { return z; });
const Scalar parabola([](double t, double) { return 3 * t * t; });
const Scalar one([](double, double) { return 1.0; });
const Scalar three([](double, double) { return 3.0; });
const State zero(3, 0.0);
const Tolerances lax{.relative = 0, .absolute = 1e9, .first_step = 1e3};  // a controlled method takes any step

constexpr double end = 2;  // T
// Integrals over s in [0, T] of e^(l (T-s)) times phi'' = -sin s and phi''' = -cos s.
const double second = -(std::sin(end) - std::cos(end) + std::exp(-end)) / 2;
const double third = -(std::cos(end) + std::sin(end) - std::exp(-end)) / 2;

// Error at T of `pairs` of steps, the second one `ratio` times the first.
double error_after(Method& method, const OdeSystem& system, int pairs, double ratio) {
  const double h = end / pairs / (1 + ratio);
  State z = zero;
  for (int k = 0; k < pairs; ++k) {
    const double t = k * (1 + ratio) * h;
    method.step(system, t, z, h);
    method.step(system, t + h, z, ratio * h);
  }
  return z[0] - std::sin(end);
}

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

TEST(TimeStepping, OrdersAreThoseThatAreClaimed) {
  requirement("methods.order");
  for (const MethodInfo& info : method_catalogue()) {
    // Boost.Odeint's own are held to theirs by the order certificate, on problems that each of them can take.
    if (info.family != "own") continue;
    const int pairs = info.order > 3 ? 8 : 64;
    const double coarse = error_after(*make_method(info.name, lax), follows_sine, pairs, 1);
    const double fine = error_after(*make_method(info.name, lax), follows_sine, 2 * pairs, 1);
    expect("observed order, " + info.name, std::log2(coarse / fine), info.order,
           absolute(0.25, "next term of the series"));
  }
}

TEST(TimeStepping, StabilisedStagesHoldAStiffRate) {
  requirement("methods.stiff");
  expect("error, rkc, h l = -100", error_after(*make_method("rkc", lax), hurries_after_sine, 20, 1), 0,
         absolute(1.2e-5, "h phi''/(2 l) = 1.1e-5: the curvature within a step, damped by h l"));
}

TEST(TimeStepping, ControlledStepsSettleWhereTheEstimateIsHalfTheTolerance) {
  requirement("methods.control");
  const auto settled = [](const std::string& name, const Tolerances& tolerances, const OdeSystem& system, double from) {
    const auto method = make_method(name, tolerances);
    State z(3, from);
    double t = 0, h = 0;
    for (int k = 0; k < 200; ++k) t += h = method->step(system, t, z, 1);
    return h;
  };
  constexpr double d = 1e-6;
  constexpr double c = 1 / (4 + 2 / 13.0);
  const Tolerances absolutely{.relative = 0, .absolute = d, .first_step = 1e-4};
  const Tolerances relatively{.relative = d, .absolute = 0, .first_step = 1e-4};
  const Tolerance round_off = relative(1e-9, "round-off: of z in the estimate, 2e-16 z/d");
  expect("step [s], pece_adaptive", settled("pece_adaptive", absolutely, parabola, 0), std::cbrt(d), round_off);
  expect("step [s], rkc", settled("rkc", absolutely, parabola, 0), std::cbrt(d / (2.4 * (1 - c))), round_off);
  expect("step [s], relative, pece_adaptive", settled("pece_adaptive", relatively, growth, 1), std::cbrt(6 * d),
         relative(2 * std::cbrt(6 * d), "the next term, of h"));
}

TEST(TimeStepping, JumpsAreForgotten) {
  requirement("methods.jump");
  for (const MethodInfo& info : method_catalogue()) {
    const auto method = make_method(info.name);
    State z = zero;
    double t = 0;
    const auto go = [&](const OdeSystem& system, double until) {
      while (t < until - 1e-12) t += method->step(system, t, z, std::min(0.1, until - t));
    };
    go(one, 1);
    method->restart();
    go(three, 2);
    expect("z(2), " + info.name, z[0], 4, relative(1e-11, "round-off, and the last 1e-12 s"));
    expect("rejected steps, " + info.name, static_cast<double>(method->rejections()), 0,
           exact("a constant rate has no error"));
  }
}

}  // namespace
}  // namespace furrow::verification
