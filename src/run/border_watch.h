// Which centres cross the border of a lattice, whether or not they touch it: between the points that discs touch a small
// one passes without a force, and where a link of the border has torn any does, unless the scene has `new_faces`.
//
// Pairs of a disc and a segment that are close are collected, and asked at each step whether the one crossed the other
// while whole. In a step that moves no body further than m a pair comes closer by no more than 2 m: pairs are collected
// again before these ways add up to the reach that they were collected with, so none is missed.
#pragma once

#include <string>
#include <vector>

#include "run/step.h"

namespace furrow {

// "disc 3 and lattice 0, through its torn border"
std::string through_torn_border(const System& system, const ContactId& contact);

class BorderWatch {
 public:
  explicit BorderWatch(const System& system);

  // Of each disc that crossed a border in the step, once a lattice, ascending. `border_is_new`: since the step before
  // other segments are touched than before.
  const std::vector<ContactId>& crossings(const Step& step, bool border_is_new);

  // The same through segments that have torn, in the step that crossings() was asked for last.
  const std::vector<ContactId>& through_torn() const { return through_torn_; }

 private:
  struct Pair {
    int disc, segment;
    auto operator<=>(const Pair&) const = default;  // NOLINT(modernize-use-nullptr): of clang-tidy 14
  };
  void collect(double t, const State& y);

  const System& system_;
  double drive_speed_ = 0;  // m/s, of the fastest driven nodes
  double least_reach_ = 0;  // m, an eighth of the smallest radius
  double reach_ = 0;        // m, of the pairs
  double way_ = 0;          // m, by which pairs may have come closer since
  bool collected_ = false;
  std::vector<Pair> near_;
  std::vector<ContactId> crossed_, through_torn_;
};

}  // namespace furrow
