#include "validation/studies/outlook.h"

#include <cmath>

#include "validation/studies/members.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

// As many particles as fill the bed of the paper's: their number goes with 1 / R^2.
void set_radius(Scene& scene, double radius) {
  Packing& p = scene.packing[0];
  const double ratio = p.radius_max / radius;
  p.count = static_cast<int>(std::lround(p.count * ratio * ratio));
  p.radius_min = p.radius_max = radius;
}

// Radii evenly spread by so many percent to both sides; as many particles as have the same area together.
void set_spread(Scene& scene, double percent) {
  Packing& p = scene.packing[0];
  const double radius = p.radius_max, spread = percent / 100;
  p.count = static_cast<int>(std::lround(p.count / (1 + spread * spread / 3)));
  p.radius_min = radius * (1 - spread);
  p.radius_max = radius * (1 + spread);
}

void set_speed(Scene& scene, double speed) {
  const double way = scene.plate[0].velocity.x * scene.time.end;
  scene.plate[0].velocity.x = speed;
  scene.output.interval *= way / speed / scene.time.end;
  for (double& t : scene.output.frames) t *= way / speed / scene.time.end;
  scene.time.end = way / speed;
}

// E and G together, so that nu stays. The bed settles by a step that falls as the period of a contact does.
void set_stiffness(Scene& scene, double young) {
  Material& m = scene.material[0];
  const double ratio = young / m.young.value();
  scene.settle->step = scene.time.step * std::fmin(1, 1 / std::sqrt(ratio));
  m.young = young;
  m.shear = ratio * m.shear.value();
}

// By rkc, which keeps an accuracy of a percent at any stiffness that these scenes come to; the paper's step is beyond
// the limit of its own method already.
Scene scene_of(const OutlookVariation& variation, double value, int packing) {
  Scene scene = paper_scene("scenario_2", Reading::disc, 301 + static_cast<std::uint64_t>(packing));
  scene.time.method = "rkc";
  scene.time.relative_tolerance = 1e-2;
  scene.time.absolute_tolerance = 1e-4;
  scene.time.max_step = 5e-3;
  scene.settle->limit = 60;
  if (value != variation.paper) variation.apply(scene, value);
  return scene;
}

}  // namespace

const std::vector<OutlookVariation>& outlook_variations() {
  static const std::vector<OutlookVariation> all{
      {"Speed of the plate", "speed", "m/s", {0.05, 0.1, 0.2, 0.4, 0.8}, 0.1, set_speed},
      {"Radius of the particles",
       "radius",
       "mm",
       {8, 10, 12.5, 15},
       10,
       [](Scene& s, double mm) { set_radius(s, 1e-3 * mm); }},
      {"Spread of the radii", "spread", "%", {0, 10, 20, 30}, 0, set_spread},
      {"Young's modulus", "stiffness", "Pa", {1e5, 2e5, 2e6, 2e7}, 2e5, set_stiffness},
      {"Damping factor",
       "damping",
       "-",
       {1, 5, 10, 20, 40},
       20,
       [](Scene& s, double beta) { s.contact.damping_factor = beta; }},
      {"Sliding friction",
       "friction",
       "-",
       {0.1, 0.3, 0.5, 0.7},
       0.5,
       [](Scene& s, double mu) { s.contact.friction = mu; }},
      {"Rolling friction",
       "rolling",
       "-",
       {0.1, 0.3, 0.5, 0.7},
       0.5,
       [](Scene& s, double mu) { s.contact.rolling_friction = mu; }},
  };
  return all;
}

int outlook_packings(bool quick) { return quick ? 2 : 12; }

std::string outlook_key(const OutlookVariation& variation, double value, int packing) {
  return variation.name + " " + three_digits(value) + " " + std::to_string(packing);
}

void measure_outlook(Measurement& measurement) {
  std::vector<Task> tasks;
  for (const OutlookVariation& variation : outlook_variations()) {
    for (const double value : variation.values) {
      for (int packing = 0; packing < outlook_packings(measurement.quick()); ++packing) {
        const Scene scene = scene_of(variation, value, packing);
        tasks.push_back({outlook_key(variation, value, packing), [scene] { return observed(scene, "scenario_2"); },
                         hash_of_observed(scene, "scenario_2")});
      }
    }
  }
  for (const bool rigid : {false, true}) {
    for (int packing = 0; packing < tool_packings(measurement.quick()); ++packing)
      tasks.push_back(tool_task(rigid, packing));
  }
  measurement.run(tasks);
}

}  // namespace furrow::validation
