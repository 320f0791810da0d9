#include "report/cases.h"

#include <algorithm>

#include "report/study.h"
#include "run/run.h"

namespace furrow {
namespace {

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

}  // namespace

Scene scene_file(const std::string& name) { return scene_named(name); }

Case make_case(const CaseInfo& info) {
  Scene scene = info.scene();
  scene.output.energy = false;
  Prepared p = prepare(scene);
  Case made{std::move(p.system), std::move(p.y), info.span};
  if (info.span.start > 0) {
    run(made.system, *make_method("pece"), made.y, {.start = 0, .end = info.span.start, .step = 5e-5, .stop = {}},
        [](double, const State&, const JumpReport&) { return true; });
  }
  return made;
}

const std::vector<CaseInfo>& cases() {
  static const std::vector<CaseInfo> all{
      {.name = "single_spring",
       .title = "a mass on a damped spring, 2 s",
       .span = {0, 0.1, 20},
       .coarsest = 0.1,
       .finest = 2e-5,
       .phases = 1,
       .reference_step = 1e-4,
       .other_step = 1e-3,
       .nudge_end = 20,
       .scene = [] { return scene_file("single_spring"); }},
      {.name = "hertz_impact",
       .title = "a disc of the paper bounces off a rigid wall, undamped",
       .span = {0, 0.01, 10},
       .coarsest = 1e-2,
       .finest = 5e-6,
       .reference_step = 1e-6,
       .other_step = 1e-5,
       .locate = {Locate::none, Locate::all},
       .nudge_end = 1,
       .scene = [] { return impact(0); }},
      {.name = "damped_hertz_impact",
       .title = "a disc of the paper creeps into a rigid wall, beta = 20",
       .span = {0, 0.01, 10},
       .coarsest = 1e-2,
       .finest = 5e-6,
       .reference_step = 2e-7,
       .other_step = 2e-6,
       .locate = {Locate::none, Locate::all},
       .nudge_end = 1,
       .scene = [] { return impact(20); }},
      {.name = "cantilever",
       .title = "a clamped lattice under a load at its tip, 1 s",
       .span = {0, 0.1, 10},
       .coarsest = 2e-3,
       .finest = 2.5e-5,
       .phases = 1,
       .reference_step = 1e-5,
       .other_step = 1e-4,
       .nudge_end = 3,
       .scene = [] { return scene_file("cantilever"); }},
      {.name = "tearing_lattice",
       .title = "a lattice whose outer column is thrown away, 0.5 s",
       .span = {0, 0.02, 25},
       .coarsest = 2e-2,
       .finest = 2.5e-5,
       .reference_step = 5e-6,
       .other_step = 1e-5,
       .locate = {Locate::none, Locate::tears, Locate::all},
       .nudge_end = 1,
       .scene = [] { return tearing_lattice(); }},
      {.name = "scenario_1",
       .title = "the paper's first scene, 1.2 s",
       .span = {0, 0.02, 60},
       .coarsest = 2e-2,
       .finest = 2.5e-5,
       .by_force = true,
       .reference_step = 4e-6,
       .other_step = 1e-5,
       .locate = {Locate::none, Locate::tears, Locate::all},
       .nudge_end = 1.2,
       .scene = [] { return scene_file("scenario_1"); }},
      {.name = "scenario_2",
       .title = "the paper's second scene from 2 s on, for 0.1 s",
       .span = {2, 0.002, 50},
       .coarsest = 2e-3,
       .finest = 6e-6,
       .phases = 1,
       .by_force = true,
       .reference_step = 1e-6,
       .other_step = 1e-5,
       .nudge_end = 0.5,
       .big = true,
       .scene = [] { return scene_file("scenario_2"); }},
      {.name = "scenario_3",
       .title = "the paper's third scene from 3.55 s, where the plate meets the lattice, for 0.1 s",
       .span = {3.55, 0.002, 50},
       .coarsest = 2e-3,
       .finest = 6e-6,
       .phases = 1,
       .by_force = true,
       .reference_step = 1e-6,
       .other_step = 2e-6,
       .other = "pece",  // no controlled method gets through: see the chart
       .nudge_end = 0.5,
       .big = true,
       .scene = [] { return scene_file("scenario_3"); }},
  };
  return all;
}

}  // namespace furrow
