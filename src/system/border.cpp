#include "system/border.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace furrow {
namespace {

// The cells of one lattice, and how its nodes and links are found by rows and columns.
class Cells {
 public:
  Cells(const Parts& parts, int lattice, int first_cell) : parts_(parts), first_cell_(first_cell) {
    for (int n = 0; n < parts.node.count(); ++n) {
      if (parts.node.lattice[n] != lattice) continue;
      if (nodes_.empty()) first_node_ = n;
      nodes_.push_back(n);
      rows_ = std::max(rows_, parts.node.row[n] + 1);
      columns_ = std::max(columns_, parts.node.column[n] + 1);
    }
    for (int k = 0; k < parts.link.count(); ++k) {
      if (parts.node.lattice[parts.link.a[k]] == lattice) link_[{parts.link.a[k], parts.link.b[k]}] = k;
    }
  }

  int count() const { return (rows_ - 1) * (columns_ - 1); }
  const std::vector<int>& nodes() const { return nodes_; }

  // The links along the sides, -1: none.
  BorderArrays::Four sides(int cell) const {
    const int lower = first_node_ + cell / (columns_ - 1) * columns_ + cell % (columns_ - 1), upper = lower + columns_;
    return {link(lower, lower + 1), link(upper, upper + 1), link(lower, upper), link(lower + 1, upper + 1)};
  }

  // Those that have both nodes at their corners; -1: outside.
  BorderArrays::Four around(int a, int b) const {
    const NodeArrays& node = parts_.node;
    const auto [lower, upper] = std::minmax(node.row[a], node.row[b]);
    const auto [left, right] = std::minmax(node.column[a], node.column[b]);
    BorderArrays::Four cells;
    cells.fill(cell(upper - 1, right - 1));
    std::size_t found = 0;
    for (int row = upper - 1; row <= lower; ++row) {
      for (int column = right - 1; column <= left; ++column) cells[found++] = cell(row, column);
    }
    return cells;
  }

 private:
  int link(int a, int b) const {
    const auto found = link_.find({a, b});
    return found == link_.end() ? -1 : found->second;
  }
  int cell(int row, int column) const {
    const bool inside = row >= 0 && row < rows_ - 1 && column >= 0 && column < columns_ - 1;
    return inside ? first_cell_ + row * (columns_ - 1) + column : -1;
  }

  const Parts& parts_;
  int first_cell_, first_node_ = 0, rows_ = 0, columns_ = 0;
  std::vector<int> nodes_;
  std::map<std::pair<int, int>, int> link_;  // by its nodes
};

class InnerSegments {
 public:
  explicit InnerSegments(Parts& parts) : parts_(parts), start_(parts.border) { parts_.border = {}; }

  void add(int lattice) {
    const Cells cells(parts_, lattice, static_cast<int>(parts_.border.side.size()));
    for (int k = 0; k < cells.count(); ++k) parts_.border.side.push_back(cells.sides(k));
    const auto put = [&](int a, int b, int link) {
      if (!known_.insert(std::minmax(a, b)).second) return;
      parts_.border.a.push_back(a);
      parts_.border.b.push_back(b);
      parts_.border.link.push_back(link);
      parts_.border.lattice.push_back(lattice);
      parts_.border.cell.push_back(cells.around(a, b));
    };
    for (int s = 0; s < start_.count(); ++s) {
      if (start_.lattice[s] == lattice) put(start_.a[s], start_.b[s], start_.link[s]);
    }
    for (int k = 0; k < parts_.link.count(); ++k) {
      const bool own = parts_.node.lattice[parts_.link.a[k]] == lattice;
      if (own && parts_.link.kind[k] != LinkClass::bending) put(parts_.link.a[k], parts_.link.b[k], k);
    }
    for (const int n : cells.nodes()) put(n, n, -1);
  }

 private:
  Parts& parts_;
  BorderArrays start_;
  std::set<std::pair<int, int>> known_;  // by their nodes
};

}  // namespace

void add_inner_segments(Parts& parts) {
  InnerSegments segments(parts);
  for (int k = 0; k < static_cast<int>(parts.lattice.size()); ++k) segments.add(k);
}

namespace {

// What is left of a lattice after these tears.
class Left {
 public:
  Left(const Parts& parts, const std::vector<int>& torn) : border_(parts.border), torn_(torn) {}

  bool whole(int segment) const { return border_.link[segment] < 0 || !is_torn(border_.link[segment]); }
  bool beside_open(int segment) const {
    const BorderArrays::Four& cells = border_.cell[segment];
    return std::any_of(cells.begin(), cells.end(), [this](int cell) { return cell < 0 || open(cell); });
  }

 private:
  bool is_torn(int link) const { return std::binary_search(torn_.begin(), torn_.end(), link); }
  bool open(int cell) const {
    const BorderArrays::Four& sides = border_.side[cell];
    return std::any_of(sides.begin(), sides.end(), [this](int link) { return link >= 0 && is_torn(link); });
  }

  const BorderArrays& border_;
  const std::vector<int>& torn_;
};

}  // namespace

std::vector<int> touched_segments(const Parts& parts, const std::vector<int>& torn) {
  const BorderArrays& border = parts.border;
  std::vector<int> touched(static_cast<std::size_t>(border.count()));
  std::iota(touched.begin(), touched.end(), 0);
  if (!parts.new_faces) return touched;
  const Left left(parts, torn);
  std::vector<char> an_end(static_cast<std::size_t>(parts.node.count()), 0);
  std::erase_if(touched, [&](int s) {  // in order: a lattice's nodes come after its links
    const bool alone = border.a[s] == border.b[s];
    if (!left.whole(s) || !left.beside_open(s) || (alone && an_end[border.a[s]] != 0)) return true;
    an_end[border.a[s]] = an_end[border.b[s]] = 1;
    return false;
  });
  return touched;
}

}  // namespace furrow
