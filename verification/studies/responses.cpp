#include "verification/studies/responses.h"

#include <algorithm>
#include <cmath>

#include "methods/method.h"
#include "scene/wording.h"
#include "verification/cantilever_scenes.h"
#include "verification/damped_hertz.h"
#include "verification/hertz_law.h"
#include "verification/oblique_scenes.h"
#include "verification/studies/kept_numbers.h"

namespace furrow::verification {
namespace {

constexpr int digits = 5;  // of a number that is drawn

// ---- loops of force and overlap ----

// The paper's disc, 0.1 m/s, against a rigid wall.
struct Loop {
  static constexpr double radius = 0.01, density = 1000, young = 2e5, poisson = -0.5, speed = 0.1;  // SI
  double mass = density * std::numbers::pi * radius * radius;
  double stiffness = hertz_stiffness((1 - poisson * poisson) / young, radius);
  double length = std::pow(mass * speed * speed / stiffness, 0.4);

  Scene scene(double damping_factor) const {
    Scene scene;
    scene.model = {.gravity = 0, .disc_mass = DiscMass::disc};
    scene.output.energy = false;
    scene.contact.damping_factor = damping_factor;
    scene.material.push_back({.name = "disc", .density = density, .young = young, .poisson = poisson});
    scene.material.push_back({.name = "wall", .rigid = true});
    scene.disc.push_back({.position = {0, radius}, .radius = radius, .velocity = {0, -speed}, .material = "disc"});
    scene.wall.push_back({.point = {0, 0}, .normal = {0, 1}, .material = "wall"});
    return scene;
  }
};

Json loop(double damping_factor) {
  const Loop impact;
  constexpr int steps = 20000, rows_apart = 100;
  const DampedHertz exact(damping_factor);
  const double last = static_cast<double>(exact.time(exact.letting_go() * (1 - 1e-9L)));  // in units of the impact
  const double end = 1.05 * last * impact.length / Loop::speed;
  double peak = 0;
  Json rows = Json::array();
  int count = 0;
  State rates;
  const auto see = [&](const System& system, double t, const State& y) {
    rates.resize(y.size());
    system.rhs(t, y, rates);
    const double overlap = (Loop::radius - y[system.y_of(0)]) / impact.length;
    const double force = impact.mass * rates[system.vy_of(0)] / impact.stiffness / std::pow(impact.length, 1.5);
    peak = std::fmax(peak, force);
    if (count++ % rows_apart == 0) rows.push_back({kept(overlap, digits), kept(force, digits)});
  };
  System system(impact.scene(damping_factor));
  State y = system.initial_state();
  run(system, *make_method("rk4"), y, {.start = 0, .end = end, .step = end / steps},
      [&](double t, const State& now, const JumpReport&) {
        see(system, t, now);
        return true;
      });
  return {{"peak", kept(peak, digits)}, {"rows", rows}};
}

// ---- phase portraits ----

Json phase(const std::string& method) {
  constexpr double mass = 5, stiffness = 500, omega = 10, rest = 0.1, stretch = 0.01;  // kg, N/m, rad/s, m
  Scene scene = bare_lattice(1, 2, rest, mass);
  scene.lattice[0].fixed_columns = {0};
  scene.lattice[0].structural = {.stiffness = stiffness};
  scene.lattice[0].node.push_back({.row = 0, .column = 1, .displacement = {stretch, 0}});
  Json rows = Json::array();
  const double step = phase_angle / omega;
  run_scene(scene, method, step, phase_steps * step, [&](double, const State& y, const JumpReport&) {
    rows.push_back({kept((y[0] - rest) / stretch, digits), kept(y[2] / (omega * stretch), digits)});
    return true;
  });
  return rows;
}

// ---- bent lattices ----

Json bent(int cells) {
  constexpr double kd = 1e4, load = -1e-3;  // N/m, N
  const Beam beam = cantilever::isotropic(cells, static_cast<int>(slenderness), kd, load);
  const Assembly own(beam);
  const Vector rest = cantilever::solver_rest(beam, own, own.equilibrium());
  const double theory = cantilever::timoshenko(static_cast<int>(slenderness), kd, load);
  Json rows = Json::array({Json::array({0, 0})});
  const int free = beam.columns - 1, first = cells / 2 * free;  // of the middle row
  for (int k = 0; k < free; k += std::max(1, cells / 4))
    rows.push_back({kept((k + 1.0) / free, digits), kept(rest[2 * (first + k) + 1] / theory, digits)});
  rows.push_back({1, kept(rest[own.tip + 1] / theory, digits)});
  return rows;
}

// ---- published impacts ----

Json glass() {
  constexpr double radius = 0.01, density = 2800, young = 4.8e10, poisson = 0.2, speed = 10;  // SI, each body's
  const double mass = sphere.mass(density, radius);
  const Hertz h{mass / 2, hertz_stiffness(2 * (1 - poisson * poisson) / young, radius / 2), 2 * speed};
  Scene scene;
  scene.model = {.gravity = 0, .disc_mass = DiscMass::sphere};
  scene.output.energy = false;
  scene.material.push_back({.name = "glass", .density = density, .young = young, .poisson = poisson});
  scene.disc.push_back({.position = {0, 0}, .radius = radius, .velocity = {speed, 0}, .material = "glass"});
  scene.disc.push_back({.position = {2 * radius, 0}, .radius = radius, .velocity = {-speed, 0}, .material = "glass"});
  double overlap = 0, force = 0, released = NAN, before = 0, then = 0;
  State rates;
  System system(scene);
  State y = system.initial_state();
  const double end = 1.1 * h.contact_time();
  run(system, *make_method("rk4"), y, {.start = 0, .end = end, .step = end / 20000},
      [&](double t, const State& now, const JumpReport&) {
        rates.resize(now.size());
        system.rhs(t, now, rates);
        const double depth = 2 * radius - (now[system.x_of(1)] - now[system.x_of(0)]);
        overlap = std::fmax(overlap, depth), force = std::fmax(force, mass * rates[system.vx_of(1)]);
        if (before > 0 && depth <= 0) released = then + (t - then) * before / (before - depth);
        before = depth, then = t;
        return true;
      });
  return {{"overlap", kept(overlap, digits)}, {"force", kept(force, digits)}, {"time", kept(released, digits)}};
}

// Without damping along the tangent, as the published computations.
Json oblique(double angle) {
  using namespace oblique_impact;
  constexpr double speed = 3.9;  // m/s
  const Case& p = alumina;
  const double radians = angle * pi / 180, vn = speed * std::cos(radians);
  Scene scene = plane(p, sphere);
  scene.model.slip_damping = false;
  scene.output.energy = false;
  scene.disc.push_back({{0, p.radius}, p.radius, {speed * std::sin(radians), -vn}, 0, "body"});
  const double time = contact_time(p, sphere.mass(p.density, p.radius), vn);
  const Ran ran = run_scene(scene, "rk4", time / (steps / 4 + 0.7), 1.2 * time);
  return kept(std::fabs(ran.y[ran.system.spin_of(0)]), digits);
}

}  // namespace

std::string loop_key(double damping_factor) { return "loop, beta = " + rounded(damping_factor, 3); }
const std::vector<double>& loop_dampings() {
  static const std::vector<double> all{0, 0.2, 1, 20};
  return all;
}

const std::vector<std::string>& phase_methods() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const MethodInfo& m : method_catalogue()) {
      if (m.family == "own" && !m.controlled) names.push_back(m.name);
    }
    return names;
  }();
  return all;
}
std::string phase_key(const std::string& method) { return "phase portrait, " + method; }

