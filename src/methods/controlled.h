// Error control and choice of step for methods whose error of one step is of third order, as furrow's own methods of
// order 2.
//
//   error     e = max over the controlled numbers of |e_i| / (absolute + relative (|y_i| + h |y'_i|)),  good up to 1
//   accepted  h_(n+1) = h_n (s / e_n)^(1/8) (s / e_(n-1))^(1/8) (h_n / h_(n-1))^(-3/8)
//   rejected  h       = h (s / e)^(3/8)
//
// with s = 1/2: Soederlind's digital filter H211b with b k = 8 for k = 3, so that its powers are square roots and the
// steps are the same on every machine. Its steps do not swing after a kink, nor where stability limits them.
// Sources: Soederlind 2003 (ACM Trans. Math. Softw. 29, 1); Soederlind and Wang 2006 (J. Comput. Appl. Math. 185, 225).
#pragma once

#include "methods/method.h"

namespace furrow {

class ControlledMethod : public Method {
 public:
  double step(const OdeSystem& system, double t, State& y, double h) final;
  void restart() override {
    steps_ = 0;
    proposal_ = tolerances_.first_step;
  }

 protected:
  ControlledMethod(MethodInfo info, const Tolerances& tolerances)
      : Method(std::move(info)), tolerances_(tolerances), proposal_(tolerances.first_step) {}

  void remember(HistoryVisitor& visit) override {
    visit("proposal", proposal_);
    visit("last h", h_before_);
    visit("last error", e_before_);
    visit("steps", steps_);
  }

  // Before the first try from (t, y).
  virtual void prepare(const OdeSystem& system, double t, const State& y) = 0;
  // Fills next_ and error_ by a step of h, and now_, if prepare did not.
  virtual void attempt(const OdeSystem& system, double t, const State& y, double h) = 0;
  // The attempt was accepted: next_ is now the state.
  virtual void accept(double h) = 0;

  State now_;    // f at (t, y)
  State next_;   // y at t + h
  State error_;  // estimated error of next_; only the controlled numbers count

 private:
  double scaled_error(const OdeSystem& system, const State& y, double h) const;
  void choose(double h, double error, bool cut);

  Tolerances tolerances_;
  double proposal_;                     // s
  double h_before_ = 0, e_before_ = 0;  // of the last accepted step
  int steps_ = 0;                       // accepted since the start or a restart
};

}  // namespace furrow
