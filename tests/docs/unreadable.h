// A header whose comment Doxygen cannot read: the check of the public headers must notice it.
#pragma once

// Holds a <name> that is no tag.
struct Unreadable {
  int number;  // see \nothing
};
