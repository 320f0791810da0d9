// How an elastic impact grows with its speed, over six decades.
//
//   d_max ~ v^(4/5),  F_max ~ v^(6/5),  t_c ~ v^(-1/5)
//
// Source: dimensional analysis of m d'' = -K d^(3/2); Hertz 1882. Sphere of glass, radius 0.01 m, on a rigid wall.
#include "verification/impact.h"

namespace furrow::verification {
namespace {

constexpr double radius = 0.01;  // m
constexpr int steps = 400;       // in a contact time, at every speed: then the truncation is the same fraction at all

TEST(HertzScaling, ExponentsOverSixDecadesOfSpeed) {
  requirement("normal.scaling");
  const double mass = mass_of(glass, radius, DiscMass::sphere);
  std::vector<double> speeds, overlaps, forces, times;
  for (int decade = -4; decade <= 2; ++decade) {
    const double v = std::pow(10.0, decade);  // m/s
    const Hertz h{mass, hertz_stiffness(softness(glass), radius), v};
    const Impact got = measure(wall_impact(glass, radius, v, DiscMass::sphere, true), mass,
                               {"rk4", h.contact_time() / steps, 1.1 * h.contact_time()});
    speeds.push_back(v);
    overlaps.push_back(got.peak_overlap);
    forces.push_back(got.peak_force);
    times.push_back(got.contact_time);
  }
  // The truncation is the same fraction everywhere and falls out of the slope. What is left is round-off: at 1e-4 m/s
  // d_max is 1e-6 R, so that each overlap is off by 1e-10 of it; that averages out over the steps and over the fit.
  const auto noise = [](double value) { return absolute(value, "round-off, averaged; measured, times about four"); };
  expect("exponent of the greatest overlap", fitted_slope(speeds, overlaps), 0.8, noise(1e-12));
  expect("exponent of the greatest force", fitted_slope(speeds, forces), 1.2, noise(1e-12));
  expect("exponent of the contact time", fitted_slope(speeds, times), -0.2, noise(3e-14));
}

}  // namespace
}  // namespace furrow::verification
