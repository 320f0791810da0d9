// A stack of unequal discs on a floor comes to rest on its contacts.
//
//   d_i = (W_i / K_i)^(2/3),  K = 4/3 E* sqrt(R*),  W_i the weight above contact i
//   stored 2/5 W_i d_i in each contact; what the weights lost in height is stored or was damped
//
// Source: Hertz 1882.
#include <cmath>
#include <numbers>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double gravity = 9.81;                          // m/s^2
constexpr double radius[] = {0.02, 0.01, 0.03, 0.015};    // m, from below
constexpr double density = 1000;                          // kg/m^3
constexpr double young[] = {1e7, 4e6, 1e7, 4e6};          // Pa
constexpr double poisson[] = {0.3, -0.5, 0.3, -0.5};      // -
constexpr double young_floor = 3e7, poisson_floor = 0.2;  // Pa, -
constexpr int discs = 4;

double mass(int i) { return density * std::numbers::pi * radius[i] * radius[i]; }  // kg, depth 1 m

// N/m^(3/2), of disc i with what is below it.
double hertz(int i) {
  const auto softness = [](double e, double nu) { return (1 - nu * nu) / e; };
  const double below = i == 0 ? softness(young_floor, poisson_floor) : softness(young[i - 1], poisson[i - 1]);
  const double reduced = i == 0 ? radius[0] : radius[i] * radius[i - 1] / (radius[i] + radius[i - 1]);
  return 4.0 / 3 * std::sqrt(reduced) / (below + softness(young[i], poisson[i]));
}

// Each disc just touches the one below.
Scene stack() {
  Scene scene;
  scene.model.gravity = gravity;
  scene.contact.damping_factor = 1;
  scene.material = {{.name = "floor", .young = young_floor, .poisson = poisson_floor},
                    {.name = "a", .density = density, .young = young[0], .poisson = poisson[0]},
                    {.name = "b", .density = density, .young = young[1], .poisson = poisson[1]}};
  scene.wall.push_back({"floor", {0, 0}, {0, 1}, "floor"});
  double top = 0;
  for (int i = 0; i < discs; ++i) {
    scene.disc.push_back({{0, top + radius[i]}, radius[i], {0, 0}, 0, i % 2 == 0 ? "a" : "b"});
    top += 2 * radius[i];
  }
  return scene;
}

TEST(StackedDiscs, RestOnTheirWeights) {
  requirement("assembly.stack");
  const Ran ran = run_scene(stack(), "rk4", 5e-5, 4.0);
  double stored = 0;   // J
  double sinking = 0;  // m, of disc i
  double lost = 0;     // J, by the weights
  for (int i = 0; i < discs; ++i) {
    double weight = 0;  // N, on the contact below disc i
    for (int k = i; k < discs; ++k) weight += mass(k) * gravity;
    const double want = std::cbrt(std::pow(weight / hertz(i), 2));
    const double distance = ran.y[ran.system.y_of(i)] - (i == 0 ? 0 : ran.y[ran.system.y_of(i - 1)]);
    stored += 0.4 * weight * want;
    sinking += want;
    lost += mass(i) * gravity * sinking;
    expect("overlap below disc " + std::to_string(i) + " [m]", radius[i] + (i == 0 ? 0 : radius[i - 1]) - distance,
           want, relative(4e-12, "an ulp of the height, 0.15 m, is 5e-14 of the least overlap; what moved has died"));
    expect("sideways position of disc " + std::to_string(i) + " [m]", ran.y[ran.system.x_of(i)], 0,
           exact("every force is vertical"));
  }
  const Energies energy = observe(ran.system, ran.end.time, ran.y).energy;
  expect("stored in the contacts [J]", energy.contact_elastic, stored, relative(2e-12, "as the overlaps"));
  expect("damped [J]", energy.contact_viscous, lost - stored,
         relative(1e-11, "truncation of rk4 over a long ringing: 3e-12 measured"));
}

}  // namespace
}  // namespace furrow::verification
