// A disc on the nodes of a lattice: at rest on a spring, in impact with free nodes, and on the segment between two.
//
//   squeezed between a wall and a node on a spring, at rest:
//     2 (F/K)^(2/3) + F/k = squeeze
//   against nodes of mass m_n, at the fraction t of their segment; a fixed node has no term in 1/m*:
//     1/m* = 1/m_disc + ((1 - t)^2 + t^2)/m_n
//     J = (1 + e) m* v on the disc, (1 - t) J and t J on the nodes
//     d_max = (15 m* v^2 / (16 E* sqrt(R)))^(2/5)
//   at the height h above a segment, x beside the nearest of its n auxiliary points, x <= s/(2 (n + 1)):
//     distance sqrt(h^2 + x^2), along a line that leans by x/h
//   on the upper of two free nodes with a spring between them: three bodies in a line, integrated here in long double
//
// Sources: algebra; Hertz 1882 for d_max; the auxiliary points are the paper's.
#include <cmath>
#include <numbers>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double radius = 0.01;                                             // m
constexpr double density = 1000;                                            // kg/m^3
constexpr double young = 1e6;                                               // Pa
constexpr double poisson = 0.3;                                             // -
constexpr double node_mass = 0.5;                                           // kg
constexpr double spacing = 0.05;                                            // m
constexpr double closing = 0.2;                                             // m/s
constexpr double modulus = young / (2 * (1 - poisson * poisson));           // Pa, E*
const double hertz = 4.0 / 3 * modulus * std::sqrt(radius);                 // N/m^(3/2), K; an edge has no curvature
constexpr double disc_mass = density * std::numbers::pi * radius * radius;  // kg

Scene disc_above(const Lattice& lattice, double x, double height) {
  Scene scene;
  scene.model.gravity = 0;
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.lattice.push_back(lattice);
  scene.lattice[0].spacing = spacing;
  scene.lattice[0].node_mass = node_mass;
  scene.lattice[0].material = "any";
  scene.disc.push_back({{x, height}, radius, {0, -closing}, 0, "any"});
  return scene;
}

double reduced_mass(double softness) { return 1 / (1 / disc_mass + softness); }  // kg
double deepest(double reduced) {
  return std::pow(15 * reduced * closing * closing / (16 * modulus * std::sqrt(radius)), 0.4);
}

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

struct Line {
  long double disc, upper, lower;  // m/s
};

