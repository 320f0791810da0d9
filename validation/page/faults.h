// The page's part about the fault study: which tests notice which faults.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/page/page.h"

namespace furrow::validation {

// `study` is faults.json, see verification/fault_study.
std::string faults_part(const nlohmann::ordered_json& study, Page& page);

}  // namespace furrow::validation
