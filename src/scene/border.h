// The nodes of a lattice as a scene places them, and its border as a polygon.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/geometry.h"
#include "scene/scene.h"

namespace furrow {

struct Box {
  double left = infinity, right = -infinity, lower = infinity, upper = -infinity;  // m
  void add(Vec2 p) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    lower = std::min(lower, p.y), upper = std::max(upper, p.y);
  }
  bool holds(Vec2 p, double margin) const {
    return p.x >= left - margin && p.x <= right + margin && p.y >= lower - margin && p.y <= upper + margin;
  }
  bool meets(const Box& b) const { return left <= b.right && b.left <= right && lower <= b.upper && b.lower <= upper; }
};

inline bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

class StandingLattice {
 public:
  explicit StandingLattice(const Lattice& l) : lattice_(l) {
    for (int row = 0; row < l.rows; ++row)
      for (int column = 0; column < l.columns; ++column)
        node_.push_back({l.origin.x + column * l.spacing, l.origin.y + row * l.spacing});
    for (const NodeSetting& s : l.node) {
      Vec2& p = node_[index(s.row, s.column)];
      p = {p.x + s.displacement.x, p.y + s.displacement.y};
    }
    for (const Vec2& p : node_) box_.add(p);
    add_border();
  }

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice_.columns) +
           static_cast<std::size_t>(column);
  }
  const std::vector<Vec2>& nodes() const { return node_; }
  const Box& box() const { return box_; }
  bool encloses() const { return lattice_.rows > 1 && lattice_.columns > 1; }

  // A point's distance to the border, and whether it lies inside (by the number of borders to its right).
  struct Standing {
    double distance;  // m
    bool inside;
  };
  Standing of(Vec2 p) const {
    Standing s{infinity, false};
    for (std::size_t k = 0; k < segments(); ++k) {
      const Vec2 a = border_[k], b = border_[(k + 1) % border_.size()];
      s.distance = std::min(s.distance, std::sqrt(nearest_on_segment(p, a, b, 0).distance2));
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) s.inside = !s.inside;
    }
    s.inside = s.inside && encloses();
    return s;
  }

  // Whether its border crosses the segment from c to d.
  bool crosses(Vec2 c, Vec2 d) const {
    for (std::size_t k = 0; k < segments(); ++k)
      if (segments_cross(border_[k], border_[(k + 1) % border_.size()], c, d)) return true;
    return false;
  }

  // Whether the two have places in common; of borders with very many pairs of nodes that is taken for granted.
  bool crosses(const StandingLattice& other) const {
    constexpr double most_pairs = 1e7;
    if (static_cast<double>(border_.size()) * static_cast<double>(other.border_.size()) > most_pairs) return true;
    const auto reaches_into = [](const StandingLattice& one, const StandingLattice& another) {
      return std::any_of(one.border_.begin(), one.border_.end(), [&](Vec2 p) { return another.of(p).inside; });
    };
    if (reaches_into(*this, other) || reaches_into(other, *this)) return true;
    for (std::size_t k = 0; k < other.segments(); ++k)
      if (crosses(other.border_[k], other.border_[(k + 1) % other.border_.size()])) return true;
    return false;
  }

  // Whether its border crosses itself; of very long ones that is not asked.
  bool crosses_itself() const {
    constexpr std::size_t most = 3000;  // segments
    if (segments() > most) return false;
    for (std::size_t k = 0; k < segments(); ++k)
      for (std::size_t j = 0; j < k; ++j)
        if (segments_cross(border_[k], border_[(k + 1) % border_.size()], border_[j], border_[j + 1])) return true;
    return false;
  }

  // m
  double longest_segment() const {
    double longest = 0;
    for (std::size_t k = 0; k < segments() && border_.size() > 1; ++k) {
      const Vec2 along = border_[(k + 1) % border_.size()] - border_[k];
      longest = std::max(longest, std::sqrt(dot(along, along)));
    }
    return longest;
  }

  std::size_t segments() const { return encloses() ? border_.size() : std::max<std::size_t>(1, border_.size() - 1); }

 private:
  void add_border() {
    const int top = lattice_.rows - 1, right = lattice_.columns - 1;
    const auto add = [&](int row, int column) { border_.push_back(node_[index(row, column)]); };
    for (int c = 0; c <= right; ++c) add(0, c);
    for (int r = 1; r <= top; ++r) add(r, right);
    if (!encloses()) return;
    for (int c = right - 1; c >= 0; --c) add(top, c);
    for (int r = top - 1; r > 0; --r) add(r, 0);
  }

  const Lattice& lattice_;
  std::vector<Vec2> node_, border_;
  Box box_;
};

}  // namespace furrow
