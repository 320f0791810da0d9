// After each accepted step: slots handed out and given back, springs returned to the Coulomb limit, links torn.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/reference.h"
#include "system/border.h"
#include "system/order.h"

namespace furrow::reference {
namespace {

bool same(const DiscreteState::Held& held, const ContactId& pair) {
  return held.kind == pair.kind && held.a == pair.a && held.b == pair.b;
}

// A contact that comes near takes a slot, one that has long been apart gives it back, in the order of the pairs.
class Slots {
 public:
  Slots(const Parts& parts, Layout& layout, DiscreteState& discrete, State& y)
      : parts_(parts), layout_(layout), discrete_(discrete), y_(y) {}

  Growth hand_out(double t) {
    ++discrete_.jumps;
    std::vector<DiscreteState::Held> held;
    auto next = discrete_.held.begin();
    const Moment now{parts_, layout_, discrete_, t, y_};
    for_each_pair(parts_, [&](const ContactId& pair) {
      const bool near = proximity(now, pair).near;
      const bool holds = next != discrete_.held.end() && same(*next, pair);
      if (holds) {
        if (near) next->near_at = discrete_.jumps;
        const bool quiet = discrete_.jumps - next->near_at > quiet_jumps;
        if (quiet)
          discrete_.unused.push_back(next->slot);
        else
          held.push_back(*next);
        ++next;
      } else if (near) {
        held.push_back({pair.kind, pair.a, pair.b, take(), discrete_.jumps});
      }
    });
    discrete_.held = held;
    return grown_;
  }

 private:
  int take() {
    if (discrete_.unused.empty()) grow();
    const int slot = discrete_.unused.back();
    discrete_.unused.pop_back();
    y_[layout_.spring_of(slot)] = 0;
    return slot;
  }

  // One more, after all others.
  void grow() {
    const Growth one{1, static_cast<std::size_t>(layout_.size() - layout_.first_dummy())};
    one.apply(y_);
    grown_ = {grown_.count + 1, one.before_end};
    discrete_.unused.push_back(layout_.spring_count++);
  }

