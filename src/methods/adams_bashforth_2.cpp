// Two-step Adams-Bashforth, the predictor of the paper's method alone.
//
//   y_(n+1) = y_n + h ((1 + r/2) f_n - r/2 f_(n-1)),  r = h / h_before
//
// The first step, and the first after a restart, takes f_(n-1) = f_n: Euler's, whose error of h^2 once keeps order 2.
// Order 2 at any step ratio; one evaluation a step. Stable on the real axis for -1 < h lambda < 0, nowhere on the
// imaginary one: an undamped oscillation grows by 1 + (h omega)^4 / 4 a step. Source: Bashforth and Adams 1883.
#include "methods/method.h"

namespace furrow {
namespace {

class AdamsBashforth2 final : public Method {
 public:
  AdamsBashforth2() : Method({"ab2", "two-step Adams-Bashforth", 2, 1, false}) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    now_.resize(y.size());
    evaluate_start(system, t, y, now_);
    if (h_before_ == 0) {
      before_ = now_;
      h_before_ = h;
    }
    const double r = h / h_before_;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * ((1 + 0.5 * r) * now_[i] - 0.5 * r * before_[i]);
    std::swap(now_, before_);
    h_before_ = h;
    return h;
  }

  void restart() override { h_before_ = 0; }

 private:
  void remember(HistoryVisitor& visit) override {
    visit("h before", h_before_);
    visit("rates before", before_);
  }

  State now_, before_;
  double h_before_ = 0;  // s; 0: no history
};

std::unique_ptr<Method> make_adams_bashforth_2(const Tolerances& /*tolerances*/) {
  return std::make_unique<AdamsBashforth2>();
}

}  // namespace

FURROW_METHODS(adams_bashforth_2) { add_method(catalogue, make_adams_bashforth_2); }

}  // namespace furrow
