// What else the catalogue says of a method: evaluations a step, where the way back ends, how the energy drifts.
//
//   way back   a run through a Hertz impact, reversed and run back, misses its start by h^(p+1) for even p or
//              not at all
//   energy     of x'' = -x in a period: |r|^(4 pi/angle) from the principal root r of the method's amplification
//
// Both are explained in studies/order_trends.h. The quick form of `furrow study order`.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_predicted.h"
#include "verification/studies/order_trends.h"

namespace furrow::verification {
namespace {

const char* const return_reason =
    "three standard errors of the fit, by Student's t, and twice what the next power of the step does to the slope, or "
    "0.05; where the force starts as t^(3/2) a step at t loses h^6/t for good, in all h^5 ln(T/h), whose slope is "
    "5 - 1/ln(T/h); no more than half an order, since without symmetry it is one less";

TEST(OrderCertificate, EvaluationsAreWhatTheCatalogueSays) {
  requirement("order.evaluations");
  for (const MethodInfo& method : method_catalogue()) {
    if (method.evaluations == 0) continue;              // as many as the stiffness needs
    const int columns = method.dense_jacobian ? 2 : 0;  // of the oscillator's Jacobian
    expect("evaluations a step, " + method.name, evaluations(method.name).per_step, method.evaluations + columns,
           exact("counted over 100 steps"));
  }
}

TEST(OrderCertificate, TheWayBackEndsWhereTheSymmetrySays) {
  requirement("order.reversal");
  for (const MethodInfo& method : method_catalogue()) {
    const auto want = predicted_return(method);
    if (!want) continue;
    const auto points = observe_return(method.name, problem("hertz"), quick);
    if (std::isinf(*want)) {
      double greatest = 0;
      for (const Point& point : points) greatest = std::max(greatest, point.position);
      expect(
          "distance from the start over the overlap, " + method.name, greatest, 0,
          absolute(1e-12, "round-off of some 6000 steps of a symmetric method: 1e-16 each as a random walk is 1e-14"));
    } else {
      const Slope slope = fitted_return(points);
      const double logarithm = *want == 5 ? 1 / std::log(problem("hertz").unit / slope.step) : 0;
      expect("order of the distance from the start, " + method.name, slope.value, *want,
             absolute(std::min(tolerance_of(slope) + logarithm, 0.5), return_reason));
    }
  }
}

TEST(OrderCertificate, EnergyDriftsAsTheAmplificationSays) {
  requirement("order.energy");
  constexpr double angle = 0.05;
  const char* const swing =
      "1e-8 for the swing of the energy within a period, angle^2/4, in means over windows that are not whole periods";
  for (const MethodInfo& method : method_catalogue()) {
    if (method.controlled) continue;
    const double got = energy_drift(method.name, angle);
    if (const auto want = predicted_drift(method.name)) {
      const double leading = want->factor * std::pow(true_angle(angle), want->power);
      expect("change of energy a period, h omega = 0.05, leading term, " + method.name, got, leading,
             absolute(2 * angle * angle * std::fabs(leading) + 1e-8,
                      std::string("the next term is angle^2 times a factor of order one; ") + swing));
    }
    if (const auto want = amplified_drift(method.name, angle)) {
      expect("change of energy a period, h omega = 0.05, amplification, " + method.name, got, *want,
             absolute(1e-3 * std::fabs(*want) + 1e-8,
                      std::string("parasitic roots die within the first window but for a start of 1e-3; ") + swing));
    }
  }
}

}  // namespace
}  // namespace furrow::verification
