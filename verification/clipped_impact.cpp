// A damped contact that never pulls lets go as soon as its force would turn, while the bodies still overlap, and is
// faster then than the restitution asked for.
//
//   With p, s of damped_hertz.h the force is zero at p'' = 0, at turn s = 2 acos(beta), turn = w sqrt(1 - beta^2):
//     beta < 1:  e_clip = exp(-2 beta acos(beta) / sqrt(1 - beta^2))
//     beta = 1:  e_clip = e^-2
//     beta > 1:  e_clip = exp(-2 beta acosh(beta) / sqrt(beta^2 - 1))
//
// Source: Schwager and Poeschel 2007 (Granular Matter 9, 465) for the linear spring; the map of damped_hertz.h carries
// it over, for it keeps the order of force and velocity: with w' = sqrt(1 - beta^2) their
// exp(-beta/w' (pi - atan2(2 beta w', w'^2 - beta^2))) is the same number.
#include "verification/damped_hertz.h"
#include "verification/impact.h"

namespace furrow::verification {
namespace {

constexpr double radius = 0.0025;  // m
constexpr double speed = 3.9;      // m/s
constexpr double pi = 3.14159265358979323846;
constexpr double tolerance = 1e-12;  // of the controlled method, in units of the impact
constexpr int steps = 1000;          // in the time to letting go, at least

double beta_of(double e) { return -std::log(e) / std::hypot(std::log(e), pi); }

double clipped_restitution(double beta) {
  if (beta == 1) return std::exp(-2.0);
  const double turn = std::sqrt(std::fabs(1 - beta * beta));
  return std::exp(-2 * beta / turn * (beta < 1 ? std::acos(beta) : std::acosh(beta)));
}

TEST(ClippedImpact, ClosedFormAgreesWithTheTableAndWithAnIntegration) {
  requirement("normal.clipped");
  for (const auto& [e, got] : {std::pair{0.3, 0.3971}, {0.5, 0.5503}, {0.7, 0.7182}, {0.9, 0.9020}}) {
    const double beta = beta_of(e);
    const double turn = std::sqrt(1 - beta * beta);
    expect("e_clip of the table for e = " + std::to_string(e), got, clipped_restitution(beta),
           absolute(5e-5, "half a unit of the last digit of the table"));
    expect("e_clip in the form of Schwager and Poeschel",
           std::exp(-beta / turn * (pi - std::atan2(2 * beta * turn, turn * turn - beta * beta))),
           clipped_restitution(beta), relative(1e-15, "round-off"));
  }
  for (const double beta : {0.1, 0.6, 1.0, 2.0, 20.0}) {
    const DampedHertz exact(beta);
    const Motion last = integrate_impact(beta, exact.time(exact.letting_go()), 8000);
    const std::string what = "beta " + std::to_string(beta);
    const auto truncation = absolute(3e-14, "truncation of 8000 graded steps of order 4, and round-off of pow");
    expect(what + ": force at letting go over K L^(3/2)", static_cast<double>(last.force), 0, truncation);
    expect(what + ": speed at letting go over v", static_cast<double>(-last.speed), clipped_restitution(beta),
           truncation);
  }
}

TEST(ClippedImpact, LeavesWithTheClippedRestitutionAndNeverPulls) {
  requirement("normal.clipped");
  const double mass = mass_of(alumina, radius, DiscMass::sphere);
  const double stiffness = hertz_stiffness(softness(alumina), radius);
  const double length = std::pow(mass * speed * speed / stiffness, 0.4);
  std::vector<double> factors{1, 2, 20};
  for (const double e : {0.1, 0.3, 0.5, 0.7, 0.9}) factors.push_back(beta_of(e));
  for (const double beta : factors) {
    const DampedHertz exact(beta);
    const double end = static_cast<double>(exact.time(exact.letting_go())) * length / speed;
    Scene scene = wall_impact(alumina, radius, speed, DiscMass::sphere, true);
    scene.contact.damping_factor = beta;
    const Impact got = measure(scene, mass, {"odeint_dopri5", end / steps, 1.05 * end, tolerance, length, end});
    const std::string what = "beta " + std::to_string(beta);
    expect(what + ": speed after over before", got.rebound, clipped_restitution(beta),
           absolute(3 * tolerance, "error control: so many errors of 1e-12 add up, measured once, doubled"));
    expect(what + ": least force [N]", got.least_force, 0, verification::exact("the law cuts the force off at zero"));
  }
}

}  // namespace
}  // namespace furrow::verification