  const Parts& parts_;
  Layout& layout_;
  DiscreteState& discrete_;
  State& y_;
  Growth grown_;
};

// The springs of contacts that another plate feels instead are that plate's. True if one was not.
bool follow_springs(const Moment& now, State& y) {
  bool changed = false;
  for (const DiscreteState::Held& held : now.discrete.held) {
    const int leader = slot_followed(now, held);
    if (leader < 0) continue;
    double& spring = y[now.layout.spring_of(held.slot)];
    changed = changed || spring != y[now.layout.spring_of(leader)];
    spring = y[now.layout.spring_of(leader)];
  }
  return changed;
}

// |xi| <= mu Fn / St; the energy that this frees is heat of friction. Without a touch a spring holds nothing.
bool return_springs(const Moment& now, State& y) {
  std::vector<double> freed(static_cast<std::size_t>(blocks_of(now.parts.disc.count())));  // J, block by block
  if (now.parts.keeps_ledger) freed[0] = y[now.layout.ledger_of(friction_work)];
  bool changed = false;
  for (const DiscreteState::Held& held : now.discrete.held) {
    const ContactId pair{static_cast<ContactKind>(held.kind), held.a, held.b};
    double& spring = y[now.layout.spring_of(held.slot)];
    const double before = spring;
    const Proximity near = proximity(now, pair);
    if (near.touching) {
      const Contact c = contact_of(now, pair, near);
      const ContactLaw& law = now.parts.law[c.law];
      spring = returned_spring(coulomb_limit(law, c.force), c.force, before);
      freed[pair.kind == disc_disc ? block_of(pair.a) : 0] +=
          0.5 * c.force.shear_stiffness * (before * before - spring * spring);
    } else if (slot_followed(now, held) < 0) {
      spring = 0;
    }
    changed = changed || spring != before;
  }
  for (std::size_t k = 1; k < freed.size(); ++k) freed[0] += freed[k];
  if (now.parts.keeps_ledger) y[now.layout.ledger_of(friction_work)] = freed[0];
  return follow_springs(now, y) || changed;
}

// The faces of plates that bodies keep from now on.
HeldFaces faces_after(const Moment& now) {
  HeldFaces kept;
  for_each_pair(now.parts, [&](const ContactId& pair) {
    if (!of_plate(pair.kind)) return;
    const Vec2 at = of_disc(pair.kind) ? disc_of(now, pair.a).at : node_of(now, pair.a).at;
    const Face face = face_after(now.parts, now.discrete.faces, pair, at, now.discrete.preparing ? 0 : now.t);
    if (face != no_face) kept.push_back({pair.kind, pair.a, pair.b, face});
  });
  return kept;
}

// J, in the contacts of lattices.
double energy_on_lattices(const Moment& now) {
  double energy = 0;
  for (const Contact& c : contacts(now)) {
    if (c.id.kind == disc_lattice) energy += stored_energy(c);
  }
  return energy;
}

// Links over their strength. What energy the contacts with the border lose by its change is booked as torn.
std::vector<Tear> tear_links(const Moment& now, DiscreteState& discrete, State& y) {
  const LinkArrays& link = now.parts.link;
  std::vector<Tear> tears;
  double released = 0;  // J
  for (int k = 0; k < link.count(); ++k) {
    if (is_torn(now.discrete, k)) continue;
    const Vec2 r = node_of(now, link.a[k]).at - node_of(now, link.b[k]).at;
    const double stretch = std::sqrt(dot(r, r)) - link.rest[k];  // m
    const double force = link.stiffness[k] * stretch;            // N
    if (!((link.in_magnitude[k] != 0 ? std::fabs(force) : force) > link.strength[k])) continue;
    tears.push_back({now.t, k, force});
    released += 0.5 * force * stretch;
  }
  if (tears.empty()) return tears;
  if (now.parts.keeps_ledger) released += energy_on_lattices(now);
  for (const Tear& tear : tears) discrete.torn.push_back(tear.link);
  std::sort(discrete.torn.begin(), discrete.torn.end());
  discrete.border = touched_segments(now.parts, discrete.torn);
  if (now.parts.keeps_ledger) y[now.layout.ledger_of(tear_energy)] += released - energy_on_lattices(now);
  return tears;
}

}  // namespace

bool Reference::torn(int link) const { return is_torn(discrete_, link); }

Reference::Reference(const std::shared_ptr<const Parts>& parts)
    : Solver(parts, make_layout(*parts)), discrete_(initial_discrete_state(*parts, layout_)) {}

// First held faces, then slots, then springs, then the survey, then tears: springs are cut to the limit of a torn
// border at the next jump.
JumpReport Reference::jump(double t, State& y) {
  const Moment now{*parts_, layout_, discrete_, t, y};
  JumpReport report;
  if (parts_->tight_plates) discrete_.faces = faces_after(now);
  if (parts_->friction) {
    report.grown = Slots(*parts_, layout_, discrete_, y).hand_out(t);
    report.springs_changed = return_springs(now, y);
  }
  if (watched_) {
    survey_.begin(*parts_);
    for (const Contact& c : contacts(now)) survey_.see(*parts_, c, survey_.seen);
    report.survey = &survey_;
  }
  if (!discrete_.preparing) report.torn = tear_links(now, discrete_, y);
  return report;
}

void Reference::flow(double t, const State& y, State& dydt) const {
  reference::flow({*parts_, layout_, discrete_, t, y}, dydt);
}

void Reference::for_each_contact(double t, const State& y, const Visit& visit) const {
  for (const Contact& c : contacts({*parts_, layout_, discrete_, t, y})) visit(c);
}

void Reference::restore(const DiscreteState& discrete) {
  if (!belongs_to(discrete, *parts_) || (layout_.dummy_slots == 0 && discrete.spring_count() > 0))
    throw std::invalid_argument("the discrete state is not one of this scene");
  discrete_ = discrete;
  discrete_.border = touched_segments(*parts_, discrete.torn);
  layout_.spring_count = discrete.spring_count();
}

}  // namespace furrow::reference
