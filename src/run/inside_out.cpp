// Cells of lattices that have turned inside out or folded over: their links do not feel it, they only know lengths.
#include <string>
#include <vector>

#include "run/crossing.h"
#include "scene/lattice_cell.h"

namespace furrow {
namespace {

// The sides of the cells that are whole, by the node that they leave from.
struct Sides {
  std::vector<char> right, up;

  explicit Sides(const System& system) {
    const NodeArrays& node = system.parts().node;
    const LinkArrays& link = system.parts().link;
    right.resize(static_cast<std::size_t>(node.count()));
    up.resize(right.size());
    for (int k = 0; k < link.count(); ++k) {
      const int a = link.a[k], b = link.b[k];
      const int rows = node.row[b] - node.row[a], columns = node.column[b] - node.column[a];
      if (system.torn(k)) continue;
      if (rows == 0 && columns == 1) right[a] = 1;
      if (rows == 1 && columns == 0) up[a] = 1;
    }
  }
};

}  // namespace

CrossingBorders cells_inside_out(const System& system, double t, const State& y) {
  const NodeArrays& node = system.parts().node;
  const Sides whole(system);
  CrossingBorders found;
  std::vector<Vec2> at;
  for (int n = 0; n < node.count(); ++n) at.push_back(node_place(system, t, y, n));
  int above = 0;  // the node over this one: rows are stored one after the other
  for (int n = 0; n < node.count(); ++n) {
    if (n == 0 || node.lattice[n] != node.lattice[n - 1]) above = n;
    while (above < node.count() && node.lattice[above] == node.lattice[n] && node.row[above] == node.row[n]) ++above;
    const int over = above + node.column[n];
    if (whole.right[n] == 0 || whole.up[n] == 0 || whole.up[n + 1] == 0 || whole.right[over] == 0) continue;
    const std::string turned = turned_over({at[n], at[n + 1], at[over + 1], at[over]});
    if (turned.empty() || ++found.pairs > 1) continue;
    found.where = "cell at row " + std::to_string(node.row[n]) + ", column " + std::to_string(node.column[n]) +
                  " of lattice " + lattice_name(system, node.lattice[n]) + " " + turned;
  }
  return found;
}

}  // namespace furrow
