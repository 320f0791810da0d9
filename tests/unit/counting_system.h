// How often all contacts are evaluated: by a method, and by a jump, which then leaves the rates of its state.
#pragma once

#include <string>

#include "run/events.h"
#include "scenes.h"

namespace furrow::test {

class CountingSystem : public System {
 public:
  using System::System;
  void rhs(double t, const State& y, State& dydt) const override {
    ++evaluations_;
    System::rhs(t, y, dydt);
  }
  void jump_as_in_a_run(Method& method, double t, State& y) {
    evaluations_ += furrow::jump(*this, method, t, y).rates ? 1 : 0;
  }
  long evaluations() const { return evaluations_; }

 private:
  mutable long evaluations_ = 0;
};

// A step of a run of many contacts; the first steps, of which some methods make more, are not counted.
inline double evaluations_a_step(const std::string& name) {
  CountingSystem system(busy_scene());
  const auto method = make_method(name);
  State y = system.initial_state();
  constexpr double h = 1e-5;
  constexpr int first = 10, steps = 40;
  long before = 0;
  for (int k = 0; k < first + steps; ++k) {
    if (k == first) before = system.evaluations();
    system.jump_as_in_a_run(*method, k * h, y);
    method->step(system, k * h, y, h);
  }
  return static_cast<double>(system.evaluations() - before) / steps;
}

}  // namespace furrow::test
