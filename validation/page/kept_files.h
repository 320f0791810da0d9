// What is kept beside the studies, checks.json, faults.json and judgements.json, as numbers: so their age is told in the same way.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "validation/page/evidence.h"

namespace furrow::validation {

// A result for each fault, named as the list has it, and one more "NAME by property" where the kernel was also held
// against the reference alone.
Numbers numbers_of_faults(const nlohmann::ordered_json& kept);
Age age_of_faults(const nlohmann::ordered_json& kept);

// A result for each "ENGINE, METHOD: CASE"; its value says what decides it.
Numbers numbers_of_judgements(const nlohmann::ordered_json& kept);
Age age_of_judgements(const nlohmann::ordered_json& kept);

// A result for each check of verification, by its place in the list; what decides a fault's verdict decides it.
Numbers numbers_of_checks(const nlohmann::ordered_json& kept);
Age age_of_checks(const nlohmann::ordered_json& kept);

struct KeptFile {
  std::string id, title, made_by;  // its part of the page, the command that makes it
  std::size_t entries = 0;         // checks, faults, engines
  Numbers numbers;
  Age age;
};

// Of what was asked for and can be shown.
std::vector<KeptFile> kept_files(const Evidence& evidence);

}  // namespace furrow::validation
