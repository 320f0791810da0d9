// A disc falls on a floor and bounces: parabolas, and impacts with the weight at work in them.
//
//   flight:          y = h - g t^2/2
//                    v = sqrt(2 g (h - R)) at the touch, after t_f = v/g
//   elastic impact:  m v^2/2 + m g d_max = 2/5 K d_max^(5/2)
//                    t_c = 2 int_0^d_max dd / sqrt(v^2 + 2 g d - 4 K/(5 m) d^(5/2))
//   every bounce is like the first: period 2 t_f + t_c, height h
//
// Source: energy and Newton, in any textbook of mechanics; for the contact hertz_wall.cpp. Parameters: drop.h.
#include <cmath>
#include <string>
#include <vector>

#include "verification/elastic_bounce.h"

namespace furrow::verification::bounce {
namespace {

constexpr int bounces = 4;

// By an unrelated way: the equation of motion itself, integrated for half a contact time.
TEST(Bounce, ClosedFormOfTheContactAgreesWithAnIntegration) {
  requirement("normal.bounce");
  for (const double young : {1e5, 1e7, 1e9}) {
    const Elastic e = closed_form(young);
    const double mass = mass_of(of_modulus(young), ball_radius, DiscMass::sphere);
    const double stiffness = hertz_stiffness(softness(of_modulus(young)), ball_radius);
    const double length = std::pow(mass * e.speed * e.speed / stiffness, 0.4);
    const double time = length / e.speed;
    const Motion deepest = integrate_impact(0, e.contact_time / 2 / time, 8000, g * length / (e.speed * e.speed));
    const auto truncation = absolute(2e-14, "truncation of 8000 graded steps of order 4, and round-off of pow");
    expect("greatest overlap over L, E = " + std::to_string(young), static_cast<double>(deepest.overlap),
           e.overlap / length, truncation);
    expect("speed after half the contact time over v", static_cast<double>(deepest.speed), 0, truncation);
  }
}

TEST(Bounce, FlightIsAParabola) {
  requirement("normal.flight");
  for (const char* method : {"pece", "rk4", "verlet"}) {
    Scene scene = impact_scene(DiscMass::disc);
    scene.model.gravity = g;
    add_disc(scene, glass, 0.01, {0.1, 0.5}, {3, 7});
    const Ran ran = run_scene(scene, method, 1e-3, 1);
    expect_true(std::string(method) + ": the run ends well", ran.end.ending == Ending::finished,
                "nothing is in the way");
    const auto round_off = absolute(1e-13, "round-off of 1000 steps: the methods are exact for a parabola");
    const auto along = absolute(2e-14, "round-off of 1000 sums below 4");
    expect(std::string(method) + ": x [m]", ran.y[0], 3.1, along);
    expect(std::string(method) + ": y [m]", ran.y[1], 0.5 + 7 - g / 2, round_off);
    expect(std::string(method) + ": vx [m/s]", ran.y[2], 3, exact("nothing acts along x"));
    expect(std::string(method) + ": vy [m/s]", ran.y[3], 7 - g, round_off);
  }
}

TEST(Bounce, ElasticBouncesRepeatForEver) {
  requirement("normal.bounce");
  constexpr double young = 1e7;  // Pa
  const Elastic e = closed_form(young);
  const double period = 2 * e.fall_time + e.contact_time;
  const std::vector<Event> events = events_of(drop_scene(young), 1e-5, (bounces + 0.2) * period);
  std::string order, expected;
  for (const Event& event : events) order += event.what + " ";
  for (int k = 0; k < bounces; ++k) expected += "touch turn leave peak ";
  expect_true("order of events: " + order, order == expected, "any other order is wrong");
  if (order != expected) return;
  for (int k = 0; k < bounces; ++k) {
    const double touch = e.fall_time + k * period;
    const std::string what = "bounce " + std::to_string(k + 1) + ": ";
    // rk4 with N = t_c/h = 1477 steps in a contact. The touch falls somewhere in a step, and after it the speed is off
    // by C N^-5/2; from then on times drift. Nothing of that has happened before the first touch.
    const auto truncation = [](double value) {
      return absolute(value,
                      "truncation of rk4, C N^-5/2, and what it makes of the bounces before; C measured, doubled");
    };
    const double drift = 3.1e-9;
    expect(what + "touch [s]", events[4 * k].time, touch, truncation(5e-14 + drift * k));
    expect(what + "turn [s]", events[4 * k + 1].time, touch + e.contact_time / 2, truncation(1e-11 + drift * k));
    expect(what + "deepest [m]", ball_radius - events[4 * k + 1].height, e.overlap, truncation(4e-11));
    expect(what + "leave [s]", events[4 * k + 2].time, touch + e.contact_time, truncation(1e-11 + drift * k));
    expect(what + "peak [s]", events[4 * k + 3].time, touch + e.contact_time + e.fall_time,
           truncation(drift * (k + 1)));
    expect(what + "peak [m]", events[4 * k + 3].height, drop, truncation(6e-9));
  }
}

}  // namespace
}  // namespace furrow::verification::bounce
