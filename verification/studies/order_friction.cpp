// Coulomb's limit: a disc on the floor, of slip speed s = vx + w R, kappa = 3 (a disc's 1 + m R^2/I), moment arm R.
//
//   sliding     an elastic Hertz impact so oblique that all of it slides; u = v - d' is the normal impulse over m:
//               vx = vx0 - mu u
//               w  = w0 - 2 mu u/R
//               x  = x0 + vx0 t - mu (v t - d)
//   stick-slip  set down under gravity with its overlap at rest, N = m g: sticks from xi(0) = 0, slips from
//               xi = mu N/St until s = 0, then sticks again:
//               xi'' = -W^2 xi,  W^2 = kappa St/m
//               s'   = -kappa mu g
//               xi   = mu N/St cos W t
//   sticking    an elastic Hertz impact, mu so great that none of it slips:
//               s'  = -kappa/m St(d) xi
//               xi' = s
//
// In the last the spring's rate jumps at touch from 0 to the slip speed, which costs all methods the first order.
// Source: algebra; for sticking integrated in long double over a clock that takes the powers off both ends.
#include <array>
#include <cmath>
#include <numbers>

#include "run/system.h"
#include "verification/studies/order_hertz.h"
#include "verification/studies/order_problems.h"
#include "verification/studies/order_reference.h"

namespace furrow::verification {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;
constexpr double radius = 0.01;   // m
constexpr double density = 1000;  // kg/m^3
constexpr double young = 2e5;     // Pa
constexpr double poisson = 0.3;   // -
constexpr double closing = 0.1;   // m/s
constexpr double gravity = 9.81;  // m/s^2
constexpr long double kappa = 3;
constexpr long double flight = 0.25L;

const long double mass = density * pi * radius * radius;
const long double root_radius = std::sqrt(static_cast<long double>(radius));
const long double modulus = young / (2 * (1 - static_cast<long double>(poisson) * poisson));              // Pa, E*
const long double shear_modulus = young / (4 * (1 + static_cast<long double>(poisson)) * (2 - poisson));  // Pa, G*
const long double hertz_stiffness = 4 * modulus * root_radius / 3;

Scene floor_scene(double friction, double g) {
  Scene scene;
  scene.model.gravity = g;
  scene.model.moment_arm = MomentArm::radius;
  scene.output.energy = false;
  scene.contact = {.damping_factor = 0, .friction = friction};
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.disc.push_back({.position = {0, 0}, .radius = radius, .material = "any"});
  scene.wall.push_back({.point = {0, -radius}, .material = "any"});
  return scene;
}

// [x, y, vx, vy, spin, springs], the first spring is the floor's.
State state_of(std::array<long double, 4> q_and_v, long double spin, long double spring, std::size_t size) {
  State y(size);
  for (int i = 0; i < 4; ++i) y[i] = static_cast<double>(q_and_v[i]);
  y[4] = static_cast<double>(spin);
  y[5] = static_cast<double>(spring);
  return y;
}

Problem scaled(Problem p, double friction, double g) {
  p.least_steps = 80;
  p.system = [=] { return std::make_unique<System>(floor_scene(friction, g)); };
  return p;
}

// ---- set down ----

Problem stick_slip() {
  constexpr double friction = 0.3;
  const long double normal = mass * gravity;
  const long double overlap = std::pow(normal / hertz_stiffness, 2.0L / 3);
  const long double shear = 8 * shear_modulus * root_radius * std::sqrt(overlap);  // N/m, St
  const long double limit = friction * normal / shear;                             // m
  const long double turn = std::sqrt(kappa * shear / mass);
  const long double launch = 1.6L * limit * turn;             // m/s, slip at the start
  const long double slips = std::asin(1 / 1.6L) / turn;       // s
  const long double speed = launch * std::cos(turn * slips);  // m/s, slip when it begins to slide
  const long double brake = kappa * friction * gravity;       // m/s^2
  const long double sticks = slips + speed / brake;           // s
  Problem p = scaled({"stick_slip", "stick-slip", "slope of the force jumps where it begins and ends to slide", 2},
                     friction, gravity);
  p.controller_sees_it = false;
  p.unit = static_cast<double>(1 / turn);
  p.duration = static_cast<double>(sticks + 0.8L / turn);
  p.length = static_cast<double>(limit);
  p.speed = static_cast<double>(launch);
  const std::size_t size = p.system()->size();
  p.state = [=](long double t) {
    long double way = 0, slip = 0, spring = 0;  // m, of the contact point; m/s; m
    if (t < slips) {
      way = spring = launch / turn * std::sin(turn * t);
      slip = launch * std::cos(turn * t);
    } else if (t < sticks) {
      const long double s = t - slips;
      slip = speed - brake * s;
      way = limit + (speed - brake * s / 2) * s;
      spring = limit;
    } else {
      const long double s = turn * (t - sticks);
      slip = -limit * turn * std::sin(s);
      spring = limit * std::cos(s);
      way = limit + speed * speed / (2 * brake) + spring - limit;
    }
    // A third of the impulse moves the disc, two thirds turn it. It starts without spin.
    const long double vx = launch + (slip - launch) / kappa;
    const long double x = launch * t + (way - launch * t) / kappa;
    return state_of({x, -overlap, vx, 0}, (slip - vx) / radius, spring, size);
  };
  return p;
}

// ---- impacts ----

const long double impact_length = std::pow(mass * closing * closing / hertz_stiffness, 0.4L);
const long double impact_time = impact_length / closing;

// The elastic impact at the time t after the touch.
struct Normal {
  long double overlap, approach;  // m, m/s
};
class ElasticImpact {
 public:
  long double contact() const { return path_.contact() * impact_time; }  // s
  Normal at(long double t) const {
    const auto [overlap, approach] = path_.at(t / impact_time);
    return {overlap * impact_length, approach * closing};
  }

