#include "methods/parallel.h"

#include <omp.h>

namespace furrow {

void share_out(int threads, int pieces, void (*work)(void*, int piece, int thread), void* argument) {
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int k = 0; k < pieces; ++k) work(argument, k, omp_get_thread_num());
}

}  // namespace furrow
