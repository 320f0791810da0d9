// Volume V (m^3) and moment of inertia I (kg m^2) of a disc of radius R (m), in its two readings. The paper (README.md)
// does not say which one it uses. The mass is m = density V.
//
//   disc    V = pi R^2 depth
//           I = m R^2/2
//   sphere  V = 4/3 pi R^3
//           I = 2/5 m R^2
#pragma once

#include "physics/constants.h"

namespace furrow {

inline double disc_volume(double radius, double depth) { return pi * radius * radius * depth; }    // m^3
inline double sphere_volume(double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; }   // m^3
inline double disc_inertia(double mass, double radius) { return 0.5 * mass * radius * radius; }    // kg m^2
inline double sphere_inertia(double mass, double radius) { return 0.4 * mass * radius * radius; }  // kg m^2

}  // namespace furrow
