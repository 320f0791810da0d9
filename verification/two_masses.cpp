// Two equal masses on a spring swing about their common centre, which moves uniformly; spun fast enough they circle.
//
//   swinging:  r = l + a cos(omega t) e^(..) as for one mass m* = m/2,  omega = sqrt(k/m*)
//              centre X = X0 + V t
//   circling:  k (r - l) = m* Omega^2 r, so at r = 1.25 l
//              Omega = sqrt(k / (5 m*))
//   kept:      momentum, and angular momentum about the centre, m* r^2 Omega
//
// Source: the two-body problem in any textbook of mechanics.
#include "run/observe.h"
#include "verification/spring.h"

namespace furrow::verification {
namespace {

constexpr double reduced = mass / 2;  // kg
constexpr double pi = 3.14159265358979323846;
const double swing = std::sqrt(stiffness / reduced);  // rad/s
constexpr Vec2 drift{0.3, -0.2};                      // m/s, of the centre

// Masses at rest against each other, `longer` than the spring; spun about their centre with `spin`.
Scene pair_scene(double longer, double spin, double zeta) {
  Scene scene = spring_scene(0);
  Lattice& spring = scene.lattice[0];
  spring.fixed_columns = {};
  spring.origin = {0.2, 0.4};
  spring.structural.damping = 2 * zeta * std::sqrt(stiffness * reduced);
  const double speed = spin * (rest + longer) / 2;
  spring.node = {{.row = 0, .column = 0, .displacement = {-longer / 2, 0}, .velocity = {drift.x, drift.y - speed}},
                 {.row = 0, .column = 1, .displacement = {longer / 2, 0}, .velocity = {drift.x, drift.y + speed}}};
  return scene;
}

// State [x0 x1 y0 y1 vx0 vx1 vy0 vy1].
void expect_uniform_centre(const std::string& what, const State& y, double t) {
  const auto summed = absolute(3e-14, "round-off of 2000 steps: the forces cancel bit by bit");
  const auto round_off = absolute(2e-15, "round-off: each step adds the same impulse with opposite signs");
  expect(what + ": centre x [m]", (y[0] + y[1]) / 2, 0.2 + rest / 2 + drift.x * t, summed);
  expect(what + ": centre y [m]", (y[2] + y[3]) / 2, 0.4 + drift.y * t, summed);
  expect(what + ": velocity of the centre, x [m/s]", (y[4] + y[5]) / 2, drift.x, round_off);
  expect(what + ": velocity of the centre, y [m/s]", (y[6] + y[7]) / 2, drift.y, round_off);
}

TEST(TwoMasses, SwingWithTheReducedMassAboutAUniformCentre) {
  requirement("spring.two_masses");
  constexpr double end = 1.9;    // s: 27 radians
  constexpr double step = 1e-3;  // s
  const double q = swing * step;
  for (const double zeta : {0.0, 0.2}) {
    const Ran ran = run_scene(pair_scene(stretch, 0, zeta), "rk4", step, end);
    const State& y = ran.y;
    const std::string what = "damping ratio " + std::to_string(zeta);
    // The one mass of spring.h, its time running faster by swing over omega.
    const double at = end * swing / omega;
    expect(what + ": (r - l) / a", (y[1] - y[0] - rest) / stretch, exact_position(zeta, at),
           absolute(2 * std::pow(q, 4) / 120 * swing * end * std::exp(-zeta * swing * end),
                    "truncation of rk4, q^4/120 a radian, doubled"));
    expect_uniform_centre(what, y, end);
  }
}

TEST(TwoMasses, CircleWhereTheSpringPullsAsHardAsTheyFlee) {
  requirement("spring.two_masses");
  const double spin = std::sqrt(stiffness / (5 * reduced));  // rad/s
  const double turn = 2 * pi / spin;                         // s
  constexpr int steps = 2000;
  const double r = 1.25 * rest;
  double change = 0;
  const Ran ran = run_scene(pair_scene(0.25 * rest, spin, 0), "rk4", turn / steps, turn,
                            [&](double, const State& y, const JumpReport&) {
                              change = std::max(change, std::fabs(std::hypot(y[1] - y[0], y[3] - y[2]) - r));
                              return true;
                            });
  const State& y = ran.y;
  const auto truncation = [](double c) {
    return absolute(2 * c * std::pow(steps, -4), "truncation of rk4, C N^-4, C measured once, doubled");
  };
  expect("after one turn: across / r", (y[3] - y[2]) / r, 0, truncation(780));
  expect("after one turn: along / r", (y[1] - y[0]) / r, 1, truncation(28));
  expect("greatest change of r / r", change / r, 0, truncation(105));
  const double vx = y[5] - y[4];
  const double vy = y[7] - y[6];
  expect("angular momentum over m* r^2 Omega", ((y[1] - y[0]) * vy - (y[3] - y[2]) * vx) / (r * r * spin), 1,
         absolute(3e-14, "round-off of 2000 steps: rk4's own loss is of order N^-5"));
  expect_uniform_centre("circling", y, turn);
}

}  // namespace
}  // namespace furrow::verification
