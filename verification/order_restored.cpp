// What gives an order back, and what follows a tolerance: steps that grow from a touch, and controlled steps.
//
//   graded       t - t0 = T (n/N)^g after the touch:  order min(p, g (a + 1))          (studies/order_cure.h)
//   controlled   error = C tolerance^s,  s = p/q on a smooth force, less with an event (studies/order_predicted.h)
//
// The quick form of `furrow study order`.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/studies/order_cure.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_predicted.h"

namespace furrow::verification {
namespace {

const char* const cure_reason =
    "three standard errors of the fit, by Student's t, and twice what the next power of the step does to the slope, or "
    "0.05; no more than half of what is between the order and that without the cure, or between it and one order less";

const char* const band_reason =
    "as for orders, no more than half of what the exponent would fall by with a method of one order less; and Odeint "
    "keeps a step while the estimate is between half the tolerance and all of it: the worst that a factor of 2 does to "
    "the slope of nine points over ln 1e5 is 0.08";

// The greatest slope over equidistant points in ln(tolerance), 1e-5 to 1e-10, of what varies within ln 2: the sign of x
// times half of it.
double worst_band(int points) {
  const double distance = std::log(1e5) / (points - 1);
  double sum = 0, squares = 0;
  for (int k = 0; k < points; ++k) {
    const double x = distance * (k - 0.5 * (points - 1));
    sum += std::fabs(x), squares += x * x;
  }
  return 0.5 * std::log(2) * sum / squares;
}

// Half of what the prediction would fall by, if it were not met, is the most that says anything.
double half_of(const Slope& slope, double fall) { return std::min(tolerance_of(slope), fall / 2); }

TEST(OrderCertificate, StepsThatGrowFromTheTouchRestoreTheOrder) {
  requirement("order.cure");
  for (const char* method : graded_methods) {
    for (const char* name : graded_problems) {
      const Problem& p = problem(name);
      for (const int grading : gradings) {
        const Slope slope = fitted(observe_graded(method, p, grading, quick), &Point::position);
        const MethodInfo info = make_method(method)->info();
        const double want = predicted_graded(info, p, grading);
        const double uncured = std::min<double>(info.order, p.limit);
        expect("order of the position, " + std::string(method) + ", " + p.title + ", g = " + std::to_string(grading),
               slope.value, want,
               absolute(half_of(slope, uncured < want ? std::min(1.0, want - uncured) : 1), cure_reason));
      }
    }
  }
}

TEST(OrderCertificate, ErrorsFollowTheTolerance) {
  requirement("order.tolerance");
  for (const MethodInfo& method : method_catalogue()) {
    if (!method.controlled) continue;
    for (const Problem& p : problems()) {
      if (!applies(method, p) || p.name == "driven_spring") continue;  // smooth as the others: the study has it
      const Slope s = fitted_exponent(observe(method.name, p, quick));
      const auto want = predicted_exponents(method, p);
      const std::string what = "exponent of the tolerance, " + method.name + ", " + p.title;
      if (p.limit == no_limit) {
        const double band = method.name.starts_with("odeint") ? worst_band(quick.sizes) : 0;
        expect(what, s.value, want.smooth, absolute(std::min(tolerance_of(s) + band, want.fall / 2), band_reason));
      } else if (method.order > 5 || method.name == "odeint_bulirsch_stoer") {
        continue;  // the longest step rules, not the tolerance
      } else if (p.controller_sees_it) {
        expect_true(what, s.value > want.with_event - tolerance_of(s),
                    "a step over the event whose estimate happens to vanish is rare, but counts in the mean square");
      } else {
        expect_true(what, s.points >= 4 && s.value < 0.5,
                    "nothing of what the jump map does between steps is in the estimate: the tolerance has no say");
      }
    }
  }
}

}  // namespace
}  // namespace furrow::verification
