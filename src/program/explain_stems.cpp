#include "program/explain_stems.h"

#include <cmath>
#include <cstdio>

#include "program/explain_line.h"
#include "scene/labels.h"
#include "scene/strip.h"

namespace furrow {
namespace {

void print_as_built(const Lattice& l) {
  if (!l.stem) return;
  line("", "%d rows of %d, %.6g m apart; %.6g kg in all", l.rows, l.columns, l.spacing,
       l.node_mass * (l.rows - 1) * (l.columns - 1));
}

void print_tearing(const Beam& b) {
  if (std::isinf(b.tearing_strain) && std::isinf(b.tearing_curvature)) return line("", "does not tear");
  line("", "tears in tension at %.6g N, in bending at %.6g N m: %.6g N across its tip", b.tearing_tension(),
       b.bending * b.tearing_curvature, b.tearing_tip_load());
}

void print_beam(const std::string& name, const Lattice& l, const Beam& b) {
  line(name, "EA = %.6g N, EI = %.6g N m^2, GA = %.6g N, nu = %.4g", b.tension, b.bending, b.shear, b.poisson);
  print_as_built(l);
  line("", "as a round rod: diameter %.4g m, young %.4g Pa, density %.4g kg/m^3", b.diameter(), b.young(),
       b.mass / (pi * b.diameter() * b.diameter() / 4));
  line("", "%s",
       b.isotropic ? "isotropic: a sheet of such cells resists alike in all directions"
       : l.stem    ? "not isotropic: its columns are of different stiffness, as a round rod is thin at its edges"
                   : "not isotropic: that takes shear links half as stiff as structural + 4 bending");
  line("", "%s, length %.4g m: first bending at %.4g Hz, tip yields %.4g m/N", b.held ? "held" : "were one end held",
       b.length, b.first_frequency(), b.tip_compliance());
  print_tearing(b);
  if (!l.link.empty()) line("", "all this without what lattice.link says of single links");
}

}  // namespace

void print_stems(const Scene& scene) {
  if (scene.lattice.empty()) return;
  std::printf("\nlattices as beams\n");
  const std::vector<std::string> names = labels(scene.lattice);
  for (std::size_t k = 0; k < scene.lattice.size(); ++k) {
    const std::string name = "lattice " + names[k];
    if (const auto beam = beam_of(scene.lattice[k]))
      print_beam(name, scene.lattice[k], *beam);
    else
      line(name, "does not resist bending");
  }
}

}  // namespace furrow
