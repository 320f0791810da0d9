// Loads and stores between scattered numbers in memory and vectors of N lanes, one contact a lane: the shuffles that
// compilers do not find by themselves. All are inlined into functions compiled for one instruction set each
// (kernel/wide.h), where N doubles fill a register.
//
// They use the vector extensions of GCC and Clang. Highway, tried on the same loops over pairs with AVX2, takes the
// same time and gives the same bits, but would be one more library; std::experimental::simd takes 15 % longer, because
// it has no shuffles to turn rows into lanes, and its width belongs to the whole file, not to a function.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "kernel/wide.h"

namespace furrow {

template <int N>
struct LanesOf {
  using Real [[gnu::vector_size(N * sizeof(double))]] = double;
  using Whole [[gnu::vector_size(N * sizeof(std::int32_t))]] = std::int32_t;
};
template <int N>
using Reals = typename LanesOf<N>::Real;
template <int N>
using Wholes = typename LanesOf<N>::Whole;
using Row = Reals<4>;  // four numbers of one disc

template <class Numbers>
FURROW_WIDE Numbers get(const void* from) {
  Numbers to;
  std::memcpy(&to, from, sizeof to);
  return to;
}

template <class Numbers>
FURROW_WIDE void put(const Numbers& numbers, void* to) {
  std::memcpy(to, &numbers, sizeof numbers);
}

// One load for each lane: quicker than the gather instructions of the processors tried.
template <int N>
FURROW_WIDE Reals<N> gather(const double* from, const int* at) {
  if constexpr (N == 8) {
    const Reals<4> low = gather<4>(from, at), high = gather<4>(from, at + 4);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  } else if constexpr (N == 4) {
    const Reals<2> low = gather<2>(from, at), high = gather<2>(from, at + 2);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
  } else {
    return Reals<2>{from[at[0]], from[at[1]]};
  }
}

template <int N>
FURROW_WIDE void scatter(const Reals<N>& numbers, double* to, const int* at) {
  for (int i = 0; i < N; ++i) to[at[i]] = numbers[i];
}

template <int N>
FURROW_WIDE Reals<N> square_roots(const Reals<N>& of) {
  Reals<N> root{};
  for (int i = 0; i < N; ++i) root[i] = std::sqrt(of[i]);  // compiles to one instruction
  return root;
}

// Transposes rows of four numbers to four vectors: r[i] = {x[i], y[i], u[i], v[i]}.
template <int N>
FURROW_WIDE void rows_to_lanes(const Row* r, Reals<N>& x, Reals<N>& y, Reals<N>& u, Reals<N>& v) {
  if constexpr (N == 8) {
    Reals<8> pair[4];
    for (int i = 0; i < 4; ++i) pair[i] = __builtin_shufflevector(r[i], r[i + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    const auto xu = __builtin_shufflevector(pair[0], pair[1], 0, 8, 2, 10, 4, 12, 6, 14);
    const auto yv = __builtin_shufflevector(pair[0], pair[1], 1, 9, 3, 11, 5, 13, 7, 15);
    const auto xu2 = __builtin_shufflevector(pair[2], pair[3], 0, 8, 2, 10, 4, 12, 6, 14);
    const auto yv2 = __builtin_shufflevector(pair[2], pair[3], 1, 9, 3, 11, 5, 13, 7, 15);
    x = __builtin_shufflevector(xu, xu2, 0, 1, 8, 9, 4, 5, 12, 13);
    y = __builtin_shufflevector(yv, yv2, 0, 1, 8, 9, 4, 5, 12, 13);
    u = __builtin_shufflevector(xu, xu2, 2, 3, 10, 11, 6, 7, 14, 15);
    v = __builtin_shufflevector(yv, yv2, 2, 3, 10, 11, 6, 7, 14, 15);
  } else if constexpr (N == 4) {
    const auto xu = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
    const auto yv = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
    const auto xu2 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
    const auto yv2 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
    x = __builtin_shufflevector(xu, xu2, 0, 1, 4, 5);
    y = __builtin_shufflevector(yv, yv2, 0, 1, 4, 5);
    u = __builtin_shufflevector(xu, xu2, 2, 3, 6, 7);
    v = __builtin_shufflevector(yv, yv2, 2, 3, 6, 7);
  } else {
    x = __builtin_shufflevector(r[0], r[1], 0, 4);
    y = __builtin_shufflevector(r[0], r[1], 1, 5);
    u = __builtin_shufflevector(r[0], r[1], 2, 6);
    v = __builtin_shufflevector(r[0], r[1], 3, 7);
  }
}

template <int N>
FURROW_WIDE void lanes_to_rows(const Reals<N>& x, const Reals<N>& y, const Reals<N>& u, const Reals<N>& v, Row* r) {
  if constexpr (N == 8) {
    const auto xy = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto xy2 = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto uv = __builtin_shufflevector(u, v, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto uv2 = __builtin_shufflevector(u, v, 1, 9, 3, 11, 5, 13, 7, 15);
    const Reals<8> pair[4] = {__builtin_shufflevector(xy, uv, 0, 1, 8, 9, 4, 5, 12, 13),
                              __builtin_shufflevector(xy2, uv2, 0, 1, 8, 9, 4, 5, 12, 13),
                              __builtin_shufflevector(xy, uv, 2, 3, 10, 11, 6, 7, 14, 15),
                              __builtin_shufflevector(xy2, uv2, 2, 3, 10, 11, 6, 7, 14, 15)};
    for (int i = 0; i < 4; ++i) {
      r[i] = __builtin_shufflevector(pair[i], pair[i], 0, 1, 2, 3);
      r[i + 4] = __builtin_shufflevector(pair[i], pair[i], 4, 5, 6, 7);
    }
  } else if constexpr (N == 4) {
    const auto xy = __builtin_shufflevector(x, y, 0, 4, 2, 6);
    const auto xy2 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
    const auto uv = __builtin_shufflevector(u, v, 0, 4, 2, 6);
    const auto uv2 = __builtin_shufflevector(u, v, 1, 5, 3, 7);
    r[0] = __builtin_shufflevector(xy, uv, 0, 1, 4, 5);
    r[1] = __builtin_shufflevector(xy2, uv2, 0, 1, 4, 5);
    r[2] = __builtin_shufflevector(xy, uv, 2, 3, 6, 7);
    r[3] = __builtin_shufflevector(xy2, uv2, 2, 3, 6, 7);
  } else {
    for (int i = 0; i < 2; ++i) r[i] = Row{x[i], y[i], u[i], v[i]};
  }
}

}  // namespace furrow
