// A disc whose rolling is resisted by a spring, a dashpot and a limit: it swings, slows, and rests on a slope.
//
//   M = -kr theta - cr w, |M| <= mu_r R N, theta' = w, cr = 2 eta sqrt((1 + c) m R^2 kr), I = c m R^2
//   in place, without friction: I theta'' = -kr theta - cr theta', a damped oscillator, while |M| is below its limit
//   at the limit: w' = -mu_r N R/I, and the spring then holds theta = mu_r R N/kr
//   on a slope: at rest where tan(slope) < mu_r, with theta = m g R sin(slope)/kr
//               else u' = g (sin(slope) - mu_r cos(slope))/(1 + c)
//
// Sources: Ai, Chen, Rotter and Ooi 2011 (Powder Technol. 206, 269), model C; LAMMPS unittest/granular, models
// rolling_decay and incline_rolling: E = 1e7 Pa, g = 1 m/s^2, a slope of 10 degrees, mu_r = 0.05 or 0.3.
#include "run/observe.h"
#include "verification/check.h"
#include "verification/rolling_scenes.h"
#include "verification/running.h"

namespace furrow::verification::rolling_resistance {
namespace {

TEST(RollingSpring, SwingsAsADampedOscillator) {
  requirement("tangential.rolling_spring");
  for (const RoundBody& body : {disc, sphere}) {
    const double inertia = body.c * mass(body) * radius * radius, kr = 1e-2 * mass(body), eta = 0.2, start = 1e-3;
    Scene scene = with_spring(on_floor(body, 0, young, 0, 0, start));
    scene.contact.rolling_stiffness = kr;
    scene.contact.rolling_damping = eta;
    scene.output.angles = true;
    const double w = std::sqrt(kr / inertia), zeta = eta * std::sqrt((1 + body.c) / body.c),
                 wd = w * std::sqrt(1 - zeta * zeta);
    const double t = 2.5 / w, decayed = std::exp(-zeta * w * t);
    const Ran ran = run_scene(scene, "rk4", t / 2000, t);
    const auto truncation = relative(1e-9, "of rk4 at 1/800 of a radian, to the fourth order");
    expect("spin [rad/s], " + body.name, ran.y[ran.system.spin_of(0)],
           start * decayed * (std::cos(wd * t) - zeta * w / wd * std::sin(wd * t)), truncation);
    expect("angle [rad], " + body.name, ran.y[ran.system.layout().angle_of(0)], start / wd * decayed * std::sin(wd * t),
           truncation);
  }
}

TEST(RollingSpring, IsAsStiffAsAiAndOthersTakeItFromTheNormalStiffness) {
  requirement("tangential.rolling_spring");
  const double weight = mass(disc) * gravity, start = 1e-6;
  const double modulus = young / (2 * (1 - poisson * poisson)), deep = overlap(weight, young);
  const double kr = 3 * 2 * modulus * std::sqrt(radius * deep) * rolling * rolling * radius * radius;
  Scene scene = with_spring(on_floor(disc, 0, young, 0, 0, start));
  scene.contact.rolling_damping = 0;
  const double w = std::sqrt(kr / (0.5 * mass(disc) * radius * radius)), t = 1 / w;
  const Ran ran = run_scene(scene, "rk4", t / 2000, t);
  expect("spin after a radian over the first", ran.y[ran.system.spin_of(0)] / start, std::cos(1.0),
         relative(1e-9, "of rk4 at 1/2000 of a radian, and the overlap at rest to its round-off"));
}

TEST(RollingSpring, AtItsLimitSlowsAsRollingDecayDoes) {
  requirement("tangential.rolling_spring");
  for (const RoundBody& body : {disc, sphere}) {
    const double start = 20, t = 0.02, rate = rolling * gravity / (body.c * radius);
    Scene scene = with_spring(on_floor(body, 0, young, 0, 0, start));
    scene.contact.rolling_stiffness = 30 * mass(body);
    const Ran ran = run_scene(scene, "rk4", t / 20000, t);
    expect("spin lost [rad/s], " + body.name, start - ran.y[ran.system.spin_of(0)], rate * t,
           relative(2e-3, "until the spring is wound up the moment is below its limit"));
    const Energies e = observe(ran.system, t, ran.y).energy;
    const double first = 0.5 * body.c * mass(body) * radius * radius * start * start;
    const double now = first * std::pow(ran.y[ran.system.spin_of(0)] / start, 2);
    expect("energy lost by rolling, of the spin's loss, " + body.name, e.rolling / (first - now), 1,
           absolute(2e-3, "what the spring holds is little beside it"));
    const double residual = (e.kinetic + e.contact_elastic + e.lost() - e.stiffening) - first;
    expect("energy residual and the normal spring's, of the spin's, " + body.name,
           (residual - 0.4 * mass(body) * gravity * overlap(mass(body) * gravity, young)) / first, 0,
           absolute(1e-6, "order 1 where the limit is reached"));
  }
}

TEST(RollingSpring, RestsOnASlopeBelowItsAngleAndRollsBeyondIt) {
  requirement("tangential.rolling_spring");
  constexpr double rise = 0.17365, g = 1;
  const double level = std::sqrt(1 - rise * rise);
  for (const RoundBody& body : {disc, sphere}) {
    for (const double mu_r : {0.3, 0.05}) {
      Scene scene = with_spring(on_floor(body, 0.8, 1e7, rise, 0, 0));
      scene.model.gravity = g;
      scene.contact.rolling_friction = mu_r;
      const double height = radius - overlap(mass(body) * g * level, 1e7);
      scene.disc[0].position = {-height * rise, height * level};
      scene.output.energy = false;
      const double t = 1;
      const Ran ran = run_scene(scene, "rk4", 1e-4, t);
      const double u = -(ran.y[ran.system.vx_of(0)] * level + ran.y[ran.system.vy_of(0)] * rise);
      const std::string what = body.name + ", mu_r " + std::to_string(mu_r);
      if (mu_r > rise / level)
        expect("speed [m/s], " + what, u, 0, absolute(1e-9, "the swing about rest, of 3 mm/s, has died to e^-20"));
      else
        expect("speed [m/s], " + what, u, (rise - mu_r * level) * g * t / (1 + body.c),
               relative(1e-2, "the tolerance of the published case; the swing at the start is not in the formula"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::rolling_resistance
