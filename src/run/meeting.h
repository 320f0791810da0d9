// Whether two parts of a scene met in a step that was too long for them: straight paths between two states.
#pragma once

#include <string>

#include "run/step.h"

namespace furrow {

struct Unseen {
  std::string what{};  // empty: nothing
  int body = -1;       // one of the two
};

// Two parts that moved against each other in the step by more than the smaller one's size and touched at one of its
// ends or on the straight way between: their contact was not seen as it was. Or two linked nodes that moved against
// each other by more than their spacing. What moves together, or far from all else, may go as far as it likes.
Unseen unseen_meeting(const System& system, const Step& step);

}  // namespace furrow
