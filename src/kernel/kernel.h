// The fast solver: neighbour lists, contacts in blocks evaluated at the widest vectors, threads. The reference judges
// it, to the bit.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "kernel/loops.h"
#include "kernel/parallel.h"
#include "kernel/search.h"
#include "system/solver.h"
#include "system/survey.h"

namespace furrow {

// Its const functions work in rooms of the kernel, one caller at a time: others wait. flow and jump are for the default
// floating-point environment: rounding to nearest, no traps (see floating_point.h).
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
  bool preparing() const override { return preparing_; }
  void prepare(bool preparing) override { preparing_ = preparing; }
  void watch(bool watched) override { watched_ = watched; }
  Survey& survey() override { return survey_; }
  int threads() const override { return threads_; }

  const NeighbourSearch& search() const { return search_; }

  // Calls sink(block) for the contacts that touch, kind by kind, sorted by pair, with the forces of the contact law.
  template <class Sink>
  void for_each_touch(double t, const State& y, Sink&& sink) const;

 private:
  // Slots for tangential springs that no contact holds; the last one is taken next.
  struct Slots {
    std::vector<int> unused;
    std::uint32_t now = 0;                   // number of this jump; the first is 1, so that 0 is no jump
    std::vector<std::vector<int>> changing;  // by chunk: first pairs of blocks where one takes or gives back a slot
    Kernel* kernel = nullptr;                // in a jump
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
    return {&parts_->law[one_law ? law : 0], one_law, parts_->rolling, parts_->rolling_smoothing};
  }
  ContactModel model_of_pairs() const { return model(law_of_pairs_ >= 0, law_of_pairs_); }
  ContactModel model_of(const TouchBlock& c) const {
    return model(std::equal(c.law.begin() + 1, c.law.begin() + c.count, c.law.begin()), c.law[0]);
  }
  int spare_of(int chunk) const { return layout_.spring_count + chunk; }
  void empty_spares(State& of) const { std::fill_n(of.begin() + layout_.first_dummy(), layout_.dummy_slots, 0.0); }
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
  void grow_slots(int wanting);
  void return_springs(double t, State& y, JumpReport& report);
  double lattice_contact_energy(double t, const State& y) const;
  void begin_survey();
  void survey_block(const TouchBlock& block, int chunk);
  static Contact contact_of(const TouchBlock& block, int k);
  void finish_survey();
  void tear_links(double t, State& y, JumpReport& report);

  bool preparing_ = false;
  int threads_ = 1;
  bool alike_ = false;                                           // all discs have the same radius, mass and material
  int law_of_pairs_ = -1;                                        // if all discs have the same material
  std::vector<double> inverse_mass_, inverse_inertia_, weight_;  // by body

  std::vector<char> torn_;
  std::vector<int> intact_;  // links, ascending
  Slots slots_;
  State rates_;                         // room for those that a jump leaves
  std::vector<double> chunk_returned_;  // J, freed by a jump, chunk by chunk
  bool watched_ = false;
  Survey survey_;
  std::vector<ContactExtremes> chunk_seen_;

  // A copy has a lock of its own.
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
  mutable std::vector<double> node_fx_, node_fy_;
  mutable std::vector<DiscRow> disc_row_;
  mutable std::vector<DiscLoad> disc_load_;          // of each disc, then each spill
  mutable std::vector<ContactPowers> chunk_powers_;  // of the pairs of each chunk; the first takes all in the end
  mutable std::vector<TouchBlock> disc_block_;       // one for each thread
  mutable TouchBlock wall_block_, flat_block_;
};

// Of a solver that is one; throws std::bad_cast if it is not.
inline const Kernel& kernel_of(const Solver& solver) { return dynamic_cast<const Kernel&>(solver); }

// Calls sink(block, chunk), for different chunks at once unless an onlooker asks.
template <class Sink>
void Kernel::for_each_disc_block(const State& y, Slots* slots, Asker asker, Sink&& sink) const {
  const ContactModel model = model_of_pairs();
  const int chunks = static_cast<int>(search_.chunks.size());
  if (slots) slots->changing.resize(search_.chunks.size());
  in_parallel(asker == Asker::onlooker ? 1 : threads_, chunks, [&](int number, int thread) {
    const Chunk& chunk = search_.chunks[number];
    TouchBlock& c = disc_block_[thread];
    if (slots) slots->changing[number].clear();
    int spill = parts_->disc.count() + chunk.first_spill;
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
void Kernel::for_each_flat_block(double t, const State& y, Slots* slots, Asker asker, Sink&& sink) const {
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
void Kernel::for_each_touch(double t, const State& y, Sink&& sink) const {
  look_around(t, y);
  for_each_disc_block(y, nullptr, Asker::onlooker, [&](const TouchBlock& c, int /*chunk*/) { sink(c); });
  for_each_flat_block(t, y, nullptr, Asker::onlooker, sink);
}

// The rates, and also(block, chunk) of each block; those that are of no chunk count to the first, after all others.
template <class Also>
void Kernel::add_up(double t, const State& y, Slots* slots, State& dydt, Also&& also) const {
  const Asker asker = parts_->keeps_ledger ? Asker::ledger : Asker::rates;
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
