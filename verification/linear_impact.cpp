// A disc or sphere that meets a floor of linear springs and dashpots comes back after the same time at any speed.
//
//   m d'' = -kn d - c d',  d(0) = 0, d'(0) = v
//   w = sqrt(kn/m), beta = c/(2 m w), wd = w sqrt(1 - beta^2)
//   d_max = v/w exp(-beta/sqrt(1 - beta^2) atan(sqrt(1 - beta^2)/beta))
//   t_c = pi/wd, e = exp(-pi beta/sqrt(1 - beta^2))                            where the contact may pull
//   e_clip = exp(-beta/sqrt(1 - beta^2) (pi - atan2(2 beta w', w'^2 - beta^2)))  where it never does, w' = wd/w
//
// In free flight and in contact with the weight, after a fall from h (case DEM01 of MFiX):
//   y = R - m g/kn + e^(-beta w s) (m g/kn cos wd s + (beta w m g/kn - sqrt(2 g (h - R)))/wd sin wd s)
//
// Sources: Cundall and Strack 1979 (Geotechnique 29, 47); Schwager and Poeschel 2007 (Granular Matter 9, 465); Garg,
// Galvin, Li and Pannala 2012 (Powder Technol. 220, 122), whose case has R = 0.1 m, 2600 kg/m^3 and h = 0.5 m.
#include "verification/linear_scenes.h"

namespace furrow::verification::linear {
namespace {

double shrunk(double beta) {
  const double r = std::sqrt(1 - beta * beta);
  return beta == 0 ? 1 : std::exp(-beta / r * std::atan(r / beta));
}

double clipped(double beta) {
  const double w = std::sqrt(1 - beta * beta);
  return std::exp(-beta / w * (std::numbers::pi - std::atan2(2 * beta * w, w * w - beta * beta)));
}

TEST(LinearImpact, HasTheRestitutionDurationAndOverlapOfTheOscillator) {
  requirement("normal.linear");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double e : {0.2, 0.5, 0.9, 1.0}) {
      const double beta = beta_of(e), time = std::numbers::pi / (omega(body) * std::sqrt(1 - beta * beta));
      Scene scene = impact(body);
      scene.model.pull = true;
      scene.contact.restitution = e;
      const std::string what = body.name + ", e = " + std::to_string(e);
      expect(what + ": speed after over before", measured(scene, body, time).rebound, e, controlled(500));
      const Impact got = by_steps(scene, body, time);
      expect(what + ": contact time [s]", got.contact_time, time,
             relative(1e-8, "order 2 where the contact opens, in a step of 5e-5 of it"));
      expect(what + ": greatest overlap [m]", got.peak_overlap, speed / omega(body) * shrunk(beta),
             relative(1e-9, "rk4, and the vertex of a parabola through points 5e-5 of the contact apart"));
    }
  }
}

TEST(LinearImpact, ThatNeverPullsLetsGoEarlier) {
  requirement("normal.linear");
  for (const double e : {0.3, 0.7}) {
    const double beta = beta_of(e);
    Scene scene = impact(disc);
    scene.contact.restitution = e;
    const Impact got = measured(scene, disc, std::numbers::pi / omega(disc));
    expect("speed after over before, e = " + std::to_string(e), got.rebound, clipped(beta), controlled(500));
    expect("least force [N]", got.least_force, 0, exact("the law cuts the force off at zero"));
  }
}

TEST(LinearImpact, DampingInNewtonSecondsAMetreIsThatOfTheEquation) {
  requirement("normal.dashpot");
  const double beta = 0.25;
  Scene scene = impact(sphere);
  scene.model.pull = true;
  scene.contact.damping = 2 * beta * std::sqrt(stiffness * mass(sphere));
  const double r = std::sqrt(1 - beta * beta), time = std::numbers::pi / (omega(sphere) * r);
  expect("speed after over before", measured(scene, sphere, time).rebound, std::exp(-std::numbers::pi * beta / r),
         controlled(500));
}

TEST(LinearImpact, FallAndBounceFollowTheThreeStagesOfMfix) {
  requirement("normal.linear");
  constexpr double g = 9.81, height = 0.5;
  for (const double e : {0.9, 0.6}) {
    const double w = omega(sphere), beta = beta_of(e), wd = w * std::sqrt(1 - beta * beta), sag = g / (w * w);
    const double fall = std::sqrt(2 * (height - radius) / g), down = std::sqrt(2 * g * (height - radius));
    const double late = 0.6 * std::numbers::pi / wd;  // s, in the contact
    Scene scene = impact(sphere);
    scene.model.gravity = g;
    scene.model.pull = true;
    scene.contact.restitution = e;
    scene.wall[0].point.y = 0;
    scene.disc[0] = {{0, height}, radius, {}, 0, "any"};
    const auto at = [&](double t) { return run_scene(scene, "rk4", t / 20000, t); };
    const double b = (beta * w * sag - down) / wd, decayed = std::exp(-beta * w * late);
    const Ran ran = at(fall + late);
    const auto truncation =
        relative(7e-5, "order 1 at the touch, which falls into a step of 5e-5 of the run; measured once, doubled");
    expect("height in the contact [m], e = " + std::to_string(e), ran.y[ran.system.y_of(0)],
           radius - sag + decayed * (sag * std::cos(wd * late) + b * std::sin(wd * late)), truncation);
    expect("height in free fall [m]", at(0.2).y[ran.system.y_of(0)], height - g * 0.02, relative(1e-12, "round-off"));
  }
}

}  // namespace
}  // namespace furrow::verification::linear
