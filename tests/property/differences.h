// The first number in which two states of one scene differ, and whose it is.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "run/system.h"

namespace furrow::test {

// What the two sides are called.
struct Sides {
  std::string one = "kernel", other = "reference";
};

// What is not a number, of discs on one spot, is no number of either.
inline bool same_bits(double one, double other) {
  if (std::isnan(one) || std::isnan(other)) return std::isnan(one) && std::isnan(other);
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

template <class Value>
std::string differing(const std::string& what, const Sides& sides, const Value& one, const Value& other) {
  std::ostringstream text;
  text.precision(17);
  text << what << ": " << sides.one << ' ' << one << ", " << sides.other << ' ' << other;
  return text.str();
}

// "spring of slot 7, of disc 3 and wall 0"
inline std::string name_of_spring(const System& system, int slot) {
  const std::string name = "spring of slot " + std::to_string(slot);
  for (const DiscreteState::Held& held : system.discrete_state().held) {
    const ContactId contact{static_cast<ContactKind>(held.kind), held.a, held.b};
    if (held.slot == slot) return name + ", of " + contact_name(system.parts(), contact);
  }
  return name;
}

// "vy of disc 3", "entry 2 of the ledger"
inline std::string name_of_number(const System& system, int place) {
  const Layout& at = system.layout();
  const int bodies = at.bodies;
  const char* names[] = {"x", "y", "vx", "vy"};
  if (place < 4 * bodies) return std::string(names[place / bodies]) + " of " + system.parts().body_name(place % bodies);
  if (place < at.first_spring) return "spin of " + system.parts().body_name(place - 4 * bodies);
  if (place < at.first_dummy()) return name_of_spring(system, (place - at.first_spring) / at.slot_width);
  if (place < at.ledger_of(0)) return "dummy slot " + std::to_string(place - at.first_dummy());
  if (at.angles > 0 && place >= at.angle_of(0)) return "angle of " + system.parts().body_name(place - at.angle_of(0));
  return "entry " + std::to_string(place - at.ledger_of(0)) + " of the ledger";
}

// How much room there is for springs may differ, what they hold not. Empty if there is no difference.
inline std::string difference(const System& one, const State& y, const System& other, const State& z,
                              const Sides& sides = {}) {
  const Layout &in_y = one.layout(), &in_z = other.layout();
  std::string found;
  const auto look = [&](int k, int r) {
    const double left = k < 0 ? 0 : y[k], right = r < 0 ? 0 : z[r];
    if (!found.empty() || same_bits(left, right)) return;
    found = differing(k < 0 ? name_of_number(other, r) : name_of_number(one, k), sides, left, right);
  };
  if (y.size() != one.size() || z.size() != other.size()) return "the size of a state";
  for (int k = 0; k < in_y.first_spring; ++k) look(k, k);
  for (int slot = 0; slot < std::max(in_y.spring_count, in_z.spring_count); ++slot) {
    for (int k = 0; k < in_y.slot_width; ++k)
      look(slot < in_y.spring_count ? in_y.spring_of(slot) + k : -1,
           slot < in_z.spring_count ? in_z.spring_of(slot) + k : -1);
  }
  for (int k = 0; k < in_y.dummy_slots; ++k) look(in_y.first_dummy() + k, in_z.first_dummy() + k);
  for (int k = 0; in_y.keeps_ledger && k < ledger_entries; ++k) look(in_y.ledger_of(k), in_z.ledger_of(k));
  for (int i = 0; i < in_y.angles; ++i) look(in_y.angle_of(i), in_z.angle_of(i));
  return found;
}

// Slots that both have, the next one last. How many more one of them made at a time may differ.
inline std::string unused_of_both(const DiscreteState& one, const DiscreteState& other) {
  std::string text;
  for (const int slot : one.unused)
    if (slot < std::min(one.spring_count(), other.spring_count())) text += ' ' + std::to_string(slot);
  return text;
}

inline std::string difference(const DiscreteState& one, const DiscreteState& other, const Sides& sides = {}) {
  const auto as_text = [](const DiscreteState::Held& held) {
    return std::string(contact_kind_names[held.kind]) + ' ' + std::to_string(held.a) + ' ' + std::to_string(held.b) +
           " slot " + std::to_string(held.slot) + " near at jump " + std::to_string(held.near_at);
  };
  for (std::size_t k = 0; k < std::max(one.torn.size(), other.torn.size()); ++k) {
    const auto link = [k](const std::vector<int>& torn) { return k < torn.size() ? torn[k] : -1; };
    if (link(one.torn) != link(other.torn))
      return differing("the next torn link", sides, link(one.torn), link(other.torn));
  }
  if (one.preparing != other.preparing)
    return differing("whether the scene is prepared", sides, one.preparing, other.preparing);
  if (one.jumps != other.jumps) return differing("the number of jumps", sides, one.jumps, other.jumps);
  for (std::size_t k = 0; k < std::min(one.held.size(), other.held.size()); ++k) {
    const std::string left = as_text(one.held[k]), right = as_text(other.held[k]);
    if (left != right) return differing("who holds a slot", sides, left, right);
  }
  const auto faces_as_text = [](const HeldFaces& faces) {
    std::string text;
    for (const HeldFace& f : faces)
      text += std::string(contact_kind_names[f.kind]) + ' ' + std::to_string(f.a) + ' ' + std::to_string(f.b) +
              " face " + std::to_string(f.face) + "; ";
    return text;
  };
  if (faces_as_text(one.faces) != faces_as_text(other.faces))
    return differing("which faces are kept", sides, faces_as_text(one.faces), faces_as_text(other.faces));
  if (one.border != other.border) return "which segments discs touch";
  if (one.held.size() != other.held.size())
    return differing("how many contacts hold a slot", sides, one.held.size(), other.held.size());
  if (unused_of_both(one, other) != unused_of_both(other, one))
    return differing("which slots are unused", sides, unused_of_both(one, other), unused_of_both(other, one));
  return {};
}

struct NamedNumber {
  const char* name;
  double value;
};

inline std::vector<NamedNumber> numbers_of(const Contact& c) {
  return {{"segment", static_cast<double>(c.segment)},
          {"share", c.share},
          {"nx", c.nx},
          {"ny", c.ny},
          {"arm of a", c.arm_a},
          {"arm of b", c.arm_b},
          {"vx", c.vx},
          {"vy", c.vy},
          {"spin of a", c.spin_a},
          {"spin of b", c.spin_b},
          {"law", static_cast<double>(c.law)},
          {"slot", static_cast<double>(c.slot)},
          {"overlap", c.touch.overlap},
          {"approach", c.touch.approach},
          {"slip", c.touch.slip},
          {"spring", c.touch.spring},
          {"relative spin", c.touch.spin},
          {"R*", c.touch.reduced_radius},
          {"m*", c.touch.reduced_mass},
          {"turn", c.touch.turn},
          {"rolling inertia", c.touch.rolling_inertia},
          {"elastic force", c.force.elastic},
          {"normal force", c.force.normal},
          {"tangential force", c.force.tangential},
          {"rolling moment", c.force.moment},
          {"stiffness", c.force.stiffness},
          {"shear stiffness", c.force.shear_stiffness},
          {"shear viscosity", c.force.shear_viscosity},
          {"fx", c.fx},
          {"fy", c.fy},
          {"torque of a", c.torque_a},
          {"torque of b", c.torque_b}};
}

// "spring of the disc-wall contact of disc 3 and wall 0". A zero has no sign here.
inline std::string difference(const Parts& parts, const Contact& one, const Contact& other, const Sides& sides = {}) {
  const auto name = [&](const ContactId& id) {
    return "the " + std::string(contact_kind_names[id.kind]) + " contact of " + contact_name(parts, id);
  };
  if (one.id.kind != other.id.kind || one.id.a != other.id.a || one.id.b != other.id.b)
    return differing("the next contact", sides, name(one.id), name(other.id));
  const std::vector<NamedNumber> left = numbers_of(one), right = numbers_of(other);
  for (std::size_t k = 0; k < left.size(); ++k) {
    if (left[k].value != right[k].value && !same_bits(left[k].value, right[k].value))
      return differing(left[k].name + (" of " + name(one.id)), sides, left[k].value, right[k].value);
  }
  return {};
}

// Of two reports of one jump: which links tore, when and under which force.
inline std::string difference(const Parts& parts, const std::vector<Tear>& one, const std::vector<Tear>& other,
                              const Sides& sides = {}) {
  for (std::size_t k = 0; k < std::max(one.size(), other.size()); ++k) {
    const auto link = [&](const std::vector<Tear>& tears) {
      return k < tears.size() ? parts.link_name(tears[k].link) : std::string("none");
    };
    if (link(one) != link(other)) return differing("the next link that tears", sides, link(one), link(other));
    if (!same_bits(one[k].time, other[k].time))
      return differing("when " + link(one) + " tears", sides, one[k].time, other[k].time);
    if (!same_bits(one[k].force, other[k].force))
      return differing("the force that tears " + link(one), sides, one[k].force, other[k].force);
  }
  return {};
}

}  // namespace furrow::test
