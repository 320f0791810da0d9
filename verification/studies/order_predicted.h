// The order that theory predicts for a method on a kind of force.
//
//   smooth force          p, the method's own
//   force as (t - t0)^a   min(p, a + 1): the step over t0 errs by h^(a + 1) in velocity, whatever the method
//   torn link             1: the tear is seen at the end of a step
//
// Where a body leaves an elastic contact as fast as it came, a method of even order p errs by h^(p + 1) in speed only:
// what it lost on the way in it regains on the way out. There the speed converges faster than the position.
#pragma once

#include <optional>
#include <vector>

#include "methods/method.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_problems.h"

namespace furrow::verification {

struct Prediction {
  double position = 0;
  double velocity = 0;
  // If p is little above the limit (problem.indistinct), the two powers of h cannot be separated at steps that can be
  // afforded: from the limit to p.
  double most = 0;
  bool at_least = false;  // the velocity's is a lower bound: the next power may have the larger factor
};

// Nothing for a controlled method (see predicted_exponents) and one that cannot integrate the problem.
std::optional<Prediction> predicted(const MethodInfo& method, const Problem& problem);

// A controlled method's error goes like tolerance^s. On a smooth force the local error, as h^q, is held at the
// tolerance and the error itself goes as h^p: s = p/q, or 1 if p = q.
//
// At an event within a step the estimate, as a function of where in the step it falls, passes through zero: with a
// probability of tolerance/e a step of the natural size h = tolerance^(1/q) is taken that errs by e = h^(a + 1). In the
// mean square that is e tolerance, so that s may fall to (1 + (a + 1)/q)/2.
//
// Where the jump map acts between steps the estimate sees nothing and s is near zero.
struct Exponents {
  double smooth, with_event;
  double fall;  // of `smooth`, with a method of one order less: 1/q
};
Exponents predicted_exponents(const MethodInfo& method, const Problem& problem);

// P(EC)E by Adams's formulas of order p errs by C h^(p+1) y^(p+1) of the corrector and, since the rate there is taken
// at the predicted place, by b0 h J C_P h^(p+1) y^(p+1) more: the next power of the step, with the factor
//   b0 C_P/C = gamma_(p-1) gamma_p / |gamma*_p|,   1, 2.5, 3.75, 4.95, 6.13 for p = 1 to 5,
// over the first; 0 for other methods. Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, III.1.
double predictors_share(const MethodInfo& method);

// How far log error may stand from the line. On a smooth force by 3 %: what the next power of the step bends it by, over
// six steps of which the longest leaves an error of a thirtieth. With an event each error is the root of a mean square
// over where in a step it falls, and at worst one of these places makes the whole error: it is hit or missed, the mean
// square varies by its whole, half its logarithm by 1/2.
double scatter_on(const Problem& problem);

// Slopes of one method on one problem against their predictions. `gate`: how far one may be off, which is
// tolerance_of(slope), and on a smooth force what the predictor of an Adams method does to the slope; but no more than
// half of what the order would fall by with a method of one order less, and half an order where that is hidden by
// the event. A wider one would certify nothing. `line`: the least correlation, of points that scatter by scatter_on; of a
// lower bound nothing is asked.
struct Verdict {
  Slope position, velocity;
  std::optional<Prediction> predicted{};
  double position_gate = 0, velocity_gate = 0;
  double position_line = 0, velocity_line = 0;
  bool position_holds = true, velocity_holds = true;
};
Verdict verdict(const MethodInfo& method, const Problem& problem, const std::vector<Point>& points);

// Whether the method can integrate the problem at all.
bool applies(const MethodInfo& method, const Problem& problem);

}  // namespace furrow::verification
