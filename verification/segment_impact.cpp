// A disc hits the segment between two nodes of a lattice: each node takes its share of the impulse.
//
//   nodes of mass m_n, at the fraction t of their segment; a fixed node has no term in 1/m*:
//     1/m* = 1/m_disc + ((1 - t)^2 + t^2)/m_n
//     J = (1 + e) m* v on the disc, (1 - t) J and t J on the nodes
//
// Source: algebra.
#include <string>

#include "verification/check.h"
#include "verification/coupling_scenes.h"
#include "verification/running.h"

namespace furrow::verification::coupling {
namespace {

TEST(Coupling, SegmentSharesTheImpulse) {
  requirement("coupling.share");
  for (const double t : {0.0, 0.3, 0.5, 0.9}) {
    for (const bool fixed : {false, true}) {
      Scene scene = disc_above({.columns = 2}, t * spacing, radius * (1 - 1e-14));
      if (fixed) scene.lattice[0].fixed_columns = {0};
      if (fixed && t == 0) continue;  // a fixed node alone
      scene.contact.restitution = 0.5;
      scene.model.pull = true;
      const double reduced = reduced_mass(((fixed ? 0 : (1 - t) * (1 - t)) + t * t) / node_mass);
      const double given = 1.5 * reduced * closing;  // N s
      const double time = 2.943275184324047 * deepest(reduced) / closing;
      const Ran ran = run_scene(scene, "rk4", time / 4000.5, 1.3 * time);
      const std::string which = ", t " + std::to_string(t).substr(0, 3) + (fixed ? ", one node fixed" : "");
      const Tolerance truncation = absolute(1.9e-6, "truncation of order 5/4, as for one node");
      expect("disc, change of velocity m / J" + which, (ran.y[ran.system.vy_of(0)] + closing) * disc_mass / given, 1,
             truncation);
      if (!fixed)
        expect("first node, velocity m / J" + which, -ran.y[ran.system.vy_of(1)] * node_mass / given, 1 - t,
               truncation);
      expect("second node, velocity m / J" + which, -ran.y[ran.system.vy_of(fixed ? 1 : 2)] * node_mass / given, t,
             truncation);
      expect("sideways velocity [m/s]" + which, ran.y[ran.system.vx_of(0)], 0,
             exact("the contact points straight down"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::coupling
