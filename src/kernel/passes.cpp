#include "kernel/passes.h"

#include "kernel/wide.h"

namespace furrow {
namespace {

FURROW_WIDE void advance_lanes(const double* y, double h, const double* f, double* out, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) out[i] = y[i] + h * f[i];
}

FURROW_WIDE void extrapolate_lanes(const double* y, double a, const double* f, double b, const double* g, double* out,
                                   std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) out[i] = y[i] + (a * f[i] - b * g[i]);
}

FURROW_WIDE void add_mean_lanes(const double* y, double h, const double* f, const double* g, double* out,
                                std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) out[i] = y[i] + h * (f[i] + g[i]);
}

FURROW_WIDTHS(void, advance, (const double* y, double h, const double* f, double* out, std::size_t n),
              (y, h, f, out, n))
FURROW_WIDTHS(void, extrapolate,
              (const double* y, double a, const double* f, double b, const double* g, double* out, std::size_t n),
              (y, a, f, b, g, out, n))
FURROW_WIDTHS(void, add_mean, (const double* y, double h, const double* f, const double* g, double* out, std::size_t n),
              (y, h, f, g, out, n))

}  // namespace

void advance(int threads, const double* y, double h, const double* f, double* out, std::size_t n) {
  in_ranges(threads, n,
            [&](std::size_t first, std::size_t last) { advance(y + first, h, f + first, out + first, last - first); });
}

void extrapolate(int threads, const State& y, double a, const State& f, double b, const State& g, State& out) {
  in_ranges(threads, y.size(), [&](std::size_t first, std::size_t last) {
    extrapolate(y.data() + first, a, f.data() + first, b, g.data() + first, out.data() + first, last - first);
  });
}

void add_mean(int threads, const State& y, double h, const State& f, const State& g, State& out) {
  in_ranges(threads, y.size(), [&](std::size_t first, std::size_t last) {
    add_mean(y.data() + first, h, f.data() + first, g.data() + first, out.data() + first, last - first);
  });
}

}  // namespace furrow
