// Hertz's impact in closed form. Equations: hertz_wall.cpp.
#pragma once

#include <cmath>

namespace furrow::verification {

// m* d'' = -K d^(3/2), d(0) = 0, d'(0) = v. From the energy m* v^2/2 = 2/5 K d^(5/2); the contact lasts
// 2 int dd / d' = (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) d_max/v.
struct Hertz {
  double mass;       // kg, m*
  double stiffness;  // N/m^(3/2), K = 4/3 E* sqrt(R*)
  double speed;      // m/s, v
  double peak_overlap() const { return std::pow(5 * mass * speed * speed / (4 * stiffness), 0.4); }
  double peak_force() const { return stiffness * std::pow(peak_overlap(), 1.5); }
  double contact_time() const {
    return 0.8 * std::sqrt(3.14159265358979323846) * std::tgamma(0.4) / std::tgamma(0.9) * peak_overlap() / speed;
  }
};

// K from the softness of both bodies together and R*.
inline double hertz_stiffness(double softness, double radius) { return 4.0 / 3.0 / softness * std::sqrt(radius); }

}  // namespace furrow::verification
