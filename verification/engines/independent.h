// An engine that shares nothing with the solver: the laws of PROTOCOL.md written down once more, every pair looked at,
// carried by a stepper of Boost.Odeint. It is there to be compared with, and to be made wrong on purpose.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/engines/case.h"

namespace furrow::verification {

using Numbers = std::vector<double>;
using Rates = std::function<void(const Numbers& y, Numbers& dydt, double t)>;

struct Stepper {
  std::string name;
  int order;  // that it claims
  std::function<void(const Rates& rates, Numbers& y, double t, double h)> step;
};
const std::vector<Stepper>& odeint_steppers();  // rk4, dopri5, euler, heun

// After a step the tangential spring of a contact that slides
enum class AfterSlip {
  returns,  // goes back to where its force is the limit
  holds,    // goes to where its force and the viscous one together are the limit
  stays     // stays as it is
};

// The answer to a request, see PROTOCOL.md.
Json independent_answer(const Json& request, const Stepper& stepper, AfterSlip after = AfterSlip::returns);

}  // namespace furrow::verification
