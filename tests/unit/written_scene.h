// A short run of which everything is known: its states, kept in memory by a run without files, and its contacts, by
// closed forms. For tests that compare written files with it.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "run/prepare.h"
#include "scenes.h"

namespace furrow::test {

// Two discs on a floor between two plates that close, one with a face, one with a corner; a third one in flight, and a
// lattice whose end flies off.
inline Scene written_scene() {
  Scene scene = empty_scene();
  scene.title = "Written and read back";
  scene.model.gravity = 9.81;
  scene.model.disc_depth = 0.5;
  scene.contact.damping_factor = 0.1;
  scene.disc = {disc({0, 0.098}, 0.1, {0.2, -0.3}), disc({0.17, 0.079}, 0.08), disc({1, 0.5}, 0.05, {-1, 0.5})};
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.plate = {plate({-0.148, 0.02}, 0.05, 0.3, {0.3, 0.4}), plate({0.242, 0.11}, 0.02, 0.25, {-0.1, 0})};
  scene.plate[0].name = "tool";
  scene.plate[1].name = "press";
  Lattice l = lattice({3, 1}, 2, 3, 0.5);
  l.name = "stem";
  l.fixed_columns = {0};
  l.gravity = true;
  l.structural = link_kind(100, 0.5, 1);
  l.shear = link_kind(50, 0.25);
  l.bending = link_kind(20, 0);
  l.node = {node_setting(1, 2, {0.001, 0.002}, {1, 0.5}, {40, -5})};
  scene.lattice = {l};
  scene.time = {.end = 0.02, .step = 1e-4, .method = "pece"};
  scene.output.interval = 0.02 / 87;  // never halfway between two steps
  scene.output.frames = {0, 0.00512, 0.02};
  return scene;
}

struct Moment {
  double t;
  State y;
  std::vector<Tear> torn;  // at this moment
};

struct KnownRun {
  explicit KnownRun(const Scene& asked) : scene(asked), prepared(prepare(asked)), system(prepared.system) {
    State y = prepared.y;
    const auto method = make_method(scene.time.method);
    const RunPlan plan{.start = 0, .end = scene.time.end, .step = scene.time.step};
    run(system, *method, y, plan, [&](double t, const State& now, const JumpReport& report) {
      moments.push_back({t, now, report.torn});
      return true;
    });
  }

  // The moment nearest to a time, of a run with fixed steps.
  const Moment& nearest(double t) const {
    return moments.at(static_cast<std::size_t>(std::lround(t / scene.time.step)));
  }

  bool intact(int link, double t) const {
    for (const Moment& m : moments) {
      for (const Tear& tear : m.torn) {
        if (tear.link == link && m.t <= t) return false;
      }
    }
    return true;
  }

  Scene scene;
  Prepared prepared;
  System& system;
  std::vector<Moment> moments;
};

// One contact of discs without friction: n from a to the other, force on the other +push n.
struct KnownContact {
  int a, b, plate;  // discs; -1: wall or plate, none
  double nx, ny, overlap, push, arm_a, arm_b, energy;
};

// The contacts of written_scene's discs by the formulas of Hertz and Tsuji, from positions and velocities alone.
inline std::vector<KnownContact> contacts_of(const KnownRun& known, const Moment& m) {
  const double modulus = 1e6 / 1.875, viscosity = 2 * std::sqrt(5.0 / 6) * 0.1;  // Pa, -
  const Scene& scene = known.scene;
  const System& s = known.system;
  std::vector<KnownContact> found;
  const auto mass = [&](int i) { return 1000 * std::numbers::pi * scene.disc[i].radius * scene.disc[i].radius * 0.5; };
  const auto add = [&](int a, int b, int plate, double dx, double dy, double vx, double vy) {
    const double distance = std::hypot(dx, dy), radius = scene.disc[a].radius;
    const double overlap = radius + (b >= 0 ? scene.disc[b].radius : 0) - distance;
    if (!(overlap > 0)) return;
    const double nx = dx / distance, ny = dy / distance;
    const double reduced = b >= 0 ? 1 / (1 / radius + 1 / scene.disc[b].radius) : radius;
    const double reduced_mass = b >= 0 ? 1 / (1 / mass(a) + 1 / mass(b)) : mass(a);
    const double elastic = 4.0 / 3 * modulus * std::sqrt(reduced) * std::pow(overlap, 1.5);
    const double stiffness = 2 * modulus * std::sqrt(reduced * overlap);
    const double approach = (m.y[s.vx_of(a)] - vx) * nx + (m.y[s.vy_of(a)] - vy) * ny;
    const double push = std::max(0.0, elastic + viscosity * std::sqrt(stiffness * reduced_mass) * approach);
    const double share = b >= 0 ? 0.5 : 1;  // of the overlap, which shortens the arm
    found.push_back({a, b, plate, nx, ny, overlap, push, radius - share * overlap,
                     b >= 0 ? scene.disc[b].radius - share * overlap : 0, 0.4 * elastic * overlap});
  };
  for (int i = 0; i < static_cast<int>(scene.disc.size()); ++i) {
    const double x = m.y[s.x_of(i)], y = m.y[s.y_of(i)];
    add(i, -1, -1, 0, -y, 0, 0);
    for (int j = i + 1; j < static_cast<int>(scene.disc.size()); ++j)
      add(i, j, -1, m.y[s.x_of(j)] - x, m.y[s.y_of(j)] - y, m.y[s.vx_of(j)], m.y[s.vy_of(j)]);
    for (int k = 0; k < static_cast<int>(scene.plate.size()); ++k) {
      const Plate& p = scene.plate[k];
      const double left = p.left_edge + p.velocity.x * m.t, lower = *p.lower_edge + p.velocity.y * m.t;
      add(i, -1, k, std::fmin(std::fmax(x, left), left + p.width) - x,
          std::fmin(std::fmax(y, lower), lower + p.height) - y, p.velocity.x, p.velocity.y);
    }
  }
  return found;
}

}  // namespace furrow::test
