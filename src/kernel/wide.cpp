#include "kernel/wide.h"

#include <cstdlib>
#include <string_view>

namespace furrow {

VectorWidth widest_vectors() {
#ifdef __x86_64__
  const char* named = std::getenv("FURROW_VECTORS");
  const std::string_view wanted = named ? named : "avx512";
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (wanted == "avx512" && avx512) return VectorWidth::avx512;
  if (wanted != "none" && __builtin_cpu_supports("avx2")) return VectorWidth::avx2;
#endif
  return VectorWidth::none;
}

const char* vector_width_name() {
  return vector_width == VectorWidth::avx512 ? "avx512" : vector_width == VectorWidth::avx2 ? "avx2" : "none";
}

}  // namespace furrow
