// Two elastic discs or spheres, alike or not, meet head-on: they share the impact as their reduced mass, radius and
// modulus say, and nothing else happens to their momentum and energy.
//
//   m* d'' = -K d^(3/2),  K = 4/3 E* sqrt(R*)
//   1/m* = 1/m_1 + 1/m_2,  1/R* = 1/R_1 + 1/R_2,  1/E* = sum (1 - nu^2)/E
//   d_max, F_max and t_c as in hertz_wall.cpp with the closing speed v
//   v_1' = v_1 - 2 (m*/m_1) v,  v_2' likewise
//
// Source: Hertz 1882; test 1 of Chung and Ooi 2011 (Granular Matter 13, 643): two spheres of radius 0.01 m, 10 m/s.
#include "verification/hertz_pair.h"

namespace furrow::verification::hertz_pair {
namespace {

constexpr int steps = 200;  // in a contact time

void expect_elastic(const std::string& what, const Case& c) {
  const Hertz h = closed_form(c);
  const double ma = mass(c.a, c.reading);
  const double mb = mass(c.b, c.reading);
  const Impact got = expect_hertz(what, h, scene_of(c), ma, steps);
  const auto along = [&](int disc) { return angle_x * got.y[4 + disc] + angle_y * got.y[6 + disc]; };  // vx, vy
  const auto across = [&](int disc) { return angle_x * got.y[6 + disc] - angle_y * got.y[4 + disc]; };
  const Tolerance speed = ElasticError{steps}.speed();
  expect(what + ": first body's change of speed [m/s]", along(0) - c.a.speed, -2 * h.mass / ma * h.speed, speed);
  expect(what + ": second body's change of speed [m/s]", along(1) - c.b.speed, 2 * h.mass / mb * h.speed, speed);
  const double scale = ma * std::fabs(c.a.speed) + mb * std::fabs(c.b.speed);
  const auto round_off = absolute(1e-14, "round-off: each step adds the same impulse to both, rounded twice");
  expect(what + ": change of momentum along the line over m v",
         (ma * (along(0) - c.a.speed) + mb * (along(1) - c.b.speed)) / scale, 0, round_off);
  expect(what + ": momentum across the line over m v", (ma * across(0) + mb * across(1)) / scale, 0, round_off);
}

TEST(HertzPair, ClosedFormAgreesWithTheTable) {
  requirement("normal.hertz_pair");
  const Hertz h = closed_form({{glass, 0.01, 10}, {glass, 0.01, -10}, DiscMass::sphere});
  expect("d_max [m]", 2.741127e-4, h.peak_overlap(), last_digit(2e-7));
  expect("F_max [N]", 10696.89, h.peak_force(), last_digit(5e-7));
  expect("t_c [s]", 4.0339456e-5, h.contact_time(), last_digit(2e-8));
}

TEST(HertzPair, EqualBodies) {
  requirement("normal.hertz_pair");
  for (const Matter& m : {glass, limestone}) {
    for (const DiscMass reading : {DiscMass::sphere, DiscMass::disc}) {
      expect_elastic(std::string(m.name) + (reading == DiscMass::disc ? " discs" : " spheres"),
                     {{m, 0.01, 10}, {m, 0.01, -10}, reading});
    }
  }
}

TEST(HertzPair, UnequalRadiiMassesAndMaterials) {
  requirement("normal.hertz_pair");
  expect_elastic("glass sphere on a larger one of cast iron, at rest",
                 {{glass, 0.01, 3}, {cast_iron, 0.025, 0}, DiscMass::sphere});
  expect_elastic("limestone disc caught up by a smaller one of aluminium",
                 {{aluminium, 0.004, 5}, {limestone, 0.01, 1}, DiscMass::disc});
}

// What one gains the other loses, at every moment and not only at the end.
TEST(HertzPair, EqualAndOppositeMomentaStayOpposite) {
  requirement("normal.momentum");
  const Case c{{glass, 0.01, 10}, {glass, 0.01, -10}, DiscMass::sphere};
  const Hertz h = closed_form(c);
  for (const char* method : {"pece", "rk4", "verlet"}) {
    double greatest = 0;
    run_scene(scene_of(c), method, h.contact_time() / 100, 1.2 * h.contact_time(),
              [&](double, const State& y, const JumpReport&) {
                greatest = std::max(greatest, std::fabs(y[4] + y[5]) + std::fabs(y[6] + y[7]));
                return true;
              });
    expect(std::string(method) + ": greatest |v_1 + v_2| [m/s]", greatest, 0,
           exact("equal masses get the same impulse with opposite signs, bit by bit"));
  }
}

}  // namespace
}  // namespace furrow::verification::hertz_pair
