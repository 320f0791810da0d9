#include "benchmarks/studies/reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "run/run.h"

namespace furrow::benchmarks {
namespace {

constexpr double nudge = 1e-12;        // of each position
constexpr double short_step = 2.5e-5;  // s: inside the stability limit of every case
constexpr std::array<double, 3> limits{1e-9, 1e-6, 1e-3};

Outcome complete_run(const Case& scene, const Effort& effort) {
  Outcome outcome = run_case(scene, effort);
  if (!outcome.failure.empty()) throw Divergence("reference by " + effort.method + ": " + outcome.failure);
  return outcome;
}

double distance_of(const State& a, const State& b, int numbers) {
  double sum = 0;
  for (int i = 0; i < numbers; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace

Reference make_reference(const CaseInfo& info, const Case& scene) {
  const Outcome fine =
      complete_run(scene, {.method = "rk4", .step = info.reference_step, .locate = info.reference_locate});
  const Outcome unlike = complete_run(
      scene, {.method = info.other, .step = info.other_step, .tolerance = 1e-10, .locate = info.reference_locate});
  return {fine, info.other, error_of(unlike, fine)};
}

Json predictability(const CaseInfo& info, const Case& scene) {
  std::array<System, 2> system{scene.system, scene.system};
  std::array<State, 2> y{scene.y, scene.y};
  std::array<std::unique_ptr<Method>, 2> method{make_method("pece"), make_method("pece")};
  const int numbers = static_cast<int>(scene.system.positions());
  for (int i = 0; i < numbers; ++i) y[1][i] *= i % 2 == 0 ? 1 + nudge : 1 - nudge;
  std::vector<double> distance{distance_of(y[0], y[1], numbers)};
  double gone = 0;
  const int pieces = static_cast<int>(std::lround(info.nudge_end / scene.span.interval));
  for (int n = 0; n < pieces; ++n) {
    const double t = scene.span.start + n * scene.span.interval;
    for (int k = 0; k < 2; ++k) {
      const RunEnd end =
          run(system[k], *method[k], y[k],
              {.start = t, .end = t + scene.span.interval, .step = short_step, .stop = {}, .locate = Locate::tears},
              [](double, const State&, const JumpReport&) { return true; });
      if (end.ending != Ending::finished) throw Divergence(end.reason);
    }
    distance.push_back(distance_of(y[0], y[1], numbers));
    gone = std::max(gone, distance_of(y[0], scene.y, numbers));
  }
  Json result = {{"watched", info.nudge_end}, {"grown", distance.at(scene.span.samples) / distance[0]}};
  for (const double limit : limits) {
    const auto beyond = std::find_if(distance.begin(), distance.end(), [&](double d) { return d > limit * gone; });
    const auto pieces_until = static_cast<double>(beyond - distance.begin());
    result["until"].push_back(beyond == distance.end() ? Json() : Json(pieces_until * scene.span.interval));
  }
  return result;
}

}  // namespace furrow::benchmarks
