// The page's part about the fault study: which tests notice which faults.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "validation/page/page.h"

namespace furrow::validation {

// Names of those in verification/faults.toml that the study says nothing of: they were added since.
std::vector<std::string> untried_faults(const nlohmann::ordered_json& study);

// `study` is faults.json, see verification/fault_study.
std::string faults_part(const nlohmann::ordered_json& study, Page& page);

}  // namespace furrow::validation
