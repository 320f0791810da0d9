// A disc falls on a floor and bounces: parabolas, and impacts with the weight at work in them.
//
//   flight:          y = h - g t^2/2
//                    v = sqrt(2 g (h - R)) at the touch, after t_f = v/g
//   elastic impact:  m v^2/2 + m g d_max = 2/5 K d_max^(5/2)
//                    t_c = 2 int_0^d_max dd / sqrt(v^2 + 2 g d - 4 K/(5 m) d^(5/2))
//   every bounce is like the first: period 2 t_f + t_c, height h
//
// Source: energy and Newton, in any textbook of mechanics; for the contact hertz_wall.cpp. Parameters: drop.h.
#include "verification/damped_hertz.h"
#include "verification/drop.h"

namespace furrow::verification {
namespace {

constexpr int bounces = 4;

struct Elastic {
  double speed, overlap, contact_time, fall_time;
};

Elastic closed_form(double young) {
  const long double m = mass_of(of_modulus(young), ball_radius, DiscMass::sphere);
  const long double stiffness = hertz_stiffness(softness(of_modulus(young)), ball_radius);
  const long double v2 = 2 * static_cast<long double>(g) * (drop - ball_radius);
  long double d = std::pow(1.25L * m * v2 / stiffness, 0.4L);
  for (int k = 0; k < 20; ++k) {  // Newton
    d -= (v2 + 2 * g * d - 0.8L * stiffness / m * std::pow(d, 2.5L)) / (2 * g - 2 * stiffness / m * std::pow(d, 1.5L));
  }
  // Near d_max, at a distance r from it, the square root's argument is a difference: taken as one from the energy
  // there.
  const long double half = integral(
      [&](long double x, long double r) {
        const long double lost = 0.8L * stiffness / m * std::pow(d, 2.5L) * -std::expm1(2.5L * std::log1p(-r / d));
        return 1 / std::sqrt(x < r ? v2 + 2 * g * x - 0.8L * stiffness / m * std::pow(x, 2.5L) : lost - 2 * g * r);
      },
      0, d);
  const long double v = std::sqrt(v2);
  return {static_cast<double>(v), static_cast<double>(d), static_cast<double>(2 * half), static_cast<double>(v / g)};
}

struct Event {
  std::string what;
  double time, height;
};

// What happens on a run, each moment worked out from the step around it: parabolas in flight, the turn from a cubic.
std::vector<Event> events_of(const Scene& scene, double step, double end) {
  std::vector<Event> events;
  double t0 = 0, y0 = drop, v0 = 0;
  run_scene(scene, "rk4", step, end, [&](double t, const State& y, const JumpReport&) {
    const double y1 = y[1];
    const double v1 = y[3];
    if (y0 >= ball_radius && y1 < ball_radius) {
      const double after = (v0 + std::sqrt(v0 * v0 + 2 * g * (y0 - ball_radius))) / g;
      events.push_back({"touch", t0 + after, ball_radius});
    } else if (y0 < ball_radius && y1 >= ball_radius) {
      events.push_back({"leave", t - (std::sqrt(v1 * v1 + 2 * g * (y1 - ball_radius)) - v1) / g, ball_radius});
    }
    if (v0 < 0 && v1 >= 0) {
      const double share = v0 / (v0 - v1);
      events.push_back({"turn", t0 + share * (t - t0), y0 + 0.5 * v0 * share * (t - t0)});
    } else if (v0 > 0 && v1 <= 0) {
      events.push_back({"peak", t0 + v0 / g, y0 + v0 * v0 / (2 * g)});
    }
    t0 = t;
    y0 = y1;
    v0 = v1;
    return true;
  });
  return events;
}

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
}  // namespace furrow::verification
