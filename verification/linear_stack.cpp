// Two spheres, one on the other, squeezed between floor and ceiling by linear springs: four linear equations.
//
//   m y1'' = k (R - y1) - k (2 R - (y2 - y1)) - m g - c y1' + c' (y2' - y1')
//   m y2'' = k (2 R - (y2 - y1)) - k (y2 + R - top) - m g - c y2' - c' (y2' - y1')
//
// solved by the exponential of their matrix, here a Taylor series in long double, halved and squared.
//
// Source: case DEM03 of MFiX (Garg, Galvin, Li and Pannala 2012, Powder Technol. 220, 122), with the numbers of its
// version among the tests of LAMMPS (unittest/granular, dem03-hooke-3d-si): k = 1000 N/m, spheres of 1 mm and 1e4
// kg/m^3 in a box of 1.8 mm, c = 5 m/s, c' = 5/2 m/s; its places after 0.4 and 2 ms stand in the same file.
#include <array>

#include "run/observe.h"
#include "verification/linear_scenes.h"

namespace furrow::verification::linear_stack {
namespace {

constexpr double radius = 5e-4, top = 1.8e-3, k = 1e3, g = 9.81, low = 4.5e-4, high = 1.35e-3;
const double m = sphere.mass(1e4, radius), c = 5 * m, between = 2.5 * m;

using Matrix = std::array<std::array<long double, 5>, 5>;  // of y1, y2, their speeds, and 1

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix p{};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int l = 0; l < 5; ++l) p[i][j] += a[i][l] * b[l][j];
  return p;
}

std::array<double, 2> places(double t) {
  const long double w = k / m, a = c / m, b = between / m;
  Matrix rate{};
  rate[0] = {0, 0, 1, 0, 0};
  rate[1] = {0, 0, 0, 1, 0};
  rate[2] = {-2 * w, w, -a - b, b, w * (radius - 2 * radius) - g};
  rate[3] = {w, -2 * w, b, -a - b, w * (2 * radius - radius + top) - g};
  constexpr int halvings = 12, terms = 20;
  Matrix whole{}, term{};
  for (int i = 0; i < 5; ++i) whole[i][i] = term[i][i] = 1;
  for (int n = 1; n <= terms; ++n) {
    term = times(term, rate);
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) whole[i][j] += term[i][j] *= t / std::ldexp(1.0L, halvings) / n;
  }
  for (int n = 0; n < halvings; ++n) whole = times(whole, whole);
  const auto row = [&](int i) { return whole[i][0] * low + whole[i][1] * high + whole[i][4]; };
  return {static_cast<double>(row(0)), static_cast<double>(row(1))};
}

Scene stack() {
  Scene scene;
  scene.model = {.gravity = g, .disc_mass = DiscMass::sphere, .law = ForceLaw::linear, .pull = true};
  scene.contact.normal_stiffness = k;
  scene.contact.damping = c;
  scene.contact.pair.push_back({.materials = {"ball", "ball"}, .damping = between});
  scene.material = {{.name = "ball", .density = 1e4, .rigid = true}, {.name = "box", .rigid = true}};
  scene.disc = {{{0, low}, radius, {}, 0, "ball"}, {{0, high}, radius, {}, 0, "ball"}};
  scene.wall = {{"floor", {0, 0}, {0, 1}, "box"}, {"ceiling", {0, top}, {0, -1}, "box"}};
  return scene;
}

TEST(LinearStack, FollowsTheExponentialOfItsMatrix) {
  requirement("normal.linear_stack");
  for (const double t : {4e-4, 2e-3}) {
    const Ran ran = run_scene(stack(), "rk4", 2e-7, t);
    const auto truncation = relative(1e-10, "of rk4 at 0.005 of the fastest period's radian, to the fourth order");
    for (int i = 0; i < 2; ++i)
      expect("height of ball " + std::to_string(i) + " [m]", ran.y[ran.system.y_of(i)], places(t)[i], truncation);
    const Observation seen = observe(ran.system, t, ran.y);
    expect("force on the floor [N]", seen.wall[0].y, -k * (radius - places(t)[0]) + c * ran.y[ran.system.vy_of(0)],
           relative(1e-7, "its overlap is a difference of numbers known to 1e-10"));
    const System fresh(stack());
    expect("energy residual [J]", seen.energy.residual(observe(fresh, 0, fresh.initial_state()).energy), 0,
           absolute(1e-12 * k * radius * radius, "truncation of rk4, of the energy of a spring pressed by R"));
  }
}

TEST(LinearStack, PublishedPlacesAreThoseOfTheMatrix) {
  requirement("normal.linear_stack");
  const auto verlet = relative(2e-3, "half-step velocities of Verlet at 0.05 of the fastest period's radian, order 2");
  expect("y1 of the table at 0.4 ms [m]", 4.1687420671793478e-4, places(4e-4)[0], verlet);
  expect("y2 of the table at 0.4 ms [m]", 1.3830977848181261e-3, places(4e-4)[1], verlet);
  expect("y1 of the table at 2 ms [m]", 4.2120998421449340e-4, places(2e-3)[0], verlet);
  expect("y2 of the table at 2 ms [m]", 1.3786049346145681e-3, places(2e-3)[1], verlet);
}

}  // namespace
}  // namespace furrow::verification::linear_stack
