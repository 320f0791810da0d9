// The solver in its simplest cases, as numbers to be drawn beside closed forms and beside what others have published.
#pragma once

#include <string>
#include <vector>

#include "report/measurement.h"

namespace furrow::verification {

// ---- a disc of the paper runs into a wall, by damping factors ----

// Of {"peak": force, "rows": [overlap, force]}; in units of the impact, see damped_hertz.h.
std::string loop_key(double damping_factor);
const std::vector<double>& loop_dampings();

// ---- a mass on a spring, by methods of fixed steps ----

inline constexpr double phase_angle = 0.5;  // rad, h omega
inline constexpr int phase_steps = 63;      // five periods
const std::vector<std::string>& phase_methods();
// Rows [x, v], in units of x(0) and of omega x(0).
std::string phase_key(const std::string& method);

// ---- a clamped lattice ten times as long as high, pushed at its end, by cells through its height ----

inline constexpr double slenderness = 10;
const std::vector<int>& bent_cells();
// Rows [x/L, deflection]; in units of Timoshenko's deflection of the end.
std::string bent_key(int cells);

// ---- published impacts ----

// Test 1 of Chung and Ooi 2011, Granular Matter 13, 643: two spheres of glass. {"overlap": m, "force": N, "time": s}.
inline const std::string glass_key = "spheres of glass";

// Test 4: a sphere of aluminium oxide strikes a plane at 3.9 m/s. Spin afterwards, rad/s.
std::string oblique_key(double angle);
std::vector<double> oblique_angles();  // degrees from the normal: the published ones among them

struct PublishedSpin {
  double angle, spin;  // degrees from the normal, rad/s
};
// The figure of Chung and Ooi, as the benchmarks of Kratos have read it off.
const std::vector<PublishedSpin>& computed_by_others();
// Kharaz, Gorham and Salman 2001, Powder Technology 120, 281, as case DEM05 of MFiX has read it off.
const std::vector<PublishedSpin>& measured_spins();

void measure_responses(Measurement& measurement);

}  // namespace furrow::verification