const std::vector<int>& bent_cells() {
  static const std::vector<int> all{2, 4, 8, 16};
  return all;
}
std::string bent_key(int cells) { return "bent lattice, " + std::to_string(cells) + " cells"; }

std::string oblique_key(double angle) { return "oblique impact, " + rounded(angle, 4) + " degrees"; }

const std::vector<PublishedSpin>& computed_by_others() {
  static const std::vector<PublishedSpin> all{{10, 213}, {20, 511}, {35, 582}, {40, 545}, {50, 457}, {70, 246}};
  return all;
}

const std::vector<PublishedSpin>& measured_spins() {
  static const std::vector<PublishedSpin> all{{6.0, 135.6},  {11.0, 264.5}, {21.2, 577.0}, {31.1, 612.6},
                                              {39.0, 595.5}, {50.2, 452.9}, {60.2, 381.3}};
  return all;
}

std::vector<double> oblique_angles() {
  std::vector<double> angles;
  for (int k = 1; k <= 42; ++k) angles.push_back(2 * k);
  for (const auto* list : {&computed_by_others(), &measured_spins()}) {
    for (const PublishedSpin& p : *list) angles.push_back(p.angle);
  }
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  return angles;
}

void measure_responses(Measurement& measurement) {
  std::vector<Task> tasks;
  for (const double beta : loop_dampings()) tasks.push_back({loop_key(beta), [beta] { return loop(beta); }});
  for (const std::string& name : phase_methods()) tasks.push_back({phase_key(name), [name] { return phase(name); }});
  for (const int cells : bent_cells()) tasks.push_back({bent_key(cells), [cells] { return bent(cells); }});
  tasks.push_back({glass_key, glass});
  for (const double angle : oblique_angles()) tasks.push_back({oblique_key(angle), [angle] { return oblique(angle); }});
  measurement.run(tasks);
}

}  // namespace furrow::verification
