// What run.json says of a watch over a run: the section "validity", and the greatest of all steps.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "run/validity.h"

namespace furrow {

// "verdict": the worst of all; then each watch: worst value, what it warns and ends above, what the scene allows, when,
// where, how often. Limits that do not exist are null.
nlohmann::ordered_json validity_json(const Validity& validity);

// "largest_force": of each plate; "greatest_relative_overlap", "greatest_speed".
void add_extremes(nlohmann::ordered_json& json, const Validity& validity, const Scene& scene);

}  // namespace furrow
