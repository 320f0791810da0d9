// Whether an accepted step went too far for its contacts to be seen.
#pragma once

#include <string>
#include <vector>

#include "run/step.h"

namespace furrow {

// What moves further than its size in a step passes contacts unseen, if there is something to meet: the step is too
// long, or the run has blown up.
class StepCheck {
 public:
  explicit StepCheck(const System& system);

  // Empty if the step is sound; else why not, and `body` is the one that went too far, if any.
  std::string complaint(const Step& step, int& body) const;

 private:
  std::string not_finite(const Step& step, int& body) const;
  std::string over_a_plate(const Step& step, int& body) const;
  bool within_its_size(const Step& step) const;
  bool driven_within_a_disc(const Step& step) const;

  const System& system_;
  std::vector<double> size_;        // m, by body: how far it may move whatever is near
  double quarter_side_ = infinity;  // m, a quarter of the smallest side of a plate
  double least_size_ = infinity;    // m
  double plate_speed_ = 0;          // m/s, of the fastest
  double least_radius_ = infinity;  // m
};

}  // namespace furrow
