// A project that uses the installed library: its headers are found, it links, and what it computes is what closed forms
// give.
#include <cmath>
#include <iostream>

#include "examples.h"
#include "output/build_info.h"

bool good(const char* what, double got, double want, double tolerance) {
  std::cout << what << ": " << got << ", expected " << want << '\n';
  return std::fabs(got - want) <= tolerance;
}

int main() {
  std::cout << "furrow " << furrow::build_info().version << '\n';
  // Hertz's impact of a disc, 1 m deep, at 0.1 m/s on a plate of its own material, which is heavy: the greatest overlap
  // is d = (15 m v^2 / (16 E* sqrt R))^(2/5), the force 4/3 E* sqrt(R) d^(3/2).
  const double R = 0.01, E = 2e5 / (2 * (1 - 0.3 * 0.3)), m = 1000 * M_PI * R * R, v = 0.1;
  const double d = std::pow(15 * m * v * v / (16 * E * std::sqrt(R)), 0.4);
  const double F = 4.0 / 3 * E * std::sqrt(R) * std::pow(d, 1.5);
  // Between two steps of a thousandth of the contact's time the force is flat to 1e-5.
  const bool scene = good("largest force [N]", largest_force_on_the_plate(), F, 1e-5 * F);
  // A polynomial of degree 2 is what a method of order 2 integrates exactly, but for rounding, 1000 times 1e-16 of 5 m.
  const bool method = good("fall [m]", fall_by_an_own_method(1e-3), -9.81 / 2, 1e-12);
  // v = g/k (1 - exp(-k t)), k = 2 / s; rk4 at h = 1 ms errs by (k h)^4 / 120 = 1e-13 of it.
  const bool force = good("speed [m/s]", speed_with_an_own_force(), 9.81 / 2 * (1 - std::exp(-2.0)), 1e-11);
  return scene && method && force ? 0 : 1;
}
