// A scene made ready: a flat state y and a discrete state (which links are intact, which contacts hold a tangential
// spring). `rhs` is the flow between events and leaves no trace; `jump` is applied once after each accepted step.
//
// State:  [ x, y | vx, vy | spin | tangential springs | ledger ]
//   x, y, vx, vy  one number for each disc, then for each free node          m, m/s
//   spin          one for each disc, only if some contact has friction       rad/s
//   springs       one for each slot, only if some contact has friction       m
//                 then one for each chunk that stays 0: contacts without a slot read and write there
//   ledger        energies handed over since t = 0, only if asked for        J
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "methods/history.h"
#include "methods/ode.h"
#include "methods/parallel.h"
#include "system/kernel.h"
#include "system/parts.h"
#include "system/search.h"
#include "system/survey.h"

namespace furrow {

enum Ledger { link_damping, contact_viscous, friction_work, rolling_work, tear_energy, plate_work, stiffening };
inline constexpr int ledger_entries = 7;

struct Tear {
  double time;  // s
  int link;
  double force;  // N, spring force that exceeded the strength
};

// What of a system changes beside its state: with both, the method's history and a time a run goes on in another system
// of the same scene. Contacts that hold a slot stand in the order of the lists.
struct DiscreteState {
  struct Held {
    int kind, a, b, slot;
    std::uint32_t near_at;  // as in Candidates
  };
  std::vector<int> torn;  // links
  std::vector<Held> held;
  std::vector<int> unused;  // slots, the next one last
  std::uint32_t jumps = 0;
  bool preparing = false;
  int spring_count() const { return static_cast<int>(held.size() + unused.size()); }
  void history(HistoryVisitor& visit);
};

// What a jump changed. A multistep method keeps its history unless the right-hand side has jumped.
struct JumpReport {
  std::vector<Tear> torn;
  bool springs_changed = false;
  Growth grown;                    // of the state, for contacts that found no room in it
  const Survey* survey = nullptr;  // of the state that was left, if it was asked for
  State* rates = nullptr;  // at the state that was left, if they are known: the system's own room, to be swapped out
  bool flow_jumped() const { return !torn.empty(); }
};

// A system is for one thread at a time, its const functions too: rhs and for_each_touch work in rooms of the system. As
// many systems as one likes may be used at once. rhs and jump are for the default floating-point environment: rounding
// to nearest, no traps (see floating_point.h); run() and prepare() see to it themselves.
class System : public OdeSystem {
 public:
  explicit System(const Scene& scene);

  std::size_t size() const override { return static_cast<std::size_t>(ledger_ + (keeps_ledger_ ? ledger_entries : 0)); }
  std::size_t positions() const override { return 2 * static_cast<std::size_t>(bodies_); }
  std::size_t lasting() const override { return static_cast<std::size_t>(springs_); }
  std::size_t controlled() const override { return static_cast<std::size_t>(springs_ + spring_count_); }
  int threads() const override { return threads_; }
  std::string velocity_dependence() const override;
  void rhs(double t, const State& y, State& dydt) const override;

  State initial_state() const;
  JumpReport jump(double t, State& y);

  DiscreteState discrete_state() const;

  // Throws std::invalid_argument if it is not one of this scene's.
  void restore(const DiscreteState& discrete);

  // Makes the room in a state of before a jump that the jump made in its own.
  void fit(State& y) const;

  // While a scene is prepared its plates stand still and its links do not tear.
  void prepare(bool preparing) { preparing_ = preparing; }

  // From now on each jump surveys its contacts. Without friction it has to evaluate them for that, at the state where
  // most methods begin their next step and do so anyway.
  void watch(bool watched) { watched_ = watched; }
  Survey& survey() { return survey_; }

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
  // rad/s. Where no contact has friction nothing turns a disc: it keeps the spin that the scene gave it, outside the
  // state.
  double spin(const State& y, int disc) const { return friction_ ? y[spin_of(disc)] : disc_start_[disc].spin; }
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
    std::uint32_t now = 0;                   // number of this jump; the first is 1, so that 0 is no jump
    std::vector<std::vector<int>> changing;  // by chunk: first pairs of blocks where one takes or gives back a slot
    System* system = nullptr;                // in a jump
    State* state = nullptr;                  // the one that is jumped
    Growth grown;                            // of it
    double* spring = nullptr;                // its springs
    bool relaxed = false;

