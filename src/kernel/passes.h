// Updates of whole state vectors by methods, on several threads and at the widest vectors.
#pragma once

#include "kernel/parallel.h"
#include "system/ode.h"

namespace furrow {

// out = y + h f, n numbers each; out may be y.
void advance(int threads, const double* y, double h, const double* f, double* out, std::size_t n);

// out = y + (a f - b g), the predictor of a two-step method; out may be y.
void extrapolate(int threads, const State& y, double a, const State& f, double b, const State& g, State& out);

// out = y + h (f + g); out may be y.
void add_mean(int threads, const State& y, double h, const State& f, const State& g, State& out);

}  // namespace furrow
