// An oblique impact that sticks, by Mindlin's law with Thornton's rescaling: the force of the tangential spring shrinks
// with the contact, and the slip does not come back faster than it came.
//
//   m d'' = -4/3 E* sqrt(R) d^(3/2)
//   m vt' = -kappa F
//   F' = St vt              while d grows
//   F' = St vt + F St'/St   while it shrinks, where F/St has the rate vt
//
// The oracle integrates d, d', vt and F itself in long double by Runge-Kutta, from the touch on; the solver carries
// xi = F/St with another equation, see physics/rescaled_mindlin.h.
//
// Source: Thornton, Cummins and Cleary 2013 (Powder Technol. 233, 30).
#include <array>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/sticking_scenes.h"

namespace furrow::verification::sticking_impact {
namespace {

using Numbers = std::array<long double, 4>;  // d, d', vt, and F or F/St

double slip_after(const RoundBody& body, double nu, int steps) {
  const long double m = mass(body), kappa = body.kappa(), modulus = young / (2 * (1 - nu * nu));
  const long double shear = young / (4 * (1 + nu) * (2 - nu)), root = std::sqrt(static_cast<long double>(radius));
  const auto st = [&](long double d) { return 8 * shear * root * std::sqrt(std::fmax(d, 0.0L)); };
  const auto rate = [&](const Numbers& y, bool grows) -> Numbers {
    const long double force = grows ? y[3] : st(y[0]) * y[3];
    const long double deep = std::fmax(y[0], 0.0L);
    return {y[1], -4 * modulus * root * deep * std::sqrt(deep) / (3 * m), -kappa * force / m,
            grows ? st(y[0]) * y[2] : y[2]};
  };
  Numbers y{0, closing, slip, 0};
  const auto go = [&](long double h, bool grows) {
    const auto moved = [&](const Numbers& k, long double by) {
      Numbers to = y;
      for (int i = 0; i < 4; ++i) to[i] += by * k[i];
      return to;
    };
    const Numbers k1 = rate(y, grows), k2 = rate(moved(k1, h / 2), grows), k3 = rate(moved(k2, h / 2), grows);
    const Numbers k4 = rate(moved(k3, h), grows);
    for (int i = 0; i < 4; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  };
  const long double half = contact_time(mass(body), radius, static_cast<double>(modulus), closing) / 2;
  for (int n = 0; n < steps; ++n) go(half / steps, true);
  y[3] /= st(y[0]);  // deepest, halfway
  for (int n = 0; n < steps; ++n) go(half / steps, false);
  return static_cast<double>(y[2]);
}

TEST(RescaledImpact, SendsTheContactPointBackAsAnIntegrationOfTheForceDoes) {
  requirement("tangential.rescaled");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double nu : {0.0, 0.3}) {
      const double want = slip_after(body, nu, 40000);
      expect("oracle at a quarter of its steps" + which(body, nu), slip_after(body, nu, 10000) / slip, want / slip,
             absolute(1e-6, "the force grows as t^(3/2) at the touch: order 5/2"));
      Scene scene = impact(body, nu, radius * (1 - 1e-13));
      scene.model.law = ForceLaw::rescaled_mindlin;
      const double time = contact_time(mass(body), radius, young / (2 * (1 - nu * nu)), closing);
      const Ran ran = run_scene(scene, "rk4", time / 8000.7, 1.05 * time);
      const double got = ran.y[ran.system.vx_of(0)] + radius * ran.y[ran.system.spin_of(0)];
      expect("slip after over before" + which(body, nu), got / slip, want / slip,
             absolute(2e-4, "the rate of xi jumps at the deepest point, within a step; and order 3/2 where it closes"));
      expect_true("it is not faster afterwards" + which(body, nu), std::fabs(got) < slip, "the law makes no energy");
      const Energies e = observe(ran.system, 1, ran.y).energy;
      const double first =
          0.5 * mass(body) * (closing * closing + sideways * sideways + body.c * radius * radius * spin * spin);
      expect("energy residual over the start's" + which(body, nu), (e.stored() + e.lost() - e.stiffening) / first, 1,
             relative(2e-4, "order 1 at the deepest point"));
      expect("stiffening [J]" + which(body, nu), e.stiffening, 0, exact("nothing supplies this spring"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::sticking_impact
