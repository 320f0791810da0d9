// Energy and momentum through tears that change the border while a disc touches it.
//
//   booked    F^2/(2 k) of the link, and what the contact with the border loses by the change:
//               + 8/15 E* sqrt(R) d^(5/2)   where the segment that the disc lay on tears
//               - 8/15 E* sqrt(R) d^(5/2)   where the links across the cell in which the disc was become the border
//   residual  of the balance of energy: the error of the method
//   momentum  m v of the disc + sum of m_n v_n is constant
//
// Source: Hertz 1882; the equations of motion times the velocities; Newton's third law.
#include <algorithm>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/new_face_scenes.h"

namespace furrow::verification::coupling {
namespace {

struct Through {
  State torn;                  // when the link tore
  Energies start, then, end;   // J
  double force, momentum = 0;  // N; N s, change of both components
};

// The lower two nodes fly apart until their link tears.
Through through(int rows, Vec2 disc) {
  constexpr LinkKind strong{.stiffness = 4000, .damping = 5};
  Scene scene = disc_above({.rows = rows, .columns = 2, .structural = strong, .shear = strong}, disc.x, disc.y);
  scene.model.new_faces = true;
  scene.disc[0].velocity = {};
  scene.lattice[0].auxiliary_points = 0;
  scene.lattice[0].structural.strength = 8;
  scene.lattice[0].node = {{.column = 0, .velocity = {-0.2, 0}}, {.column = 1, .velocity = {0.2, 0}}};
  const System system(scene);
  const State start = system.initial_state();
  const auto momentum = [&](const State& y, int velocity) {
    double sum = disc_mass * y[velocity];
    for (int k = 1; k <= 2 * rows; ++k) sum += node_mass * y[velocity + k];
    return sum;
  };
  Through all{{}, observe(system, 0, start).energy, {}, {}, 0, 0};
  int left = 20;  // steps after the tear
  const Ran ran = run_scene(scene, "rk4", 1e-5, 1, [&](double t, const State& y, const JumpReport& jump) {
    if (!jump.torn.empty()) all.torn = y, all.then = observe(system, t, y).energy, all.force = jump.torn[0].force;
    return all.torn.empty() || --left > 0;
  });
  all.end = observe(ran.system, ran.end.time, ran.y).energy;
  for (const int velocity : {system.vx_of(0), system.vy_of(0)})
    all.momentum = std::max(all.momentum, std::fabs(momentum(ran.y, velocity) - momentum(start, velocity)));
  return all;
}

// m, from the disc to the line through two nodes, `bodies` numbers of state apart in x and y.
double distance(const State& y, int bodies, int node_a, int node_b) {
  const double ux = y[1 + node_b] - y[1 + node_a], uy = y[bodies + 1 + node_b] - y[bodies + 1 + node_a];
  const double px = y[0] - y[1 + node_a], py = y[bodies] - y[bodies + 1 + node_a];
  return std::fabs(px * uy - py * ux) / std::hypot(ux, uy);
}

double elastic(double overlap) { return 8.0 / 15 * modulus * std::sqrt(radius) * std::pow(overlap, 2.5); }

void expect_booked(const std::string& name, const Through& t, double lost) {
  expect("booked beside the link's energy [J], " + name, t.then.tear - 0.5 * t.force * t.force / 4000, lost,
         relative(1e-14, "round-off of the overlap, which is a difference of lengths"));
  expect("residual, of the energy at the start, " + name, t.end.residual(t.start) / t.start.live(), 0,
         absolute(1e-13,
                  "truncation: omega h of the links is 1.3e-3, its fourth power a radian 3e-12, of which damping shows "
                  "a part"));
  expect("change of momentum, of that of a node, " + name, t.momentum / (0.2 * node_mass), 0,
         absolute(1e-14, "round-off of some 1000 steps, as a random walk"));
}

TEST(NewFaces, EnergyOfALostFaceIsBooked) {
  requirement("tear.new_faces_booked");
  const Through t = through(1, {spacing / 2, 0.0085});
  expect_booked("segment torn", t, elastic(radius - distance(t.torn, 3, 0, 1)));
}

TEST(NewFaces, EnergyOfANewFaceIsBooked) {
  requirement("tear.new_faces_booked");
  const Through t = through(2, {spacing / 2 + 0.002, spacing / 2 + 0.004});
  const double near = std::min(distance(t.torn, 5, 0, 3), distance(t.torn, 5, 1, 2));
  expect_booked("cell opened", t, -elastic(radius - near));
}

}  // namespace
}  // namespace furrow::verification::coupling
