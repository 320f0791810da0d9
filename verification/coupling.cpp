// A disc on a node of a lattice: at rest on a spring, and in impact with a free node.
//
//   squeezed between a wall and a node on a spring, at rest:
//     2 (F/K)^(2/3) + F/k = squeeze
//   against a node of mass m_n:
//     1/m* = 1/m_disc + 1/m_n
//     J = (1 + e) m* v on both
//     d_max = (15 m* v^2 / (16 E* sqrt(R)))^(2/5)
//
// Sources: algebra; Hertz 1882 for d_max.
#include <algorithm>
#include <cmath>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/coupling_scenes.h"
#include "verification/running.h"

namespace furrow::verification::coupling {
namespace {

TEST(Coupling, DiscAndSprungNodeAreInSeries) {
  requirement("coupling.series");
  constexpr double squeeze = 0.006;  // m
  constexpr double spring = 1e4;     // N/m
  Scene scene = disc_above({.rows = 2, .fixed_rows = {0}, .structural = {.stiffness = spring, .damping = 50}}, 0,
                           spacing + radius - squeeze / 2);
  scene.contact.damping_factor = 1;
  scene.disc[0].velocity = {};
  scene.wall.push_back({"lid", {0, spacing + 2 * radius - squeeze}, {0, -1}, "any"});
  const Ran ran = run_scene(scene, "rk4", 5e-5, 2);
  long double low = 0;
  long double high = spring * squeeze;  // N; halved until nothing is left
  for (int k = 0; k < 100; ++k) {
    const long double force = (low + high) / 2;
    (2 * std::cbrt(force * force / (hertz * hertz)) + force / spring < squeeze ? low : high) = force;
  }
  const auto force = static_cast<double>(low);
  const double overlap = std::cbrt(force * force / (hertz * hertz));
  const double node = ran.y[ran.system.y_of(1)];
  const Tolerance rounded =
      relative(2e-12, "an ulp of the height, 0.06 m, is 3e-15 of the overlap; what moved has died");
  expect("force on the spring [N]", spring * (spacing - node), force, rounded);
  expect("overlap of disc and node [m]", radius - (ran.y[ran.system.y_of(0)] - node), overlap, rounded);
  expect("2 (F/K)^(2/3) + F/k of that force [m]", 2 * overlap + force / spring, squeeze, relative(1e-15, "round-off"));
}

TEST(Coupling, FreeNodeIsHitAsABodyOfItsOwn) {
  requirement("coupling.impact");
  const double reduced = reduced_mass(1 / node_mass);
  for (const double e : {1.0, 0.5}) {
    Scene scene = disc_above({}, 0, radius * (1 - 1e-14));
    scene.contact.restitution = e;
    scene.model.pull = true;
    const double time = 2.943275184324047 * deepest(reduced) / closing;  // s, if elastic
    const System system(scene);
    double depth = 0;
    const Ran ran =
        run_scene(scene, "rk4", time / 4000.5, 1.3 * time, [&](double t, const State& y, const JumpReport&) {
          depth = std::max(depth, observe(system, t, y).overlap.depth);
          return true;
        });
    const std::string which = ", e " + std::to_string(e).substr(0, 3);
    const double given = (1 + e) * reduced * closing;  // N s
    const Tolerance truncation =
        e == 1 ? relative(2.6e-10, "truncation of order 5/2: 1.3e-10 measured at 4000 steps, doubled")
               : relative(1.9e-6, "truncation of order 5/4: 9.3e-7 measured at 4000 steps, doubled");
    expect("disc, change of velocity m / J" + which, (ran.y[ran.system.vy_of(0)] + closing) * disc_mass / given, 1,
           truncation);
    expect("node, velocity m / J" + which, -ran.y[ran.system.vy_of(1)] * node_mass / given, 1, truncation);
    if (e == 1)
      expect("greatest overlap [m]", depth, deepest(reduced),
             relative(4.3e-8, "the greatest of 4000 samples: 2.1e-8 measured, doubled"));
  }
}

}  // namespace
}  // namespace furrow::verification::coupling
