// The fast solver: neighbour lists, contacts evaluated in batches at the widest vectors, threads. It must give the
// reference's results to the bit.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "kernel/links.h"
#include "kernel/loops.h"
#include "kernel/options.h"
#include "kernel/parallel.h"
#include "kernel/search.h"
#include "system/solver.h"
#include "system/survey.h"

namespace furrow {

// Its const functions share working memory, so they admit one caller at a time: others wait. flow and jump are for the
// default floating-point environment: rounding to nearest, no traps (see floating_point.h).
class Kernel final : public Solver {
 public:
  Kernel(const std::shared_ptr<const Parts>& parts, const Search& search);

  std::unique_ptr<Solver> clone() const override { return std::make_unique<Kernel>(*this); }
  void flow(double t, const State& y, State& dydt) const override;
  JumpReport jump(double t, State& y) override;
  void for_each_contact(double t, const State& y, const Visit& visit) const override;
  DiscreteState discrete_state() const override;
  void restore(const DiscreteState& discrete) override;
  bool torn(int link) const override { return torn_[link] != 0; }
  Face held_face(const ContactId& contact) const override { return face_of(search_.faces, contact); }
  const std::vector<int>& border() const override { return search_.border; }
  bool preparing() const override { return preparing_; }
  void prepare(bool preparing) override { preparing_ = preparing; }
  void watch(bool watched) override { watched_ = watched; }
  Survey& survey() override { return survey_; }
  int threads() const override { return threads_; }

  const NeighbourSearch& search() const { return search_; }

  // Calls sink(batch) for the contacts that touch, kind by kind, sorted by pair, with the forces of the contact law.
  template <class Sink>
  void for_each_touch(double t, const State& y, Sink&& sink) const;

 private:
  // In a flow every contact keeps the slot that it holds, or has none.
  struct KeptSlots {
    static constexpr bool jumping = false;
  };

  // In a jump contacts take slots and give them back.
  struct JumpingSlots {
    static constexpr bool jumping = true;
    std::vector<int> unused;                 // held by no contact; the last one is taken next
    std::uint32_t now = 0;                   // number of this jump; the first is 1, so that 0 is no jump
    std::vector<std::vector<int>> changing;  // by block: first pairs of batches where one takes or gives back a slot
    Kernel* kernel = nullptr;                // in a jump
    State* state = nullptr;                  // the one that is jumped
    Growth grown;                            // of it
    double* spring = nullptr;                // its springs
    int width = 1;                           // numbers of a slot
    bool relaxed = false;

    void make_room(const Candidates& list, int first, int last) const;

    void update(Candidates& list, int candidate, bool near);
    bool stretched(int slot) const;
    void renew(const TouchBatch& pairs) const;
    void relax(int slot);
  };

  // What a batch is evaluated for: forces; forces and the terms of the ledger; all fields, of the contacts that touch.
  enum class Purpose { rates, rates_and_ledger, observation };

