// The classical Runge-Kutta method. Order 4, four evaluations a step; stable to -2.785 on the real axis and 2.828 on
// the imaginary one. Source: Kutta 1901.
//
//   k1 = f(t, y)
//   k2 = f(t + h/2, y + h/2 k1)
//   k3 = f(t + h/2, y + h/2 k2)
//   k4 = f(t + h, y + h k3)
//   y_(n+1) = y_n + h/6 (k1 + 2 k2 + 2 k3 + k4)
#include "methods/method.h"

namespace furrow {
namespace {

class RungeKutta4 final : public Method {
 public:
  RungeKutta4() : Method({"rk4", "classical Runge-Kutta", 4, 4, false}) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    for (State* room : {&k1_, &k2_, &k3_, &k4_, &stage_}) room->resize(y.size());
    evaluate_start(system, t, y, k1_);
    move(y, 0.5 * h, k1_);
    evaluate(system, t + 0.5 * h, stage_, k2_);
    move(y, 0.5 * h, k2_);
    evaluate(system, t + 0.5 * h, stage_, k3_);
    move(y, h, k3_);
    evaluate(system, t + h, stage_, k4_);
    const double sixth = h / 6;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += sixth * (k1_[i] + 2 * (k2_[i] + k3_[i]) + k4_[i]);
    return h;
  }

 private:
  void move(const State& y, double h, const State& k) {
    for (std::size_t i = 0; i < y.size(); ++i) stage_[i] = y[i] + h * k[i];
  }

  State k1_, k2_, k3_, k4_, stage_;
};

std::unique_ptr<Method> make_runge_kutta_4(const Tolerances& /*tolerances*/) { return std::make_unique<RungeKutta4>(); }

}  // namespace

FURROW_METHODS(runge_kutta_4) { add_method(catalogue, make_runge_kutta_4); }

}  // namespace furrow
