// One fault or constant, tried on the verification tests, and the result in words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verification/fault_study/workshop.h"

namespace furrow::verification {

// Runs the pages whose turn is up to `last`, and those after it one turn at a time until some test fails.
void try_fault(Workshop& workshop, const std::vector<Page>& pages, Turn last, const Change& change,
               nlohmann::ordered_json& result);

// The smallest power of ten that some test notices as a relative change. `pages` is left with the one that noticed last
// in front: it is the likeliest to notice the next change.
void smallest_noticed(Workshop& workshop, std::vector<Page>& pages, const Change& constant,
                      nlohmann::ordered_json& result);

// By the pages, or by the property alone, as far as they were asked.
bool failed(const nlohmann::ordered_json& result);
std::string in_words(const nlohmann::ordered_json& result);

}  // namespace furrow::verification
