#include "export/data_file.h"

#include <algorithm>

#include "scene/wording.h"
#include "system/place.h"

namespace furrow {
namespace {

// fix bond/break writes past the end of its lists where they are as long as the data asks for (29 Sep 2021).
constexpr const char* room_for_bonds = "30 extra bond per atom\n120 extra special per atom\n";

std::string line(std::initializer_list<std::string> words) { return joined(words, " ") + "\n"; }
std::string words(double a, double b) { return shortest(a) + " " + shortest(b); }
std::string words(int a, int b) { return std::to_string(a) + " " + std::to_string(b); }

// kg/m^3, that gives a sphere the mass of what it stands for.
std::string density(double mass, double radius) { return shortest(mass / (4.0 / 3.0 * pi * radius * radius * radius)); }

std::string box(const Prepared& prepared) {
  const Parts& parts = prepared.system.parts();
  double x0 = infinity, x1 = -infinity, y0 = infinity, y1 = -infinity, most = 0;
  const auto see = [&](double x, double y, double r) {
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    y0 = std::min(y0, y), y1 = std::max(y1, y);
    most = std::max(most, r);
  };
  for (int i = 0; i < parts.disc.count(); ++i)
    see(prepared.y[prepared.system.x_of(i)], prepared.y[prepared.system.y_of(i)], parts.disc.radius[i]);
  const NodeMotion now = prepared.system.nodes(0, prepared.y);
  for (int k = 0; k < parts.node.count(); ++k) see(now.x[k], now.y[k], parts.node.spacing[k]);
  const double wide = 10 * most;  // LAMMPS wants some cells, whatever is in them
  return words(x0 - wide, x1 + wide) + " xlo xhi\n" + words(y0 - wide, y1 + wide) + " ylo yhi\n" + words(-most, most) +
         " zlo zhi\n";
}

std::string discs(const Prepared& prepared, const AtomKinds& kinds) {
  const System& system = prepared.system;
  const DiscArrays& disc = system.parts().disc;
  const State& y = prepared.y;
  std::string atoms = "\nAtoms\n\n", speeds = "\nVelocities\n\n";
  for (const int i : places_in(disc.number)) {
    const int id = disc.number[i] + 1;
    atoms += line({words(id, kinds.of_disc[static_cast<std::size_t>(i)] + 1), shortest(2 * disc.radius[i]),
                   density(disc.mass[i], disc.radius[i]), words(y[system.x_of(i)], y[system.y_of(i)]), "0"});
    speeds +=
        line({std::to_string(id), words(y[system.vx_of(i)], y[system.vy_of(i)]), "0 0 0", shortest(system.spin(y, i))});
  }
  return atoms + speeds;
}

std::string links(const Parts& parts, const AtomKinds& kinds) {
  std::string bonds = "\nBonds\n\n";
  int number = 0;
  for (const auto& [link, type] : kinds.bonds)
    bonds += line({words(++number, type + 1), words(parts.link.a[link] + 1, parts.link.b[link] + 1)});
  return number > 0 ? bonds : "";
}

std::string nodes(const Prepared& prepared, const AtomKinds& kinds) {
  const NodeArrays& node = prepared.system.parts().node;
  const NodeMotion now = prepared.system.nodes(0, prepared.y);
  std::string atoms = "\nAtoms\n\n", speeds = "\nVelocities\n\n", loads = "\nLoads\n\n";
  for (int k = 0; k < node.count(); ++k) {
    const int kind = kinds.of_node[static_cast<std::size_t>(k)];
    const double radius = kinds.kind[static_cast<std::size_t>(kind)].radius;
    const std::string id = std::to_string(k + 1);
    atoms += line({words(k + 1, kind + 1), words(now.x[k], now.y[k]), "0", shortest(2 * radius),
                   density(node.mass[k], radius), "1"});
    speeds += line({id, words(now.vx[k], now.vy[k]), "0 0 0 0"});
    loads += line({id, words(node.load_x[k], node.load_y[k])});
  }
  return atoms + speeds + links(prepared.system.parts(), kinds) + (has_loads(prepared.system.parts()) ? loads : "");
}

}  // namespace

bool has_loads(const Parts& parts) {
  const auto some = [](const std::vector<double>& loads) {
    return std::any_of(loads.begin(), loads.end(), [](double load) { return load != 0; });
  };
  return some(parts.node.load_x) || some(parts.node.load_y);
}

std::string data_file(const Prepared& prepared, const AtomKinds& kinds) {
  const bool net = kinds.of_disc.empty();
  std::string text = "furrow: bodies at t = 0\n\n" + std::to_string(kinds.of_disc.size() + kinds.of_node.size()) +
                     " atoms\n" + std::to_string(kinds.kind.size()) + " atom types\n";
  if (net)
    text += std::to_string(kinds.bonds.size()) + " bonds\n" +
            std::to_string(std::max<std::size_t>(1, kinds.bond.size())) + " bond types\n" + room_for_bonds;
  return text + box(prepared) + (net ? nodes(prepared, kinds) : discs(prepared, kinds));
}

}  // namespace furrow
