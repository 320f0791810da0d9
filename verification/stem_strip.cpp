// A stem resists as the rod that it stands for: stretch, narrowing, bending, shear.
//
//   EA = E pi d^2/4,  EI = E pi d^4/64,  GA = EA/(2 (1 + nu))
//   far from its ends, pulled by F, bent by M, pushed across by V:
//     strain F/EA, across -nu F/EA;  curvature M/EI;  shear V/GA
//   the paper's lattice, 3 columns of k each, spacing s (the least of k (e + w)^2 + k w^2 in each cell, k (w + w')^2):
//     EA = 16.5 k s,  EI = 10.25 k s^3,  GA = 2 k s,  nu = 1/4
//
// Source: strength of materials; algebra of a row of cells.
#include <algorithm>
#include <string>

#include "verification/check.h"
#include "verification/stem_scenes.h"

namespace furrow::verification::stem {
namespace {

constexpr double force = 1e-4;  // N: strains of 1e-8, whose squares are lost in round-off
const char* rounding =
    "round-off: an ulp of 0.1 m, 1e-17, of stretches of 1e-8 spacings, over 10 rows; and of the tangent";

void expect_beam(const Scene& held, double want_EA, double want_EI, double want_GA, double nu,
                 const std::string& name) {
  const auto loaded = [&](auto put) {
    Scene scene = held;
    put(scene);
    return at_rest(scene);
  };
  const int last = held.lattice[0].columns - 1;
  const Rest pulled = loaded([&](Scene& s) {
    for (int c = 0; c <= last; ++c) load(s, c, {0, force / (last + 1)});
  });
  const int low = pulled.rows() / 2 - 4, high = low + 8;
  const double s = pulled.spacing(), span = 8 * s, width = last * s;
  const double strain = (pulled.at(high, 0).y - pulled.at(low, 0).y) / span - 1;
  expect("EA [N]" + name, force / strain, want_EA, relative(1e-6, rounding));
  const double across = (pulled.at(low, last).x - pulled.at(low, 0).x) / width - 1;
  expect("Poisson's ratio" + name, -across / strain, nu, relative(3e-6, rounding));
  const Rest bent = loaded([&](Scene& l) {
    load(l, 0, {0, -force});
    load(l, last, {0, force});
  });
  expect("EI [N m^2]" + name, force * width * span / (bent.turn(high) - bent.turn(low)), want_EI,
         relative(1e-6, rounding));
  const Rest pushed = loaded([&](Scene& l) { load(l, last / 2, {force, 0}); });
  if (last != 2) return;             // with more columns the shear is not the same across the cells
  const auto place = [&](int row) {  // mean of the two cells, whose corners bending moves across by nu
    return (pushed.at(row, 0).x + 2 * pushed.at(row, 1).x + pushed.at(row, 2).x) / 4;
  };
  const double lean = (place(low + 1) - place(low)) / s;
  const double turn = 0.5 * (pushed.turn(low) + pushed.turn(low + 1));
  expect("GA [N]" + name, force / (lean + turn), want_GA,
         relative(1e-4, "the same of a shear that is a hundredth of the lean"));
}

TEST(StemStrip, ResistsAsItsRod) {
  requirement("stem.beam");
  for (const Shape& shape : {Shape{3, 0.1}, Shape{3, 1.0 / 3}, Shape{3, 0.5}, Shape{4, 0.3}, Shape{5, 0.3}})
    expect_beam(scene_of(shape), EA, EI, EA / (2 * (1 + shape.poisson)), shape.poisson, shape.name());
}

TEST(StemStrip, HasTheMassOfItsRod) {
  requirement("stem.mass");
  for (const int columns : {3, 4, 5}) {
    const Rest rest{System(scene_of({columns})), {}};
    double mass = 0;
    for (const double m : rest.system.parts().node.mass) mass += m;
    expect("mass [kg], columns " + std::to_string(columns), mass, density * area * 0.12,
           relative(1e-13, "round-off of up to 405 nodes"));
  }
}

TEST(StemStrip, RowsFillItsLength) {
  requirement("stem.mass");
  for (const double length : {0.05, 0.0777, 0.12}) {
    const Rest rest{System(scene_of({3, 0.3, length})), {}};
    const double s = rest.spacing();
    expect("length [m]", (rest.rows() - 1) * s, length, relative(1e-14, "round-off"));
    expect("spacing, of half a diameter", s / (diameter / 2), 1, absolute(0.5 / (rest.rows() - 1.5), "half a row"));
  }
}

}  // namespace
}  // namespace furrow::verification::stem
