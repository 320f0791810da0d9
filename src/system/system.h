// A scene made ready: a flat state y and a discrete state (which links are intact, which contacts hold a tangential
// spring). `rhs` is the flow between events and leaves no trace; `jump` is applied once after each accepted step.
//
// State:  [ x, y | vx, vy | spin | tangential springs | ledger ]
//   x, y, vx, vy  one number for each disc, then for each free node          m, m/s
//   spin          one for each disc, only if some contact has friction       rad/s
//   springs       one for each slot, only if some contact has friction       m
//   ledger        energies handed over since t = 0, only if asked for        J
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "methods/ode.h"
#include "system/kernel.h"
#include "system/parts.h"
#include "system/search.h"

namespace furrow {

enum Ledger { link_damping, contact_viscous, friction_work, rolling_work, tear_energy, plate_work, stiffening };
inline constexpr int ledger_entries = 7;

struct Tear {
  double time;  // s
  int link;
  double force;  // N, spring force that exceeded the strength
};

// What a jump changed. A multistep method keeps its history unless the right-hand side has jumped.
struct JumpReport {
  std::vector<Tear> torn;
  bool springs_changed = false;
  bool flow_jumped() const { return !torn.empty(); }
};

class System : public OdeSystem {
 public:
  explicit System(const Scene& scene);

  std::size_t size() const override { return static_cast<std::size_t>(ledger_ + (keeps_ledger_ ? ledger_entries : 0)); }
  std::size_t positions() const override { return 2 * static_cast<std::size_t>(bodies_); }
  std::size_t controlled() const override { return static_cast<std::size_t>(ledger_); }
  std::string velocity_dependence() const override;
  void rhs(double t, const State& y, State& dydt) const override;

  State initial_state() const;
  JumpReport jump(double t, State& y);

  // While a scene is prepared its plates stand still and its links do not tear.
  void prepare(bool preparing) {
    preparing_ = preparing;
    known_.clear();
  }

  const Parts& parts() const { return parts_; }
  const NeighbourSearch& search() const { return search_; }
  bool torn(int link) const { return torn_[link] != 0; }
  bool has_friction() const { return friction_; }
  bool has_rolling() const { return rolling_; }
  bool keeps_ledger() const { return keeps_ledger_; }
  double gravity() const { return gravity_; }
  double rolling_smoothing() const { return rolling_smoothing_; }

  int x_of(int body) const { return body; }
  int y_of(int body) const { return bodies_ + body; }
  int vx_of(int body) const { return 2 * bodies_ + body; }
  int vy_of(int body) const { return 3 * bodies_ + body; }
  int spin_of(int disc) const { return 4 * bodies_ + disc; }
  int first_spring() const { return springs_; }
  int spring_count() const { return spring_count_; }
  int ledger_of(Ledger entry) const { return ledger_ + entry; }

  struct PlateAt {
    double left, lower, vx, vy;
  };
  PlateAt plate_at(int plate, double t) const;

  // Position and velocity of all nodes, fixed ones included.
  struct Nodes {
    std::vector<double> x, y, vx, vy;
  };
  Nodes nodes(const State& y) const;

  // Calls sink(block) for the contacts that touch, kind by kind, sorted by pair, with the forces of the contact law.
  template <class Sink>
  void for_each_touch(double t, const State& y, Sink&& sink) const;

  // 64-bit FNV-1a of the bits of positions, velocities, spins, springs and of which links are torn.
  std::uint64_t state_hash(const State& y) const;

 private:
  // Slots for tangential springs that no contact holds; the last one is taken next.
  struct Slots {
    std::vector<int> unused;
    Nearness nearness;

    void see(Candidates& list, int candidate, bool near);
  };

  // Forces alone, the ledger's terms too, or all that a block names of those that touch.
  enum class Asker { rates, ledger, onlooker };

  Asker asker() const { return keeps_ledger_ ? Asker::ledger : Asker::rates; }
  void place_nodes(const State& y) const;
  Placement placement(double t, const State& y) const;
  void pack_discs(const State& y) const;
  template <class Sink>
  void for_each_block(double t, const State& y, Slots* slots, Asker asker, Sink&& sink) const;
  void fill_discs(int first, int last, Slots* slots) const;
  void fill_flat(ContactKind kind, int first, int last, double t, const State& y, Slots* slots) const;
  void take_springs(const State& y) const;
  NearestOnSegment nearest_border(const Placement& now, int candidate, int& segment) const;
  void begin_rates(const State& y, State& dydt) const;
  void add_contacts(const TouchBlock& block, double t, State& dydt) const;
  void finish_rates(State& dydt) const;
  void add_link_forces(double* work) const;
  void add_to_ledger(const TouchBlock& block, double* work, double t) const;
  void return_springs(double t, State& y, JumpReport& report);
  double lattice_contact_energy(double t, const State& y) const;
  void tear_links(double t, State& y, JumpReport& report);

  const Kernel* kernel_ = &kernel();
  Parts parts_;
  double gravity_ = 0;
  double lever_ = 1;  // 1: arm to the contact point, 0: whole radius
  double rolling_smoothing_ = 0;
  bool friction_ = false, rolling_ = false, keeps_ledger_ = false, preparing_ = false;
  int bodies_ = 0, springs_ = 0, spring_count_ = 0, ledger_ = 0;
  std::vector<double> inverse_mass_, inverse_inertia_, weight_;  // by body

  std::vector<Disc> disc_start_;
  std::vector<char> torn_;
  std::vector<int> intact_;  // links, ascending
  Slots slots_;
  std::vector<double> relaxed_;  // room for the springs of a jump

  // Caches: they hold nothing that a result depends on.
  mutable NeighbourSearch search_;
  mutable Nodes nodes_;
  mutable std::vector<double> node_fx_, node_fy_;
  mutable std::vector<TouchBlock::DiscPair> first_of_pair_, second_of_pair_;
  mutable std::vector<DiscLoad> disc_load_;
  mutable TouchBlock block_;
  double known_time_ = 0;
  State known_, known_rates_;  // the flow at the state that the last jump left; empty: not known
};

template <class Sink>
void System::for_each_block(double t, const State& y, Slots* slots, Asker asker, Sink&& sink) const {
  place_nodes(y);
  search_.update(parts_, placement(t, y));
  pack_discs(y);
  const ContactModel model{parts_.law.data(), parts_.law.size() == 1, rolling_, lever_, rolling_smoothing_};
  for (int kind = 0; kind < contact_kinds; ++kind) {
    const int count = search_.candidates[kind].count();
    for (int first = 0; first < count; first += TouchBlock::capacity) {
      const int last = std::min(count, first + TouchBlock::capacity);
      if (kind == disc_disc) {
        fill_discs(first, last, slots);
      } else {
        fill_flat(static_cast<ContactKind>(kind), first, last, t, y, slots);
      }
      if (kind == disc_disc && asker == Asker::onlooker) block_.keep_touching();
      if (block_.count == 0) continue;
      take_springs(y);
      kernel_->evaluate(block_, model, slots != nullptr, asker != Asker::rates);
      sink(static_cast<const TouchBlock&>(block_));
    }
  }
}

template <class Sink>
void System::for_each_touch(double t, const State& y, Sink&& sink) const {
  for_each_block(t, y, nullptr, Asker::onlooker, sink);
}

}  // namespace furrow
