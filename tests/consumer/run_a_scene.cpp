// Reads a scene, runs it and reads the force on its plate after each step.
#include <algorithm>
#include <iostream>

#include "examples.h"
#include "run/observe.h"
#include "run/prepare.h"
#include "run/run.h"
#include "scene/read.h"

constexpr std::string_view pushed_disc = R"(
title = "A plate pushes a disc away"
[model]
gravity = 0.0
[time]
end = 0.05
step = 1e-5
method = "rk4"
[[material]]
name = "soft"
density = 1000.0
young = 2e5
poisson = 0.3
[[disc]]
position = [0.0, 0.0]
radius = 0.01
material = "soft"
[[plate]]
left_edge = -0.0201
lower_edge = -0.05
width = 0.01
height = 0.1
velocity = [0.1, 0.0]
material = "soft"
)";

double largest_force_on_the_plate() {
  const furrow::Scene scene = furrow::parse_scene(pushed_disc, "pushed_disc");
  furrow::Prepared ready = furrow::prepare(scene);  // packings placed and settled
  const auto method = furrow::make_method(scene.time.method);
  double largest = 0;
  const auto end = furrow::run(ready.system, *method, ready.y, {.end = scene.time.end, .step = scene.time.step},
                               [&](double t, const furrow::State& y, const furrow::JumpReport&) {
                                 const auto seen = furrow::observe(ready.system, t, y);
                                 largest = std::max(largest, -seen.plate[0].x);
                                 return true;  // false would stop the run
                               });
  std::cout << scene.title << ": " << to_string(end.ending) << " after " << end.steps << " steps\n";
  return largest;
}
