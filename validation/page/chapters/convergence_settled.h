// Whether a number of the kept convergence study depends on the step.
#pragma once

#include <string>

#include "validation/studies/convergence.h"
#include "validation/studies/members.h"

namespace furrow::validation {

// Whether the study has all runs of the case; those of a later form are not in one that was kept before.
bool measured(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c);

// Energy that the method or a law made, as a share of what the scene was given; NaN where the run diverged, or where
// the study is of a form that did not book it.
double energy_made(const Numbers& results, const ConvergenceRun& one);

// "the method makes 1.45e+04 times all the energy that the scene was given"; empty where it makes no more than all.
std::string instability_words(const Numbers& results, const ConvergenceRun& one);

// "0.005 ms"
std::string in_ms(double step);

bool failed(const Numbers& results, const ConvergenceRun& one);

// NaN where the run did not get to the end, or does not say.
double value_in(const Numbers& results, const ConvergenceRun& one, const std::string& id);

// Rows of ms and N, where the run got to its end.
Json forces_by_step(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c,
                    const std::string& id);

// The coarsest step from which on every number stays within what chaos or 2 % allow of the finest, and the method makes no
// more than all the energy that there is; NaN: none.
double settled_from(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c,
                    const std::string& id, double spread);

// What a nudge of one body does to it.
double spread_of(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c, const std::string& id);

// "depends on the step: 278 at 0.1 ms, 75.6 at 0.002 ms"; empty if the study does not say.
std::string step_words(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c,
                       const std::string& id);

}  // namespace furrow::validation
