// Batches of contacts whose law has options that the vectors do not carry: the reference's function contact_force, one
// contact after the other.
#pragma once

#include "kernel/loops.h"
#include "system/layout.h"

namespace furrow {

// As `evaluate`, with all fields.
void evaluate_with_options(TouchBatch&, const Parts&, bool returning);

// As `gather_springs`, also the turns of rolling springs and the inertias against rolling.
void gather_slots(TouchBatch&, const Parts&, const Layout&, const State& y);

// The rates of the springs, into the rates of the state.
void scatter_spring_rates(const TouchBatch&, const Parts&, const Layout&, State& dydt);

// As `scatter_returned`.
Returned scatter_returned_slots(const TouchBatch&, const Layout&, State& y);

// As `add_powers`.
void add_powers_with_options(const TouchBatch&, const Parts&, ContactPowers&);

// J: adds the heat of the springs that a jump has returned, contact by contact, and that of rolling springs.
void add_sliding_heat(const TouchBatch&, const Parts&, double& sum);
void add_rolling_heat(const TouchBatch&, const Parts&, double& sum);

}  // namespace furrow
