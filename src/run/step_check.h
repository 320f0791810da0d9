// Whether an accepted step went too far for its contacts to be seen.
#pragma once

#include <string>

#include "run/step.h"

namespace furrow {

// Its states are finite, no contact was passed unseen (meeting.h), no plate skipped a body.
class StepCheck {
 public:
  explicit StepCheck(const System& system);

  // Empty if the step is sound; else why not, and `body` is the one that went too far, if any.
  std::string complaint(const Step& step, int& body) const;

 private:
  std::string not_finite(const Step& step, int& body) const;
  std::string over_a_plate(const Step& step, int& body) const;
  bool within_half_a_size(const Step& step) const;

  const System& system_;
  double least_size_ = infinity;    // m, of a disc's radius or a lattice's spacing
  double quarter_side_ = infinity;  // m, a quarter of the smallest side of a plate
  double plate_speed_ = 0;          // m/s, of the fastest
};

}  // namespace furrow
