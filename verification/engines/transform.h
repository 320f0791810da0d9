// A case seen from elsewhere: turned, mirrored, or from a frame that moves. Its answer is that of the case itself.
#pragma once

#include <nlohmann/json.hpp>

namespace furrow::verification {

// `view` has the name, title, text and the key `view` of the new case: turn (rad), mirror, drift (m/s). The observables
// are those of `of`, expected to be what the engine itself says of it.
nlohmann::ordered_json seen_from(nlohmann::ordered_json of, const nlohmann::ordered_json& view);

}  // namespace furrow::verification
