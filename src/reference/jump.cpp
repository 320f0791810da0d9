// After each accepted step: faces of plates kept, slots handed out and given back, springs returned to the Coulomb limit,
// a survey for the run's watches, links torn.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "physics/link.h"
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
    ++discrete_.jumps;                      // counts jumps
    std::vector<DiscreteState::Held> held;  // after this jump, in the order of the pairs
    auto next = discrete_.held.begin();     // the next one that holds a slot
    const Instant now{parts_, layout_, discrete_, t, y_};
    for_each_pair(parts_, [&](const ContactId& pair) {
      const bool near = proximity(now, pair).near;                           // closer than Parts::margin
      const bool holds = next != discrete_.held.end() && same(*next, pair);  // it has a slot
      if (holds) {
        if (near || stretched(next->slot)) next->near_at = discrete_.jumps;  // in jumps
        const bool quiet = discrete_.jumps - next->near_at > quiet_jumps;    // long apart
        if (quiet)
          discrete_.unused.push_back(next->slot);
        else
          held.push_back(*next);
        ++next;
      } else if (near) {
        held.push_back({pair.kind, pair.a, pair.b, take(), discrete_.jumps});
      }
    });
    discrete_.held = held;  // sorted, as the pairs are
    return grown_;
  }

 private:
  // A spring that is not zero: the contact touches, or did so within the step.
  bool stretched(int slot) const {
    const auto first = y_.begin() + layout_.spring_of(slot);
    return std::any_of(first, first + layout_.slot_width, [](double number) { return number != 0; });
  }

  int take() {
    if (discrete_.unused.empty()) grow();
    const int slot = discrete_.unused.back();  // the one given back last
    discrete_.unused.pop_back();
    std::fill_n(y_.begin() + layout_.spring_of(slot), layout_.slot_width, 0.0);  // m and rad: xi = theta = 0
    return slot;
  }

  // One more slot, after all others: room in the state before the dummy slots, the ledger and the angles. How many numbers
  // stand after it does not change, so the room of several slots is one Growth.
  void grow() {
    const Growth one{static_cast<std::size_t>(layout_.slot_width),
                     static_cast<std::size_t>(layout_.size() - layout_.first_dummy())};
    one.apply(y_);
    grown_ = {grown_.count + one.count, one.before_end};  // numbers of the state
    discrete_.unused.push_back(layout_.spring_count++);
  }

  const Parts& parts_;
  Layout& layout_;
  DiscreteState& discrete_;
  State& y_;
  Growth grown_;  // how many numbers of the state are new, and where, for what else holds states
};

// The springs of contacts that another plate feels instead are that plate's. True if one was not.
bool follow_springs(const Instant& now, State& y) {
  bool changed = false;
  for (const DiscreteState::Held& held : now.discrete.held) {
    const int leader = slot_followed(now, held);  // -1: its spring is its own
    if (leader < 0) continue;
    for (int k = 0; k < now.layout.slot_width; ++k) {
      double& number = y[now.layout.spring_of(held.slot) + k];             // m or rad
      changed = changed || number != y[now.layout.spring_of(leader) + k];  // the springs
      number = y[now.layout.spring_of(leader) + k];                        // m or rad
    }
  }
  return changed;
}

// J: the heat of an entry of the ledger, block by block; the first begins with what is there.
class Heat {
 public:
  Heat(const Instant& now, Ledger entry) : of_block_(static_cast<std::size_t>(blocks_of(now.parts.disc.count()))) {
    if (now.parts.keeps_ledger) of_block_[0] = now.y[now.layout.ledger_of(entry)];  // J
  }
  void add(const ContactId& pair, double heat) { of_block_[pair.kind == disc_disc ? block_of(pair.a) : 0] += heat; }
  double sum() {
    join_blocks(of_block_, [](double& all, double one) { all += one; });
    return of_block_[0];
  }

 private:
  std::vector<double> of_block_;
};

