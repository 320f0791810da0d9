// Whether two parts of a scene met in a step that was too long for them: straight paths between two states.
#pragma once

#include <string>

#include "run/step.h"

namespace furrow {

struct Unseen {
  std::string what{};  // empty: nothing
  int body = -1;       // one of the two
};

// Two parts whose contact the step was too long for, seen on the straight way between its ends: they touched at its
// start, and the depth of their contact changed by more than the smaller one's size; or they were deeper in each other
// on the way than at its ends, by more than a tenth of that. Or two linked nodes that moved against each other by more
// than their spacing. What moves together, past each other or far from all else may go as far as it likes.
Unseen unseen_meeting(const System& system, const Step& step);

}  // namespace furrow