    void make_room(const Candidates& list, int first, int last) const;

    void see(Candidates& list, int candidate, bool near);
    void relax(int slot);
  };

  // Forces alone, the ledger's terms too, or all that a block names of those that touch.
  enum class Asker { rates, ledger, onlooker };

  // One law of all contacts is quicker than that of each.
  ContactModel model(bool one_law, int law) const {
    return {&parts_.law[one_law ? law : 0], one_law, rolling_, rolling_smoothing_};
  }
  ContactModel model_of_pairs() const { return model(law_of_pairs_ >= 0, law_of_pairs_); }
  ContactModel model_of(const TouchBlock& c) const {
    return model(std::equal(c.law.begin() + 1, c.law.begin() + c.count, c.law.begin()), c.law[0]);
  }
  int spare_of(int chunk) const { return spring_count_ + chunk; }
  void empty_spares(State& of) const { std::fill(of.begin() + springs_ + spring_count_, of.begin() + ledger_, 0.0); }
  void place_nodes(const State& y) const;
  Placement placement(double t, const State& y) const;
  void look_around(double t, const State& y) const;
  DiscMotion motion(const State& y) const;
  template <class Sink>
  void for_each_disc_block(const State& y, Slots* slots, Asker asker, Sink&& sink) const;
  template <class Sink>
  void for_each_flat_block(double t, const State& y, Slots* slots, Asker asker, Sink&& sink) const;
  template <class Also>
  void add_up(double t, const State& y, Slots* slots, State& dydt, Also&& also) const;
  void fetch_ahead(const State& y, int first, int last) const;
  void hand_out_slots(const State& y, Slots& slots, State& dydt) const;
  void point_at(TouchBlock& c, ContactKind kind, int first, int last) const;
  void fill_discs(TouchBlock& c, const State& y, int first, int last) const;
  void fill_walls(int first, int last, const State& y, Slots* slots) const;
  template <ContactKind kind>
  void fill_flat_of(int first, int last, double t, const State& y, Slots* slots) const;
  void fill_flat(ContactKind kind, int first, int last, double t, const State& y, Slots* slots) const;
  void take_springs(TouchBlock& c, const State& y, int chunk) const;
  NearestOnSegment nearest_border(const Placement& now, int candidate, int& segment) const;
  void begin_rates(const State& y, State& dydt) const;
  void empty_loads(const Chunk& chunk) const;
  void add_contacts(const TouchBlock& block, int chunk, double t, State& dydt) const;
  void join_chunks() const;
  void finish_rates(State& dydt) const;
  void add_link_forces(double* work) const;
  void add_to_ledger(const TouchBlock& block, int chunk, double t, double* work) const;
  void lay_out(int spring_count);
  void grow_slots(int wanting);
  void return_springs(double t, State& y, JumpReport& report);
  double lattice_contact_energy(double t, const State& y) const;
  void begin_survey();
  void survey_block(const TouchBlock& block, int chunk);
  void survey_few(const TouchBlock& block);
  bool near_border(const TouchBlock& block, int k) const;
  void finish_survey();
  void tear_links(double t, State& y, JumpReport& report);

  Parts parts_;
  double gravity_ = 0;
  double lever_ = 1;  // 1: arm to the contact point, 0: whole radius
  double rolling_smoothing_ = 0;
  bool friction_ = false, rolling_ = false, keeps_ledger_ = false, preparing_ = false;
  int threads_ = 1;
  bool alike_ = false;     // all discs have the same radius, mass and material
  int law_of_pairs_ = -1;  // if all discs have the same material
  int bodies_ = 0, springs_ = 0, spring_count_ = 0, spares_ = 0, ledger_ = 0;
  std::vector<double> inverse_mass_, inverse_inertia_, weight_;  // by body

  std::vector<Disc> disc_start_;
  std::vector<char> torn_;
  std::vector<int> intact_;  // links, ascending
  Slots slots_;
  State rates_;                         // room for those that a jump leaves
  std::vector<double> chunk_returned_;  // J, freed by a jump, chunk by chunk
  bool watched_ = false;
  Survey survey_;
  std::vector<ContactExtremes> chunk_seen_;

