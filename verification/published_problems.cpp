// Published initial-value problems: each method of the catalogue, at many steps or tolerances, against end values that
// others have printed.
//
//   y' = f(t, y), y(0) given;  error at the end, of its greatest number, over step or tolerance
//   fixed steps    error = C h^p down to round-off;  C h where f jumps within steps, C h^p where steps end at the jumps
//   controlled     error = C tolerance^s, s = 1 or p/(p + 1) (studies/order_predicted.h)
//
// Sources: DETEST, Enright and Pryce, Arenstorf's orbit, CVODE's first example, see studies/published_problems.h. The
// quick form is the only one: `furrow study published` makes the table of it.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/studies/published_table.h"

namespace furrow::verification {
namespace {

const char* const order_reason =
    "three standard errors of the fit, by Student's t, and twice what the next power of the step does to the slope, or "
    "0.05, no more than half an order; of P(EC)E by Adams's formulas and of order 5 the next power may rule: to p + 1";
const char* const tolerance_reason =
    "one run a tolerance: a third of the exponent over four decades or more is beyond luck; over jumps a lower bound";
const char* const line_reason =
    "points off the line by 3 % and by what the next power bends it, half of how far it moves the slope; with error "
    "control by the factor of 5 that a step may grow at a time";

void expect_cell(const MethodInfo& method, const PublishedProblem& problem) {
  const PublishedCell cell = published_cell(method, problem);
  const std::string what = ", " + method.name + ", " + problem.name;
  if (!cell.cannot.empty()) return expect_true("cannot" + what + ": " + cell.cannot, true, "named, not left out");
  double greatest = 0, finest = 0;
  for (const Point& p : cell.points) greatest = std::max(greatest, p.position / p.tolerance);
  for (auto p = cell.points.end() - 3; p != cell.points.end(); ++p) finest = std::max(finest, p->position);
  if (cell.at_floor) {
    expect("error with the finest three steps" + what, finest, 0,
           absolute(problem.floor, "round-off: above it too few errors, or of two powers of the step, for an order"));
  } else if (cell.few_steps) {
    expect("error over tolerance" + what, greatest, 0, absolute(100, "ten steps carry it at most tolerances"));
  } else {
    const double most = std::min(cell.most, 2.0 * cell.least + 1), middle = (cell.least + most) / 2;
    expect((method.controlled ? "exponent of the tolerance" : "order") + what, cell.slope.value, middle,
           absolute(cell.gate + most - middle, method.controlled ? tolerance_reason : order_reason));
    expect("correlation" + what, cell.slope.correlation, 1, absolute(1 - cell.line, line_reason));
  }
}

template <class Chosen>
void expect_cells(const Chosen& chosen) {
  for (const PublishedProblem& problem : published_problems()) {
    for (const MethodInfo& method : method_catalogue()) {
      if (chosen(problem) && !known_to_fail(method, problem)) expect_cell(method, problem);
    }
  }
}

TEST(PublishedProblems, PrintedEndValuesAreThoseOfAnExtrapolationInLongDouble) {
  requirement("order.reference");
  for (const PublishedProblem& p : published_problems()) {
    const State end = extrapolated(p, p.end);
    double off = 0, size = 0;
    for (std::size_t i = 0; i < end.size(); ++i) {
      off = std::max(off, std::fabs(end[i] - p.published[i]));
      size = std::max(size, std::fabs(p.published[i]));
    }
    expect("end value, " + p.name, off / size, 0, absolute(p.digits, "digits of the printed value that hold"));
  }
}

TEST(PublishedProblems, ErrorsFallAsTheMethodSays) {
  requirement("order.published");
  expect_cells([](const PublishedProblem& p) { return !p.jumps && p.name != "Arenstorf"; });
}

TEST(PublishedProblems, AnOrbitThatNearlyMeetsTheMoonCloses) {
  requirement("order.published");
  expect_cells([](const PublishedProblem& p) { return p.name == "Arenstorf"; });
}

TEST(PublishedProblems, JumpsLeaveFirstOrderUnlessStepsEndThere) {
  requirement("order.published_jumps");
  expect_cells([](const PublishedProblem& p) { return p.jumps; });
}

// The day that this one holds it belongs among the others.
TEST(PublishedProblems, Fehlberg78StepsOverJumps) {
  requirement("order.published_jumps");
  for (const PublishedProblem& p : published_problems()) {
    const MethodInfo method = make_method("odeint_fehlberg78")->info();
    if (!known_to_fail(method, p)) continue;
    const PublishedCell cell = published_cell(method, p);
    expect_true("known to fail: odeint_fehlberg78 follows no tolerance, " + p.name, !cell.holds,
                "its estimate is that of two formulas that see a jump alike; see time.max_step");
  }
}

}  // namespace
}  // namespace furrow::verification
