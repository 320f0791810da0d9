// The paper's pair with error control: PECE with steps of any length, whose error Milne's device gives for nothing.
//
//   y*, y_(n+1)  as in pece.cpp, r = h / h_before
//   y*           misses by h^3 (1/6 + 1/(4 r)) y'''
//   y_(n+1)      misses by -h^3/12 y''', so
//   e            = r / (3 (1 + r)) (y_(n+1) - y*)
//
// Without history y* is Euler's and y_(n+1) Heun's, and e = (y_(n+1) - y*)/2, which is h times too large: the first
// step is short. Order 2, two evaluations a step, one for each rejected try. Sources: Milne 1926; Hairer, Norsett and
// Wanner, Solving ODEs I, III.5.
#include "methods/controlled.h"

namespace furrow {
namespace {

class PeceAdaptive final : public ControlledMethod {
 public:
  explicit PeceAdaptive(const Tolerances& tolerances)
      : ControlledMethod({"pece_adaptive", "AB2 predictor, AM2 corrector, PECE, controlled", 2, 2, true}, tolerances) {}

  void restart() override {
    ControlledMethod::restart();
    h_before_ = 0;
  }

 protected:
  void prepare(const OdeSystem& system, double t, const State& y) override { evaluate_start(system, t, y, now_); }

  void attempt(const OdeSystem& system, double t, const State& y, double h) override {
    const bool started = h_before_ > 0;
    const double r = started ? h / h_before_ : 0;
    const State& before = started ? before_ : now_;
    for (State* room : {&predicted_, &ahead_}) room->resize(y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
      predicted_[i] = y[i] + h * ((1 + 0.5 * r) * now_[i] - 0.5 * r * before[i]);
    evaluate(system, t + h, predicted_, ahead_);
    const double milne = started ? r / (3 * (1 + r)) : 0.5;
    for (std::size_t i = 0; i < y.size(); ++i) {
      next_[i] = y[i] + 0.5 * h * (ahead_[i] + now_[i]);
      error_[i] = milne * (next_[i] - predicted_[i]);
    }
  }

  void accept(double h) override {
    before_ = now_;
    h_before_ = h;
  }

 private:
  void remember(HistoryVisitor& visit) override {
    ControlledMethod::remember(visit);
    visit("h before", h_before_);
    visit("rates before", before_);
  }

  State before_, predicted_, ahead_;
  double h_before_ = 0;  // s; 0: no history
};

std::unique_ptr<Method> make_pece_adaptive(const Tolerances& tolerances) {
  return std::make_unique<PeceAdaptive>(tolerances);
}

}  // namespace

FURROW_METHODS(pece_adaptive) { add_method(catalogue, make_pece_adaptive); }

}  // namespace furrow
