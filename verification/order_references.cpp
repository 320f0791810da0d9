// The exact solutions against which orders are observed, each by a second way.
//
//   between events   the solver's own right-hand side, integrated by the classical Runge-Kutta method, leads from one
//                    exact state to another
//   Hertz            the closed form of damped_hertz.h against its equation of motion
//
// Sources: the closed forms of studies/order_problems.h.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/damped_hertz.h"
#include "verification/second_integration.h"
#include "verification/studies/order_hertz.h"
#include "verification/studies/order_problems.h"

namespace furrow::verification {
namespace {

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
    const Problem& p = problem(piece.problem);
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
    const HertzPath path(beta, true);
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

}  // namespace
}  // namespace furrow::verification
