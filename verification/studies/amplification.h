// What a method makes of a linear system y' = J y in one step: its amplification, by running the method's own step, and
// the steps at which it grows.
//
//   [y, memory]_(n+1) = M(h J) [y, memory]_n,   stable if no eigenvalue of M is larger than one
//
// Any method of the catalogue that takes fixed steps has one, whoever wrote it. Where the formula is published,
// published_schemes.h has M from that. Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I,
// III.3 and III.8; II, IV.2.
#pragma once

#include <complex>
#include <string>

#include "methods/stability.h"

namespace furrow::verification {

// Largest modulus of an eigenvalue of M. For y' = lambda y with z = h lambda; of a method that takes forces that depend
// on velocity.
double own_amplification(const std::string& method, std::complex<double> z);

// For x'' = -2 zeta omega x' - omega^2 x with angle = h omega.
double own_amplification(const std::string& method, double zeta, double angle);

// Whether each eigenvalue of h J alone decides: false if positions and velocities are treated differently.
bool acts_by_eigenvalue(const std::string& method);

// Whether both have the same amplification wherever they are asked.
bool same_amplification(const std::string& one, const std::string& other);

// Largest h omega at which x'' = -2 zeta omega x' - omega^2 x does not grow, coming from zero; `most` if there is none
// below.
double largest_stable_angle(const std::string& method, double zeta, double most = 100);

// The same for y' = lambda y: largest h |lambda| along the direction of lambda.
double largest_stable_radius(const std::string& method, std::complex<double> direction, double growth = growth_seen,
                             double most = 100);

}  // namespace furrow::verification
