// data.lammps: the bodies at t = 0, the links, constant loads.
#pragma once

#include <string>

#include "export/kinds.h"
#include "run/prepare.h"

namespace furrow {

std::string data_file(const Prepared& prepared, const AtomKinds& kinds);

// Whether some node carries a load: then each atom has one.
bool has_loads(const Parts& parts);

}  // namespace furrow