  // One law for all contacts is quicker than a law for each.
  ContactModel model(bool one_law, int law) const {
    return {&parts_->law[one_law ? law : 0], one_law, parts_->rolling, parts_->rolling_smoothing};
  }
  ContactModel model_of_pairs() const { return model(law_of_pairs_ >= 0, law_of_pairs_); }
  ContactModel model_of(const TouchBatch& c) const {
    return model(std::equal(c.law.begin() + 1, c.law.begin() + c.count, c.law.begin()), c.law[0]);
  }
  int dummy_of(int block) const { return layout_.spring_count + block; }
  void clear_dummy_slots(State& of) const { std::fill_n(of.begin() + layout_.first_dummy(), layout_.dummy_slots, 0.0); }
  Placement placement(double t, const State& y) const;
  void update_positions(double t, const State& y) const;
  DiscMotion motion(const State& y) const;
  template <class Slots, class Sink>
  void for_each_disc_batch(const State& y, Slots& slots, Purpose purpose, Sink&& sink) const;
  template <class Slots, class Sink>
  void for_each_flat_batch(double t, const State& y, Slots& slots, Purpose purpose, Sink&& sink) const;
  template <class Slots, class Also>
  void sum_rates(double t, const State& y, Slots& slots, State& dydt, Also&& also) const;
  void prefetch(const State& y, int first, int last) const;
  void assign_slots(const State& y, JumpingSlots& slots, State& dydt) const;
  void point_at(TouchBatch& c, ContactKind kind, int first, int last) const;
  void fill_discs(TouchBatch& c, const State& y, int first, int last) const;
  template <class Slots>
  void fill_walls(int first, int last, const State& y, Slots& slots) const;
  // The part that a disc or node may touch: the gap to it, and its velocity there.
  struct Facing {
    Gap gap;
    double vx, vy;  // m/s
  };
  Facing facing_lattice(const Placement& now, int candidate, int n) const;
  Facing facing_wall_or_plate(const Placement& now, double t, const ContactId& pair) const;
  template <ContactKind kind>
  void put_flat(int candidate, const Facing& other, const State& y, int n) const;
  template <ContactKind kind, class Slots>
  void fill_flat_of(int first, int last, double t, const State& y, Slots& slots) const;
  template <class Slots>
  void fill_flat(ContactKind kind, int first, int last, double t, const State& y, Slots& slots) const;
  void gather_springs(TouchBatch& c, const State& y, int block) const;
  void apply_law(TouchBatch& c, const ContactModel& model, Evaluation asked) const;
  void scatter_rates(const TouchBatch& c, State& dydt) const;
  NearestOnSegment nearest_border(const Placement& now, int candidate, int& segment) const;
  void begin_rates(const State& y, State& dydt) const;
  void clear_loads(const DiscBlock& block) const;
  void add_contacts(const TouchBatch& batch, int block, double t, State& dydt) const;
  void join_blocks() const;
  void finish_rates(State& dydt) const;
  void add_link_forces(double* work) const;
  void add_to_ledger(const TouchBatch& batch, int block, double t, double* work) const;
  void grow_slots(int wanting);
  void return_springs(double t, State& y, JumpReport& report);
  void keep_faces(double t, const State& y);
  int slot_of(const ContactId& contact) const;
  int slot_followed(const Placement& now, const ContactId& pair) const;
  template <class Slots>
  void follow_springs(double t, const State& y, Slots& slots, State& dydt) const;
  double lattice_contact_energy(double t, const State& y) const;
  void begin_survey();
  void survey_batch(const TouchBatch& batch, int block);
  static Contact contact_of(const TouchBatch& batch, int k);
  void finish_survey();
  void tear_links(double t, State& y, JumpReport& report);
  void find_border();
  void tear(const std::vector<int>& links);  // these, and no others

  bool preparing_ = false;
  int threads_ = 1;
  bool alike_ = false;                                            // all discs have the same radius, mass and material
  int law_of_pairs_ = -1;                                         // if all discs have the same material
  std::vector<double> inverse_mass_, inverse_inertia_, gravity_;  // by body

  std::vector<char> torn_;
  std::vector<int> intact_;  // links, ascending
  JumpingSlots slots_;
  State rates_;                         // after a jump
  std::vector<double> block_returned_;  // J, freed by a jump, block by block
  std::vector<double> block_rolled_;    // J, the same of rolling springs
  bool watched_ = false;
  Survey survey_;
  std::vector<ContactExtremes> block_seen_;

  // A copy of the kernel gets its own lock.
  struct Lock {
    Lock() = default;
    Lock(const Lock& /*other*/) {}
    Lock& operator=(const Lock& /*other*/) { return *this; }  // NOLINT(cert-oop54-cpp): nothing is copied
    ~Lock() = default;
    std::mutex mutex;
  };
  mutable Lock lock_;

