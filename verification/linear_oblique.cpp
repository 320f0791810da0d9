// An oblique impact by the linear law: one that sticks, and one that sticks, slides and is damped along the tangent.
//
//   Fn = kn d, d = v/w sin(w t), w = sqrt(kn/m): elastic along the normal, for pi/w
//   m vt' = -kappa Ft,  Ft = kt xi + ct vt,  xi' = vt,  |Ft| <= mu Fn,  kappa = 1 + m R^2/I
//   without a limit and undamped: vt' / vt = cos(pi wt/w),  wt = sqrt(kappa kt/m)
//
// After each step the spring holds, where the contact slides, mu Fn/kt (`elastic`) or (mu Fn - ct vt)/kt, with signs
// (`less_viscous`). The oracle integrates vt and xi alone, in long double by Heun's method in short steps.
//
// Sources: Cundall and Strack 1979 (Geotechnique 29, 47); the second rule: Luding 2008 (Granular Matter 10, 235).
#include "run/observe.h"
#include "verification/linear_scenes.h"

namespace furrow::verification::linear {
namespace {

constexpr double ratio = 0.8;     // kt/kn
constexpr double sideways = 1.5;  // m/s
const double contact_time = std::numbers::pi / omega(disc);

struct Slide {
  double friction, damping;  // -, N s/m
  bool less_viscous;
};

// m/s, of the contact point afterwards.
double slip_after(const Slide& s, long steps) {
  const long double kt = ratio * stiffness, m = mass(disc), kappa = disc.kappa(),
                    h = contact_time / static_cast<double>(steps);
  long double vt = sideways, xi = 0;
  const auto limit = [&](long double t) {
    return std::fmax(0.0L, s.friction * stiffness * speed / omega(disc) * std::sin(omega(disc) * t));
  };
  const auto force = [&](long double t, long double x, long double v) {
    return std::fmax(-limit(t), std::fmin(limit(t), kt * x + s.damping * v));
  };
  for (long n = 0; n < steps; ++n) {
    const long double t = n * h, k1 = -kappa / m * force(t, xi, vt), half = vt + h * k1;
    const long double k2 = -kappa / m * force(t + h, xi + h * vt, half);
    xi += h / 2 * (vt + half);
    vt += h / 2 * (k1 + k2);
    const long double most = limit(t + h), stick = kt * xi + s.damping * vt;
    if (!s.less_viscous) xi = std::fmax(-most / kt, std::fmin(most / kt, xi));
    if (s.less_viscous && std::fabs(stick) > most) xi = ((stick > 0 ? most : -most) - s.damping * vt) / kt;
  }
  return static_cast<double>(vt);
}

Scene oblique(const Slide& s, const RoundBody& body) {
  Scene scene = impact(body);
  scene.disc[0].velocity.x = sideways;
  scene.model.after_slip = s.less_viscous ? AfterSlip::less_viscous : AfterSlip::elastic;
  scene.contact.friction = s.friction;
  scene.contact.tangential_stiffness = ratio * stiffness;
  scene.contact.damping = 0;
  scene.contact.tangential_damping = s.damping;
  return scene;
}

TEST(LinearOblique, OneThatSticksHasTheRestitutionOfTwoSprings) {
  requirement("tangential.linear");
  for (const RoundBody& body : {disc, sphere}) {
    const double time = std::numbers::pi / omega(body), w_ratio = std::sqrt(ratio * body.kappa());
    const Ran ran = run_scene(oblique({1e12, 0, false}, body), "rk4", time / 20000.7, 1.1 * time);
    const double slip = ran.y[ran.system.vx_of(0)] + radius * ran.y[ran.system.spin_of(0)];
    expect("slip after over before, " + body.name, slip / sideways, std::cos(std::numbers::pi * w_ratio),
           absolute(2e-4, "order 1 where the contact opens with its spring stretched, at 0.7 of a step of 5e-5"));
  }
}

TEST(LinearOblique, OneThatSlidesFollowsAnIndependentIntegrationByBothRules) {
  requirement("tangential.after_slip");
  for (const bool less_viscous : {false, true}) {
    const Slide s{0.25, 300, less_viscous};
    const double want = slip_after(s, 400000);
    const std::string rule = less_viscous ? "less_viscous" : "elastic";
    expect("oracle at a quarter of its steps [m/s], " + rule, slip_after(s, 100000), want,
           absolute(2e-4, "order 1 of the rule, which acts once a step"));
    const Ran ran = run_scene(oblique(s, disc), "rk4", contact_time / 40000.7, 1.1 * contact_time);
    expect("slip afterwards [m/s], " + rule, ran.y[ran.system.vx_of(0)] + radius * ran.y[ran.system.spin_of(0)], want,
           absolute(1e-3, "order 1 of the rule, which acts once a step"));
    const Energies e = observe(ran.system, 0, ran.y).energy;
    expect("energy residual over the start's",
           (e.stored() + e.lost() - e.stiffening) / (0.5 * mass(disc) * (speed * speed + sideways * sideways)), 1,
           relative(1e-4, "order 1 at the ends of the contact"));
  }
}

TEST(LinearOblique, UndampedAlongTheTangentWhereTheSceneSaysSo) {
  requirement("tangential.after_slip");
  Scene scene = oblique({0.25, 300, false}, disc);
  scene.model.slip_damping = false;
  const Ran ran = run_scene(scene, "rk4", contact_time / 40000.7, 1.1 * contact_time);
  expect("slip afterwards [m/s]", ran.y[ran.system.vx_of(0)] + radius * ran.y[ran.system.spin_of(0)],
         slip_after({0.25, 0, false}, 400000), absolute(1e-3, "order 1 of the rule, which acts once a step"));
}

}  // namespace
}  // namespace furrow::verification::linear
