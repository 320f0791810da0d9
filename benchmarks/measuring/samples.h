// Medians and their intervals from few noisy samples, without an assumption on the distribution of the noise.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "report/numbers.h"

namespace furrow::benchmarks {

struct Interval {
  double low = 0, middle = 0, high = 0;
  int samples = 0;
  double spread() const { return (high - low) / middle; }
};

// The median and the interval between two order statistics that holds the true median in at least 95 of 100 cases: the
// number of samples below it is binomial with p = 1/2. Fewer than 6 samples cannot say so: then all of them lie in it.
// Source: David and Nagaraja, Order Statistics, 7.1.
inline Interval median_interval(std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  const int n = static_cast<int>(samples.size());
  if (n == 0) return {};
  int k = 0;  // so many samples are left out at each end
  double left_out = std::pow(0.5, n);
  for (double term = left_out; k < (n - 1) / 2; ++k) {
    term *= static_cast<double>(n - k) / (k + 1);
    if (2 * (left_out + term) > 0.05) break;
    left_out += term;
  }
  const double middle = 0.5 * (samples[(n - 1) / 2] + samples[n / 2]);
  if (2 * left_out > 0.05) k = 0;
  return {samples[k], middle, samples[n - 1 - k], n};
}

// Sample by sample: what was measured side by side met the same state of the machine.
inline std::vector<double> ratios(const std::vector<double>& over, const std::vector<double>& under) {
  std::vector<double> all;
  for (std::size_t k = 0; k < std::min(over.size(), under.size()); ++k) all.push_back(over[k] / under[k]);
  return all;
}

// Four digits: a time is not known better.
inline double rounded(double value) { return to_digits(value, 4); }

// How far the interval of a ratio that should be 1 reaches from 1.
inline double noise_floor(const Interval& same) { return std::max(1 - same.low, same.high - 1); }

// `ratio` of time, new over old. A difference counts when its whole interval is beyond what the old one shows against
// itself; no difference is only claimed when the interval is narrow.
inline std::string verdict(const Interval& ratio, double noise) {
  constexpr double narrow = 0.1;
  if (ratio.high < 1 - noise) return "faster";
  if (ratio.low > 1 + noise) return "slower";
  return ratio.high - ratio.low > narrow || noise > narrow ? "too noisy" : "no difference";
}

}  // namespace furrow::benchmarks