  // Caches: they hold nothing that a result depends on.
  mutable NeighbourSearch search_;
  mutable NodeMotion nodes_;
  mutable LinkLanes links_;
  mutable std::vector<double> node_fx_, node_fy_;
  mutable std::vector<DiscRow> disc_row_;
  mutable std::vector<DiscLoad> disc_load_;          // of each disc, then each boundary contribution
  mutable std::vector<ContactPowers> block_powers_;  // of the pairs of each block; in the end the first holds the sum
  mutable std::vector<TouchBatch> disc_batch_;       // one for each thread
  mutable TouchBatch wall_batch_, flat_batch_;
};

// The solver as a kernel; throws std::bad_cast if it is another.
inline const Kernel& kernel_of(const Solver& solver) { return dynamic_cast<const Kernel&>(solver); }

// Calls sink(batch, block); for several blocks at once, except in an observation.
template <class Slots, class Sink>
void Kernel::for_each_disc_batch(const State& y, Slots& slots, Purpose purpose, Sink&& sink) const {
  const ContactModel model = model_of_pairs();
  const int blocks = static_cast<int>(search_.blocks.size());
  if constexpr (Slots::jumping) slots.changing.resize(search_.blocks.size());
  in_parallel(purpose == Purpose::observation ? 1 : threads_, blocks, [&](int number, int thread) {
    const DiscBlock& block = search_.blocks[number];
    TouchBatch& c = disc_batch_[thread];
    if constexpr (Slots::jumping) slots.changing[number].clear();
    int contribution = parts_->disc.count() + block.first_contribution;
    if (purpose != Purpose::observation) clear_loads(block);
    for (int first = block.first_pair; first < block.last_pair; first += TouchBatch::capacity) {
      const int last = std::min(block.last_pair, first + TouchBatch::capacity);
      if (blocks > 1) prefetch(y, first, last);
      fill_discs(c, y, first, last);
      if constexpr (Slots::jumping) {
        if (note_near(c, &search_.candidates[disc_disc].near_at[first], slots.now))
          slots.changing[number].push_back(first);
      }
      if (purpose == Purpose::observation) c.keep_touching();
      if (c.count == 0) continue;
      gather_springs(c, y, number);
      apply_law(c, model, {.returning = Slots::jumping, .all_fields = purpose != Purpose::rates});
      if (blocks > 1) {
        for (int k = 0; k < c.count; ++k) c.load_of_b[k] = c.b[k] < block.last_disc ? c.b[k] : contribution++;
      }
      sink(static_cast<const TouchBatch&>(c), number);
    }
  });
}

template <class Slots, class Sink>
void Kernel::for_each_flat_batch(double t, const State& y, Slots& slots, Purpose purpose, Sink&& sink) const {
  for (int kind = disc_disc + 1; kind < contact_kinds; ++kind) {
    const int count = search_.candidates[kind].count();
    for (int first = 0; first < count; first += TouchBatch::capacity) {
      const int last = std::min(count, first + TouchBatch::capacity);
      TouchBatch& c = kind == disc_wall ? wall_batch_ : flat_batch_;
      if (kind == disc_wall) {
        fill_walls(first, last, y, slots);
        if (purpose == Purpose::observation) c.keep_touching();
      } else {
        fill_flat(static_cast<ContactKind>(kind), first, last, t, y, slots);
      }
      if (c.count == 0) continue;
      gather_springs(c, y, 0);
      apply_law(c, model_of(c), {.returning = Slots::jumping, .all_fields = purpose != Purpose::rates});
      sink(static_cast<const TouchBatch&>(c));
    }
  }
}

template <class Sink>
void Kernel::for_each_touch(double t, const State& y, Sink&& sink) const {
  update_positions(t, y);
  const KeptSlots slots;
  for_each_disc_batch(y, slots, Purpose::observation, [&](const TouchBatch& c, int /*block*/) { sink(c); });
  for_each_flat_batch(t, y, slots, Purpose::observation, sink);
}

// Springs of contacts that another plate feels instead are that plate's.
template <class Slots>
void Kernel::follow_springs(double t, const State& y, Slots& slots, State& dydt) const {
  const Placement now = placement(t, y);
  double* rate = dydt.data() + layout_.first_spring;
  for (const ContactKind kind : {disc_plate, node_plate}) {
    const Candidates& list = search_.candidates[kind];
    for (int k = 0; k < list.count(); ++k) {
      const int own = list.slot[k], leader = own < 0 ? -1 : slot_followed(now, {kind, list.a[k], list.b[k]});
      if (leader < 0) continue;
      for (int n = 0; n < layout_.slot_width; ++n) {
        const int to = own * layout_.slot_width + n, from = leader * layout_.slot_width + n;
        rate[to] = rate[from];
        if constexpr (Slots::jumping) {
          slots.relaxed = slots.relaxed || slots.spring[to] != slots.spring[from];
          slots.spring[to] = slots.spring[from];
        }
      }
    }
  }
}

// The rates, and also(batch, block) for each batch. Contacts other than those of two discs come last and count to the
// first block.
template <class Slots, class Also>
void Kernel::sum_rates(double t, const State& y, Slots& slots, State& dydt, Also&& also) const {
  const Purpose purpose = parts_->keeps_ledger ? Purpose::rates_and_ledger : Purpose::rates;
  const auto add = [&](const TouchBatch& c, int block) {
    also(c, block);
    add_contacts(c, block, t, dydt);
  };
  update_positions(t, y);
  begin_rates(y, dydt);
  for_each_disc_batch(y, slots, purpose, add);
  join_blocks();
  if constexpr (Slots::jumping) assign_slots(y, slots, dydt);
  for_each_flat_batch(t, y, slots, purpose, [&](const TouchBatch& c) { add(c, 0); });
  if (parts_->flush_plates && parts_->friction) follow_springs(t, y, slots, dydt);
  finish_rates(dydt);
}

}  // namespace furrow