  // Caches: they hold nothing that a result depends on.
  mutable NeighbourSearch search_;
  mutable Nodes nodes_;
  mutable std::vector<double> node_fx_, node_fy_;
  mutable std::vector<DiscRow> disc_row_;
  mutable std::vector<DiscLoad> disc_load_;          // of each disc, then each spill
  mutable std::vector<ContactPowers> chunk_powers_;  // of the pairs of each chunk; the first takes all in the end
  mutable std::vector<TouchBlock> disc_block_;       // one for each thread
  mutable TouchBlock wall_block_, flat_block_;
};

// Calls sink(block, chunk), for different chunks at once unless an onlooker asks.
template <class Sink>
void System::for_each_disc_block(const State& y, Slots* slots, Asker asker, Sink&& sink) const {
  const ContactModel model = model_of_pairs();
  const int chunks = static_cast<int>(search_.chunks.size());
  if (slots) slots->changing.resize(search_.chunks.size());
  in_parallel(asker == Asker::onlooker ? 1 : threads_, chunks, [&](int number, int thread) {
    const Chunk& chunk = search_.chunks[number];
    TouchBlock& c = disc_block_[thread];
    if (slots) slots->changing[number].clear();
    int spill = parts_.disc.count() + chunk.first_spill;
    if (asker != Asker::onlooker) empty_loads(chunk);
    for (int first = chunk.first_pair; first < chunk.last_pair; first += TouchBlock::capacity) {
      const int last = std::min(chunk.last_pair, first + TouchBlock::capacity);
      if (chunks > 1) fetch_ahead(y, first, last);
      fill_discs(c, y, first, last);
      if (slots && note_near(c, &search_.candidates[disc_disc].near_at[first], slots->now))
        slots->changing[number].push_back(first);
      if (asker == Asker::onlooker) c.keep_touching();
      if (c.count == 0) continue;
      take_springs(c, y, number);
      evaluate(c, model, slots != nullptr, asker != Asker::rates);
      if (chunks > 1) {
        for (int k = 0; k < c.count; ++k) c.load_of_b[k] = c.b[k] < chunk.last_disc ? c.b[k] : spill++;
      }
      sink(static_cast<const TouchBlock&>(c), number);
    }
  });
}

template <class Sink>
void System::for_each_flat_block(double t, const State& y, Slots* slots, Asker asker, Sink&& sink) const {
  for (int kind = disc_disc + 1; kind < contact_kinds; ++kind) {
    const int count = search_.candidates[kind].count();
    for (int first = 0; first < count; first += TouchBlock::capacity) {
      const int last = std::min(count, first + TouchBlock::capacity);
      TouchBlock& c = kind == disc_wall ? wall_block_ : flat_block_;
      if (kind == disc_wall) {
        fill_walls(first, last, y, slots);
        if (asker == Asker::onlooker) c.keep_touching();
      } else {
        fill_flat(static_cast<ContactKind>(kind), first, last, t, y, slots);
      }
      if (c.count == 0) continue;
      take_springs(c, y, 0);
      evaluate(c, model_of(c), slots != nullptr, asker != Asker::rates);
      sink(static_cast<const TouchBlock&>(c));
    }
  }
}

template <class Sink>
void System::for_each_touch(double t, const State& y, Sink&& sink) const {
  look_around(t, y);
  for_each_disc_block(y, nullptr, Asker::onlooker, [&](const TouchBlock& c, int /*chunk*/) { sink(c); });
  for_each_flat_block(t, y, nullptr, Asker::onlooker, sink);
}

// The rates, and also(block, chunk) of each block; those that are of no chunk count to the first, after all others.
template <class Also>
void System::add_up(double t, const State& y, Slots* slots, State& dydt, Also&& also) const {
  const Asker asker = keeps_ledger_ ? Asker::ledger : Asker::rates;
  const auto add = [&](const TouchBlock& c, int chunk) {
    also(c, chunk);
    add_contacts(c, chunk, t, dydt);
  };
  look_around(t, y);
  begin_rates(y, dydt);
  for_each_disc_block(y, slots, asker, add);
  join_chunks();
  if (slots) hand_out_slots(y, *slots, dydt);
  for_each_flat_block(t, y, slots, asker, [&](const TouchBlock& c) { add(c, 0); });
  finish_rates(dydt);
}

}  // namespace furrow
