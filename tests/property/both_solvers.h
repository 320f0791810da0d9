// The kernel and the reference side by side, step by step.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "differences.h"
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

  // Empty, or the first difference: after which step, of which body, which number. A run that blows up ends without
  // one, if both do.
  std::string run(const std::string& method, double step, long steps, double start = 0) {
    const auto one = make_method(method), other = make_method(method);
    double t = start;
    if (!starts_well(start)) return {};
    std::string found = jump_and_compare(*one, *other, t);
    for (long n = 1; n <= steps && found.empty(); ++n) {
      one->step(kernel_, t, y_, step);
      other->step(reference_, t, z_, step);
      t = start + static_cast<double>(n) * step;
      if (!finite()) return {};
      found = jump_and_compare(*one, *other, t);
      if (!found.empty()) found = "after step " + std::to_string(n) + ": " + found;
    }
    return found;
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

  bool finite() const {
    for (const double number : y_) {
      if (!std::isfinite(number)) return false;
    }
    return true;
  }

  std::string jump_and_compare(Method& one, Method& other, double t) {
    const JumpReport left = furrow::jump(kernel_, one, t, y_);
    const JumpReport right = furrow::jump(reference_, other, t, z_);
    if (left.torn.size() != right.torn.size()) return "how many links tore";
    if (left.springs_changed != right.springs_changed) return "whether springs were returned";
    if (std::string found = difference(kernel_, y_, reference_, z_); !found.empty()) return found;
    if (std::string found = difference(kernel_.discrete_state(), reference_.discrete_state()); !found.empty())
      return found;
    if (std::string found = compare_rates(t); !found.empty()) return found;
    return compare_contacts(t);
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
    if (one.size() != other.size()) return "how many contacts touch";
    for (std::size_t k = 0; k < one.size(); ++k) {
      const std::string found = difference(one[k], other[k]);
      if (!found.empty()) return "the contact of " + contact_name(kernel_.parts(), one[k].id) + ": " + found;
    }
    return {};
  }

  System kernel_, reference_;
  State y_, z_;
  long contacts_ = 0;
};

}  // namespace furrow::test
