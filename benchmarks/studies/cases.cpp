#include "studies/cases.h"

#include <algorithm>

#include "studies/study.h"
#include "system/run.h"

namespace furrow::studies {
namespace {

// Without the ledger: not every method is right to be charged for it.
Case from_start(Scene scene, double interval, int samples) {
  scene.output.energy = false;
  Prepared p = prepare(scene);
  return {std::move(p.system), std::move(p.y), {0, interval, samples}};
}

// A disc of the paper flies at 0.1 m/s against a rigid wall, which it touches after 13.7 ms.
Scene impact(double damping_factor) {
  constexpr double radius = 0.01, speed = 0.1;  // m, m/s
  Scene scene;
  scene.model.gravity = 0;
  scene.contact.damping_factor = damping_factor;
  scene.material = {{.name = "common", .density = 1000, .young = 2e5, .shear = 2e5}, {.name = "rigid", .rigid = true}};
  scene.wall = {{.name = "floor", .material = "rigid"}};
  scene.disc = {
      {.position = {0, radius + 0.0137 * speed}, .radius = radius, .velocity = {0, -speed}, .material = "common"}};
  return scene;
}

// A square of the paper's lattice, clamped at its left: its right column is thrown upwards and away.
Scene tearing_lattice() {
  Scene scene;
  scene.model.gravity = 0;
  scene.material = {{.name = "common", .young = 2e5, .shear = 2e5}};
  const LinkKind link{.stiffness = 1e4, .damping = 50, .strength = 40};
  Lattice lattice{.name = "square", .rows = 5, .columns = 5, .spacing = 0.01, .node_mass = 5, .material = "common"};
  lattice.fixed_columns = {0};
  lattice.structural = lattice.shear = lattice.bending = link;
  for (int row = 0; row < lattice.rows; ++row)
    lattice.node.push_back({.row = row, .column = 4, .velocity = {0.6, 0.1 * row}});
  scene.lattice = {lattice};
  return scene;
}

// A scene with a bed from the time `start` on, to which the paper's method has brought it by short steps.
Case with_bed(const std::string& name, double start, double interval, int samples) {
  Case made = from_start(scene_file(name), interval, samples);
  if (start == 0) return made;
  run(made.system, *make_method("pece"), made.y, {.start = 0, .end = start, .step = 5e-5, .stop = {}},
      [](double, const State&, const JumpReport&) { return true; });
  made.span.start = start;
  return made;
}

}  // namespace

Scene scene_file(const std::string& name) { return scene_named(name); }

const std::vector<CaseInfo>& cases() {
  static const std::vector<CaseInfo> all{
      {.name = "single_spring",
       .title = "a mass on a damped spring, 2 s",
       .coarsest = 0.1,
       .finest = 2e-5,
       .phases = 1,
       .reference_step = 1e-4,
       .other_step = 1e-3,
       .nudge_end = 20,
       .make = [] { return from_start(scene_file("single_spring"), 0.1, 20); }},
      {.name = "hertz_impact",
       .title = "a disc of the paper bounces off a rigid wall, undamped",
       .coarsest = 1e-2,
       .finest = 5e-6,
       .reference_step = 1e-6,
       .other_step = 1e-5,
       .nudge_end = 1,
       .make = [] { return from_start(impact(0), 0.01, 10); }},
      {.name = "damped_hertz_impact",
       .title = "a disc of the paper creeps into a rigid wall, beta = 20",
       .coarsest = 1e-2,
       .finest = 5e-6,
       .reference_step = 2e-7,
       .other_step = 2e-6,
       .nudge_end = 1,
       .make = [] { return from_start(impact(20), 0.01, 10); }},
      {.name = "cantilever",
       .title = "a clamped lattice under a load at its tip, 1 s",
       .coarsest = 2e-3,
       .finest = 1e-5,
       .phases = 1,
       .reference_step = 1e-5,
       .other_step = 1e-4,
       .nudge_end = 3,
       .make = [] { return from_start(scene_file("cantilever"), 0.1, 10); }},
      {.name = "tearing_lattice",
       .title = "a lattice whose outer column is thrown away, 0.5 s",
       .coarsest = 2e-2,
       .finest = 1e-5,
       .reference_step = 1e-6,
       .other_step = 2e-6,
       .nudge_end = 1,
       .make = [] { return from_start(tearing_lattice(), 0.02, 25); }},
      {.name = "scenario_1",
       .title = "the paper's first scene, 1.2 s",
       .coarsest = 2e-2,
       .finest = 1e-5,
       .by_force = true,
       .reference_step = 2e-6,
       .other_step = 4e-6,
       .nudge_end = 1.2,
       .make = [] { return from_start(scene_file("scenario_1"), 0.02, 60); }},
      {.name = "scenario_2",
       .title = "the paper's second scene from 2 s on, for 0.1 s",
       .coarsest = 2e-3,
       .finest = 3e-6,
       .phases = 1,
       .by_force = true,
       .reference_step = 1e-6,
       .other_step = 1e-5,
       .nudge_end = 0.5,
       .big = true,
       .make = [] { return with_bed("scenario_2", 2, 0.002, 50); }},
      {.name = "scenario_3",
       .title = "the paper's third scene from 3.55 s, where the plate meets the lattice, for 0.1 s",
       .coarsest = 2e-3,
       .finest = 3e-6,
       .phases = 1,
       .by_force = true,
       .reference_step = 1e-6,
       .other_step = 1e-5,
       .nudge_end = 0.5,
       .big = true,
       .make = [] { return with_bed("scenario_3", 3.55, 0.002, 50); }},
  };
  return all;
}

}  // namespace furrow::studies
