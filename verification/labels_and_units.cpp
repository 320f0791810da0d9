// What must hold of every scene whatever it is: nothing depends on the order of counting, nothing on the units.
//
//   units of length L, time T, mass M that are powers of two: every number is multiplied by a power of two, which does
//   not change how it is rounded
//
// Source: invariance of Newton's laws; IEEE 754.
#include <vector>

#include "verification/observers.h"
#include "verification/relabelled.h"

namespace furrow::verification::invariants {
namespace {

TEST(Invariants, LabelsDoNotMatter) {
  requirement("invariants.labels");
  for (const Case& c : cases()) {
    const Outcome base = outcome(c, c.scene);
    const Outcome other = outcome(c, relabelled(c.scene));
    const Parts& parts = base.system.parts();
    std::vector<int> number;
    for (int i = 0; i < parts.disc.count(); ++i) number.push_back(parts.disc.count() - 1 - i);
    for (int n = 0; n < parts.node.count(); ++n) {
      if (parts.node.body[n] < 0) continue;
      const int columns = c.scene.lattice[parts.node.lattice[n]].columns;
      number.push_back(other.system.parts().node.body[n + columns - 1 - 2 * parts.node.column[n]]);
    }
    expect_same(c.name, difference(base, other, {}, 0, number), rounding(c, base));
  }
}

TEST(Invariants, UnitsOfPowersOfTwoChangeNoBit) {
  requirement("invariants.units");
  constexpr double length = 8, time = 1.0 / 32, mass = 16;
  for (const Case& c : cases()) {
    const Outcome base = outcome(c, c.scene);
    const Outcome other = outcome({c.name, {}, c.step * time, c.steps}, in_units(c.scene, length, time, mass));
    const System& s = base.system;
    double different = 0;
    for (int k = 0; k < static_cast<int>(s.size()); ++k) {
      const bool place = k < s.vx_of(0), speed = k < s.spin_of(0), spin = k < s.first_spring();
      const bool spring = k < s.ledger_of(link_damping);
      const double factor = place    ? length
                            : speed  ? length / time
                            : spin   ? 1 / time
                            : spring ? length
                                     : mass * length * length / (time * time);
      different += other.y[k] == factor * base.y[k] ? 0 : 1;
    }
    expect("numbers of the state with other bits, " + c.name, different, 0,
           exact("places, velocities, spins, springs and energies by their powers of two"));
  }
}

}  // namespace
}  // namespace furrow::verification::invariants
