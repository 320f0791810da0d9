// The paper's method: predictor AB2, corrector AM2 (the trapezoid rule), evaluated PECE.
//
//   y* = y_n + h ((1 + r/2) f_n - r/2 f_(n-1)),  r = h / h_before      y_(n+1) = y_n + h/2 (f(t_(n+1), y*) + f_n)
//
// r = 1 gives the usual 3/2 and 1/2. The first step, and the first after a restart, takes f_(n-1) = f_n (Heun).
// Order 2; two evaluations a step: f_n is evaluated anew from the accepted state, which a jump may have changed.
// Stable on the real axis for -2 < h lambda < 0, on the imaginary axis up to |h lambda| = 1.287.
// Sources: Bashforth and Adams 1883; Moulton 1926; the combination after Graeff et al. 2004, as the paper cites it.
#include "methods/method.h"

namespace furrow {
namespace {

class Pece final : public Method {
 public:
  Pece() : Method({"pece", "AB2 predictor, AM2 corrector, PECE: the paper's method", 2, 2, false}) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    const std::size_t n = y.size();
    for (State* room : {&now_, &before_, &predicted_, &next_}) room->resize(n);
    evaluate(system, t, y, now_);
    if (h_before_ == 0) {
      before_ = now_;
      h_before_ = h;
    }
    const double r = h / h_before_;
    const double on_now = h * (1 + 0.5 * r);
    const double on_before = h * (0.5 * r);
    for (std::size_t i = 0; i < n; ++i) predicted_[i] = y[i] + (on_now * now_[i] - on_before * before_[i]);
    evaluate(system, t + h, predicted_, next_);
    const double half = 0.5 * h;
    for (std::size_t i = 0; i < n; ++i) y[i] += half * (next_[i] + now_[i]);
    std::swap(now_, before_);
    h_before_ = h;
    return h;
  }

  void restart() override { h_before_ = 0; }

 private:
  State now_, before_, predicted_, next_;
  double h_before_ = 0;  // s; 0: no history
};

}  // namespace

std::unique_ptr<Method> make_pece(const Tolerances& /*tolerances*/) { return std::make_unique<Pece>(); }

}  // namespace furrow
