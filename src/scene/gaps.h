// Between the points of a lattice's border that discs touch.
#pragma once

#include <string>

#include "scene/scene.h"

namespace furrow {

double half_gap(const Lattice& l);  // m, between two points at the start; 0 where the whole border is touched

// What to do where discs of this radius pass between the points; empty if they do not.
std::string way_through(const Lattice& l, double radius);

}  // namespace furrow
