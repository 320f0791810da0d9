// What the steppers of Boost.Odeint carry from one step to the next. Boost 1.74 keeps that private and has no way to
// write it down. To keep it outside would take the same methods once more, to be verified, with bits of their own.
//
// Access is checked wherever a member is named but in an explicit instantiation (C++20, [temp.spec.general]/6): its
// argument may point to a private member, and a friend defined there hands that out. Where another Boost has another
// name or type, this does not compile.
#pragma once

#include "system/history.h"

namespace furrow {

template <class Stepper, class Member, Member Stepper::*place, class Name>
struct Revealed {
  friend Member& reveal(Stepper& stepper, Name) { return stepper.*place; }
};

// reveal(stepper, Name{}) is stepper.member from here on.
// NOLINTBEGIN(bugprone-macro-parentheses): types and members cannot stand in parentheses
#define FURROW_REVEAL(Stepper, Member, member, Name) \
  Member& reveal(Stepper&, Name);                    \
  template struct Revealed<Stepper, Member, &Stepper::member, Name>
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace furrow
