// One contact of a disc by its closed form, for tests of the energy ledger.
#pragma once

#include <cmath>
#include <numbers>

namespace furrow::test::ledger {

inline constexpr double modulus = 1e6 / 1.875, shear_modulus = 4e5 / 3.5;  // Pa, E* and G* of the material with itself
inline constexpr double radius = 0.1, overlap = 0.002;                     // m
inline constexpr double mass = 1000 * std::numbers::pi * radius * radius;  // kg
inline constexpr double round_off = 1e-9;  // relative: the overlap is a small difference of larger numbers

// The law for one contact of a disc with its partner, with damping 0.1.
struct Law {
  explicit Law(double reduced_radius, double reduced_mass) {
    elastic = 4.0 / 3 * modulus * std::sqrt(reduced_radius) * std::pow(overlap, 1.5);
    const double normal_stiffness = 2 * modulus * std::sqrt(reduced_radius * overlap);
    stiffness = 8 * shear_modulus * std::sqrt(reduced_radius * overlap);
    viscosity = 2 * std::sqrt(5.0 / 6) * 0.1 * std::sqrt(normal_stiffness * reduced_mass);
    shear_viscosity = 2 * std::sqrt(5.0 / 6) * 0.1 * std::sqrt(stiffness * reduced_mass);
  }
  double elastic, stiffness, viscosity, shear_viscosity;  // N, N/m, N s/m
};

}  // namespace furrow::test::ledger
