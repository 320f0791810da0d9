// Velocity Verlet for forces that depend on velocity.
//
//   q_(n+1) = q_n + h v_n + h^2/2 a_n
//   v*      = v_n + h a_n
//   z*      = z_n + h z'_n
//   a_(n+1) = a(t_(n+1), q_(n+1), v*, z*)
//   v_(n+1) = v_n + h/2 (a_n + a_(n+1)),  z likewise
//
// The usual form takes a(q_(n+1), v_n), whose velocity is a step old: it drops to first order with any damping. With
// the predicted v* it is of order 2 again, still with one evaluation a step: a_(n+1) differs from a(q_(n+1), v_(n+1))
// by O(h^2). Without damping it is the symplectic method, stable to h omega = 2; damping lowers the limit (0.47 at
// critical damping), so that it suits elastic scenes, not the paper's. Source: Swope et al. 1982; the prediction is the
// usual cure.
#include <algorithm>

#include "methods/method.h"

namespace furrow {
namespace {

class Verlet final : public Method {
 public:
  Verlet() : Method({"verlet", "velocity Verlet with predicted velocities", 2, 1, false}) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    const std::size_t n = y.size();
    const std::size_t q = system.positions();
    for (State* room : {&now_, &next_, &predicted_}) room->resize(n);
    if (!started_) evaluate_start(system, t, y, now_);
    started_ = true;
    const double half = 0.5 * h;
    for (std::size_t i = 0; i < q; ++i) predicted_[i] = y[i] + h * (y[q + i] + half * now_[q + i]);
    for (std::size_t i = q; i < n; ++i) predicted_[i] = y[i] + h * now_[i];
    evaluate(system, t + h, predicted_, next_);
    std::copy(predicted_.begin(), predicted_.begin() + static_cast<std::ptrdiff_t>(q), y.begin());
    for (std::size_t i = q; i < n; ++i) y[i] += half * (now_[i] + next_[i]);
    std::swap(now_, next_);
    return h;
  }

  // A returned spring leaves the force as it is, but not the rates of the energy ledger: evaluated again, they keep
  // order 2.
  void restart() override { started_ = false; }
  void state_changed() override { started_ = false; }

 private:
  void remember(HistoryVisitor& visit) override {
    visit("started", started_);
    visit("rates", now_);
  }

  State now_, next_, predicted_;
  bool started_ = false;
};

std::unique_ptr<Method> make_verlet(const Tolerances& /*tolerances*/) { return std::make_unique<Verlet>(); }

}  // namespace

FURROW_METHODS(verlet) { add_method(catalogue, make_verlet); }

}  // namespace furrow
