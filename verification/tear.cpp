// When a link tears, which one, and what that costs.
//
//   a link tears when its spring force exceeds its strength S, at the stretch x_c = S/k
//   pulled by a plate at speed v through a contact F = 4/3 E* sqrt(R) d^(3/2):
//     v t = x_c + (S/(4/3 E* sqrt(R)))^(2/3)
//   step load F0 on a mass at rest, tears if F0 > S/2:
//     x = F0/k (1 - cos wt)
//   impulse v0, tears if v0 > w x_c:
//     x = v0/w sin wt
//     t = asin(w x_c/v0)/w
//   energy lost with a link:
//     F^2/(2 k)
//
// Source: algebra.
#include <map>
#include <numbers>
#include <set>

#include "run/observe.h"
#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double spacing = 0.1;               // m
constexpr double mass = 5;                    // kg
constexpr double stiffness = 500;             // N/m
constexpr double strength = 2;                // N
constexpr double omega = 10;                  // rad/s, sqrt(500 / 5)
constexpr double x_c = strength / stiffness;  // m

Scene lattice_scene(int rows, int columns) {
  Scene scene = bare_lattice(rows, columns, spacing, mass);
  scene.material.push_back({.name = "rigid", .rigid = true});
  scene.lattice[0].structural = {.stiffness = stiffness, .strength = strength};
  return scene;
}

// One spring from a fixed node to the free node 1.
Scene spring_scene(const NodeSetting& free) {
  Scene scene = lattice_scene(1, 2);
  scene.lattice[0].fixed_columns = {0};
  scene.lattice[0].node = {free};
  return scene;
}

struct Torn {
  Ran ran;
  std::vector<Tear> tears;
};

Torn run_and_tear(const Scene& scene, double step, double end) {
  std::vector<Tear> tears;
  Ran ran = run_scene(scene, "rk4", step, end, [&](double, const State&, const JumpReport& jump) {
    tears.insert(tears.end(), jump.torn.begin(), jump.torn.end());
    return true;
  });
  return {std::move(ran), std::move(tears)};
}

