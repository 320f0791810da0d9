// What changes in a scene besides the flat state: which links are torn, which contact holds which tangential spring,
// which body keeps which face of a plate (system/held_faces.h).
//
// The life of a tangential spring. A contact gets a slot, a place for its spring in the state, with xi = 0, at the
// first jump that finds its gap below Parts::margin, as a rule before it touches; a faster pair has no spring until the
// next jump. run() jumps at its start too. While the two touch, xi' = vt (or as physics/rescaled_mindlin.h has it);
// while they do not, xi' = 0. After each accepted step a jump limits |xi| as physics/damping.h has it, and sets xi of
// an open contact to zero. So a contact that opens and closes within one step keeps its spring, unless events are
// located (run/events.h). It is one spring for a disc and a plate or lattice, whichever face or segment is the nearest:
// xi goes on along the new tangent. A multistep method keeps its history when a spring is shortened, so its next step
// may still carry the old slip. A contact that has been further away than the margin for more than `quiet_jumps` jumps,
// and touched within no step between them, gives its slot back: longer than the history of any multistep method, so
// that nothing that it remembers of the old contact reaches the new one. A contact without a slot has no spring: xi =
// 0. Slots are a stack: the one given back last is taken next.
#pragma once

#include <cstdint>
#include <vector>

#include "system/contact.h"
#include "system/held_faces.h"
#include "system/history.h"
#include "system/layout.h"

namespace furrow {

inline constexpr std::uint32_t quiet_jumps = 8;

// Together with a state, the method's history and a time it continues the equations in another system of the same scene.
// To continue a run to the bit takes its place in the schedule and the memory of its events and watches too: a
// checkpoint has them all (output/run_checkpoint.h).
struct DiscreteState {
  struct Held {
    int kind, a, b, slot;
    std::uint32_t near_at;  // jump at which the two were last closer than the margin
  };
  std::vector<int> torn;      // links, ascending
  std::vector<Held> held;     // contacts that hold a slot, sorted by (kind, a, b)
  std::vector<int> unused;    // slots, the next one last
  std::uint32_t jumps = 0;    // that handed out slots: all, if there is friction
  bool preparing = false;     // plates stand still and links do not tear
  HeldFaces faces{};          // of plates, that bodies keep
  std::vector<int> border{};  // segments that discs touch, ascending: it follows from the torn links
  int spring_count() const { return static_cast<int>(held.size() + unused.size()); }
  void history(HistoryVisitor& visit);
};

// Of a scene at t = 0: nothing is torn but notches, nothing is held.
DiscreteState initial_discrete_state(const Parts& parts, const Layout& layout);

bool is_torn(const DiscreteState& discrete, int link);
int slot_of(const DiscreteState& discrete, const ContactId& contact);  // -1: none

// Whether every slot is held once or unused, every pair is possible, and links and held faces ascend.
bool belongs_to(const DiscreteState& discrete, const Parts& parts);

struct Tear {
  double time;  // s
  int link;
  double force;  // N, spring force that exceeded the strength
};

struct Survey;

// What a jump changed. A multistep method keeps its history unless the right-hand side has jumped.
struct JumpReport {
  std::vector<Tear> torn;
  bool springs_changed = false;
  Growth grown;                    // of the state, for new contacts
  const Survey* survey = nullptr;  // of the state after the jump but before links tear; if it was asked for
  State* rates = nullptr;          // of the state after the jump, if known: a buffer of the solver, to be swapped
  bool flow_jumped() const { return !torn.empty(); }
};

}  // namespace furrow
