// The figures and tables of the order certificate.
#pragma once

#include <string>

#include "report/study.h"
#include "scene/wording.h"
#include "verification/studies/order.h"

namespace furrow::validation {

std::string shown_order(double order);                     // 2, 2.5, 1.25
std::string with_error(const verification::Slope& slope);  // "1.98 ± 0.01"
std::string in_short(const verification::Slope& slope);    // "1.98(1)": the standard error in units of the last digit

// Method by force: observed above predicted order, coloured by the observed one.
Figure matrix_figure(const verification::Observations& all, bool of_velocity);
// Error against step, a panel for each force, for the methods that a scene would use.
Figure slopes_figure(const verification::Observations& all);
// Change of energy a period against h omega.
Figure energy_figure(const verification::Observations& all);

void kinds_table(Report& report);
void controlled_table(Report& report, const verification::Observations& all);
// Cured orders: steps that end at the touch, and grow from there.
void cure_table(Report& report, const verification::Observations& all);
void trends_table(Report& report, const verification::Observations& all);

}  // namespace furrow::validation
