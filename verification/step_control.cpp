// What the catalogue promises of every method: its order, steps of the length that its error estimate says, and that it
// forgets what was before a jump.
//
//   under error control the step settles where the estimate is half of the tolerance d:
//     z' = 3 t^2, Milne's device                     h^3 = d,  as the estimate is h^3/12 z'''
//     z' = 3 t^2, Runge-Kutta-Chebyshev, two stages  h^3 = d/(2.4 (1 - c)),  c = 1/(4 + 2/13)
//     z' = z, Milne's device, d relative             h^3 = 6 d (1 + O(h))
//   a stiff rate l, stabilised stages:               error h phi''/(2 l)
//   z' = 1, then 3:                                  exact for a method that forgets
//
// Sources: Hairer, Norsett and Wanner, Solving ODEs I, II.3 and III.5; Sommeijer, Shampine and Verwer 1997.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/known_errors.h"

namespace furrow::verification::time_stepping {
namespace {

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
}  // namespace furrow::verification::time_stepping
