// The kernel and the reference side by side, step by step.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "run/run.h"

namespace furrow::test {

// What is not a number, of discs on one spot, is no number of either.
inline bool same_bits(double one, double other) {
  if (std::isnan(one) || std::isnan(other)) return std::isnan(one) && std::isnan(other);
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

// "vy of disc 3", "spring of slot 7", "ledger: link damping".
inline std::string name_of_number(const System& system, int place) {
  const Layout& at = system.layout();
  const int bodies = at.bodies;
  const char* names[] = {"x", "y", "vx", "vy"};
  if (place < 4 * bodies) return std::string(names[place / bodies]) + " of " + system.parts().body_name(place % bodies);
  if (place < at.first_spring) return "spin of " + system.parts().body_name(place - 4 * bodies);
  if (place < at.first_dummy()) return "spring of slot " + std::to_string(place - at.first_spring);
  if (place < at.ledger_of(0)) return "dummy slot " + std::to_string(place - at.first_dummy());
  return "entry " + std::to_string(place - at.ledger_of(0)) + " of the ledger";
}

// How much room there is for springs may differ, what they hold not. Empty if there is no difference.
inline std::string difference(const System& kernel, const State& y, const System& reference, const State& z) {
  const Layout &in_y = kernel.layout(), &in_z = reference.layout();
  std::ostringstream text;
  text.precision(17);
  const auto look = [&](int k, int r) {
    const double one = k < 0 ? 0 : y[k], other = r < 0 ? 0 : z[r];
    if (!text.str().empty() || same_bits(one, other)) return;
    text << (k < 0 ? name_of_number(reference, r) : name_of_number(kernel, k)) << ": kernel " << one << ", reference "
         << other;
  };
  if (y.size() != kernel.size() || z.size() != reference.size()) return "the size of a state";
  for (int k = 0; k < in_y.first_spring; ++k) look(k, k);
  for (int slot = 0; slot < std::max(in_y.spring_count, in_z.spring_count); ++slot) {
    look(slot < in_y.spring_count ? in_y.spring_of(slot) : -1, slot < in_z.spring_count ? in_z.spring_of(slot) : -1);
  }
  for (int k = 0; k < in_y.dummy_slots; ++k) look(in_y.first_dummy() + k, in_z.first_dummy() + k);
  for (int k = 0; in_y.keeps_ledger && k < ledger_entries; ++k) look(in_y.ledger_of(k), in_z.ledger_of(k));
  return text.str();
}

inline std::string difference(const DiscreteState& kernel, const DiscreteState& reference) {
  if (kernel.torn != reference.torn) return "which links are torn";
  if (kernel.jumps != reference.jumps) return "the number of jumps";
  if (kernel.held.size() != reference.held.size())
    return "how many contacts hold a slot: kernel " + std::to_string(kernel.held.size()) + ", reference " +
           std::to_string(reference.held.size());
  for (std::size_t k = 0; k < kernel.held.size(); ++k) {
    const auto &one = kernel.held[k], &other = reference.held[k];
    if (one.kind == other.kind && one.a == other.a && one.b == other.b && one.slot == other.slot &&
        one.near_at == other.near_at)
      continue;
    std::ostringstream text;
    text << "who holds a slot: kernel " << contact_kind_names[one.kind] << ' ' << one.a << ' ' << one.b << " slot "
         << one.slot << ", reference " << contact_kind_names[other.kind] << ' ' << other.a << ' ' << other.b << " slot "
         << other.slot;
    return text.str();
  }
  return {};
}

inline std::string difference(const Contact& one, const Contact& other) {
  const auto numbers = [](const Contact& c) {
    return std::vector<double>{c.share,
                               c.nx,
                               c.ny,
                               c.arm_a,
                               c.arm_b,
                               c.vx,
                               c.vy,
                               c.spin_a,
                               c.spin_b,
                               c.touch.overlap,
                               c.touch.approach,
                               c.touch.slip,
                               c.touch.spring,
                               c.touch.spin,
                               c.touch.reduced_radius,
                               c.touch.reduced_mass,
                               c.force.elastic,
                               c.force.normal,
                               c.force.tangential,
                               c.force.moment,
                               c.force.stiffness,
                               c.force.shear_stiffness,
                               c.force.shear_viscosity,
                               c.fx,
                               c.fy,
                               c.torque_a,
                               c.torque_b};
  };
  const std::vector<double> a = numbers(one), b = numbers(other);
  std::ostringstream text;
  text.precision(17);
  if (one.id.kind != other.id.kind || one.id.a != other.id.a || one.id.b != other.id.b || one.law != other.law ||
      one.slot != other.slot || one.segment != other.segment)
    text << "another contact, law, slot or segment";
  for (std::size_t k = 0; k < a.size() && text.str().empty(); ++k) {
    if (a[k] != b[k] && !same_bits(a[k], b[k]))
      text << "number " << k << " of it: kernel " << a[k] << ", reference " << b[k];
  }
  return text.str();
}

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
