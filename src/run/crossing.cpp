#include "run/crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/border.h"

namespace furrow {

Vec2 node_place(const System& system, double t, const State& y, int node) {
  const int body = system.parts().node.body[node];
  if (body >= 0) return {y[system.x_of(body)], y[system.y_of(body)]};
  const NodeAt held = held_node_at(system.parts(), node, t, system.solver().preparing());
  return {held.x, held.y};
}

std::string lattice_name(const System& system, int lattice) {
  const std::string& given = system.parts().lattice[lattice].name;
  return given.empty() ? std::to_string(lattice) : given;
}

namespace {

// Twice the area of the triangle a, b, p: positive if p is to the left of a -> b.
double side_of(Vec2 a, Vec2 b, Vec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

}  // namespace

bool crosses_segment(const System& system, const Step& s, const Path& point, int segment) {
  const BorderArrays& border = system.parts().border;
  if (border.a[segment] == border.b[segment]) return false;
  const auto ends = [&](double t, const State& y) {
    return Path{node_place(system, t, y, border.a[segment]), node_place(system, t, y, border.b[segment])};
  };
  const Path was = ends(s.t - s.h, s.before), is = ends(s.t, s.after);
  const double left_before = side_of(was.from, was.to, point.from), left_after = side_of(is.from, is.to, point.to);
  const bool changed = (left_before > 0) != (left_after > 0);
  const Path to_a{was.from - point.from, is.from - point.to}, to_b{was.to - point.from, is.to - point.to};
  // Where the side has changed one of the two is in the step, but for rounding.
  const auto is_between = [&](double share) {
    if (!(share >= -1e-9 && share <= 1 + 1e-9)) return false;
    const Vec2 a = at(to_a, share), b = at(to_b, share);
    return dot(a, b) <= 1e-9 * dot(a - b, a - b);
  };
  const auto [one, other] = crossing_shares(to_a, to_b);
  const int times = (is_between(one) ? 1 : 0) + (is_between(other) ? 1 : 0);
  return changed ? times > 0 : times == 2 && one > 0 && other > 0 && one < 1 && other < 1;
}

namespace {

bool inside_box(Vec2 p, double half_width, double half_height) {
  return std::fabs(p.x) <= half_width && std::fabs(p.y) <= half_height;
}

// A body that the plate felt, or was about to, keeps its face.
bool kept_face(const System& system, const ContactId& contact, Vec2 from) {
  const Parts& parts = system.parts();
  const PlatePart& p = parts.plate[contact.b];
  const double radius = of_disc(contact.kind) ? parts.disc.radius[contact.a] : 0;
  const Rectangle box{-0.5 * p.width, 0.5 * p.width, -0.5 * p.height, 0.5 * p.height};
  return parts.tight_plates && nearest_on_rectangle(from, box).distance - radius < parts.margin;
}

}  // namespace

bool crosses_plate(const System& system, const Step& s, const ContactId& contact) {
  const Parts& parts = system.parts();
  const PlatePart& p = parts.plate[contact.b];
  const int body = of_disc(contact.kind) ? contact.a : parts.node.body[contact.a];
  const Path path = path_from_plate(system, s, contact.b, path_of_body(system, s, body));
  const bool upright = p.width <= p.height;
  const double from = upright ? path.from.x : path.from.y, to = upright ? path.to.x : path.to.y;
  if ((from > 0) == (to > 0) || kept_face(system, contact, path.from)) return false;
  const double share = from / (from - to);
  const double start = upright ? path.from.y : path.from.x, end = upright ? path.to.y : path.to.x;
  return std::fabs(start + share * (end - start)) <= 0.5 * std::max(p.width, p.height);
}

namespace {

bool share_a_node(const BorderArrays& border, int one, int other) {
  return border.a[one] == border.a[other] || border.a[one] == border.b[other] || border.b[one] == border.a[other] ||
         border.b[one] == border.b[other];
}

}  // namespace

namespace {

struct StandingSegment {
  int segment;
  Vec2 a, b;
  Box box;
};

// Without links across cells, which cross each other from the start on.
std::vector<StandingSegment> standing_segments(const System& system, double t, const State& y) {
  const BorderArrays& border = system.parts().border;
  std::vector<StandingSegment> standing;
  for (const int s : system.border()) {
    const int link = border.link[s];
    if (border.a[s] == border.b[s]) continue;
    if (link >= 0 && (system.torn(link) || system.parts().link.kind[link] == LinkClass::shear)) continue;
    StandingSegment one{s, node_place(system, t, y, border.a[s]), node_place(system, t, y, border.b[s]), {}};
    one.box.add(one.a);
    one.box.add(one.b);
    standing.push_back(one);
  }
  std::sort(standing.begin(), standing.end(), [](const StandingSegment& p, const StandingSegment& q) {
    return p.box.left < q.box.left || (p.box.left == q.box.left && p.segment < q.segment);
  });
  return standing;
}

std::string names_of(const System& system, int one, int other) {
  const auto name = [&](int lattice) { return "lattice " + lattice_name(system, lattice); };
  return one == other ? name(one) + " and itself" : name(one) + " and " + name(other);
}

}  // namespace

CrossingBorders crossing_borders(const System& system, double t, const State& y) {
  const BorderArrays& border = system.parts().border;
  CrossingBorders found;
  const std::vector<StandingSegment> standing = standing_segments(system, t, y);
  for (std::size_t i = 0; i < standing.size(); ++i) {
    const StandingSegment& p = standing[i];
    for (std::size_t k = i + 1; k < standing.size() && standing[k].box.left <= p.box.right; ++k) {
      const StandingSegment& q = standing[k];
      if (share_a_node(border, p.segment, q.segment) || !p.box.meets(q.box)) continue;
      if (segments_cross(p.a, p.b, q.a, q.b) && ++found.pairs == 1)
        found.where = names_of(system, std::min(border.lattice[p.segment], border.lattice[q.segment]),
                               std::max(border.lattice[p.segment], border.lattice[q.segment]));
    }
  }
  return found;
}

namespace {

Box box_of(const Path& path) {
  Box box;
  box.add(path.from);
  box.add(path.to);
  return box;
}

// The ways of the nodes of a lattice in a step, sorted along the axis on which it is spread more: those that meet a box stand
// together there.
struct SortedWays {
  struct Way {
    int node;
    Box box;
  };
  std::vector<Way> ways;
  bool upright = false;
  double widest = 0;  // m, along that axis

