#include "benchmarks/studies/need.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "benchmarks/studies/measured_run.h"
#include "methods/method.h"

namespace furrow::benchmarks {
namespace {

constexpr int digits = 6;  // of an effect

Scene changed(const Subject& subject, const Term* term, int packing) {
  Scene scene = subject.scene();
  for (Packing& p : scene.packing) p.seed += static_cast<std::uint64_t>(packing);
  if (term) term->drop(scene);
  return scene;
}

struct Run {
  double cpu = 0;                 // s
  std::array<double, 6> value{};  // by observable
  Outcome outcome;
};

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// `curve` and `place`: the units of their errors.
std::array<double, 6> values_of(const Outcome& outcome, double plate_work) {
  std::array<double, 6> value{};
  const std::vector<double>& force = outcome.force;
  for (std::size_t k = 0; k + 1 < force.size(); k += 2) {
    const double size = std::hypot(force[k], force[k + 1]);
    value[largest] = std::max(value[largest], size);
    value[mean] += 2 * size / static_cast<double>(force.size());
  }
  value[curve] = root_mean_square(force);
  value[work] = plate_work;
  value[torn] = outcome.torn;
  value[place] = root_mean_square(outcome.reach);
  return value;
}

Run run_of(const Subject& subject, const Term* term, int packing) {
  const Scene scene = changed(subject, term, packing);
  Prepared p = prepare(scene);
  const Case made{std::move(p.system), std::move(p.y), subject.span};
  const Effort effort{.method = subject.method, .step = subject.step, .most_evaluations = 100'000'000};
  std::vector<double> cpu;
  Outcome outcome;
  for (double spent = 0; cpu.empty() || (spent < 0.3 && cpu.size() < 5); spent += cpu.back()) {
    outcome = run_case(made, effort);
    cpu.push_back(outcome.cpu);
  }
  if (!outcome.failure.empty()) throw Divergence(outcome.failure);
  std::sort(cpu.begin(), cpu.end());
  double work = 0;
  for (std::size_t k = 0; k + 1 < outcome.force.size() && !scene.plate.empty(); k += 2)
    work -= subject.span.interval *
            (outcome.force[k] * scene.plate[0].velocity.x + outcome.force[k + 1] * scene.plate[0].velocity.y);
  return {cpu[cpu.size() / 2], values_of(outcome, work), outcome};
}

// Fractions of the base run's; of links torn the number. NaN where there is nothing to compare.
std::array<double, 6> effect(const Run& run, const Run& base) {
  std::array<double, 6> e{};
  for (const int k : {largest, mean, work}) e[k] = run.value[k] / base.value[k] - 1;
  const Error error = error_of(run.outcome, base.outcome);
  e[curve] = base.outcome.force.empty() ? NAN : error.force;
  e[place] = error.place;
  e[torn] = run.value[torn] - base.value[torn];
  return e;
}

// The runs of the whole model, each made once, when something is first compared with it.
class Whole {
 public:
  const Run& of(const Subject& subject, int packing) {
    One* one = nullptr;
    {
      const std::scoped_lock lock(mutex_);
      std::unique_ptr<One>& place = runs_[{subject.name, packing}];
      if (!place) place = std::make_unique<One>();
      one = place.get();
    }
    const std::scoped_lock lock(one->mutex);
    if (!one->run) one->run = run_of(subject, nullptr, packing);
    return *one->run;
  }

 private:
  struct One {
    std::mutex mutex;
    std::optional<Run> run;
  };
  std::mutex mutex_;
  std::map<std::pair<std::string, int>, std::unique_ptr<One>> runs_;
};

Json json_of(const std::array<double, 6>& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(std::isfinite(value) ? Json(to_digits(value, digits)) : Json());
  return json;
}

// The ledger looks on; it must not touch what it looks at: then "same".
Json compared(const Run& run, const Run& whole) {
  return {{"effects", json_of(effect(run, whole))},
          {"same", run.outcome.place == whole.outcome.place && run.outcome.force == whole.outcome.force}};
}

Json between_packings(const Subject& subject, Whole& whole) {
  Json effects = Json::array();
  for (int i = 0; i < subject.packings; ++i) {
    for (int j = 0; j < i; ++j)
      effects.push_back(to_digits(effect(whole.of(subject, i), whole.of(subject, j))[curve], digits));
  }
  return effects;
}

std::string packed(const Subject& subject, int packing) { return subject.name + " " + std::to_string(packing); }

}  // namespace

std::string whole_key(const Subject& subject, int packing) { return packed(subject, packing) + " whole"; }
std::string without_key(const Subject& subject, const Term& term, int packing) {
  return packed(subject, packing) + " without " + term.name;
}
std::string cost_key(const Subject& subject, const Term& term, int packing) {
  return without_key(subject, term, packing) + ", cost";
}
std::string between_key(const Subject& subject) { return subject.name + " between packings"; }

std::vector<Term> terms_of(const Subject& subject) {
  const Scene scene = subject.scene();
  std::vector<Term> all;
  for (const Term& term : terms()) {
    if (term.present(scene)) all.push_back(term);
  }
  return all;
}

// What is compared and what it cost come from one run: the cost is asked for first, so that a result that is kept of one
// and old of the other is made of both again.
void measure_need(Measurement& measurement) {
  Whole whole;
  std::vector<Task> times, numbers;
  std::map<std::string, Run> made;
  std::mutex mutex;
  const auto run_once = [&](const Subject& subject, const Term& term, int packing) -> const Run& {
    const std::string key = without_key(subject, term, packing);
    {
      const std::scoped_lock lock(mutex);
      if (const auto found = made.find(key); found != made.end()) return found->second;
    }
    Run run = run_of(subject, &term, packing);
    const std::scoped_lock lock(mutex);
    return made.emplace(key, std::move(run)).first->second;
  };
  const std::vector<Subject> all = subjects(measurement.quick());
  for (const Subject& subject : all) {
    const std::string input = hash_of_scene(subject.scene());
    for (int k = 0; k < subject.packings; ++k) {
      numbers.push_back({whole_key(subject, k),
                         [&whole, &subject, k] {
                           return Json{{"values", json_of(whole.of(subject, k).value)}};
                         },
                         input});
      for (const Term& term : terms_of(subject)) {
        times.push_back({cost_key(subject, term, k),
                         [&, term, k] { return Json(run_once(subject, term, k).cpu / whole.of(subject, k).cpu); },
                         input, true});
        numbers.push_back({without_key(subject, term, k),
                           [&, term, k] { return compared(run_once(subject, term, k), whole.of(subject, k)); }, input});
      }
    }
    if (subject.packings > 1)
      numbers.push_back({between_key(subject), [&] { return between_packings(subject, whole); }, input});
  }
  measurement.run(times);
  measurement.run(numbers);
}

}  // namespace furrow::benchmarks