// xi is reset by one of the two rules of physics/damping.h; the second can lengthen or reverse it. |theta| is limited as
// physics/rolling_spring.h has it. The energy that this frees is heat of friction and of rolling, negative where |xi|
// grows. Without a touch a spring holds nothing: what it held is heat too.
bool return_springs(const Instant& now, State& y) {
  Heat sliding(now, friction_work), rolling(now, rolling_work);
  bool changed = false;
  const auto set = [&](double& number, double value) {
    changed = changed || value != number;  // the springs
    number = value;                        // m or rad
  };
  for (const DiscreteState::Held& held : now.discrete.held) {
    const ContactId pair{static_cast<ContactKind>(held.kind), held.a, held.b};
    double& spring = y[now.layout.spring_of(held.slot)];                                    // m, xi
    double* turn = now.parts.rolling_spring ? &y[now.layout.turn_of(held.slot)] : nullptr;  // rad, theta
    const Proximity near = proximity(now, pair);                                            // m: where the two are
    if (!near.touching) {
      if (slot_followed(now, held) >= 0) continue;
      const SpringEnergies lost = energy_at_opening(now, pair, spring, turn ? *turn : 0);  // J
      sliding.add(pair, lost.tangential);                                                  // J
      rolling.add(pair, lost.rolling);                                                     // J
      set(spring, 0);                                                                      // m
      if (turn) set(*turn, 0);                                                             // rad
      continue;
    }
    const Contact c = contact_of(now, pair, near);  // with its force at the old xi
    const ContactLaw& law = now.parts.law[c.law];
    const double before = spring;                                                            // m
    set(spring, spring_after_step(law, c.touch, c.force));                                   // m, by the rule
    sliding.add(pair, 0.5 * c.force.shear_stiffness * (before * before - spring * spring));  // J
    if (!turn || !rolls_on_spring(law)) continue;
    set(*turn, turn_after_step(law, c.touch, c.force));  // rad, within the limit
    rolling.add(pair, 0.5 * rolling_stiffness(law, c.touch, c.force) * (c.touch.turn * c.touch.turn - *turn * *turn));
  }
  if (now.parts.keeps_ledger) y[now.layout.ledger_of(friction_work)] = sliding.sum();                             // J
  if (now.parts.keeps_ledger && now.parts.rolling_spring) y[now.layout.ledger_of(rolling_work)] = rolling.sum();  // J
  return follow_springs(now, y) || changed;
}

// The faces of plates that bodies keep from now on.
HeldFaces faces_after(const Instant& now) {
  HeldFaces kept;
  for_each_pair(now.parts, [&](const ContactId& pair) {
    if (!of_plate(pair.kind)) return;
    const Vec2 at = of_disc(pair.kind) ? disc_of(now, pair.a).at : node_of(now, pair.a).at;  // m
    const Face face = face_after(now.parts, now.discrete.faces, pair, at, now.discrete.preparing ? 0 : now.t);
    if (face != no_face) kept.push_back({pair.kind, pair.a, pair.b, face});
  });
  return kept;
}

// J, in the contacts of lattices.
double energy_on_lattices(const Instant& now) {
  double energy = 0;  // J
  for (const Contact& c : contacts(now)) {
    if (c.id.kind == disc_lattice) energy += stored_energy(now.parts, c);  // J
  }
  return energy;
}

// Links over their strength; only the force of the spring counts. What energy the contacts with the border lose by its
// change is booked as torn. `now` sees the old border before the change of `discrete` and the new one after it.
std::vector<Tear> tear_links(const Instant& now, DiscreteState& discrete, State& y) {
  const LinkArrays& link = now.parts.link;
  std::vector<Tear> tears;
  double released = 0;  // J
  for (int k = 0; k < link.count(); ++k) {
    if (is_torn(now.discrete, k)) continue;
    const Vec2 r = node_of(now, link.a[k]).at - node_of(now, link.b[k]).at;  // m
    const double stretch = std::sqrt(dot(r, r)) - link.rest[k];              // m
    const double force = link.stiffness[k] * stretch;                        // N
    if (!link_tears(force, link.strength[k], link.tear_rule(k))) continue;
    tears.push_back({now.t, k, force});  // s, link, N
    released += 0.5 * force * stretch;   // J, of the spring
  }
  if (tears.empty()) return tears;
  if (now.parts.keeps_ledger) released += energy_on_lattices(now);    // J, on the old border
  for (const Tear& tear : tears) discrete.torn.push_back(tear.link);  // from now on
  std::sort(discrete.torn.begin(), discrete.torn.end());
  discrete.border = touched_segments(now.parts, discrete.torn);  // segments that discs touch from now on
  if (now.parts.keeps_ledger) y[now.layout.ledger_of(tear_energy)] += released - energy_on_lattices(now);  // J
  return tears;
}

}  // namespace

bool Reference::torn(int link) const { return is_torn(discrete_, link); }

Reference::Reference(const std::shared_ptr<const Parts>& parts)
    : Solver(parts, make_layout(*parts)), discrete_(initial_discrete_state(*parts, layout_)) {}

// In this order: first held faces, then slots, then springs, then the survey, then tears: springs are reset by the limit
// of a torn border at the next jump. `now` refers to layout_, discrete_ and y: each part sees what those before it changed.
JumpReport Reference::jump(double t, State& y) {
  const Instant now{*parts_, layout_, discrete_, t, y};
  JumpReport report;
  if (parts_->tight_plates) discrete_.faces = faces_after(now);  // from now on
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

// A layout without dummy slots is one of a scene without springs: it can have no slots.
void Reference::restore(const DiscreteState& discrete) {
  if (!belongs_to(discrete, *parts_) || (layout_.dummy_slots == 0 && discrete.spring_count() > 0))
    throw std::invalid_argument("the discrete state is not one of this scene");
  discrete_ = discrete;                                         // as handed out by discrete_state()
  discrete_.border = touched_segments(*parts_, discrete.torn);  // it follows from the torn links
  layout_.spring_count = discrete.spring_count();               // slots
}

}  // namespace furrow::reference
