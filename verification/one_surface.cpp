// Flush plates, a plate that stands on a wall, and the segments of a border feel like one surface: a joint is not felt.
//
//   at rest on it     d = (m g/(4/3 E* sqrt(R)))^(2/3), and nothing moves
//   rolling over it   v = -omega R stays, and so does d
//   sliding over it   all as on one wall: the tangential spring is handed over
//
// Source: geometry; Hertz 1882.
#include <algorithm>
#include <string>

#include "verification/check.h"
#include "verification/one_surface_scenes.h"

namespace furrow::verification::one_surface {
namespace {

TEST(OneSurface, ADiscAtRestOverAJointStaysAtRest) {
  requirement("coupling.one_surface");
  for (const std::string& name : in_pieces) {
    for (const double x : {0.0, 1e-6, 1e-3}) {
      const Ran ran = on(floor_of(name, 0.5), x, 0, 0, 0.1);
      const std::string which = ", " + name + ", x " + std::to_string(x).substr(0, 5);
      expect("overlap / d" + which, (radius - ran.y[1]) / resting, 1,
             relative(6e-15, "four ulps of the height, 1.7e-18 m each, of d = 1.2e-3 m"));
      expect("x [m]" + which, ran.y[0], x, exact("the force points straight up"));
      expect("spin [rad/s]" + which, ran.y[4], 0, exact("no slip"));
    }
  }
}

TEST(OneSurface, ADiscThatRollsOverAJointLosesNothing) {
  requirement("coupling.one_surface");
  constexpr double speed = 0.5, end = 0.2;  // m/s, s: from -0.05 m to 0.05 m
  for (const std::string& name : in_pieces) {
    const System system(floor_of("one wall", 0.5).scene);
    double least = 1, most = 0;
    const Ran ran =
        on(floor_of(name, 0.5), -0.05, speed, -speed / radius, end, [&](double, const State& y, const JumpReport&) {
          least = std::min(least, radius - y[1]);
          most = std::max(most, radius - y[1]);
          return true;
        });
    const Tolerance rounded = relative(6e-15, "four ulps of the height, of d");
    expect("least overlap / d, " + name, least / resting, 1, rounded);
    expect("greatest overlap / d, " + name, most / resting, 1, rounded);
    expect("speed afterwards, of that before, " + name, ran.y[2] / speed, 1, rounded);
    expect("spin afterwards, of that before, " + name, -ran.y[4] * radius / speed, 1, rounded);
  }
}

TEST(OneSurface, ADiscThatSlidesOverAJointKeepsItsSpring) {
  requirement("coupling.one_surface");
  constexpr double speed = 0.02, end = 0.06;  // m/s, s: it slides, sticks and swings
  const Ran whole = on(floor_of("one wall", 0.1), -0.0005, speed, 0, end);
  for (const std::string& name : in_pieces) {
    const Ran ran = on(floor_of(name, 0.1), -0.0005, speed, 0, end);
    expect_true("it has crossed the joint, " + name, ran.y[0] > 1e-5, "else nothing is compared");
    const Tolerance rounded = relative(1e-14, "the same contact by other sums: round-off");
    expect("x / that on one wall, " + name, ran.y[0] / whole.y[0], 1, rounded);
    expect("speed / that on one wall, " + name, ran.y[2] / whole.y[2], 1, rounded);
    expect("spin / that on one wall, " + name, ran.y[4] / whole.y[4], 1, rounded);
  }
}

TEST(OneSurface, APlateOnAWallHasNoLowerFace) {
  requirement("coupling.one_surface");
  Scene scene = floor_of("one wall", 0).scene;
  scene.plate.push_back({.lower_edge = 0, .width = 0.02, .height = 0.1, .material = "any"});
  scene.model.gravity = 0;
  scene.disc.push_back({{-0.006, -0.003}, radius, {}, 0, "any"});
  const System system(scene);
  system.for_each_contact(0, system.initial_state(), [](const Contact& c) {
    if (c.id.kind != disc_plate) return;
    expect("overlap with the plate, of a centre below the floor [m]", c.touch.overlap, radius - 0.006,
           absolute(4e-18, "2 ulp of R"));
    expect("its force upwards [N]", c.fy, 0, exact("the face goes on behind the wall: it points straight aside"));
  });
}

}  // namespace
}  // namespace furrow::verification::one_surface
