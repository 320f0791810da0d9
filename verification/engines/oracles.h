// What the cases expect, worked out from their parameters by the oracles of the pages of verification/. None of them
// calls the solver.
#pragma once

#include <map>
#include <string>

#include "verification/engines/case.h"

namespace furrow::verification {

// Of an interval its ends.
inline std::string low_of(const std::string& observable) { return observable + ", low"; }
inline std::string high_of(const std::string& observable) { return observable + ", high"; }

// By the name of the observable. Throws std::invalid_argument if the case names an oracle that there is not.
std::map<std::string, double> expected_of(const Json& whole);

// The text of a case file with these values in place of those that it has, twelve digits each, of intervals six.
std::string with_values(const std::string& text, const std::map<std::string, double>& expected);

}  // namespace furrow::verification
