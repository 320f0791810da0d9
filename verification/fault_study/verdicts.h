// What the fault study writes down: faults.json.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/numbers.h"
#include "verification/fault_study/workshop.h"

namespace furrow::verification {

inline constexpr const char* turn_names[] = {"always", "methods", "costly"};

struct Tried {
  Maker maker;                                // commit that the faults were tried on, sources that decide
  std::vector<std::string> names;             // of all faults, in their order
  std::vector<Page> pages;                    // that ran
  std::map<std::string, std::string> silent;  // tests that notice nothing: why
  std::vector<nlohmann::ordered_json> results;
};

Maker maker_of_verdicts(const std::filesystem::path& tree);

// `earlier`: verdicts of faults that were not tried now; those that faults.toml no longer names are dropped. Each names its
// maker in the list "makers", and one that the property noticed, its "property_maker".
nlohmann::ordered_json report_of(const Tried& tried, const nlohmann::ordered_json& earlier);

// The earlier report with what the property noticed; it has a verdict on each fault.
nlohmann::ordered_json with_property(const Tried& tried, nlohmann::ordered_json earlier);

}  // namespace furrow::verification
