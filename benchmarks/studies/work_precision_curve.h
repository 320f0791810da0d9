// One method on one case over a range of steps or tolerances: error and cost, failures included.
#pragma once

#include "benchmarks/studies/reference.h"
#include "methods/method.h"

namespace furrow::benchmarks {

struct WorkPrecisionPoint {
  double setting = 0;                           // s, step; of a controlled method the relative tolerance
  Error error{};                                // root mean square over the phases
  double evaluations = 0;                       // mean over the phases
  double cpu = 0, cpu_least = 0, cpu_most = 0;  // s: median, and spread of the repeats
  bool given_up = false;                        // it cost too much: no finer setting is tried
  std::string failure{};                        // then the costs are those of a run to the end, as far as known
  double error_by(bool force) const { return force ? error.force : error.place; }
};

struct WorkPrecisionCurve {
  std::string method;
  Locate locate = Locate::none;
  std::string left_out{};                    // why the method cannot run here
  std::vector<WorkPrecisionPoint> points{};  // from coarse to fine
  std::string name() const { return method + (locate == Locate::tears ? " +t" : locate == Locate::all ? " +e" : ""); }
};

// Steps are halved, tolerances divided by ten, from the coarsest on until the error is below the floor of the reference
// or a run costs more evaluations than rk4 with the finest step.
struct Variant {
  MethodInfo method;
  Locate locate = Locate::none;
};
WorkPrecisionCurve measure_curve(const Variant& variant, const CaseInfo& info, const Case& scene,
                                 const Reference& reference);

Json json_of(const WorkPrecisionCurve& method_curve);
// Of one that failed as a whole: left out, for that reason.
WorkPrecisionCurve curve_from(const Variant& variant, const Json& json);

// Cost at an error that the method keeps with every finer setting that was tried: between two points along the straight
// line in logarithms. NaN if it does not get there.
double cost_at(const WorkPrecisionCurve& method_curve, double error, bool by_force, double WorkPrecisionPoint::*cost);

}  // namespace furrow::benchmarks
