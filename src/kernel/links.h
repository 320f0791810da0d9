// The links of the lattices, many at once: all links of one kind that lead from a node n to the node n + offset make a
// row of lanes, one for each n. Where there is no such link, or it is torn, the lane is a gap.
#pragma once

#include <cstdint>
#include <vector>

#include "system/layout.h"
#include "system/parts.h"

namespace furrow {

class LinkLanes {
 public:
  // Rows are of whole vectors of the widest kind, so the last ones may reach beyond the nodes by less than this.
  static constexpr int whole = 8;

  explicit LinkLanes(const LinkArrays& links);

  // These become gaps, and no others. By link, 0: intact.
  void tear(const std::vector<char>& torn);

  // Adds the forces to those on the nodes (N), in the order of system/order.h. All arrays are longer than the nodes by
  // `whole`.
  void add_forces(const NodeMotion& nodes, double* fx, double* fy);

  // W, taken by the dampers when forces were last added.
  double damping() const;

  // Whether the force of a link is over its strength.
  bool any_over(const NodeMotion& nodes) const;

  struct Row {
    int offset;  // b - a
    int first;   // node a of the first lane
    int lanes;
    int at;  // of the first lane, in what is kept by lane
  };

  // Links of one kind of one lattice.
  struct Group {
    std::vector<Row> row;   // in the order in which a node has its links as a
    std::vector<Row> back;  // in the order in which it has them as b: of the furthest first
    Damper damper;
    TearRule tear;
  };

  // By lane.
  struct Arrays {
    std::vector<double> rest, stiffness, damping, strength;  // m, N/m, N s/m, N
    std::vector<double> there;                               // 1, or 0: a gap
    std::vector<double> fx, fy, power;                       // N, W
  };

 private:
  void add_group(const LinkArrays& links, int first, int last);

  std::vector<Group> group_;
  std::vector<int> lane_;    // by link
  std::vector<int> intact_;  // lanes, in the order of the links
  Arrays by_;
};

}  // namespace furrow