  double low(const Box& box) const { return upright ? box.lower : box.left; }
  double high(const Box& box) const { return upright ? box.upper : box.right; }
  void add(int node, const Box& box) {
    ways.push_back({node, box});
    widest = std::max(widest, high(box) - low(box));
  }
  void sort() {
    std::sort(ways.begin(), ways.end(), [this](const Way& p, const Way& q) {
      return low(p.box) < low(q.box) || (low(p.box) == low(q.box) && p.node < q.node);
    });
  }
  template <class Visit>
  void for_each_meeting(const Box& box, const Visit& visit) const {
    auto way = std::lower_bound(ways.begin(), ways.end(), low(box) - widest,
                                [this](const Way& one, double bound) { return low(one.box) < bound; });
    for (; way != ways.end() && low(way->box) <= high(box); ++way)
      if (box.meets(way->box)) visit(way->node);
  }
};

// Where the nodes of each lattice are in a step, and which are there together.
struct Ways {
  std::vector<Path> node;
  std::vector<Box> lattice;
  std::vector<SortedWays> sorted;  // of each lattice

  Ways(const System& system, const Step& s)
      : lattice(system.parts().lattice.size()), sorted(system.parts().lattice.size()) {
    const NodeArrays& nodes = system.parts().node;
    for (int n = 0; n < nodes.count(); ++n) {
      node.push_back({node_place(system, s.t - s.h, s.before, n), node_place(system, s.t, s.after, n)});
      lattice[nodes.lattice[n]].add(node.back().from);
      lattice[nodes.lattice[n]].add(node.back().to);
    }
  }

  // Only of the lattices whose nodes are asked for.
  void sort(const NodeArrays& nodes, const std::vector<std::vector<int>>& asked) {
    std::vector<bool> wanted(lattice.size());
    for (const std::vector<int>& others : asked)
      for (const int other : others) wanted[other] = true;
    for (std::size_t k = 0; k < lattice.size(); ++k)
      sorted[k].upright = lattice[k].upper - lattice[k].lower > lattice[k].right - lattice[k].left;
    for (int n = 0; n < nodes.count(); ++n)
      if (wanted[nodes.lattice[n]]) sorted[nodes.lattice[n]].add(n, box_of(node[n]));
    for (SortedWays& one : sorted) one.sort();
  }

  std::vector<std::vector<int>> together(bool with_itself) const {
    std::vector<std::vector<int>> others(lattice.size());
    for (std::size_t one = 0; one < lattice.size(); ++one)
      for (std::size_t other = 0; other < lattice.size(); ++other)
        if (one == other ? with_itself : lattice[one].meets(lattice[other]))
          others[one].push_back(static_cast<int>(other));
    return others;
  }
};

}  // namespace

CrossingBorders passed_borders(const System& system, const Step& s, bool of_their_own) {
  const BorderArrays& border = system.parts().border;
  CrossingBorders found;
  if (system.parts().lattice.size() < 2 && !of_their_own) return found;
  Ways ways(system, s);
  const std::vector<std::vector<int>> others = ways.together(of_their_own);
  ways.sort(system.parts().node, others);
  for (const int segment : system.border()) {
    const int link = border.link[segment], own = border.lattice[segment];
    if (others[own].empty()) continue;
    if (link >= 0 && (system.torn(link) || system.parts().link.kind[link] == LinkClass::shear)) continue;
    Box box = box_of(ways.node[border.a[segment]]);
    box.add(ways.node[border.b[segment]].from);
    box.add(ways.node[border.b[segment]].to);
    for (const int other : others[own]) {
      if (!box.meets(ways.lattice[other])) continue;
      ways.sorted[other].for_each_meeting(box, [&](int n) {
        if (n == border.a[segment] || n == border.b[segment]) return;
        if (!crosses_segment(system, s, ways.node[n], segment)) return;
        if (++found.pairs == 1) found.where = names_of(system, std::min(own, other), std::max(own, other));
      });
    }
  }
  return found;
}

ContactId stepped_over(const System& system, const Step& s) {
  const Parts& parts = system.parts();
  for (int k = 0; k < static_cast<int>(parts.plate.size()); ++k) {
    const PlatePart& p = parts.plate[k];
    const auto over = [&](const ContactId& contact, int body, double radius) {
      const Path path = path_from_plate(system, s, k, path_of_body(system, s, body));
      const double width = 0.5 * p.width + radius, height = 0.5 * p.height + radius;
      if (inside_box(path.to, width, height)) return false;
      return inside_box(path.from, width, height) ? crosses_plate(system, s, contact)
                                                  : meets_box(path, 0.5 * p.width, 0.5 * p.height);
    };
    for (int i = 0; i < parts.disc.count(); ++i) {
      if (const ContactId one{disc_plate, i, k}; over(one, i, parts.disc.radius[i])) return one;
    }
    for (int n = 0; n < parts.node.count(); ++n) {
      const int body = parts.node.body[n];
      if (const ContactId one{node_plate, n, k}; body >= 0 && over(one, body, 0)) return one;
    }
  }
  return {};
}

}  // namespace furrow
