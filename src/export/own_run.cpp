#include "export/own_run.h"

#include <algorithm>
#include <cmath>

#include "methods/method.h"
#include "output/schedule.h"
#include "run/observe.h"
#include "run/run.h"
#include "run/validity.h"

namespace furrow {
namespace {

constexpr int blocks = 10;  // of the later force

}  // namespace

OwnRun own_run(Prepared& prepared, const std::string& method_name, double step, double until) {
  OwnRun own;
  System& system = prepared.system;
  const Timing& time = prepared.scene.time;
  const auto method = make_method(method_name, {time.relative_tolerance, time.absolute_tolerance, step});
  const double interval = deck_run(prepared).interval();
  own.end = prepared.y;
  Validity validity(system, prepared.scene, [](const std::string&) {});
  RunPlan plan{.start = 0, .end = until, .step = step, .validity = &validity};
  Due due(method->info(), step, interval);
  plan.stop = [&](double t) { return due.stop(t, until); };
  const RunEnd ended = run(system, *method, own.end, plan, [&](double t, const State& y, const JumpReport& jump) {
    own.tears.insert(own.tears.end(), jump.torn.begin(), jump.torn.end());
    if (!due.at(t)) return true;
    const Observation seen = observe(system, t, y);
    validity.judge_row(t, seen);
    own.forces.push_back({static_cast<double>(due.taken())});
    for (const auto& list : {seen.plate, seen.wall})
      for (const Force& f : list) own.forces.back().insert(own.forces.back().end(), {f.x, f.y});
    due.take(t);
    return true;
  });
  if (ended.ending != Ending::finished) throw Divergence("furrow's own run: " + ended.reason);
  return own;
}

double greatest_force(const ForceRows& rows, std::size_t c, std::size_t last) {
  double most = 0;
  for (std::size_t k = 1; k <= last && k < rows.size(); ++k)
    most = std::max(most, std::hypot(rows[k][c], rows[k][c + 1]));
  return most;
}

double force_error(const ForceRows& engine, const ForceRows& own, std::size_t c) {
  double most = 0;
  const std::size_t count = std::min(engine.size(), own.size());
  for (std::size_t k = 1; k < count; ++k)
    most = std::max(most, std::hypot(engine[k][c] - own[k][c], engine[k][c + 1] - own[k][c + 1]));
  return most / greatest_force(own, c, own.size());
}

Mean mean_force(const ForceRows& rows, std::size_t c, std::size_t first) {
  const std::size_t count = rows.size() > first ? (rows.size() - first) / blocks : 0;
  if (count == 0) return {};
  std::vector<double> means(blocks, 0.0);
  for (std::size_t k = 0; k < blocks * count; ++k)
    means[k / count] += std::hypot(rows[first + k][c], rows[first + k][c + 1]) / static_cast<double>(count);
  Mean mean;
  double square = 0;
  for (const double m : means) mean.value += m / blocks;
  for (const double m : means) square += (m - mean.value) * (m - mean.value);
  mean.error = std::sqrt(square / (blocks - 1) / blocks);
  return mean;
}

}  // namespace furrow
