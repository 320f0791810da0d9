// Where within a step the first link tears.
//
// A method that learns of a tear only after its step is of first order in all that follows, whatever its own order: the
// link has held up to h too long. Between the two ends of the step the state is Hermite's cubic through both states and
// both rates, which is of order 4; the tear is found on it by bisection of the greatest load, and the rest of the step
// is given back. Source: Hairer, Norsett and Wanner, Solving ODEs I, II.6.
#pragma once

#include "system/system.h"

namespace furrow {

// Spring force over strength of the link that is nearest to its tear; above 1 the next jump tears it.
double greatest_load(const System& system, const State& y);

// Takes y (at time `reached`) back to the first tear on the way from `before` (at t), and returns its time; leaves both
// if no link tears. No link may be overloaded at t. Two evaluations for each tear. Uses only + - * / and comparisons.
double go_back_to_first_tear(const System& system, double t, const State& before, double reached, State& y);

}  // namespace furrow