 private:
  HertzPath path_{0, true};
};

Problem impact(Problem p, double friction, double until) {
  p = scaled(std::move(p), friction, 0);
  const ElasticImpact normal;
  p.unit = static_cast<double>(normal.contact());
  p.duration = static_cast<double>((flight + until) * normal.contact());
  p.length = static_cast<double>(impact_length);
  p.speed = closing;
  return p;
}

Problem sliding() {
  constexpr double friction = 0.2;
  const long double limit = friction * modulus / (6 * shear_modulus);  // mu Fn/St over the overlap
  constexpr long double sideways = 0.5L;  // m/s; slides all the way from 2 kappa mu = 1.2 times the closing speed on
  Problem p = impact({"sliding", "sliding impact", "force starts and ends as t^(3/2)", 2.5}, friction, 1.4);
  p.from_rest = p.rebounds = true;  // the capped force follows from the overlap alone
  const auto normal = std::make_shared<ElasticImpact>();
  const std::size_t size = p.system()->size();
  p.state = [=](long double t) {
    const long double s = t - flight * normal->contact();
    const Normal n = normal->at(s);
    const long double impulse = closing - n.approach;
    const long double x = sideways * t - friction * (closing * s - n.overlap);
    return state_of({x, -n.overlap, sideways - friction * impulse, -n.approach}, -2 * friction * impulse / radius,
                    std::fmax(0, limit * n.overlap), size);
  };
  return p;
}

Problem sticking() {
  constexpr double friction = 1e6;
  constexpr long double sideways = 0.05L;  // m/s
  Problem p =
      impact({"sticking", "sticking impact", "rate of the tangential spring jumps at touch", 1}, friction, 0.65);
  const auto normal = std::make_shared<ElasticImpact>();
  const std::size_t size = p.system()->size();
  // [clock, d, d', way, slip, xi] over q with t = q^4: the powers of t^(1/2) at touch become smooth.
  const Rate rate = [](const Numbers& y) -> Numbers {
    const long double pace = 4 * y[0] * y[0] * y[0];
    const long double root = std::sqrt(std::fmax(y[1], 0.0L));
    const long double shear = 8 * shear_modulus * root_radius * root;
    return {1,
            pace * y[2],
            -pace * hertz_stiffness / mass * root * root * root,
            pace * y[4],
            -pace * kappa / mass * shear * y[5],
            pace * y[4]};
  };
  const long double last = std::pow(p.duration, 0.25L);
  const auto path = std::make_shared<Trajectory>(rate, Numbers{0, 0, closing, 0, sideways, 0}, last / 60, last);
  p.state = [=](long double t) {
    const long double s = t - flight * normal->contact();
    if (s <= 0) return state_of({sideways * t, -closing * s, sideways, -closing}, 0, 0, size);
    const Numbers y = path->at(std::pow(s, 0.25L));
    const long double x = sideways * t + (y[3] - sideways * s) / kappa;
    const long double vx = sideways + (y[4] - sideways) / kappa;
    return state_of({x, -y[1], vx, -y[2]}, (y[4] - vx) / radius, y[5], size);
  };
  return p;
}

}  // namespace

std::vector<Problem> friction_problems() { return {stick_slip(), sliding(), sticking()}; }

}  // namespace furrow::verification
