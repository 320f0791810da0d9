// The reference solver: flow (the right-hand side) and jump (what changes at once after a step) of a scene, every pair,
// contact after contact. It is there to be read and to judge the kernel, which gives the same bits
// (tests/property/kernel_is_reference_test.cpp).
//
// Read physics/contact.h (the law; its options: physics/contact_force.h), system/contact.h (which radius, mass, arm and
// normal), system/discrete.h (the life of a tangential spring), system/held_faces.h (which face of a plate a body
// keeps), system/border.h (what of a torn lattice discs touch), system/layout.h (the state and the balance of energy),
// system/order.h (the order of sums), then
//
//   contact.cpp   one contact: where two parts touch, how they move there, and what the law answers
//   flow.cpp      y' = f(t, y): all contacts, all links, the sums of forces, the ledger; the force on plates and walls
//   jump.cpp      after each accepted step: faces of plates kept, slots handed out, springs returned to the Coulomb
//                 limit, what the run's watches ask for, links torn
//
// The geometry that contact.cpp calls stands below it, for the kernel shares it: physics/geometry.h (nearest points),
// physics/held_face.h (a rectangle of which one face is kept), system/surface.h (where a plate is; the gap to a plate,
// wall or border), system/held_faces.h (plates that are one surface, and which of them feels a body), system/border.h
// (which segments discs can touch).
//
// What a jump means for a method's history: methods/method.h. What continues a run exactly: system/discrete.h.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "system/solver.h"
#include "system/survey.h"

namespace furrow::reference {

// A scene at one instant, as all functions here take it.
struct Instant {
  const Parts& parts;
  const Layout& layout;
  const DiscreteState& discrete;
  double t;  // s
  const State& y;
};

struct Body {
  Vec2 at;          // m
  Vec2 velocity;    // m/s
  double spin = 0;  // rad/s
};

Body disc_of(const Instant& now, int disc);
Body node_of(const Instant& now, int node);

// Where the two of a pair are against each other.
struct Proximity {
  bool near = false;      // closer than Parts::margin (m)
  bool touching = false;  // the surfaces cross
  double overlap = 0;     // m; negative if they are apart
  double nx = 0, ny = 0;  // -, from a to b; shorter than 1 only inside the rounded corners of a kept face (held_face.h)
  int segment = -1;       // disc-lattice: the nearest one
  double share = 0;       // -, disc-lattice: where on it, 0 at its node a, 1 at b
};
Proximity proximity(const Instant& now, const ContactId& pair);

// The contact of a pair that touches. Without a slot it has no springs, xi = theta = 0: its Ft is that of the damper alone,
// within the limit of friction.
Contact contact_of(const Instant& now, const ContactId& pair, const Proximity& near);

// Of flush plates one feels a body, and the springs of the others follow its spring. held: a contact that holds a slot.
// Slot of the plate that feels the body instead; -1 if this plate feels it itself or that one has no slot.
int slot_followed(const Instant& now, const DiscreteState::Held& held);

// J: what the springs of a pair that touches no more still hold; spring: m, xi; turn: rad, theta.
SpringEnergies energy_at_opening(const Instant& now, const ContactId& pair, double spring, double turn);

// Every pair that there can be, in the order of the sums: see system/order.h.
void for_each_pair(const Parts& parts, const std::function<void(const ContactId&)>& for_pair);

// All contacts that touch, in the same order.
std::vector<Contact> contacts(const Instant& now);

// N: what each plate and each wall feels.
struct FlatForces {
  std::vector<Vec2> plate, wall;
};
FlatForces forces_on_flats(const Instant& now);

// y' = f(t, y).
void flow(const Instant& now, State& rates);

class Reference final : public Solver {
 public:
  explicit Reference(const std::shared_ptr<const Parts>& parts);

  std::unique_ptr<Solver> clone() const override { return std::make_unique<Reference>(*this); }
  void flow(double t, const State& y, State& dydt) const override;
  JumpReport jump(double t, State& y) override;
  void for_each_contact(double t, const State& y, const Visit& visit) const override;
  DiscreteState discrete_state() const override { return discrete_; }
  void restore(const DiscreteState& discrete) override;
  bool torn(int link) const override;
  Face held_face(const ContactId& contact) const override { return face_of(discrete_.faces, contact); }
  const std::vector<int>& border() const override { return discrete_.border; }
  bool preparing() const override { return discrete_.preparing; }
  void prepare(bool preparing) override { discrete_.preparing = preparing; }
  void watch(bool watched) override { watched_ = watched; }
  Survey& survey() override { return survey_; }

 private:
  DiscreteState discrete_;
  bool watched_ = false;
  Survey survey_;
};

}  // namespace furrow::reference