// The greatest value up to `high` at which `tears` is still false, by bisection.
template <class Tears>
double threshold(double high, const Tears& tears) {
  double low = 0;
  while (high - low > 1e-13 * high) (tears(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return low;
}

TEST(Tear, SlowPullTearsAtTheStrength) {
  requirement("tear.at_strength");
  constexpr double speed = 1e-3, step = 1e-3;  // m/s, s
  Scene scene = spring_scene({.column = 1});
  scene.lattice[0].node_mass = 0.01;
  scene.lattice[0].structural.damping = 1;
  scene.plate.push_back(
      {.left_edge = spacing - 0.01, .lower_edge = -0.05, .velocity = {speed, 0}, .material = "rigid"});
  const Torn torn = run_and_tear(scene, step, 8);
  const double contact = 4.0 / 3 * 2e5 / (1 - 0.3 * 0.3) * std::sqrt(scene.lattice[0].contact_radius);
  const double time = (x_c + std::pow(strength / contact, 2.0 / 3)) / speed;
  expect("links torn", static_cast<double>(torn.tears.size()), 1, exact("one link"));
  const Tear& tear = torn.tears.at(0);
  expect("time of the tear [s]", tear.time, time + step / 2,
         absolute(step / 2 + 1e-4, "seen at the end of a step; the damper's 1 mN presses the contact by 0.1 um more"));
  expect("force at the tear [N]", tear.force, strength + stiffness * speed * step / 2,
         absolute(stiffness * speed * step / 2, "the first step beyond the strength: at most k v h above it"));
}

TEST(Tear, StepLoadTearsFromHalfTheStrength) {
  requirement("tear.step_load");
  const double critical = threshold(strength, [](double force) {
    return !run_and_tear(spring_scene({.column = 1, .force = {force, 0}}), pi / omega / 200, 4 * pi / 3 / omega)
                .tears.empty();
  });
  expect("critical load [N]", critical, strength / 2,
         relative(2.1e-11,
                  "rk4 at omega h = pi/200 with a step at the very peak: its amplitude falls by (omega h)^6/144 a "
                  "step, half of the peak by 2.1e-11 in 200 steps, the peak by 1e-11; doubled"));
}

TEST(Tear, ImpulseTearsWhenTheStretchGetsThere) {
  requirement("tear.impulse");
  constexpr double step = 1e-3;  // s
  const double critical = threshold(2 * omega * x_c, [](double speed) {
    return !run_and_tear(spring_scene({.column = 1, .velocity = {speed, 0}}), pi / omega / 200, pi / omega)
                .tears.empty();
  });
  expect(
      "critical speed [m/s]", critical, omega * x_c,
      relative(2.1e-11,
               "rk4 at omega h = pi/200 with a step at the very peak: (omega h)^6/144 a step over 100 steps, doubled"));
  for (const double excess : {1.01, 1.5, 4.0}) {
    const Torn torn = run_and_tear(spring_scene({.column = 1, .velocity = {excess * omega * x_c, 0}}), step, 1);
    const double steps = std::ceil(std::asin(1 / excess) / omega / step);
    expect("steps until it tears, v0 = " + std::to_string(excess) + " w x_c", torn.tears.at(0).time / step, steps,
           absolute(1e-12, "the first step after the exact time; round-off of n h / h"));
  }
}

TEST(Tear, EachKindOfLinkHasItsOwnStrength) {
  requirement("tear.own_strength");
  constexpr double shear = 700, bending = 200;                                                                 // N/m
  const auto diagonal = [](double strain) { return spacing * (std::hypot(1 + strain, 1) - std::sqrt(2.0)); };  // m
  Scene scene = lattice_scene(3, 4);
  Lattice& lattice = scene.lattice[0];
  lattice.structural.strength = stiffness * spacing * 0.01;
  lattice.shear = {.stiffness = shear, .strength = shear * diagonal(0.02)};
  lattice.bending = {.stiffness = bending, .strength = bending * 2 * spacing * 0.03};
  const auto torn_by = [&](double strain, TearRule rule) {
    lattice.tear = rule;
    lattice.node.clear();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        lattice.node.push_back({.row = row, .column = column, .displacement = {strain * column * spacing, 0}});
    System system(scene);
    State y = system.initial_state();
    std::map<LinkClass, double> torn;
    for (const Tear& tear : system.jump(0, y).torn) ++torn[system.parts().link.kind[tear.link]];
    return std::pair(torn, y[system.ledger_of(tear_energy)]);
  };
  constexpr double hair = 1e-9;
  for (const double strain : {0.01, 0.02, 0.03}) {
    for (const double side : {-hair, hair}) {
      auto [torn, energy] = torn_by(strain * (1 + side), TearRule::tension);
      const double at = strain * (1 + side);
      const std::string name = " at a stretch of " + std::to_string(strain) + (side < 0 ? " less 1e-9" : " plus 1e-9");
      const double along = at > 0.01 ? 9 : 0, across = at > 0.02 ? 12 : 0, skip = at > 0.03 ? 6 : 0;
      expect("structural links torn" + name, torn[LinkClass::structural], along, exact("a count: 3 rows of 3"));
      expect("shear links torn" + name, torn[LinkClass::shear], across, exact("a count: 6 cells of 2"));
      expect("bending links torn" + name, torn[LinkClass::bending], skip, exact("a count: 3 rows of 2"));
      const double stretch = spacing * at;
      expect("tear energy [J]" + name, energy,
             0.5 * (along * stiffness * stretch * stretch + across * shear * diagonal(at) * diagonal(at) +
                    skip * bending * 4 * stretch * stretch),
             absolute(6e-16,
                      "round-off: stretches good to an ulp of 0.3 m, 6e-17, times forces of up to 3 N, as a random "
                      "walk over 27 links, doubled"));
    }
  }
  const auto squeezed = torn_by(-0.15, TearRule::tension).first;
  expect("links torn by compression", static_cast<double>(squeezed.size()), 0, exact("tension only"));
  auto crushed = torn_by(-0.15, TearRule::magnitude).first;
  expect("links torn by compression, rule of magnitude",
         crushed[LinkClass::structural] + crushed[LinkClass::shear] + crushed[LinkClass::bending], 27,
         exact("all that are not upright"));
}

TEST(Tear, TakesTheEnergyOfItsSpringAndNoMore) {
  requirement("tear.energy");
  constexpr double v0 = 0.06, step = 1e-3;  // m/s, s
  const Torn torn = run_and_tear(spring_scene({.column = 1, .velocity = {v0, 0}}), step, 1);
  const double time = std::ceil(std::asin(omega * x_c / v0) / omega / step) * step;
  const double force = stiffness * v0 / omega * std::sin(omega * time);
  const Energies energy = observe(torn.ran.system, 1, torn.ran.y).energy;
  const char* reason =
      "truncation of rk4 at omega h = 0.01: (omega h)^4/120 a radian over 0.7 rad, doubled, and 1e-9 "
      "times the slope of the energy";
  expect("force at the tear [N]", torn.tears.at(0).force, force, relative(1.5e-10, reason));
  expect("tear energy [J]", energy.tear, 0.5 * force * force / stiffness, relative(3e-10, reason));
  expect("kinetic energy afterwards [J]", energy.kinetic, 0.5 * mass * v0 * v0 - 0.5 * force * force / stiffness,
         relative(3e-10, reason));
  expect("spring energy afterwards [J]", energy.springs, 0, exact("there is no spring"));
}

TEST(Tear, MultistepMethodsForgetTheTornLink) {
  requirement("tear.forgotten");
  for (const char* method : {"pece", "verlet", "odeint_abm2"}) {
    double time = 0, place = 0, speed = 0;  // s, m, m/s: at the tear
    const Ran ran = run_scene(spring_scene({.column = 1, .velocity = {0.06, 0}}), method, 1e-3, 1,
                              [&](double t, const State& y, const JumpReport& jump) {
                                if (!jump.torn.empty()) time = t, place = y[0], speed = y[2];
                                return true;
                              });
    expect("place at the end [m], " + std::string(method), ran.y[0], place + speed * (1 - time),
           absolute(1.3e-14,
                    "uniform motion: round-off of 900 steps, half an ulp of 0.14 m each and of one sign at worst; "
                    "one remembered force would be h^2 a/4 = 1e-7 m"));
  }
}

TEST(Tear, MirrorImagesTearInTheSameSteps) {
  requirement("tear.order_of_storage");
  constexpr int columns = 6;
  using Ends = std::pair<std::pair<int, int>, std::pair<int, int>>;
  // Steps and ends (row, column) of the links torn; `mirrored` counts columns from the right.
  const auto tears = [](bool mirrored) {
    const auto place = [&](int column) { return mirrored ? columns - 1 - column : column; };
    Scene scene = lattice_scene(4, columns);
    scene.lattice[0].shear = scene.lattice[0].structural;
    scene.lattice[0].bending = {.stiffness = 300, .damping = 1, .strength = 1.5};
    scene.lattice[0].node = {{.row = 3, .column = place(1), .velocity = {mirrored ? 0.2 : -0.2, 0.3}},
                             {.row = 0, .column = place(3), .velocity = {mirrored ? -0.1 : 0.1, -0.4}}};
    const Torn torn = run_and_tear(scene, 1e-3, 0.5);
    const NodeArrays& node = torn.ran.system.parts().node;
    const LinkArrays& link = torn.ran.system.parts().link;
    std::set<std::pair<long, Ends>> all;
    for (const Tear& tear : torn.tears) {
      const std::pair a(node.row[link.a[tear.link]], place(node.column[link.a[tear.link]]));
      const std::pair b(node.row[link.b[tear.link]], place(node.column[link.b[tear.link]]));
      all.insert({std::lround(tear.time / 1e-3), std::minmax(a, b)});
    }
    return all;
  };
  const auto original = tears(false);
  expect_true("at least ten links tear", original.size() >= 10, "else the comparison says little");
  expect_true("the mirror image tears the same links in the same steps", original == tears(true),
              "links are stored from the left: the mirror image has them in another order");
}

TEST(Tear, TwoLinksAtTheirLimitTearTogether) {
  requirement("tear.order_of_storage");
  Scene scene = lattice_scene(1, 3);
  scene.lattice[0].fixed_columns = {0, 2};
  scene.lattice[0].node = {{.column = 1, .velocity = {0, 1}}};
  const Torn torn = run_and_tear(scene, 1e-3, 0.1);
  expect("links torn", static_cast<double>(torn.tears.size()), 2, exact("both springs are stretched alike"));
  expect("time between them [s]", torn.tears.at(1).time - torn.tears.at(0).time, 0, exact("the same step"));
}

TEST(Tear, NothingHeals) {
  requirement("tear.for_ever");
  // Torn at the start, then pushed back through its rest length: a parabola.
  Scene scene = spring_scene({.column = 1, .displacement = {2 * x_c, 0}, .force = {-0.1, 0}});
  scene.lattice[0].structural.damping = 40;
  System system(scene);
  State y = system.initial_state();
  for (const double start : {0.0, 1.0})  // the second half with a fresh method
    run(system, *make_method("pece"), y, {.start = start, .end = start + 1, .step = 1e-3, .stop = {}},
        [](double, const State&, const JumpReport&) { return true; });
  expect("position after 2 s [m]", y[system.x_of(0)], spacing + 2 * x_c - 0.5 * 0.1 / mass * 2 * 2,
         absolute(3e-15,
                  "pece is exact on a parabola; round-off of 2000 steps, half an ulp of 0.1 m each, as a random "
                  "walk, and of the sums of the speed"));
  expect_true("still torn", system.torn(0), "no link is ever mended");
}

}  // namespace
}  // namespace furrow::verification
