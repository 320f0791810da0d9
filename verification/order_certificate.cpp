// The order of every method of the catalogue on every kind of force: observed against predicted.
//
//   observed    slope of log(error) over log(step), error: root of the mean square over runs whose events fall at
//               different places within a step; with the standard error of the fit (studies/order_observed.h)
//   predicted   min(p, a + 1), where the force at an event starts as (t - t0)^a (studies/order_predicted.h)
//
// The quick form of `furrow study order`. Sources: closed forms; two unrelated integrations where there are none.
#include <algorithm>
#include <cmath>
#include <string>

#include "run/system.h"
#include "verification/check.h"
#include "verification/damped_hertz.h"
#include "verification/studies/order_cure.h"
#include "verification/studies/order_hertz.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_predicted.h"
#include "verification/studies/order_trends.h"

namespace furrow::verification {
namespace {

using verification::Point;
using verification::Problem;
using verification::Slope;

const char* const slope_reason =
    "three standard errors of the fit, by Student's t, and twice what the next power of the step does to the slope, or "
    "0.05, and the predictor's share of the next power; no more than half of what the order would fall by with a "
    "method of one order less; where p is little above the limit, anything between the two";

const char* const cure_reason =
    "three standard errors of the fit, by Student's t, and twice what the next power of the step does to the slope, or "
    "0.05; no more than half of what is between the order and that without the cure, or between it and one order less";

const char* const band_reason =
    "as for orders, no more than half of what the exponent would fall by with a method of one order less; and Odeint "
    "keeps a step while the estimate is between half the tolerance and all of it: the worst that a factor of 2 does to "
    "the slope of nine points over ln 1e5 is 0.08";

const char* const return_reason =
    "three standard errors of the fit, by Student's t, and twice what the next power of the step does to the slope, or "
    "0.05; where the force starts as t^(3/2) a step at t loses h^6/t for good, in all h^5 ln(T/h), whose slope is "
    "5 - 1/ln(T/h); no more than half an order, since without symmetry it is one less";

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
double told_apart(const Slope& slope, double fall) { return std::min(verification::tolerance_of(slope), fall / 2); }

void expect_orders(const std::string& name) {
  const Problem& p = verification::problem(name);
  for (const MethodInfo& method : method_catalogue()) {
    if (method.controlled || !verification::applies(method, p)) continue;
    const auto v = verification::verdict(method, p, verification::observe(method.name, p, verification::quick));
    const auto& want = *v.predicted;
    const double room = (want.most - want.position) / 2;
    const auto near = [&](double gate) { return absolute(room + gate, slope_reason); };
    const std::string what = method.name + ", " + p.title;
    expect("order of the position, " + what, v.position.value, want.position + room, near(v.position_gate));
    if (want.at_least) {
      expect_true(
          "order of the speed, " + what, v.velocity_holds,
          "after a rebound what is lost on the way in is regained on the way out: at least min(p + 1, a + 1) for "
          "even p; after a tear it follows from the energy alone: at least p");
    } else {
      expect("order of the velocity, " + what, v.velocity.value, want.velocity + room, near(v.velocity_gate));
    }
  }
}

// By the classical Runge-Kutta method with 4000 steps. A first jump gives contacts their tangential springs.
State integrated(OdeSystem& system, State y, double from, double duration) {
  constexpr int steps = 4000;
  State room = y;
  if (auto* scene = dynamic_cast<System*>(&system)) scene->jump(0, room);
  const double h = duration / steps;
  State k[4] = {y, y, y, y};
  for (int n = 0; n < steps; ++n) {
    for (int stage = 0; stage < 4; ++stage) {
      const double reach = stage == 0 ? 0 : stage == 3 ? h : h / 2;
      for (std::size_t i = 0; i < y.size(); ++i) room[i] = y[i] + (stage == 0 ? 0 : reach * k[stage - 1][i]);
      system.rhs(from + n * h + reach, room, k[stage]);
    }
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (k[0][i] + 2 * (k[1][i] + k[2][i]) + k[3][i]);
  }
  return y;
}

// Between events, the solver's own right-hand side carries one exact state to another.
struct Piece {
  const char* problem;
  double from, to;  // in the problem's unit of time
};
constexpr Piece pieces[] = {{"spring", 0, 6},
                            {"damped_spring", 0, 6},
                            {"driven_spring", 0, 3},
                            {"lattice", 0, 4},
                            {"tear", 0, 0.72},
                            {"linear_contact", 0.3, 1.2},
                            {"dashpot_contact", 0.3, 1.2},
                            {"hertz", 0.5, 1.0},
                            {"damped_hertz_inside", 0.5, 0.9},
                            {"damped_hertz", 0.5, 1.0},
                            {"stick_slip", 0, 0.67},
                            {"stick_slip", 0.68, 1.92},
                            {"stick_slip", 1.93, 2.7},
                            {"sliding", 0.5, 1.0},
                            {"sticking", 0.5, 0.9}};

TEST(OrderCertificate, ReferencesAgreeWithASecondIntegration) {
  requirement("order.reference");
  const Tolerance round_off = absolute(
      1e-12,
      "rk4 at 4000 steps errs by less than 1e-13; round-off of 4000 sums at 0.1 m over lengths of 1 mm and more");
  for (const Piece& piece : pieces) {
    const Problem& p = verification::problem(piece.problem);
    const auto system = p.system();
    const double from = piece.from * p.unit, to = piece.to * p.unit;
    const State want = p.state(to);
    const State got = integrated(*system, p.state(from), from, to - from);
    const std::size_t n = system->positions();
    double position = 0, velocity = 0;
    for (std::size_t i = 0; i < n; ++i) {
      position = std::max(position, std::fabs(got[i] - want[i]) / p.length);
      velocity = std::max(velocity, std::fabs(got[i + n] - want[i + n]) / p.speed);
    }
    const std::string what = ", " + p.title + ", from " + std::to_string(piece.from).substr(0, 4) + " units of time on";
    expect("distance of the positions" + what, position, 0, round_off);
    expect("distance of the velocities" + what, velocity, 0, round_off);
  }
}

TEST(OrderCertificate, HertzReferenceAgreesFromTheTouchOn) {
  requirement("order.reference");
  for (const double beta : {0.0, 0.1}) {
    const verification::HertzPath path(beta, true);
    for (const double end : {0.5, 1.5, 2.5}) {
      const auto [overlap, speed] = path.at(end);
      const Motion motion = integrate_impact(beta, end, 4000);
      const std::string what =
          ", beta " + std::to_string(beta).substr(0, 3) + ", " + std::to_string(end).substr(0, 3) + " after the touch";
      const Tolerance truncation = absolute(
          1e-10, "rk4 with 4000 steps graded as the fourth power of time, whose first step sees a root: order 4 still");
      expect("overlap" + what, static_cast<double>(overlap), static_cast<double>(motion.overlap), truncation);
      expect("speed" + what, static_cast<double>(speed), static_cast<double>(motion.speed), truncation);
    }
  }
}

TEST(OrderCertificate, SmoothForcesShowTheMethodsOwnOrder) {
  requirement("order.smooth");
  for (const char* name : {"spring", "damped_spring", "driven_spring", "lattice"}) expect_orders(name);
}

TEST(OrderCertificate, LinearContactsShowTheOrderOfTheirKink) {
  requirement("order.contact");
  for (const char* name : {"linear_contact", "dashpot_contact"}) expect_orders(name);
}

TEST(OrderCertificate, ElasticHertzContactsShowOrderFiveHalvesAtMost) {
  requirement("order.contact");
  for (const char* name : {"hertz_inside", "hertz"}) expect_orders(name);
}

TEST(OrderCertificate, DampedHertzContactsShowOrderFiveQuartersAtMost) {
  requirement("order.contact");
  for (const char* name : {"damped_hertz_inside", "damped_hertz"}) expect_orders(name);
}

TEST(OrderCertificate, FrictionShowsTheOrderOfItsKink) {
  requirement("order.friction");
  for (const char* name : {"stick_slip", "sliding", "sticking"}) expect_orders(name);
}

TEST(OrderCertificate, ATornLinkLeavesFirstOrderUnlessItIsLocated) {
  requirement("order.tear");
  for (const char* name : {"tear", "located_tear"}) expect_orders(name);
}

TEST(OrderCertificate, StepsThatGrowFromTheTouchRestoreTheOrder) {
  requirement("order.cure");
  for (const char* method : verification::graded_methods) {
    for (const char* name : verification::graded_problems) {
      const Problem& p = verification::problem(name);
      for (const int grading : verification::gradings) {
        const Slope slope = verification::fitted(verification::observe_graded(method, p, grading, verification::quick),
                                                 &Point::position);
        const MethodInfo info = make_method(method)->info();
        const double want = verification::predicted_graded(info, p, grading);
        const double uncured = std::min<double>(info.order, p.limit);
        expect("order of the position, " + std::string(method) + ", " + p.title + ", g = " + std::to_string(grading),
               slope.value, want,
               absolute(told_apart(slope, uncured < want ? std::min(1.0, want - uncured) : 1), cure_reason));
      }
    }
  }
}

TEST(OrderCertificate, ErrorsFollowTheTolerance) {
  requirement("order.tolerance");
  for (const MethodInfo& method : method_catalogue()) {
    if (!method.controlled) continue;
    for (const Problem& p : verification::problems()) {
      if (!verification::applies(method, p) || p.name == "driven_spring")
        continue;  // smooth as the others: the study has it
      const Slope s = verification::fitted_exponent(verification::observe(method.name, p, verification::quick));
      const auto want = verification::predicted_exponents(method, p);
      const std::string what = "exponent of the tolerance, " + method.name + ", " + p.title;
      if (p.limit == verification::no_limit) {
        const double band = method.name.starts_with("odeint") ? worst_band(verification::quick.sizes) : 0;
        expect(what, s.value, want.smooth,
               absolute(std::min(verification::tolerance_of(s) + band, want.fall / 2), band_reason));
      } else if (method.order > 5 || method.name == "odeint_bulirsch_stoer") {
        continue;  // the longest step rules, not the tolerance
      } else if (p.controller_sees_it) {
        expect_true(what, s.value > want.with_event - verification::tolerance_of(s),
                    "a step over the event whose estimate happens to vanish is rare, but counts in the mean square");
      } else {
        expect_true(what, s.points >= 4 && s.value < 0.5,
                    "nothing of what the jump map does between steps is in the estimate: the tolerance has no say");
      }
    }
  }
}

TEST(OrderCertificate, EvaluationsAreWhatTheCatalogueSays) {
  requirement("order.evaluations");
  for (const MethodInfo& method : method_catalogue()) {
    if (method.evaluations == 0) continue;              // as many as the stiffness needs
    const int columns = method.dense_jacobian ? 2 : 0;  // of the oscillator's Jacobian
    expect("evaluations a step, " + method.name, verification::evaluations(method.name).per_step,
           method.evaluations + columns, exact("counted over 100 steps"));
  }
}

TEST(OrderCertificate, TheWayBackEndsWhereTheSymmetrySays) {
  requirement("order.reversal");
  for (const MethodInfo& method : method_catalogue()) {
    const auto want = verification::predicted_return(method);
    if (!want) continue;
    const auto points = verification::observe_return(method.name, verification::problem("hertz"), verification::quick);
    if (std::isinf(*want)) {
      double greatest = 0;
      for (const Point& point : points) greatest = std::max(greatest, point.position);
      expect(
          "distance from the start over the overlap, " + method.name, greatest, 0,
          absolute(1e-12, "round-off of some 6000 steps of a symmetric method: 1e-16 each as a random walk is 1e-14"));
    } else {
      const Slope slope = verification::fitted_return(points);
      const double logarithm = *want == 5 ? 1 / std::log(verification::problem("hertz").unit / slope.step) : 0;
      expect("order of the distance from the start, " + method.name, slope.value, *want,
             absolute(std::min(verification::tolerance_of(slope) + logarithm, 0.5), return_reason));
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
    const double got = verification::energy_drift(method.name, angle);
    if (const auto want = verification::predicted_drift(method.name)) {
      const double leading = want->factor * std::pow(verification::true_angle(angle), want->power);
      expect("change of energy a period, h omega = 0.05, leading term, " + method.name, got, leading,
             absolute(2 * angle * angle * std::fabs(leading) + 1e-8,
                      std::string("the next term is angle^2 times a factor of order one; ") + swing));
    }
    if (const auto want = verification::amplified_drift(method.name, angle)) {
      expect("change of energy a period, h omega = 0.05, amplification, " + method.name, got, *want,
             absolute(1e-3 * std::fabs(*want) + 1e-8,
                      std::string("parasitic roots die within the first window but for a start of 1e-3; ") + swing));
    }
  }
}

}  // namespace
}  // namespace furrow::verification
