// A method as a program of the user's brings it along.
#pragma once

#include "methods/method.h"

namespace furrow::test {

// y + h f at the middle, by Euler's half step: the midpoint rule.
class Midpoint final : public Method {
 public:
  Midpoint() : Method({"midpoint_from_outside", "explicit midpoint rule", 2, 2, false}) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    rate_.resize(y.size());
    evaluate_start(system, t, y, rate_);
    State middle = y;
    for (std::size_t i = 0; i < y.size(); ++i) middle[i] += h / 2 * rate_[i];
    evaluate(system, t + h / 2, middle, rate_);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * rate_[i];
    return h;
  }

 private:
  State rate_;
};

inline MethodEntry midpoint_entry() {
  const auto make = [](const Tolerances&) -> std::unique_ptr<Method> { return std::make_unique<Midpoint>(); };
  return {make({})->info(), make};
}

// One for all tests: a name is taken once.
inline void register_midpoint() { [[maybe_unused]] static const bool once = (register_method(midpoint_entry()), true); }

}  // namespace furrow::test
