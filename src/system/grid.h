// Points sorted into square cells, by counting. The room for it is kept from one time to the next.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace furrow {

class Grid {
 public:
  // x, y: m, at least one point, finite; they must stay until the last call of around. cell: m, the least size of a
  // cell.
  void sort(const double* x, const double* y, int count, double cell) {
    x_ = x;
    y_ = y;
    const auto [left, right] = std::minmax_element(x, x + count);
    const auto [lower, upper] = std::minmax_element(y, y + count);
    left_ = *left;
    lower_ = *lower;
    const double width = *right - left_;
    const double height = *upper - lower_;
    // A point that flew far off must not make the grid larger than the points are many.
    cell_ =
        std::max(cell, std::max(std::sqrt(width * height / (4.0 * count)), std::max(width, height) / (4.0 * count)));
    columns_ = static_cast<int>(width / cell_) + 1;
    rows_ = static_cast<int>(height / cell_) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (int i = 0; i < count; ++i) ++first_[cell_of(i) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    point_.resize(static_cast<std::size_t>(count));
    next_.assign(first_.begin(), first_.end() - 1);
    for (int i = 0; i < count; ++i) point_[next_[cell_of(i)]++] = i;
  }

  // Calls visit(j) for every point j in the cells within `reach` (m) of point i, itself included.
  template <class Visit>
  void around(int i, double reach, Visit&& visit) const {
    const int range = static_cast<int>(std::ceil(reach / cell_));
    const int row = row_of(i);
    const int column = column_of(i);
    for (int r = std::max(0, row - range); r <= std::min(rows_ - 1, row + range); ++r) {
      const int from = std::max(0, column - range);
      const int to = std::min(columns_ - 1, column + range);
      for (int k = first_[r * columns_ + from]; k < first_[r * columns_ + to + 1]; ++k) visit(point_[k]);
    }
  }

 private:
  int row_of(int i) const { return std::min(rows_ - 1, static_cast<int>((y_[i] - lower_) / cell_)); }
  int column_of(int i) const { return std::min(columns_ - 1, static_cast<int>((x_[i] - left_) / cell_)); }
  int cell_of(int i) const { return row_of(i) * columns_ + column_of(i); }

  const double* x_ = nullptr;
  const double* y_ = nullptr;
  double left_ = 0, lower_ = 0, cell_ = 0;  // m
  int columns_ = 0, rows_ = 0;
  std::vector<int> first_, next_, point_;
};

}  // namespace furrow
