#include "verification/studies/order_reference.h"

#include <algorithm>
#include <utility>

namespace furrow::verification {
namespace {

Numbers moved(const Numbers& y, long double h, const Numbers& rate) {
  Numbers sum(y);
  for (std::size_t i = 0; i < y.size(); ++i) sum[i] += h * rate[i];
  return sum;
}

Numbers modified_midpoint(const Rate& f, const Numbers& y, long double h, int substeps) {
  const long double part = h / substeps;
  Numbers before = y;
  Numbers now = moved(y, part, f(y));
  for (int k = 1; k < substeps; ++k) {
    Numbers next = moved(before, 2 * part, f(now));
    before = std::move(now);
    now = std::move(next);
  }
  const Numbers last = f(now);
  for (std::size_t i = 0; i < y.size(); ++i) now[i] = (now[i] + before[i] + part * last[i]) / 2;
  return now;
}

}  // namespace

State rounded(const Numbers& y) {
  State shorter;
  for (const long double v : y) shorter.push_back(static_cast<double>(v));
  return shorter;
}

Numbers extrapolated_step(const Rate& f, const Numbers& y, long double h) {
  constexpr int columns = 8;
  std::vector<Numbers> table;  // the last row of Neville's scheme
  for (int k = 0; k < columns; ++k) {
    Numbers entry = modified_midpoint(f, y, h, 2 * (k + 1));
    for (int j = 0; j < k; ++j) {
      const long double ratio = static_cast<long double>(k + 1) / static_cast<long double>(k - j);
      const Numbers coarser = std::exchange(table[j], entry);
      for (std::size_t i = 0; i < y.size(); ++i) entry[i] += (entry[i] - coarser[i]) / (ratio * ratio - 1);
    }
    table.push_back(std::move(entry));
  }
  return table.back();
}

Trajectory::Trajectory(Rate f, Numbers start, long double step, long double end) : f_(std::move(f)), step_(step) {
  kept_.push_back(std::move(start));
  for (long double t = 0; t < end; t += step) kept_.push_back(extrapolated_step(f_, kept_.back(), step));
}

Numbers Trajectory::at(long double t) const {
  const auto n = std::min(static_cast<std::size_t>(t / step_), kept_.size() - 1);
  return extrapolated_step(f_, kept_[n], t - static_cast<long double>(n) * step_);
}

}  // namespace furrow::verification
