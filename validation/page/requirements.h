// What the checks are for.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/page/page.h"

namespace furrow::validation {

// A folded table, one row a requirement with an id of its own: how many checks bear it out, how many failed, and on which
// pages of verification/. checks: the list of checks.json.
std::string requirements_table(const nlohmann::ordered_json& checks, Page& page);

}  // namespace furrow::validation
