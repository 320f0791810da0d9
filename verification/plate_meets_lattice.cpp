// A plate meets a lattice: the first impact force with the paper's Table 1, and the order of the coupling.
//
//   force on a node that is in the plate by d, d' = v - vx:
//     F = max(0, 4/3 E* sqrt(R*) d^(3/2) + 2 sqrt(5/6) beta sqrt(2 E* sqrt(R* d) m) d')
//   a node alone has a closed form (Antypov and Elliott 2011), with u = d^(5/4) and dtau = a u^(1/5) dt:
//     u = U/(2 r) (e^((r - beta) tau) - e^(-(r + beta) tau))
//     r = sqrt(beta^2 - 1),  U = 5 v / (4 a),  a = sqrt(5 K / (4 m))
//     F = K u^(1/5) (u + 2 beta u')
//   rows of linked nodes are integrated here in long double, on t = T s^4; the links are found by their length alone
//
// The plate is where its motion puts it at every stage, so a contact that stays closed has the order of the method.
//
// Source: the paper's sections on contact and on scene 1, MODEL.md sections 2, 6 and 7.
#include <cmath>
#include <string>
#include <vector>

#include "verification/check.h"
#include "verification/plate_scenes.h"

namespace furrow::verification::plate_meets_lattice {
namespace {

constexpr double end = 0.01;  // s

TEST(PlateMeetsLattice, OracleAgreesWithTheClosedFormOfOneNode) {
  requirement("coupling.plate_impact");
  const Impact got = Oracle(one_node).run(end, 4000);
  const Impact want = closed_form(end);
  expect("one node, force at 10 ms [N]", got.force, want.force,
         relative(2e-9, "truncation of the closed form's time integral, order 2: 1e-9 measured, doubled"));
  expect("one node, greatest force [N]", got.peak, want.peak,
         relative(2e-7, "the greatest of 4000 samples: 1e-7 measured, doubled"));
  const Impact half = Oracle(three_rows).run(end, 1000);
  const Impact full = Oracle(three_rows).run(end, 2000);
  expect("three rows, force at 10 ms, steps halved [N]", half.force, full.force,
         relative(2e-10, "truncation of order 4: 7e-11 measured, doubled"));
  expect("three rows, greatest force, steps halved [N]", half.peak, full.peak,
         relative(1.7e-7, "the greatest of 1000 samples: 8.3e-8 measured, doubled"));
}

TEST(PlateMeetsLattice, FirstImpactForceIsThatOfTheRowsHit) {
  requirement("coupling.plate_impact");
  struct Row {
    std::string name;
    Meeting meeting;
  };
  const Tolerance at_end = relative(8e-6, "order 5/4 at touch: 4e-6 measured at h = 2e-6 s, doubled");
  const Tolerance at_peak = relative(2.2e-5, "order 5/4 at touch: 1.1e-5 measured at h = 2e-6 s, doubled");
  for (const Row& row : {Row{"one node", one_node}, Row{"one row", one_row}, Row{"two rows of ten", two_rows},
                         Row{"three rows of ten", three_rows}}) {
    const Impact want = Oracle(row.meeting).run(end, 2000);
    const Impact got = run_meeting(row.meeting, "rk4", 2e-6, end);
    expect("force at 10 ms [N], " + row.name, got.force, want.force, at_end);
    expect("greatest force [N], " + row.name, got.peak, want.peak, at_peak);
  }
}

TEST(PlateMeetsLattice, CouplingHasTheOrderOfTheMethod) {
  requirement("coupling.order");
  const Impact want = Oracle(held).run(end, 4000);
  struct Row {
    std::string method;
    double order, width;  // -
    double error;         // m, at the shortest step
  };
  for (const Row& row :
       {Row{"pece", 2, 0.05, 2.7e-12}, Row{"verlet", 2, 0.002, 1.1e-11}, Row{"rk4", 4, 0.1, 1.5e-19}}) {
    std::vector<double> steps;
    std::vector<double> errors;
    double got = 0;
    for (const int n : {80, 160, 320, 640}) {
      got = run_meeting(held, row.method.c_str(), end / n, end).x;
      steps.push_back(end / n);
      errors.push_back(std::fabs(got - want.x));
    }
    expect("observed order, " + row.method, fitted_slope(steps, errors), row.order,
           absolute(row.width, "the next order of the error at these steps and round-off: half of it measured"));
    expect("position of the node, 640 steps [m], " + row.method, got, want.x,
           absolute(row.error, "truncation: half of it measured"));
  }
}

}  // namespace
}  // namespace furrow::verification::plate_meets_lattice
