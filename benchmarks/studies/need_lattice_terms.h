// What a lattice may have that those of the paper do not, each in the place of what they have.
#pragma once

#include "benchmarks/studies/need_terms.h"

namespace furrow::benchmarks {

std::vector<Term> lattice_terms();

}  // namespace furrow::benchmarks
