#include "kernel/links.h"

#include <algorithm>
#include <cmath>

#include "kernel/lanes.h"
#include "kernel/wide.h"
#include "physics/link.h"

namespace furrow {
namespace {

using Row = LinkLanes::Row;
using Group = LinkLanes::Group;
using Arrays = LinkLanes::Arrays;

template <Damper Acting>
FURROW_WIDE void forces_of(const Row& row, const NodeMotion& nodes, const Arrays& by, double* __restrict fx,
                           double* __restrict fy, double* __restrict power) {
  const double *xa = nodes.x.data() + row.first, *ya = nodes.y.data() + row.first;
  const double *vxa = nodes.vx.data() + row.first, *vya = nodes.vy.data() + row.first;
  const double *xb = xa + row.offset, *yb = ya + row.offset, *vxb = vxa + row.offset, *vyb = vya + row.offset;
  const double *rest = &by.rest[row.at], *stiffness = &by.stiffness[row.at], *damping = &by.damping[row.at];
  for (int k = 0; k < row.lanes; k += LinkLanes::whole) {
    for (int i = k; i < k + LinkLanes::whole; ++i) {
      const LinkForce f = link_force({xa[i] - xb[i], ya[i] - yb[i]}, {vxa[i] - vxb[i], vya[i] - vyb[i]}, rest[i],
                                     stiffness[i], damping[i], Acting);
      fx[i] = f.fx;
      fy[i] = f.fy;
      power[i] = f.damping;
    }
  }
}

FURROW_WIDE void forces_of(Damper acting, const Row& row, const NodeMotion& nodes, Arrays& by) {
  double *fx = &by.fx[row.at], *fy = &by.fy[row.at], *power = &by.power[row.at];
  acting == Damper::axial ? forces_of<Damper::axial>(row, nodes, by, fx, fy, power)
                          : forces_of<Damper::full>(row, nodes, by, fx, fy, power);
}

// A gap changes no sum, not even the sign of a zero.
template <int N, bool AsA>
FURROW_WIDE void add_row(const Row& row, const Arrays& by, double* fx, double* fy) {
  using Real = Reals<N>;
  for (int i = 0; i < row.lanes; i += N) {
    const Real there = get<Real>(&by.there[row.at + i]);
    const Real x = get<Real>(fx + i), y = get<Real>(fy + i);
    const Real own_x = get<Real>(&by.fx[row.at + i]), own_y = get<Real>(&by.fy[row.at + i]);
    put(there != 0 ? (AsA ? x + own_x : x - own_x) : x, fx + i);
    put(there != 0 ? (AsA ? y + own_y : y - own_y) : y, fy + i);
  }
}

// In the order of the links a node is b of those of smaller nodes before it is a of its own.
template <int N>
FURROW_WIDE void add_link_forces_lanes(const std::vector<Group>& groups, const NodeMotion& nodes, Arrays& by,
                                       double* fx, double* fy) {
  for (const Group& group : groups) {
    for (const Row& row : group.row) forces_of(group.damper, row, nodes, by);
    for (const Row& row : group.back)
      add_row<N, false>(row, by, fx + row.first + row.offset, fy + row.first + row.offset);
    for (const Row& row : group.row) add_row<N, true>(row, by, fx + row.first, fy + row.first);
  }
}

FURROW_WIDE bool any_over_lanes(const std::vector<Group>& groups, const NodeMotion& nodes, const Arrays& by) {
  std::int64_t over = 0;
  for (const Group& group : groups) {
    for (const Row& row : group.row) {
      const double *xa = nodes.x.data() + row.first, *ya = nodes.y.data() + row.first;
      const double *xb = xa + row.offset, *yb = ya + row.offset;
      const double *rest = &by.rest[row.at], *stiffness = &by.stiffness[row.at], *strength = &by.strength[row.at];
      const double* there = &by.there[row.at];
      for (int k = 0; k < row.lanes; k += LinkLanes::whole) {
        for (int i = k; i < k + LinkLanes::whole; ++i) {
          const double rx = xa[i] - xb[i], ry = ya[i] - yb[i];
          const double force = stiffness[i] * (std::sqrt(rx * rx + ry * ry) - rest[i]);
          const std::int64_t tearing = link_tears(force, strength[i], group.tear) ? 1 : 0;
          over += there[i] != 0 ? tearing : 0;
        }
      }
    }
  }
  return over != 0;
}

FURROW_WIDTHS_OF(void, add_link_forces,
                 (const std::vector<Group>& groups, const NodeMotion& nodes, Arrays& by, double* fx, double* fy),
                 (groups, nodes, by, fx, fy))
FURROW_WIDTHS(bool, any_over, (const std::vector<Group>& groups, const NodeMotion& nodes, const Arrays& by),
              (groups, nodes, by))

int offset_of(const LinkArrays& links, int k) { return links.b[k] - links.a[k]; }

std::ptrdiff_t place_of(const std::vector<int>& offsets, int offset) {
  return std::find(offsets.begin(), offsets.end(), offset) - offsets.begin();
}

// Whether two links that follow each other may be of one group.
bool alike(const LinkArrays& links, int j, int k) {
  return links.kind[k] == links.kind[j] && links.a[k] >= links.a[j] && links.axial[k] == links.axial[j] &&
         links.in_magnitude[k] == links.in_magnitude[j];
}

// Whether link k comes after the one before it, of the same node, in the order of the offsets too; `own` is the node's
// first one.
bool follows(const std::vector<int>& offsets, const LinkArrays& links, int own, int k) {
  return k == own || place_of(offsets, offset_of(links, k)) > place_of(offsets, offset_of(links, k - 1));
}

}  // namespace

// Of a group all nodes have their links as a in one order of offsets. Where a node has another order, as it may where
// links are left out or another lattice begins, the next group begins with that node.
LinkLanes::LinkLanes(const LinkArrays& links) : lane_(static_cast<std::size_t>(links.count())) {
  std::vector<int> offsets;
  int first = 0, own = 0;  // links: of the group, and of the node
  const auto begin_again_at = [&](int k) {
    add_group(links, first, k);
    first = k;
    offsets.clear();
  };
  for (int k = 0; k < links.count(); ++k) {
    if (k > 0 && !alike(links, k - 1, k)) begin_again_at(k);
    if (k == first || links.a[k] != links.a[k - 1]) own = k;
    if (!follows(offsets, links, own, k)) {
      begin_again_at(own);
      k = own;
    }
    if (place_of(offsets, offset_of(links, k)) == std::ssize(offsets)) offsets.push_back(offset_of(links, k));
  }
  if (links.count() > 0) add_group(links, first, links.count());
  const std::size_t lanes = by_.rest.size();
  by_.there.resize(lanes);
  for (auto* written : {&by_.fx, &by_.fy, &by_.power}) written->resize(lanes);
  tear(std::vector<char>(lane_.size(), 0));
}

void LinkLanes::add_group(const LinkArrays& links, int first, int last) {
  Group group{{}, {}, links.damper(first), links.tear_rule(first)};
  for (int k = first; k < last; ++k) {
    const int offset = links.b[k] - links.a[k];
    auto row = std::find_if(group.row.begin(), group.row.end(), [&](const Row& r) { return r.offset == offset; });
    if (row == group.row.end()) row = group.row.insert(row, {offset, links.a[k], 0, 0});
    row->lanes = links.a[k] - row->first + 1;
  }
  for (Row& row : group.row) {
    row.at = static_cast<int>(by_.rest.size());
    row.lanes = (row.lanes + whole - 1) / whole * whole;
    for (auto* kept : {&by_.rest, &by_.stiffness, &by_.damping, &by_.strength})
      kept->resize(kept->size() + static_cast<std::size_t>(row.lanes));
    for (int k = first; k < last; ++k) {
      if (links.b[k] - links.a[k] != row.offset) continue;
      const int lane = lane_[k] = row.at + links.a[k] - row.first;
      by_.rest[lane] = links.rest[k];
      by_.stiffness[lane] = links.stiffness[k];
      by_.damping[lane] = links.damping[k];
      by_.strength[lane] = links.strength[k];
    }
  }
  group.back = group.row;
  std::stable_sort(group.back.begin(), group.back.end(),
                   [](const Row& p, const Row& q) { return p.offset > q.offset; });
  group_.push_back(group);
}

void LinkLanes::tear(const std::vector<char>& torn) {
  std::fill(by_.there.begin(), by_.there.end(), 0);
  intact_.clear();
  for (std::size_t k = 0; k < lane_.size(); ++k) {
    if (torn[k] != 0) continue;
    by_.there[lane_[k]] = 1;
    intact_.push_back(lane_[k]);
  }
}

void LinkLanes::add_forces(const NodeMotion& nodes, double* fx, double* fy) {
  add_link_forces(group_, nodes, by_, fx, fy);
}

double LinkLanes::damping() const {
  double sum = 0;
  for (const int lane : intact_) sum += by_.power[lane];
  return sum;
}

bool LinkLanes::any_over(const NodeMotion& nodes) const { return furrow::any_over(group_, nodes, by_); }

}  // namespace furrow
