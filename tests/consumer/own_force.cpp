// A force of one's own: the drag of a fluid, F = -c v, on every disc.
#include <cmath>

#include "examples.h"
#include "run/run.h"
#include "scene/read.h"

void add_drag(furrow::System& system, double c) {  // N s/m
  const auto drag = [c](const furrow::System& s, double /*t*/, const furrow::State& y, furrow::State& rates) {
    for (int i = 0; i < s.parts().disc.count(); ++i) {
      const double mass = s.parts().disc.mass[i];
      rates[s.vx_of(i)] -= c / mass * y[s.vx_of(i)];
      rates[s.vy_of(i)] -= c / mass * y[s.vy_of(i)];
    }
  };
  system.add_force({.add = drag, .velocity_dependence = "drag"});
}

double speed_with_an_own_force() {
  furrow::Scene scene;
  scene.material = {{.name = "soft", .density = 1000, .young = 2e5, .poisson = 0.3}};
  scene.disc = {{.position = {0, 0}, .radius = 0.01, .material = "soft"}};
  furrow::System system(scene);
  add_drag(system, 2 * system.parts().disc.mass[0]);
  furrow::State y = system.initial_state();
  const auto method = furrow::make_method("rk4");
  const auto end = furrow::run(system, *method, y, {.end = 1, .step = 1e-3}, [](auto&&...) { return true; });
  return end.ending == furrow::Ending::finished ? -y[system.vy_of(0)] : NAN;
}
