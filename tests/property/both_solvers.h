// The kernel and the reference side by side, step by step.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "differences.h"
#include "reference/reference.h"
#include "run/observe.h"
#include "run/run.h"

namespace furrow::test {

class BothSolvers {
 public:
  explicit BothSolvers(const Scene& scene)
      : kernel_(with(scene, SolverKind::kernel)), reference_(with(scene, SolverKind::reference)) {
    y_ = kernel_.initial_state();
    z_ = reference_.initial_state();
  }

  // From another run's state, which both take over.
  void start_from(const State& y, const DiscreteState& discrete) {
    for (System* system : {&kernel_, &reference_}) system->restore(discrete);
    y_ = z_ = y;
  }

  // From now on plates stand still and links do not tear, or no more.
  void prepare(bool preparing) {
    for (System* system : {&kernel_, &reference_}) system->prepare(preparing);
  }

  // Empty, or the first difference: after which step, of which body, which number. A run that blows up ends without
  // one, if both do.
  std::string run(const std::string& method, double step, long steps, double start = 0) {
    const auto one = make_method(method), other = make_method(method);
    double t = start;
    if (!starts_well(start)) return {};
    std::string found = jump_and_compare(*one, *other, t);
    if (!found.empty()) return "at the start: " + found;
    for (long n = 1; n <= steps; ++n) {
      const std::optional<double> left = taken(*one, kernel_, t, y_, step);
      const std::optional<double> right = taken(*other, reference_, t, z_, step);
      const std::string after = "after step " + std::to_string(n) + " of " + method + ": ";
      if (left.has_value() != right.has_value() && finite(y_) && finite(z_))
        return after + differing("whether it diverges", {}, !left, !right);
      if (!left || !right || !finite(y_)) return {};
      if (!same_bits(*left, *right)) return after + differing("how long it is", {}, *left, *right);
      t = one->info().controlled ? t + *left : start + static_cast<double>(n) * step;
      found = jump_and_compare(*one, *other, t);
      if (!found.empty()) return after + found;
    }
    return {};
  }

  long contacts() const { return contacts_; }
  const System& kernel() const { return kernel_; }

 private:
  static Scene with(Scene scene, SolverKind solver) {
    scene.time.solver = solver;
    return scene;
  }

  // Parts on one spot have no direction to part in; a scene file with such a start is refused.
  bool starts_well(double t) const {
    State rates(y_.size());
    kernel_.rhs(t, y_, rates);
    return std::all_of(rates.begin(), rates.end(), [](double rate) { return std::isfinite(rate); });
  }

  static bool finite(const State& y) {
    return std::all_of(y.begin(), y.end(), [](double number) { return std::isfinite(number); });
  }

  // s: how far the step went; nothing if it failed.
  static std::optional<double> taken(Method& method, const System& system, double t, State& y, double step) {
    try {
      return method.step(system, t, y, step);
    } catch (const Divergence&) {
      return {};
    }
  }

  std::string jump_and_compare(Method& one, Method& other, double t) {
    const JumpReport left = furrow::jump(kernel_, one, t, y_);
    const JumpReport right = furrow::jump(reference_, other, t, z_);
    if (std::string found = difference(kernel_.parts(), left.torn, right.torn); !found.empty()) return found;
    if (left.springs_changed != right.springs_changed)
      return differing("whether springs were returned", {}, left.springs_changed, right.springs_changed);
    if (std::string found = difference(kernel_, y_, reference_, z_); !found.empty()) return found;
    if (std::string found = difference(kernel_.discrete_state(), reference_.discrete_state()); !found.empty())
      return found;
    if (std::string found = compare_rates(t); !found.empty()) return found;
    if (std::string found = compare_contacts(t); !found.empty()) return found;
    return compare_forces_on_flats(t);
  }

  std::string compare_rates(double t) {
    State one(y_.size()), other(z_.size());
    kernel_.rhs(t, y_, one);
    reference_.rhs(t, z_, other);
    const std::string found = difference(kernel_, one, reference_, other);
    return found.empty() ? found : "rate of " + found;
  }

  std::string compare_contacts(double t) {
    std::vector<Contact> one, other;
    kernel_.for_each_contact(t, y_, [&](const Contact& c) { one.push_back(c); });
    reference_.for_each_contact(t, z_, [&](const Contact& c) { other.push_back(c); });
    contacts_ += static_cast<long>(one.size());
    for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) {
      if (std::string found = difference(kernel_.parts(), one[k], other[k]); !found.empty()) return found;
    }
    if (one.size() == other.size()) return {};
    return differing("how many contacts touch", {}, one.size(), other.size());
  }

  // What a run writes of plates and walls, by the kernel, against their sums in the reference.
  std::string compare_forces_on_flats(double t) {
    const DiscreteState discrete = reference_.discrete_state();
    const auto [plate, wall] = reference::forces_on_flats({reference_.parts(), reference_.layout(), discrete, t, z_});
    const Observation seen = observe(kernel_, t, y_);
    const std::string found = difference_of_forces("plate", seen.plate, plate);
    return found.empty() ? difference_of_forces("wall", seen.wall, wall) : found;
  }

  static std::string difference_of_forces(const char* what, const std::vector<Force>& one,
                                          const std::vector<Vec2>& other) {
    for (std::size_t k = 0; k < std::max(one.size(), other.size()); ++k) {
      const std::string name = "the force on " + std::string(what) + ' ' + std::to_string(k);
      if (!same_bits(one.at(k).x, other.at(k).x)) return differing(name + ", x", {}, one[k].x, other[k].x);
      if (!same_bits(one[k].y, other[k].y)) return differing(name + ", y", {}, one[k].y, other[k].y);
    }
    return {};
  }

  System kernel_, reference_;
  State y_, z_;
  long contacts_ = 0;
};

}  // namespace furrow::test
