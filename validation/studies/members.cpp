#include "validation/studies/members.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "output/files.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

double kept(double value) { return to_digits(value, 6); }

// One number a stretch; null where no row falls into it.
Json force_by_way(const ForceCurve& curve) {
  Json largest = Json::array();
  for (std::size_t k = 0; k < curve.mm.size(); ++k) {
    const auto stretch = static_cast<std::size_t>(std::max(0.0, curve.mm[k] / stretch_of_way));
    while (largest.size() <= stretch) largest.push_back(nullptr);
    Json& most = largest[stretch];
    if (most.is_null() || most.get<double>() < curve.f[k]) most = to_digits(curve.f[k], 3);
  }
  return largest;
}

}  // namespace

Json observed(const Scene& made, const std::string& scene, Curve curve) {
  Prepared prepared = prepare(made);
  Json values = Json::object();
  if (prepared.surface) values["surface"] = kept(*prepared.surface);
  const Timing time = prepared.scene.time;
  const RunRecord run = observed_run(std::move(prepared), time);
  if (!run.finished()) values = {{"failed", run.fact("reason")->texts.at(0)}};
  for (const Statement& s : the_paper().statements) {
    if (s.scene != scene || (!run.finished() && s.observable != "finished")) continue;
    const Measured ours = measure(run, s.observable, s.window);
    if (std::isfinite(ours.value)) {
      values[s.id] = kept(ours.value);
    } else if (!ours.words.empty()) {
      values[s.id] = ours.words;
    }
  }
  if (!run.finished()) return values;
  double sum = 0;
  for (std::size_t k = 0; k < run.force.even(); ++k) sum += run.force.f[k];
  values["mean_force"] = kept(sum / static_cast<double>(run.force.even()));
  if (curve == Curve::kept) values["force_by_way"] = force_by_way(run.force);
  return values;
}

Json only(const std::vector<std::string>& ids, const Json& observed) {
  Json some = Json::object();
  if (observed.contains("failed")) some["failed"] = observed["failed"];
  for (const std::string& id : ids) {
    if (observed.contains(id)) some[id] = observed[id];
  }
  return some;
}

Scene Member::made() const {
  Scene made = paper_scene(scene, reading, seed);
  if (reading == Reading::sphere) made.time.step = step_for_spheres;
  return made;
}

Task Member::task() const {
  const Scene run = made();
  return {key(), [run, of = scene] { return observed(run, of, Curve::kept); }, hash_of_observed(run, scene)};
}

std::vector<Member> paper_members(bool quick) {
  std::vector<Member> all{{"scenario_1", Reading::disc, 1}};
  const std::uint64_t discs = quick ? 2 : 100;
  const std::uint64_t spheres = quick ? 0 : 8;
  for (const char* scene : {"scenario_2", "scenario_3"}) {
    for (std::uint64_t seed = 1; seed <= discs; ++seed) all.push_back({scene, Reading::disc, seed});
    for (std::uint64_t seed = 1; seed <= spheres; ++seed) all.push_back({scene, Reading::sphere, seed});
  }
  return all;
}

double Sample::quantile(double p) const {
  if (numbers.empty()) return NAN;
  const double at = p * static_cast<double>(numbers.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const double high = numbers[std::min(low + 1, numbers.size() - 1)];
  return numbers[low] + (at - static_cast<double>(low)) * (high - numbers[low]);
}

// Binomial ranks in their normal approximation.
std::pair<double, double> Sample::median_interval() const {
  const double n = static_cast<double>(numbers.size());
  if (n < 6) return {NAN, NAN};
  const double half = 0.98 * std::sqrt(n);
  const auto low = static_cast<std::size_t>(std::max(0.0, std::floor(n / 2 - half)));
  const auto high = static_cast<std::size_t>(std::min(n - 1, std::ceil(n / 2 + half) - 1));
  return {numbers[low], numbers[high]};
}

double Sample::share(const std::array<double, 2>& range) const {
  const auto inside =
      std::count_if(numbers.begin(), numbers.end(), [&](double v) { return v >= range[0] && v <= range[1]; });
  return members() == 0 ? NAN : static_cast<double>(inside) / static_cast<double>(members());
}

double Sample::mean() const {
  double sum = 0;
  for (const double v : numbers) sum += v;
  return sum / static_cast<double>(numbers.size());
}

double Sample::deviation() const {
  double sum = 0;
  for (const double v : numbers) sum += (v - mean()) * (v - mean());
  return numbers.size() < 2 ? NAN : std::sqrt(sum / static_cast<double>(numbers.size() - 1));
}

Sample sample_of(const std::string& observable, const std::vector<Json>& members) {
  Sample sample;
  for (const Json& m : members) {
    if (!m.contains(observable)) {
      sample.failed += m.contains("failed") ? 1 : 0;
    } else if (m[observable].is_number()) {
      sample.numbers.push_back(m[observable]);
    } else {
      sample.words.push_back(m[observable]);
    }
  }
  std::sort(sample.numbers.begin(), sample.numbers.end());
  return sample;
}

std::string three_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return number(std::strtod(text, nullptr));
}

}  // namespace furrow::validation
