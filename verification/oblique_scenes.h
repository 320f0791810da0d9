// Spheres and discs of the literature that strike a rigid plane obliquely: scenes, and what the oracle says of them.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "verification/oblique_oracle.h"
#include "verification/round_body.h"
#include "verification/running.h"

namespace furrow::verification::oblique_impact {

inline constexpr double pi = std::numbers::pi;

struct Case {  // one material against a rigid plane, or against itself
  double radius, density, young, poisson, friction, restitution;
};
inline constexpr Case alumina{0.0025, 4000, 3.8e11, 0.23, 0.092, 0.98};  // test 4; m, kg/m^3, Pa, -, -, -
inline constexpr Case steel{1e-5, 7850, 2.08e11, 0.3, 0.3, 1};           // test 5
inline constexpr Case alloy{0.1, 2700, 7e10, 0.33, 0.4, 0.5};            // tests 6 to 8

inline double beta_of(double e) { return -std::log(e) / std::hypot(std::log(e), pi); }

// Restitution of a contact that never pulls.
inline double clipped(double e) {
  const double beta = beta_of(e);
  const double w = std::sqrt(1 - beta * beta);
  return std::exp(-beta / w * (pi - std::atan2(2 * beta * w, w * w - beta * beta)));
}

inline double modulus(const Case& p) { return p.young / (1 - p.poisson * p.poisson); }
inline double contact_time(const Case& p, double mass, double vn) {
  return 2.943275184324047 * std::pow(15 * mass * vn * vn / (16 * modulus(p) * std::sqrt(p.radius)), 0.4) / vn;
}

inline Scene plane(const Case& p, const RoundBody& body) {
  Scene scene;
  scene.model = {.gravity = 0, .disc_mass = body.reading, .moment_arm = MomentArm::radius};
  scene.contact = {.restitution = p.restitution, .friction = p.friction};
  scene.material.push_back({.name = "body", .density = p.density, .young = p.young, .poisson = p.poisson});
  scene.material.push_back({.name = "plane", .rigid = true});
  scene.wall.push_back({"plane", {0, 0}, {0, 1}, "plane"});
  return scene;
}

struct After {
  double vx, vy, spin;  // m/s, m/s, rad/s
};

inline constexpr int steps = 20000;  // a contact

// From an overlap of a few units of the last place of R, so that the spring follows the slip from the first stage on.
inline After strike(const Case& p, const RoundBody& body, double vn, double vx, double spin, int n = steps) {
  Scene scene = plane(p, body);
  scene.output.energy = false;
  scene.disc.push_back({{0, p.radius * (1 - 1e-15)}, p.radius, {vx, -vn}, spin, "body"});
  const double time = contact_time(p, body.mass(p.density, p.radius), vn);
  const Ran ran = run_scene(scene, "rk4", time / (n + 0.7), 1.2 * time);
  return {ran.y[ran.system.vx_of(0)], ran.y[ran.system.vy_of(0)], ran.y[ran.system.spin_of(0)]};
}

inline ObliqueOutcome by_oracle(const Case& p, const RoundBody& body, double vn, double slip, int n = 20000,
                                bool damps_slip = true) {
  const double shear = p.young / (2 * (1 + p.poisson) * (2 - p.poisson));
  return oblique_outcome({modulus(p), shear, p.radius, body.mass(p.density, p.radius), body.kappa(),
                          beta_of(p.restitution), p.friction, vn, slip, damps_slip},
                         n);
}

inline std::string degrees(const RoundBody& body, double angle) {
  return ", " + body.name + ", " + std::to_string(int(angle)) + " deg";
}

}  // namespace furrow::verification::oblique_impact
