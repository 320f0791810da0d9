// Points sorted into square cells, by counting. There are never many more cells than points: if the points are far
// from each other, the grid is periodic, and cells a whole number of periods apart share their storage. So a point far
// from all others costs no more than any other. Memory is kept from one sort to the next.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace furrow {

struct Extent {
  double from, to;  // m
};

// The cells along one axis. Cell numbers never decrease as the coordinate grows, so that rounding loses no point.
class Axis {
 public:
  struct Cells {
    std::int64_t first, last;
    bool all;  // of a folded axis
    long count() const { return std::max<long>(0, last - first + 1); }
  };

  // of: the cells of [from, to]. folded: `count` cells, repeated periodically; they start at the origin, where their
  // numbers are exact.
  static Axis of(Extent r, double cell) {
    return {r.from, cell, static_cast<std::int64_t>((r.to - r.from) / cell) + 1};
  }
  static Axis folded(double cell, double count) { return {0, cell, static_cast<std::int64_t>(count), true}; }
  static double cells(Extent r, double cell) { return std::floor((r.to - r.from) / cell) + 1; }

  int count() const { return static_cast<int>(count_); }
  int fold(std::int64_t number) const {
    if (!folded_) return static_cast<int>(number);
    const auto rest = static_cast<int>(number % count_);
    return rest < 0 ? rest + count() : rest;
  }
  int cell_of(double x) const { return fold(number(x)); }

  Cells overlapping(Extent r) const {
    const Cells cells{number(r.from), number(r.to), false};
    if (folded_) return cells.last - cells.first < count_ ? cells : Cells{0, count_ - 1, true};
    return {std::max<std::int64_t>(0, cells.first), std::min(count_ - 1, cells.last), false};
  }

  // The extent of the cells with this number, widened by more than `cell_of` rounds; false if that is not small.
  bool extent(std::int64_t number, Extent& r) const {
    const auto n = static_cast<double>(number);  // rounded towards 0
    const double slack = 1e-3 * cell_ + 1e-15 * std::fabs(start_);
    r = {start_ + (n > 0 ? n : n - 1) * cell_ - slack, start_ + (n < 0 ? n : n + 1) * cell_ + slack};
    return std::fabs(n) < 0x1p26;
  }

 private:
  Axis(double start, double cell, std::int64_t count, bool folded = false)
      : start_(start), cell_(cell), count_(count), folded_(folded) {}
  std::int64_t number(double x) const {
    return static_cast<std::int64_t>(std::max(-0x1p52, std::min(0x1p52, (x - start_) / cell_)));
  }

  double start_, cell_;  // m
  std::int64_t count_;
  bool folded_;
};

class Grid {
 public:
  // x, y: m, finite at `points`, of which there is at least one; they must outlive all queries. cell: m, the side of a
  // cell.
  void sort(const double* x, const double* y, const std::vector<int>& points, double cell) {
    lay_out(x, y, points, cell);
    const auto cells = static_cast<std::size_t>(columns_.count()) * static_cast<std::size_t>(rows_.count());
    first_.assign(cells + 1, 0);
    const auto cell_of = [&](int i) { return rows_.cell_of(y[i]) * columns_.count() + columns_.cell_of(x[i]); };
    cell_.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) ++first_[(cell_[k] = cell_of(points[k])) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    next_.assign(first_.begin(), first_.end() - 1);
    point_.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) point_[next_[cell_[k]]++] = points[k];
  }

  // Calls visit(point) once for every point of the box, and for some others near it. Returns the number of rows
  // visited.
  template <class Visit>
  long in_box(Extent x, Extent y, Visit&& visit) const {
    const Axis::Cells rows = rows_.overlapping(y);
    const Axis::Cells columns = columns_.overlapping(x);
    if (columns.first > columns.last) return 0;
    for (std::int64_t r = rows.first; r <= rows.last; ++r) in_row(rows_.fold(r), columns, visit);
    return rows.count();
  }

  // The same with a range along x that differs from row to row: along(y) is the range for points at these y.
  template <class Along, class Visit>
  long in_rows(Extent y, Along&& along, Visit&& visit) const {
    const Axis::Cells rows = rows_.overlapping(y);
    for (std::int64_t r = rows.first; r <= rows.last; ++r) {
      Extent row{};
      const bool known = rows_.extent(r, row) && !rows.all;
      in_row(rows_.fold(r), columns_.overlapping(along(known ? row : y)), visit);
    }
    return rows.count();
  }

 private:
  // As many cells as the extent needs, but at most four a point: else folded. The numbers of columns and rows then have
  // no common divisor, so that points on a diagonal do not soon share a cell.
  void lay_out(const double* x, const double* y, const std::vector<int>& points, double cell) {
    Extent across{infinity, -infinity}, up{infinity, -infinity};
    for (const int i : points) {
      across = {std::min(across.from, x[i]), std::max(across.to, x[i])};
      up = {std::min(up.from, y[i]), std::max(up.to, y[i])};
    }
    const double most = 4.0 * static_cast<double>(points.size());
    const double side = std::floor(std::sqrt(most));
    const double columns = Axis::cells(across, cell);
    const double rows = Axis::cells(up, cell);
    const bool fits = columns * rows <= most;
    const bool narrow = fits || columns <= side;
    const bool low = fits || rows <= side;
    columns_ = narrow ? Axis::of(across, cell) : Axis::folded(cell, low ? most / rows : side);
    rows_ = low ? Axis::of(up, cell) : Axis::folded(cell, narrow ? most / columns : side + 1);
    first_.reserve(static_cast<std::size_t>(most + side) + 2);  // enough for all later layouts
  }

  template <class Visit>
  void in_row(int row, const Axis::Cells& columns, Visit&& visit) const {
    if (columns.first > columns.last) return;
    const int* first = &first_[row * columns_.count()];
    const int from = columns_.fold(columns.first);
    const int to = from + static_cast<int>(columns.last - columns.first) + 1;
    for (int k = first[from]; k < first[std::min(to, columns_.count())]; ++k) visit(point_[k]);
    if (to <= columns_.count()) return;
    for (int k = first[0]; k < first[to - columns_.count()]; ++k) visit(point_[k]);
  }

  Axis columns_ = Axis::folded(1, 1), rows_ = Axis::folded(1, 1);
  std::vector<int> first_, next_, cell_, point_;
};

}  // namespace furrow