// Disc, node, spring, node from the touch to `end`, elastic: Runge-Kutta over t = end s^4, which takes the root off the
// onset.
Line three_bodies(long double spring, long double end, int steps) {
  struct Motion {
    long double q[3], v[3];
  };
  const long double mass[3] = {disc_mass, node_mass, node_mass};
  const auto rates = [&](const Motion& y, long double scale) {
    Motion r{};
    const long double d = std::fmax(0.0L, y.q[1] - y.q[0]);  // heights from where each is at the touch
    const long double contact = hertz * d * std::sqrt(d);
    const long double pull = spring * (y.q[1] - y.q[2]);
    const long double force[3] = {contact, -contact - pull, pull};
    for (int i = 0; i < 3; ++i) {
      r.q[i] = y.v[i] * scale;
      r.v[i] = force[i] / mass[i] * scale;
    }
    return r;
  };
  const auto moved = [](const Motion& y, const Motion& k, long double h) {
    Motion z = y;
    for (int i = 0; i < 3; ++i) {
      z.q[i] += h * k.q[i];
      z.v[i] += h * k.v[i];
    }
    return z;
  };
  Motion y{{0, 0, 0}, {-closing, 0, 0}};
  const long double h = 1.0L / steps;
  for (int n = 0; n < steps; ++n) {
    const auto scale = [&](long double s) { return end * 4 * s * s * s; };
    const Motion k1 = rates(y, scale(n * h));
    const Motion k2 = rates(moved(y, k1, h / 2), scale((n + 0.5L) * h));
    const Motion k3 = rates(moved(y, k2, h / 2), scale((n + 0.5L) * h));
    const Motion k4 = rates(moved(y, k3, h), scale((n + 1) * h));
    y = moved(moved(moved(moved(y, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  return {y.v[0], y.v[1], y.v[2]};
}

TEST(Coupling, SprungMassTakesMomentumAndEnergyOver) {
  requirement("coupling.impact");
  const double reduced = reduced_mass(1 / node_mass);
  const double time = 2.943275184324047 * deepest(reduced) / closing;
  const double end = 1.6 * time;  // s, the disc has left
  const double alone = 2 * reduced * closing / node_mass;
  expect("upper node by integration, no spring [m/s]", static_cast<double>(three_bodies(0, end, 20000).upper), -alone,
         relative(5e-12, "truncation: 2.4e-12 measured, doubled"));
  for (const double spring : {100.0, 1e4}) {
    const Line want = three_bodies(spring, end, 20000);
    const Scene scene =
        disc_above({.origin = {0, -spacing}, .rows = 2, .structural = {.stiffness = spring}}, 0, radius * (1 - 1e-14));
    const System system(scene);
    double worst = 0;
    const Ran ran = run_scene(scene, "verlet", end / 20000, end, [&](double t, const State& y, const JumpReport&) {
      worst = std::max(worst, std::fabs(observe(system, t, y).momentum.y / (-disc_mass * closing) - 1));
      return true;
    });
    const std::string which = ", k " + std::to_string(int(spring)) + " N/m";
    const Tolerance truncation = absolute(1.3e-8, "truncation of order 2: 6.3e-9 measured at 20000 steps, doubled");
    const auto v = [&](int body) { return ran.y[ran.system.vy_of(body)] / closing; };
    expect("disc, velocity / v" + which, v(0), static_cast<double>(want.disc) / closing, truncation);
    expect("upper node, velocity / v" + which, v(2), static_cast<double>(want.upper) / closing, truncation);
    expect("lower node, velocity / v" + which, v(1), static_cast<double>(want.lower) / closing, truncation);
    expect("greatest error of momentum" + which, worst, 0,
           absolute(4e-14, "round-off over 20000 steps: 1.7e-14 measured, doubled"));
    expect("energy / m v^2 / 2" + which,
           observe(system, end, ran.y).energy.stored() / (0.5 * disc_mass * closing * closing), 1,
           relative(2.4e-9, "truncation of order 2: 1.2e-9 measured, doubled"));
  }
}

TEST(Coupling, AuxiliaryPointsAreOffByNoMoreThanHalfTheirSpacing) {
  requirement("coupling.auxiliary_points");
  constexpr double height = 0.0095;  // m
  for (const int auxiliary : {0, 4, 9}) {
    const double furthest = auxiliary == 0 ? 0 : spacing / (2 * (auxiliary + 1));  // m
    double least = 1;
    double most = 0;
    double lean = 0;
    for (int k = 0; k <= 400; ++k) {
      Lattice edge{.columns = 2, .fixed_columns = {0, 1}};
      edge.auxiliary_points = auxiliary;
      const Scene scene = disc_above(edge, k * spacing / 400, height);
      const System system(scene);
      const State y = system.initial_state();
      const double depth = observe(system, 0, y).overlap.depth;
      least = std::min(least, depth);
      most = std::max(most, depth);
      if (depth == 0) continue;
      State rates(system.size());
      system.rhs(0, y, rates);
      lean = std::max(lean, std::fabs(rates[system.vx_of(0)] / rates[system.vy_of(0)]));
    }
    const std::string which = ", " + std::to_string(auxiliary) + " points";
    const double reach = std::hypot(height, furthest);
    expect("greatest overlap [m]" + which, most, radius - height, absolute(4e-18, "2 ulp of R"));
    expect("least overlap [m]" + which, least, std::fmax(0, radius - reach), absolute(4e-18, "2 ulp of R"));
    if (reach < radius)
      expect("greatest lean of the force" + which, lean, furthest / height,
             absolute(2e-15, "round-off of a quotient of small numbers"));
  }
}

}  // namespace
}  // namespace furrow::verification
