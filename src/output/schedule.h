// When a sample of a run is due: one rule for files, records, goldens, exports and benchmarks.
#pragma once

#include "methods/method.h"

namespace furrow {

// Due at start, start + interval, ...: a fixed step takes the accepted time nearest to that, a method that chooses its
// steps ends one there. A time that takes several at once is one sample. The last state of a run is a sample beside
// these; whoever keeps samples adds it when the run is over.
class Due {
 public:
  // interval and step in s, the interval above 0; the step that of a fixed method.
  Due(const MethodInfo& method, double step, double interval, double start = 0)
      : slack_(method.controlled ? 0 : 0.5 * step), interval_(interval), start_(start) {}

  bool at(double t) const { return t >= next() - slack_; }

  // All that are due by t are taken.
  void take(double t) {
    while (at(t)) ++taken_;
  }

  double next() const { return start_ + static_cast<double>(taken_) * interval_; }  // s

  // For RunPlan::stop of a run that ends at `end`, s.
  double stop(double t, double end) const { return next() > t && next() < end ? next() : end; }

  double slack() const { return slack_; }  // s
  long taken() const { return taken_; }
  void restore(long taken) { taken_ = taken; }

 private:
  double slack_, interval_, start_;
  long taken_ = 0;
};

}  // namespace furrow
