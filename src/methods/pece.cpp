// Predictor AB2, corrector AM2 (the trapezoid rule): the paper's method and its two neighbours.
//
//   P  y*      = y_n + h ((1 + r/2) f_n - r/2 f_(n-1)),  r = h / h_before
//   C  y_(n+1) = y_n + h/2 (f(t_(n+1), y*) + f_n)
//
//   form        evaluated as                      evaluations   real axis   imaginary axis
//   pec         f_n = f(t_n, y*), never corrected      1          0.5         0.667
//   pece        f_n = f(t_n, y_n): the paper's         2          2           1.287
//   pecece      C once more with y_(n+1) for y*        3          1.478       1.691
//
// r = 1 gives the usual 3/2 and 1/2. The first step, and the first after a restart, takes f_(n-1) = f_n (Heun). Order 2
// at any step ratio. pece and pecece evaluate f_n again from the accepted state, which a jump may have changed; pec
// keeps the rate of its prediction: of a sliding contact force and slip are the same, so only the rates of the energy
// ledger are a step late there; of a spring that was shortened while its damper held the contact, the force is too.
// Stable for h lambda from minus the limit to 0 on the real axis, up to |h lambda| on the imaginary one. Sources:
// Bashforth and Adams 1883; Moulton 1926; the combination after Graeff et al. 2004, as the paper cites it; the forms:
// Hairer, Norsett and Wanner, Solving ODEs I, III.1 and III.8.
#include "kernel/passes.h"
#include "methods/method.h"

namespace furrow {
namespace {

enum class Form { pec, pece, pecece };

class Pece final : public Method {
 public:
  Pece(MethodInfo info, Form form) : Method(std::move(info)), form_(form) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    const std::size_t n = y.size();
    for (State* room : {&now_, &before_, &predicted_, &next_}) room->resize(n);
    if (form_ != Form::pec || h_before_ == 0) evaluate_start(system, t, y, now_);
    if (h_before_ == 0) {
      before_ = now_;
      h_before_ = h;
    }
    const double r = h / h_before_;
    const double on_now = h * (1 + 0.5 * r);
    const double on_before = h * (0.5 * r);
    const int threads = system.threads();
    extrapolate(threads, y, on_now, now_, on_before, before_, predicted_);
    const double half = 0.5 * h;
    for (int corrections = form_ == Form::pecece ? 2 : 1; corrections > 0; --corrections) {
      evaluate(system, t + h, predicted_, next_);
      add_mean(threads, y, half, next_, now_, predicted_);
    }
    y.swap(predicted_);
    std::swap(now_, before_);
    if (form_ == Form::pec) now_.swap(next_);
    h_before_ = h;
    return h;
  }

  void restart() override { h_before_ = 0; }
  const State* start() const override { return &predicted_; }

 private:
  void remember(HistoryVisitor& visit) override {
    visit("h before", h_before_);
    visit("rates before", before_);
    if (form_ == Form::pec) visit("rates", now_);
  }

  Form form_;
  State now_, before_, predicted_, next_;
  double h_before_ = 0;  // s; 0: no history
};

std::unique_ptr<Method> make_pece(const Tolerances& /*tolerances*/) {
  return std::make_unique<Pece>(
      MethodInfo{"pece", "AB2 predictor, AM2 corrector, PECE: the paper's method", 2, 2, false}, Form::pece);
}

std::unique_ptr<Method> make_pec(const Tolerances& /*tolerances*/) {
  return std::make_unique<Pece>(MethodInfo{"pec", "AB2 predictor, AM2 corrector, PEC", 2, 1, false}, Form::pec);
}

std::unique_ptr<Method> make_pecece(const Tolerances& /*tolerances*/) {
  return std::make_unique<Pece>(MethodInfo{"pecece", "AB2 predictor, AM2 corrector, P(EC)^2E", 2, 3, false},
                                Form::pecece);
}

}  // namespace

FURROW_METHODS(pece) {
  add_method(catalogue, make_pece);
  add_method(catalogue, make_pec);
  add_method(catalogue, make_pecece);
}

}  // namespace furrow
