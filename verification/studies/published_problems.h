// Published initial-value problems, which have nothing to do with contacts: does each method solve what others solve?
//
//   A1 ... E5   DETEST: Hull, Enright, Fellen and Sedgwick 1972 (SIAM J. Numer. Anal. 9, 603)
//   F2          its class of right-hand sides that jump: Enright and Pryce 1987 (ACM Trans. Math. Softw. 13, 1)
//   Arenstorf   Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.0: a periodic orbit
//   Van der Pol Hindmarsh et al. 2005 (ACM Trans. Math. Softw. 31, 363), the first example of CVODE
//
// From t = 0 to 20 s if nothing else is said. Where the first half of y are positions q and the other half q', methods
// for systems of second order know.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "system/ode.h"
#include "verification/studies/order_reference.h"

namespace furrow::verification {

struct PublishedProblem {
  std::string name, equation;
  State start;
  State published;                    // y(end) as printed
  double digits = 1e-13;              // how far that is off at most, of its greatest number
  double end = 20;                    // s
  double judged = 0;                  // s, when errors are taken; 0: at the end
  double floor = 1e-12;               // errors below it, of the greatest number, may be round-off
  int least_steps = 80;               // of methods of order 3 and more
  int order_two = 4, order_one = 60;  // times as many for methods of lower order; 0: more than can be afforded
  double fastest = 1;                 // 1/s, about the largest eigenvalue
  bool second_order = false, velocity_matters = true;  // q'' depends on q'
  bool jumps = false, located = false;                 // f jumps at whole t; steps end there, and the method is told
  std::function<void(double, int, const State&, State&)> rate{};                // of (t, piece, y)
  std::function<void(long double, int, const Numbers&, Numbers&)> long_rate{};  // the same
};

const std::vector<PublishedProblem>& published_problems();

// y(t) by extrapolation in long double, from whole t to whole t where f jumps.
State extrapolated(const PublishedProblem& problem, double t);

// The problem as methods see it. Between jumps `piece` says which right-hand side holds; -1: the time itself does.
class PublishedSystem final : public OdeSystem {
 public:
  explicit PublishedSystem(const PublishedProblem& problem) : problem_(problem) {}
  std::size_t size() const override { return problem_.start.size(); }
  std::size_t positions() const override { return problem_.second_order ? size() / 2 : 0; }
  std::string velocity_dependence() const override;
  void rhs(double t, const State& y, State& dydt) const override;
  void hold(int piece) { piece_ = piece; }

 private:
  const PublishedProblem& problem_;
  int piece_ = -1;
};

}  // namespace furrow::verification
