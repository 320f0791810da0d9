#include "validation/studies/few_members.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "validation/studies/kept_ensemble.h"

namespace furrow::validation {

Norm norm_of(const std::vector<Json>& ensemble) {
  Norm norm;
  for (const std::string& id : few_observables) {
    const Sample sample = sample_of(id, ensemble);
    norm.mean.push_back(sample.mean());
    norm.deviation.push_back(sample.deviation());
  }
  return norm;
}

double strangeness(const std::vector<Json>& members, const Norm& norm) {
  double most = 0;
  for (std::size_t k = 0; k < few_observables.size(); ++k) {
    const Sample sample = sample_of(few_observables[k], members);
    if (sample.numbers.size() != members.size()) return INFINITY;  // one diverged, or does not say
    const double error = norm.deviation[k] / std::sqrt(static_cast<double>(members.size()));
    const double distance = std::fabs(sample.mean() - norm.mean[k]) / error;
    if (std::isnan(distance)) return INFINITY;  // a norm of nothing, or of one number many times
    most = std::max(most, distance);
  }
  return most;
}

double alarm_rate(const std::vector<Json>& members, const Norm& norm, int draws) {
  std::mt19937_64 random(1);
  std::vector<Json> order;
  for (const Json& member : members) {
    if (!member.contains("failed")) order.push_back(only(few_observables, member));
  }
  if (order.size() < few) return 1;
  int alarms = 0;
  for (int k = 0; k < draws; ++k) {
    for (std::size_t i = 0; i < few; ++i) {
      std::uniform_int_distribution<std::size_t> from(i, order.size() - 1);
      std::swap(order[i], order[from(random)]);
    }
    alarms += strangeness({order.begin(), order.begin() + few}, norm) > few_limit ? 1 : 0;
  }
  return static_cast<double>(alarms) / draws;
}

bool check_few(const Settings& settings, const std::function<void(const std::string&)>& say) {
  const std::string group = "scenario_2 disc";
  const std::vector<Json> list = kept_ensemble(settings.directory, {group}).at(group);
  const Norm norm = norm_of(list);
  std::vector<Task> tasks;
  for (std::uint64_t seed = 101; seed < 101 + few; ++seed)
    tasks.push_back(Member{"scenario_2", Reading::disc, seed}.task());
  Settings running = settings;
  running.directory.clear();
  const std::vector<Json> got = Measurement("few", running, {}).run(tasks);
  for (std::size_t k = 0; k < few_observables.size(); ++k)
    say(few_observables[k] + ": " + three_digits(sample_of(few_observables[k], got).mean()) + ", ensemble " +
        three_digits(norm.mean[k]) + " with standard deviation " + three_digits(norm.deviation[k]));
  const double strange = strangeness(got, norm);
  say("compared with " + std::to_string(list.size()) + " packings, of which the first gives the same numbers today");
  const bool alike = strange <= few_limit;
  say(std::to_string(few) + " packings lie within " + three_digits(strange) + " standard errors, " +
      three_digits(few_limit) + " are allowed: " + (alike ? "like the ensemble" : "NOT like the ensemble"));
  return alike;
}

}  // namespace furrow::validation
