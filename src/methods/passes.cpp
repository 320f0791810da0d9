#include "methods/passes.h"

#include "methods/wide.h"

namespace furrow {
namespace {

FURROW_WIDE void extrapolate_lanes(const double* y, double a, const double* f, double b, const double* g, double* out,
                                   std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) out[i] = y[i] + (a * f[i] - b * g[i]);
}

FURROW_WIDE void add_mean_lanes(const double* y, double h, const double* f, const double* g, double* out,
                                std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) out[i] = y[i] + h * (f[i] + g[i]);
}

FURROW_WIDTHS(void, extrapolate,
              (const double* y, double a, const double* f, double b, const double* g, double* out, std::size_t n),
              (y, a, f, b, g, out, n))
FURROW_WIDTHS(void, add_mean, (const double* y, double h, const double* f, const double* g, double* out, std::size_t n),
              (y, h, f, g, out, n))

}  // namespace

void extrapolate(int threads, const State& y, double a, const State& f, double b, const State& g, State& out) {
  in_ranges(threads, y.size(), [&](std::size_t first, std::size_t last) {
    extrapolate(&y[first], a, &f[first], b, &g[first], &out[first], last - first);
  });
}

void add_mean(int threads, const State& y, double h, const State& f, const State& g, State& out) {
  in_ranges(threads, y.size(), [&](std::size_t first, std::size_t last) {
    add_mean(&y[first], h, &f[first], &g[first], &out[first], last - first);
  });
}

}  // namespace furrow
