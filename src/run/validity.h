// Whether a run stays where its laws and its method are valid: watched at every accepted step.
//
//   watch            measured                                                     warns above   ends the run above
//   energy_made      residual of the ledger and heat that was taken back, or what      0.01            0.1
//                    there is beyond what was given; of all that the scene was given,
//                    but for discs that have met nothing
//   energy_lost      the residual, where energy is missing                                0.01            1
//   overlap          of the smaller radius                                            0.1             1
//   behind_walls     discs whose centres are behind a wall, at once                    0              0
//   through_plates   centres that crossed the middle of a plate                        0              0
//   through_lattices centres that crossed a whole border segment                       0              0
//   crossing_lattices pairs of border segments that cross, of two lattices or of one,   0               -
//                    which do not touch each other, and cells that are inside out or
//                    folded over; or nodes that have crossed another lattice's border;
//                    or border segments that go through a plate, from side to opposite side;
//                    or bodies that go through a torn border
//   impact           energy of a contact, of what carries the one through the other   1               -
//   step             step, of the largest stable one at the contacts that are there   0.5             -
//   arrival          step, of the largest stable one in an impact at the greatest      1              -
//                    speed that there is
//
// Overlap: at 0.1 a contact is 0.3 radii wide, too wide for Hertz's half-space; at 1 a centre reaches the other's
// surface. Energy: a ledger closes to the error of the method; if a tenth of all energy is made by the method, the run
// means nothing. What a scene allows (Scene::allow) neither warns nor ends a run up to there; beyond, the run ends.
// Energy is looked at at each step of up to 8 bodies, at every n-th of n + 7, at every 200th at least, and at the end:
// what was made for good stays in the residual, and of what comes and goes within a contact one of n pairs has an n-th. So
// in a large scene the worst within a contact may lie between two looks. Every 25 steps at least once there was a warning,
// and in the first 200, where only what ends a run is judged. Crossing lattices every 50 steps, and whenever something may
// have moved by a quarter of a spacing, or of a plate's size, since; lattices that pass each other at each step; the step
// when contacts have come or deepened by a tenth and the fastest rate has grown by a quarter, and once at the end by the
// fastest that there was; all else at each step.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "run/border_watch.h"
#include "run/cut_lattices.h"
#include "run/idle_discs.h"
#include "run/observe.h"

namespace furrow {

enum class WatchKind {
  energy_made,
  energy_lost,
  overlap,
  behind_walls,
  through_plates,
  through_lattices,
  crossing_lattices,
  impact,
  step,
  arrival
};
inline constexpr int watch_kinds = 10;

enum class Verdict { not_watched, kept, allowed, warned, broken };
const char* to_string(Verdict verdict);

struct Watched {
  const char* name = "";
  double warns_above = 0, ends_above = 0;  // ends: infinity, it does not
  std::optional<double> allowed{};         // up to here
  bool watched = true;
  double worst = 0;
  double time = 0;  // s, of the worst
  std::string where;
  long times = 0;  // checks at which it was above the warning limit
  Verdict verdict() const;
  void history(HistoryVisitor& visit);
};

// Up to where a scene allows it; none if it says nothing of it.
std::optional<double> allowed_by(const Scene& scene, WatchKind kind);

// The greatest of all steps.
struct RunExtremes {
  struct PlateForce {
    double force = 0, fx = 0, fy = 0;  // N
    double time = 0;                   // s
  };
  std::vector<PlateForce> plate;
  double speed = 0, speed_time = 0;  // m/s, of a disc or node; s
  std::string fastest;
  void history(HistoryVisitor& visit);
};

class Validity {
 public:
  using Warn = std::function<void(const std::string&)>;
  Validity(System& system, const Scene& scene, Warn warn);
  ~Validity();
  Validity(const Validity&) = delete;
  Validity& operator=(const Validity&) = delete;

  // After each accepted step, or the start (h = 0), and its jump.
  void see(const Step& step, const JumpReport& report);

  // Checks the energy at the end of what was seen; `seen` is of the state at t.
  void book(double t, const Observation& seen);

  // Checks the energy that an observer has computed on the way, as it is checked at every n-th step.
  void judge_row(double t, const Observation& seen);

  // At the end of the run: judges what was postponed.
  void conclude();

  void history(HistoryVisitor& visit);

  // Why the run should end; empty if it need not.
  const std::string& failure() const { return failure_; }

  const std::array<Watched, watch_kinds>& watches() const { return watch_; }
  const RunExtremes& extremes() const { return extremes_; }
  const Energies& start() const { return start_; }

 private:
  Watched& of(WatchKind kind) { return watch_[static_cast<std::size_t>(kind)]; }
  // Keeps the worst.
  template <class Where>
  void look(WatchKind kind, double t, double value, const Where& where);
  // Warns once, and fails the run once.
  void say(WatchKind kind, Verdict verdict);
  void look_at_energy(const Step& step);
  // Early, what a first-order method is off in its n-th step, 1/n of what came since the start, ends no run (twice that is
  // taken off), and is not yet worth a warning. What plates do
  // in the step in which they touch the method cannot know yet.
  bool is_early() const;
  void judge_energy(double t, const Observation& seen, bool early);
  // Sets how far the survey looks: a centre that is closer to a plate may reach it in a step, or in the next one at twice
  // the speed.
  void look_at_speed(const Step& step);
  void look_at_contacts(double t, const Survey& survey);
  void look_at_plates(double t, const Survey& survey);
  void look_for_crossings(const Step& step, const JumpReport& report);
  void look_at_borders(const Step& step);
  // Again when contacts have come or deepened: the spectrum changes with how many there are and how deep.
  void look_at_step(const Step& step, const Survey& survey);
  void judge_step();
  void look_at_arrival(double t);

  System& system_;
  const Scene& scene_;
  Warn warn_;
  std::array<Watched, watch_kinds> watch_;
  RunExtremes extremes_;
  std::string failure_;
  double step_;             // s, the largest that the method takes
  double plate_speed_ = 0;  // m/s, of the fastest
  bool started_ = false;
  Energies start_;
  IdleDiscs idle_;
  const State* state_ = nullptr;  // of the run, which outlives it; it stands where it was seen last
  double supplied_ = 0;           // J, the most so far, of what has met something
  double all_supplied_ = 0;       // J, with the discs in free flight
  double most_lost_ = 0;          // J, heat and the like, so far
  double plate_power_ = 0;        // W, of the last step
  long since_booked_ = 0;         // steps
  long balanced_steps_ = 0;       // since the start
  long balance_every_ = 1;        // steps
  BorderWatch border_;
  long since_crossed_ = 0;                                       // steps
  double way_since_crossed_ = 0;                                 // m, of the fastest
  double least_spacing_ = infinity;                              // m, of a lattice
  double least_crossing_ = least_crossing_way(system_.parts());  // m, the least way on which a crossing can be seen
  int passed_ = 0;                                               // nodes that crossed another lattice's border, so far
  double stepped_overlap_ = 0, stepped_contacts_ = 0;            // when the step was looked at last
  struct Stiffest;
  std::unique_ptr<Stiffest> stiffest_;  // that there was, and by which the step was judged
  double arrival_speed_ = 0;            // m/s, the same
};

}  // namespace furrow
