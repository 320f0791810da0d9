// A clamped lattice becomes Timoshenko's beam as its spacing shrinks.
//
//   per unit of thickness, with ks = 2 kd and no skip-one springs (isotropic, nu = 1/3), height H = n s:
//     d = P L^3/(3 E I) + P L/(kappa G H)
//     E = 8 kd/3,  G = kd,  I = H^3/12,  kappa = 5/6
//   rows on the edge have a whole spring where half of one belongs to the material, 2 (ks s/2) (H/2)^2 more in E I:
//     Timoshenko / d = 1 + 9/(4 n) + O(1/n^2), first order in the spacing
//
// Source: Timoshenko 1921; the lattice's constants as in lattice_waves.cpp.
#include <cmath>
#include <string>

#include "run/system.h"
#include "verification/cantilever_scenes.h"
#include "verification/check.h"

namespace furrow::verification::cantilever {
namespace {

TEST(Cantilever, TendsToTimoshenkoAsTheLatticeIsRefined) {
  requirement("lattice.cantilever_beam");
  constexpr double load = -1e-3, kd = 1e4;  // N, N/m
  for (const int slenderness : {10, 20}) {
    const double theory = timoshenko(slenderness, kd, load);
    const std::string beam_name = ", L/H = " + std::to_string(slenderness);
    Eigen::Vector3d excess;  // Timoshenko / deflection - 1
    for (int level = 0; level < 3; ++level) {
      const int n = 4 << level;
      const Beam b = isotropic(n, slenderness, kd, load);
      const Assembly own(b);
      const Vector rest = own.equilibrium();
      const double deflection = solver_rest(b, own, rest)[own.tip + 1];
      expect("tip deflection [m], " + std::to_string(n) + " cells" + beam_name, deflection, rest[own.tip + 1],
             relative(slenderness * 1e-12, "round-off: half an ulp of the length against the deflection"));
      excess[level] = theory / deflection - 1;
    }
    // excess = limit + first/n + second/n^2 through n = 4, 8, 16
    const Eigen::Matrix3d powers{{1, 1.0 / 4, 1.0 / 16}, {1, 1.0 / 8, 1.0 / 64}, {1, 1.0 / 16, 1.0 / 256}};
    const Eigen::Vector3d terms = powers.partialPivLu().solve(excess);
    expect("Timoshenko / deflection for endless refinement" + beam_name, 1 + terms[0], 1,
           absolute(0.033 / slenderness,
                    "Timoshenko's clamp lets the section contract, ours does not: C H/L, C = 0.0165 "
                    "measured once at L/H = 10 and doubled"));
    expect("factor of 1/n: whole springs on the edges" + beam_name, terms[1], 9.0 / 4,
           absolute(4e-3, "term 1/n^3 of the series at n = 4 to 16, measured once and doubled"));
    expect("observed order from 8 to 16 cells" + beam_name, std::log2(excess[1] / excess[2]), 1,
           absolute(0.05, "next terms of the series: log2((1 + 1.2/18)/(1 + 1.2/36))"));
  }
}

}  // namespace
}  // namespace furrow::verification::cantilever
