#include "system/place.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "system/order.h"

namespace furrow {
namespace {

constexpr std::uint32_t side = 1u << 16;  // cells

// How far along Hilbert's curve through side x side cells the cell (x, y) lies. From the whole square to a cell, each
// quarter is entered in its turn, and turned so that the curve does not jump (D. Hilbert, Math. Ann. 38, 459, 1891).
std::uint32_t along_curve(std::uint32_t x, std::uint32_t y) {
  std::uint32_t passed = 0;
  for (std::uint32_t half = side / 2; half > 0; half /= 2) {
    const std::uint32_t right = (x & half) != 0 ? 1 : 0, upper = (y & half) != 0 ? 1 : 0;
    passed += half * half * ((3 * right) ^ upper);
    if (upper == 1) continue;
    if (right == 1) {
      x = side - 1 - x;
      y = side - 1 - y;
    }
    std::swap(x, y);
  }
  return passed;
}

// Cells by rank, not by distance: one disc that flies far off does not press all others into one cell.
std::vector<std::uint32_t> cells_by_rank(const std::vector<double>& at) {
  std::vector<double> sorted = at;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> cells;
  for (const double here : at) {
    const auto below =
        static_cast<std::uint64_t>(std::lower_bound(sorted.begin(), sorted.end(), here) - sorted.begin());
    cells.push_back(static_cast<std::uint32_t>(below * side / at.size()));
  }
  return cells;
}

}  // namespace

std::vector<int> order_of_storage(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<int> order(x.size());
  std::iota(order.begin(), order.end(), 0);
  if (blocks_of(static_cast<int>(x.size())) == 1) return order;
  const std::vector<std::uint32_t> column = cells_by_rank(x), row = cells_by_rank(y);
  std::vector<std::uint32_t> passed(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) passed[k] = along_curve(column[k], row[k]);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return passed[a] < passed[b]; });
  return order;
}

std::vector<int> places_in(const std::vector<int>& order) {
  std::vector<int> places(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) places[order[place]] = static_cast<int>(place);
  return places;
}

}  // namespace furrow
