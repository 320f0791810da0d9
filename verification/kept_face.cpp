// A body that met a plate on one face comes out of that face, also when it was pressed deeper than the plate is thick.
//
//   elastic, head-on, against a plate that stands still:
//     d_max = (15 m v^2/(16 E* sqrt(R)))^(2/5);   v -> -v
//   depth of the centre: d_max - R of a disc, d_max of a node, whose R is its contact radius
//
// Source: Hertz 1882. Here the depth is one and a half times the thickness.
#include <string>

#include "verification/check.h"
#include "verification/kept_face_scenes.h"

namespace furrow::verification::kept_face {
namespace {

struct Pressed {
  double furthest, speed, place;  // m: x; m/s and m at the end
};

Pressed press(Scene scene, double speed, double overlap) {
  const double time = 2.943275184324047 * overlap / speed;  // s, of the contact
  Pressed p{-1, 0, 0};
  const Ran ran = run_scene(scene, "rk4", time / 4000.5, 1.3 * time, [&](double, const State& y, const JumpReport&) {
    p.furthest = std::fmax(p.furthest, y[0]);
    return true;
  });
  p.speed = ran.y[2];
  p.place = ran.y[0];
  return p;
}

void expect_thrown_back(const std::string& which, const Pressed& p, double speed, double overlap, double reach) {
  expect("speed afterwards / -v, " + which, -p.speed / speed, 1,
         relative(2.6e-10, "truncation of order 5/2: 1.3e-10 measured at 4000 steps of a contact, doubled"));
  expect("greatest depth of the centre, of the thickness, " + which, p.furthest / width, 1.5,
         relative(4.3e-8 * overlap / (1.5 * width),
                  "the greatest of 4000 samples: 2.1e-8 of the overlap measured of other contacts, doubled"));
  expect_true("it is in front of its own face again, " + which, p.place < -reach, "the other one is at +0.01 m");
}

TEST(KeptFace, ADiscPressedThroughThePlateComesBack) {
  requirement("coupling.kept_face");
  const double overlap = radius + 1.5 * width;
  const double speed = std::sqrt(2 * hertz * std::pow(overlap, 2.5) / mass);
  const Pressed p = press(thrown_disc({-radius * (1 + 1e-14), 0.05}, {speed, 0}), speed, overlap);
  expect_thrown_back("disc", p, speed, overlap, radius);
}

TEST(KeptFace, ANodePressedThroughThePlateComesBack) {
  requirement("coupling.kept_face");
  const double overlap = 1.5 * width, node_mass = 2;
  const double speed = std::sqrt(2 * hertz * std::pow(overlap, 2.5) / node_mass);
  Scene scene = plate_scene();
  scene.lattice.push_back({.origin = {-1e-14 * radius, 0.05},
                           .node_mass = node_mass,
                           .material = "any",
                           .contact_radius = radius,
                           .node = {{.velocity = {speed, 0}}}});
  expect_thrown_back("node", press(scene, speed, overlap), speed, overlap, 0);
}

}  // namespace
}  // namespace furrow::verification::kept_face
