#include "kernel/parallel.h"

#include <omp.h>

#include "system/floating_point.h"

namespace furrow {

void distribute(int threads, int pieces, void (*work)(void*, int piece, int thread), void* argument) {
#pragma omp parallel num_threads(threads)
  {
    const DefaultFloatingPoint environment;  // a thread starts with its creator's
#pragma omp for schedule(static)
    for (int k = 0; k < pieces; ++k) work(argument, k, omp_get_thread_num());
  }
}

}  // namespace furrow
