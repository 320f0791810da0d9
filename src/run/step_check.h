// Whether an accepted step went too far for its contacts to be seen.
#pragma once

#include <string>
#include <vector>

#include "run/step.h"

namespace furrow {

// A body that moves further than its size in a step, or a node further than the radius of the smallest disc where a disc
// is near, passes contacts unseen: the step is too long, or the run has blown up.
class StepCheck {
 public:
  explicit StepCheck(const System& system);

  // Empty if the step is sound; else why not, and `body` is the one that went too far, if any.
  std::string complaint(const Step& step, int& body) const;

 private:
  std::string too_far(const Step& step, bool finite, int& body) const;
  std::string driven_too_far(const Step& step) const;
  std::string over_a_plate(const Step& step, int& body) const;
  bool none_beyond_its_size(const Step& step) const;
  bool none_beyond_what_it_may_meet(const Step& step) const;
  bool meets_no_disc(const Step& step, std::size_t i) const;
  double distance(const Step& step, std::size_t i) const;

  const System& system_;
  std::vector<double> size_;        // m, by body: how far it may move where it may meet anything
  std::vector<double> spacing_;     // m, of the lattice of each body that is a node
  double quarter_side_ = infinity;  // m, a quarter of the smallest side of a plate
  double least_size_ = infinity;    // m
  double plate_speed_ = 0;          // m/s, of the fastest
  double least_radius_ = infinity;  // m
};

}  // namespace furrow
