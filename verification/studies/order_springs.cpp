// Smooth motions, and one that ends smoothness: a mass on a spring, with and without damper; a lattice that swings in
// the plane, nonlinear because its links turn; a spring that tears.
//
//   x'' = -2 zeta w x' - w^2 x,  x(0) = x0, x'(0) = v0
//   x = e^(-zeta w t) (x0 cos wd t + (v0 + zeta w x0)/wd sin wd t),  wd = w sqrt(1 - zeta^2)
//   tear: x = v0/w sin wt until k x = S, from there on x' stays as it is
//
// Source: algebra. The lattice is integrated here, in long double, by extrapolation (order_reference.h).
#include <array>
#include <cmath>

#include "run/system.h"
#include "verification/studies/order_problems.h"
#include "verification/studies/order_reference.h"

namespace furrow::verification {
namespace {

constexpr long double omega = 10;              // rad/s, sqrt(500 / 5)
constexpr double mass = 5;                     // kg
constexpr double stiffness = 500;              // N/m
constexpr double spacing = 0.1;                // m
constexpr long double launch = 0.05L;          // m/s, v0
constexpr long double reach = launch / omega;  // m, greatest stretch without damping

Scene lattice_scene(int rows, int columns) {
  Scene scene;
  scene.model.gravity = 0;
  scene.output.energy = false;
  scene.material.push_back({.name = "any", .young = 2e5, .poisson = 0.3});
  Lattice lattice;
  lattice.rows = rows;
  lattice.columns = columns;
  lattice.spacing = spacing;
  lattice.node_mass = mass;
  lattice.material = "any";
  scene.lattice.push_back(lattice);
  return scene;
}

Scene spring_scene(double zeta, double strength) {
  Scene scene = lattice_scene(1, 2);
  scene.lattice[0].fixed_columns = {0};
  scene.lattice[0].structural = {
      .stiffness = stiffness, .damping = 2 * zeta * std::sqrt(stiffness * mass), .strength = strength};
  return scene;
}

// The free node of a spring along x: [x, y, vx, vy].
State along_x(long double x, long double v) {
  return {static_cast<double>(static_cast<long double>(spacing) + x), 0, static_cast<double>(v), 0};
}

State swinging(long double zeta, long double t) {
  const long double decay = zeta * omega;
  const long double turn = omega * std::sqrt(1 - zeta * zeta);
  const long double x0 = 0.3L * reach;
  const long double rise = (launch + decay * x0) / turn;
  const long double c = std::cos(turn * t), s = std::sin(turn * t), e = std::exp(-decay * t);
  return along_x(e * (x0 * c + rise * s), e * ((rise * turn - decay * x0) * c - (x0 * turn + decay * rise) * s));
}

Problem spring(double zeta, const std::string& name, const std::string& title) {
  Problem p{name, title, "none"};
  p.fastest = static_cast<double>(omega);
  p.unit = static_cast<double>(1 / omega);
  p.duration = 6 * p.unit;
  p.earliest = 0.5;
  p.length = static_cast<double>(reach);
  p.speed = static_cast<double>(launch);
  p.least_steps = 64;
  p.system = [zeta] { return std::make_unique<System>(spring_scene(zeta, infinity)); };
  p.state = [zeta](long double t) { return swinging(zeta, t); };
  return p;
}

// x'' = -x + 3 cos 2t, in units of 1/omega: x = (x0 + 1) cos t + v0 sin t - cos 2t. The only force here that depends on
// time: a stage at the wrong time shows in no other.
class DrivenSpring final : public OdeSystem {
 public:
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double t, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = -y[0] + 3 * std::cos(2 * t);
  }
};

Problem driven() {
  Problem p{"driven_spring", "driven spring", "none"};
  p.fastest = 2;  // of what drives it
  p.duration = 3;
  p.earliest = 0.5;
  p.length = 2.5;  // as far and as fast as it gets, in units
  p.speed = 3.5;
  p.least_steps = 64;
  p.system = [] { return std::make_unique<DrivenSpring>(); };
  p.state = [](long double t) -> State {
    const long double x0 = 0.5L, v0 = 0.3L;
    const long double c = std::cos(t), s = std::sin(t);
    return {static_cast<double>((x0 + 1) * c + v0 * s - std::cos(2 * t)),
            static_cast<double>(v0 * c - (x0 + 1) * s + 2 * std::sin(2 * t))};
  };
  return p;
}

Problem tear(bool located) {
  constexpr long double slip = 2.0L / 3;  // strength over that of the greatest stretch
  const long double torn = std::asin(slip) / omega;
  Problem p{"tear", "tear", "the spring's force jumps to zero, seen at the end of a step", 1};
  if (located) p = {"located_tear", "located tear", "the step ends at the tear, on a cubic through it", 4};
  if (located) p.locate = Locate::tears;
  if (located) p.indistinct = 1;  // the cubic errs by h^4/384
  p.controller_sees_it = p.speed_by_energy = located;
  p.unit = static_cast<double>(1 / omega);
  p.duration = 1.5 * p.unit;
  p.length = static_cast<double>(reach);
  p.speed = static_cast<double>(launch);
  p.least_steps = located ? 16 : 40;  // high orders reach round-off soon
  const double strength = static_cast<double>(slip * reach * stiffness);
  p.system = [strength] { return std::make_unique<System>(spring_scene(0, strength)); };
  p.state = [torn](long double t) {
    if (t < torn) return along_x(reach * std::sin(omega * t), launch * std::cos(omega * t));
    const long double v = launch * std::cos(omega * torn);
    return along_x(slip * reach + v * (t - torn), v);
  };
  return p;
}

// ---- two by two nodes, the left ones fixed, links along the sides and across ----

constexpr double lattice_damping = 5;  // N s/m
constexpr std::array<long double, 8> lattice_start{0.1L, 0.1L, 0, 0.1L, 0.3L, -0.2L, 0.5L, -0.4L};

// Free nodes 0 (lower) and 1 (upper), [x0, x1, y0, y1, vx0, vx1, vy0, vy1]; fixed nodes at (0, 0) and (0, spacing).
Numbers lattice_rate(const Numbers& y) {
  Numbers rate(8);
  for (int i = 0; i < 4; ++i) rate[i] = y[4 + i];
  const auto pull = [&](int a, int b, long double fixed_y, bool diagonal) {  // b < 0: a fixed node
    const long double rx = y[a] - (b < 0 ? 0 : y[b]);
    const long double ry = y[2 + a] - (b < 0 ? fixed_y : y[2 + b]);
    const long double vx = y[4 + a] - (b < 0 ? 0 : y[4 + b]);
    const long double vy = y[6 + a] - (b < 0 ? 0 : y[6 + b]);
    const long double l = std::sqrt(rx * rx + ry * ry);
    // Rest lengths as the solver has them, in double.
    const long double rest = diagonal ? static_cast<long double>(std::sqrt(2 * spacing * spacing)) : spacing;
    const long double along = (stiffness * (l - rest) + lattice_damping * (vx * rx + vy * ry) / l) / l / mass;
    rate[4 + a] -= along * rx;
    rate[6 + a] -= along * ry;
    if (b >= 0) rate[4 + b] += along * rx;
    if (b >= 0) rate[6 + b] += along * ry;
  };
  pull(0, -1, 0, false);
  pull(1, -1, spacing, false);
  pull(1, 0, 0, false);
  pull(0, -1, spacing, true);
  pull(1, -1, 0, true);
  return rate;
}

Problem lattice() {
  Problem p{"lattice", "lattice", "none"};
  // Both nodes up and down against each other: K/k = [1.5 -0.5; -0.5 2.5], of eigenvalue 2 + 1/sqrt 2.
  p.fastest = static_cast<double>(omega) * std::sqrt(2 + std::sqrt(0.5));
  p.unit = static_cast<double>(1 / omega);
  p.duration = 4 * p.unit;
  p.earliest = 0.5;
  p.length = 0.03;
  p.speed = 0.3;
  p.least_steps = 60;
  p.system = [] {
    Scene scene = lattice_scene(2, 2);
    scene.lattice[0].fixed_columns = {0};
    scene.lattice[0].structural = {.stiffness = stiffness, .damping = lattice_damping};
    scene.lattice[0].shear = {.stiffness = stiffness, .damping = lattice_damping};
    return std::make_unique<System>(scene);
  };
  const auto path = std::make_shared<Trajectory>(lattice_rate, Numbers(lattice_start.begin(), lattice_start.end()),
                                                 0.05L / omega, 1.4L * p.duration);
  p.state = [path](long double t) { return rounded(path->at(t)); };
  return p;
}

}  // namespace

std::vector<Problem> spring_problems() {
  return {spring(0, "spring", "spring"),
          spring(0.2, "damped_spring", "damped spring"),
          driven(),
          lattice(),
          tear(false),
          tear(true)};
}

}  // namespace furrow::verification
