// The parts of furrow explain that say which law contacts have.
#pragma once

#include <string>

#include "run/prepare.h"

namespace furrow {

// The options of the law of contacts, of ramps and moment arms, one row each.
void print_options(const Scene& scene, const Parts& parts);

// One pair of materials.
void print_law(const std::string& pair, const ContactLaw& law);

}  // namespace furrow
