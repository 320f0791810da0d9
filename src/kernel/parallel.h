// Loops over threads. The pieces are the same for any number of threads, and sums over pieces are taken in their order,
// so no bit depends on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace furrow {

// Calls work(argument, piece, thread) for each piece in [0, pieces), on this many threads. A thread gets the same
// pieces in every call, so that their data may still be in its cache. work must not throw.
void distribute(int threads, int pieces, void (*work)(void*, int piece, int thread), void* argument);

// Calls work(piece, thread) for each piece; one thread takes them in order.
template <class Work>
void in_parallel(int threads, int pieces, Work&& work) {
  using Plain = std::remove_reference_t<Work>;
  if (threads == 1 || pieces == 1) {
    for (int k = 0; k < pieces; ++k) work(k, 0);
  } else {
    distribute(
        threads, pieces, [](void* w, int piece, int thread) { (*static_cast<Plain*>(w))(piece, thread); },
        std::addressof(work));
  }
}

// Calls pass(first, last) for ranges that together are [0, count).
template <class Pass>
void in_ranges(int threads, std::size_t count, Pass&& pass) {
  constexpr std::size_t length = 1 << 12;
  if (threads == 1) return pass(std::size_t{0}, count);
  in_parallel(threads, static_cast<int>((count + length - 1) / length), [&](int piece, int /*thread*/) {
    const std::size_t first = length * static_cast<std::size_t>(piece);
    pass(first, std::min(count, first + length));
  });
}

// to[0 ... count) = from[0 ... count)
template <class T>
void copy_in_ranges(int threads, const T* from, std::size_t count, T* to) {
  in_ranges(threads, count,
            [&](std::size_t first, std::size_t last) { std::copy(from + first, from + last, to + first); });
}

// to[0 ... count) = value
template <class T>
void fill_in_ranges(int threads, T* to, std::size_t count, const T& value) {
  in_ranges(threads, count, [&](std::size_t first, std::size_t last) { std::fill(to + first, to + last, value); });
}

}  // namespace furrow
