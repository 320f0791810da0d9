// The tables of the order certificate.
#pragma once

#include <string>
#include <vector>

#include "verification/studies/order_figures.h"

namespace furrow::verification {

std::string with_error(const Slope& slope);  // "1.98 ± 0.01"
std::string in_short(const Slope& slope);    // "1.98(1)": the standard error in units of the last digit

// Points as they are kept between runs.
Json to_json(const std::vector<Point>& points);
std::vector<Point> to_points(const Json& rows);

// s of error = C tolerance^s, of a controlled method.
Slope exponent_of(const Observations& all, const std::string& method, const std::string& problem);

void kinds_table(Report& report);
void controlled_table(Report& report, const Observations& all);
// Cured orders: steps that end at the touch, and grow from there.
void cure_table(Report& report, const Observations& all);
void trends_table(Report& report, const Observations& all);

}  // namespace furrow::verification
