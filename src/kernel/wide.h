// Loops compiled once for each width of vector instructions; a call runs the widest that the processor supports. Every
// lane does the same arithmetic in the same order, so the width changes no bit.
#pragma once

namespace furrow {

enum class VectorWidth { none, avx2, avx512 };

// The widest that the processor supports, or what the environment variable FURROW_VECTORS names: none, avx2, avx512.
VectorWidth widest_vectors();
inline const VectorWidth vector_width = widest_vectors();
const char* vector_width_name();

}  // namespace furrow

// Always inlined: a function called from several widths would be compiled for one of them only.
#define FURROW_WIDE [[gnu::always_inline]] inline

// Defines result name(parameters), which runs name_lanes(arguments), a FURROW_WIDE function, at the chosen width;
// FURROW_WIDTHS_OF runs name_lanes<N>(arguments), with N doubles a vector.
// NOLINTBEGIN(bugprone-macro-parentheses): names, parameters and attributes cannot stand in parentheses
#define FURROW_WIDTHS(result, name, parameters, arguments) \
  FURROW_CHOICE(result, name, parameters, arguments, name##_lanes, name##_lanes, name##_lanes)
#define FURROW_WIDTHS_OF(result, name, parameters, arguments) \
  FURROW_CHOICE(result, name, parameters, arguments, name##_lanes<8>, name##_lanes<4>, name##_lanes<2>)
#ifdef __x86_64__
#define FURROW_CHOICE(result, name, parameters, arguments, wide, medium, narrow)                 \
  [[gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] static result name##_avx512 parameters { \
    return wide arguments;                                                                       \
  }                                                                                              \
  [[gnu::target("avx2")]] static result name##_avx2 parameters { return medium arguments; }      \
  static result name##_none parameters { return narrow arguments; }                              \
  result name parameters {                                                                       \
    switch (vector_width) {                                                                      \
      case VectorWidth::avx512:                                                                  \
        return name##_avx512 arguments;                                                          \
      case VectorWidth::avx2:                                                                    \
        return name##_avx2 arguments;                                                            \
      case VectorWidth::none:                                                                    \
        break;                                                                                   \
    }                                                                                            \
    return name##_none arguments;                                                                \
  }
#else
#define FURROW_CHOICE(result, name, parameters, arguments, wide, medium, narrow) \
  result name parameters { return narrow arguments; }
#endif
// NOLINTEND(bugprone-macro-parentheses)
