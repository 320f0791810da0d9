// The floating-point environment that all bits of a run depend on: rounding to nearest, subnormal numbers kept, no
// traps, since lanes that are masked out may compute what is not finite.
#pragma once

#include <cfenv>

namespace furrow {

// That environment as long as this lives, in this thread; then the caller's as it was.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloatingPoint() { std::fesetenv(&callers_); }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
  std::fenv_t callers_{};
};

}  // namespace furrow
