// Verification cases as data: what is in verification/cases, written out so that any engine can take it.
// The fields are described in PROTOCOL.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::verification {

using Json = nlohmann::ordered_json;

// Of a file of verification/cases: masses worked out, lattices as bodies and springs, materials in pairs, a case that is
// another one seen from elsewhere transformed. `text` is TOML. Throws std::invalid_argument with the name and what is
// wrong.
Json case_from(std::string_view text, const std::string& name);

// As its file has it, nothing worked out.
Json plain_case_from(std::string_view text, const std::string& name);

// The same, its point masses, springs, edges and pairs made anew from its lattices and materials.
Json made_of_lattices(Json c);

const std::vector<std::string>& case_names();  // sorted
Json case_named(const std::string& name);      // throws std::invalid_argument with the nearest name

// The case of that name, else those whose name contains a pattern or of which a pattern is a need; all if there are no
// patterns.
// Throws std::invalid_argument for a pattern that none has.
std::vector<Json> cases_like(const std::vector<std::string>& patterns);

// What an engine gets: the case without its expected values, and N steps in the characteristic time.
Json request_of(const Json& whole, int steps);

// The element of a list of `whole` that has this name. Throws std::invalid_argument.
const Json& named(const Json& whole, const char* list, const std::string& name);

}  // namespace furrow::verification
