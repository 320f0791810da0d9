// Rods and frameworks of springs beside numbers that the literature prints: verification/published/springs.toml.
//
//   a stem held at its foot, P across at its tip, a^2 = P L^2/EI: where the tip goes, of its length (the elastica)
//   pressed along: P L^2/EI at which it buckles, pi^2/4 (Euler), less by shear
//   a square lattice with diagonals, k_s + 4 k_b = 2 k_d: Poisson's ratio C12/C11 = 1/3
//
// Source: Bisshopp and Drucker 1945; Mattiasson 1981; Timoshenko and Gere 1961; Hrennikoff 1941.
#include <cmath>
#include <string>
#include <vector>

#include "verification/check.h"
#include "verification/displaced_lattice.h"
#include "verification/stem_scenes.h"
#include "verification/studies/numbers_of_others.h"

namespace furrow::verification {
namespace {

constexpr double length = 0.12;  // m: 20 diameters

void expect_printed(const std::string& problem, const std::string& name, double got) {
  const NumberOfOthers& n = number_of_others(problem, name);
  expect(problem + ": " + name + " as printed, " + n.printed, got, n.number, absolute(n.tolerance * n.scale, n.reason));
  expect(problem + ": " + name + " in the file", n.got, got,
         absolute(1e-6 * n.scale,
                  "the file has nine digits, and rest is found to 1e-6 of a diameter, 5e-8 of the length"));
}

stem::Rest pushed(Vec2 force) {
  Scene scene = stem::scene_of({});
  stem::load(scene, 1, force);
  const System system(scene);
  stem::Rest rest{system, system.initial_state()};
  constexpr int parts = 8;  // of the load, each from where the one before came to rest
  for (int k = 1; k <= parts; ++k) {
    scene.lattice[0].node[0].force = {force.x * k / parts, force.y * k / parts};
    rest = {System(scene), rest.y};
    rest.y = at_rest(rest.system, 0, rest.y, 1e-6 * stem::diameter);
  }
  return rest;
}

TEST(PublishedSprings, TipOfTheElastica) {
  requirement("stem.published");
  for (const int squared : {1, 4}) {
    const stem::Rest rest = pushed({squared * stem::EI / (length * length), 0});
    const Vec2 tip = rest.at(rest.rows() - 1, 1);
    const std::string problem = "elastica, P L^2/EI = " + std::to_string(squared);
    expect_printed(problem, "across, of the length", (tip.x - stem::diameter / 2) / length);
    expect_printed(problem, "along, of the length", tip.y / length);
  }
}

TEST(PublishedSprings, ColumnBucklesAsEulerSays) {
  requirement("stem.published");
  const double unit = stem::EI / (length * length), low = 2.2 * unit, high = 2.7 * unit;  // N
  const auto softest = [&](double load) {  // 1/s^2, of the stem under the load along it
    const stem::Rest rest = pushed({0, -load});
    const Eigen::MatrixXd k = tangent(rest.system, 0, rest.y, 1e-6 * stem::diameter);
    return softest_mode(k);
  };
  const double at_low = softest(low);  // it falls almost in proportion to the load that is left
  expect_printed("Euler's load", "P L^2/EI", (low + (high - low) * at_low / (at_low - softest(high))) / unit);
}

TEST(PublishedSprings, IsotropicFrameworkHasOneThird) {
  using namespace lattice_waves;
  requirement("stem.published");
  constexpr double strain = 1e-5;
  const System system = lattice_system(side, side, ks, (ks + 4 * kb) / 2);
  const auto stress = [&](const Vector2d& stretch) {  // N/m, on the right edge, along x
    const std::vector<Vector2d> force = odd_forces(system, [&](int row, int column) -> Vector2d {
      return strain * spacing * Vector2d(stretch.x() * column, stretch.y() * row);
    });
    return -(force[middle * side + side - 1] + force[middle * side + side - 2]).x() / (strain * spacing);
  };
  expect_printed("lattice of isotropy", "Poisson's ratio", stress({0, 1}) / stress({1, 0}));
}

}  // namespace
}  // namespace furrow::verification
