// furrow as an engine that a case is given to, see PROTOCOL.md.
#pragma once

#include <string>

#include "scene/scene.h"
#include "verification/engines/case.h"

namespace furrow::verification {

// What furrow cannot do of a case; empty if it can do all. Throws std::invalid_argument if a key of it is not as the
// protocol says.
std::string lacking(const Json& c);

// The case as a scene; of one that furrow can do.
Scene scene_of_case(const Json& c);

// The answer to a request. The method takes a fixed step; it claims its own order.
Json furrow_answer(const Json& request, const std::string& method);

}  // namespace furrow::verification
