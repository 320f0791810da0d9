// Whether a case follows the protocol, as far as furrow reads it.
#pragma once

#include "verification/engines/case.h"

namespace furrow::verification {

// Throws std::invalid_argument that names the first key that is missing, of another type or out of range.
void require_needs(const Json& c);
void require_fields(const Json& c);

}  // namespace furrow::verification
