// An impact by Hertz's law with a dashpot of constant strength.
//
//   m d'' = -4/3 E* sqrt(R) d^(3/2) - c d',  d(0) = 0, d'(0) = v, while the force pushes
//
// The oracle integrates d and d' in long double by Runge-Kutta up to where the force would pull, found by halving.
#include "verification/damped_scenes.h"

namespace furrow::verification::damped_impact {
namespace {

// Speed after over before, where the contact never pulls. Lengths in (m v^2/K)^(2/5), times in that over v; c in m over
// the time.
double rebound(double c, int steps) {
  const auto force = [&](long double d, long double v) { return d * std::sqrt(std::fmax(d, 0.0L)) + c * v; };
  long double d = 0, v = 1, h = 3.0L / steps;
  const auto go = [&](long double s) {
    const long double d1 = v, v1 = -force(d, v), d2 = v + s / 2 * v1, v2 = -force(d + s / 2 * d1, d2);
    const long double d3 = v + s / 2 * v2, v3 = -force(d + s / 2 * d2, d3), d4 = v + s * v3,
                      v4 = -force(d + s * d3, d4);
    d += s / 6 * (d1 + 2 * d2 + 2 * d3 + d4);
    v += s / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  };
  while (h > 1e-18L) {
    const long double before_d = d, before_v = v;
    go(h);
    if (force(d, v) > 0) continue;
    d = before_d, v = before_v, h /= 2;
  }
  return static_cast<double>(-v);
}

TEST(DashpotImpact, LosesWhatAnIndependentIntegrationLoses) {
  requirement("normal.dashpot");
  const Units u = units_of(alumina, 3.9);
  for (const double c : {0.05, 0.4}) {
    const double want = rebound(c, 40000);
    expect("oracle at half its steps, c = " + std::to_string(c), rebound(c, 20000), want,
           absolute(1e-9, "the force grows as t^(3/2) at the touch: order 5/2"));
    Scene scene = scene_of(alumina, u.speed);
    scene.model.pull = false;
    scene.contact.damping = c * u.mass / u.time();
    const Impact got =
        measure(scene, u.mass, {"odeint_dopri5", 3 * u.time() / steps, 4 * u.time(), tolerance, u.length()});
    expect("speed after over before, c = " + std::to_string(c), got.rebound, want,
           absolute(1e-8, "error control at 1e-12, and the step in which the force ends"));
    expect("least force [N]", got.least_force, 0, exact("the law cuts the force off at zero"));
  }
}

}  // namespace
}  // namespace furrow::verification::damped_impact
