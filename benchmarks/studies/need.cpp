#include "benchmarks/studies/need.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>

#include "benchmarks/studies/measured_run.h"
#include "methods/method.h"
#include "output/machine.h"

namespace furrow::benchmarks {
namespace {

constexpr int digits = 6;          // of an effect
constexpr int digits_of_cost = 4;  // of a ratio of times

Scene changed(const Subject& subject, const Term* term, int packing) {
  Scene scene = subject.scene();
  for (Packing& p : scene.packing) p.seed += static_cast<std::uint64_t>(packing);
  if (term) term->drop(scene);
  return scene;
}

struct Run {
  std::array<double, 6> value{};  // by observable
  Outcome outcome;
};

// A scene that has settled, to be run again and again.
struct Ready {
  Case made;
  Effort effort;
  Vec2 velocity{};         // m/s, of the plate, if there is one
  std::size_t frames = 0;  // in each of which the contacts are listed
};

Ready ready(const Subject& subject, const Term* term, int packing) {
  const Scene scene = changed(subject, term, packing);
  Prepared p = prepare(scene);
  return {{std::move(p.system), std::move(p.y), subject.span},
          {.method = subject.method, .step = subject.step, .most_evaluations = 100'000'000},
          scene.plate.empty() ? Vec2{} : scene.plate[0].velocity,
          scene.output.frames.size()};
}

// s: the list of contacts as a frame makes it, of the start; its text is not counted.
double cpu_of_lists(const Ready& one) {
  const double begun = cpu_seconds();
  for (std::size_t k = 0; k < one.frames; ++k) {
    std::vector<Contact> list;
    one.made.system.for_each_contact(one.made.span.start, one.made.y, [&](const Contact& c) { list.push_back(c); });
  }
  return cpu_seconds() - begun;
}

Outcome once(const Ready& one) {
  Outcome outcome = run_case(one.made, one.effort);
  if (!outcome.failure.empty()) throw Divergence(outcome.failure);
  outcome.cpu += cpu_of_lists(one);
  return outcome;
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

Run run_of(const Ready& one) {
  Outcome outcome = once(one);
  double work = 0;
  for (std::size_t k = 0; k + 1 < outcome.force.size(); k += 2)
    work -= one.made.span.interval * (outcome.force[k] * one.velocity.x + outcome.force[k + 1] * one.velocity.y);
  return {values_of(outcome, work), std::move(outcome)};
}

// The CPU time of one over that of the other. A busy machine slows a run by half and more, and for seconds: so both run
// side by side, in turn the one and the other first, and what is kept is the ratio of each pair.
Json cost_ratios(const Ready& without, const Ready& whole, int pairs) {
  Json all = Json::array();
  for (int k = 0; k < pairs; ++k) {
    const double first = once(k % 2 == 0 ? without : whole).cpu, second = once(k % 2 == 0 ? whole : without).cpu;
    all.push_back(to_digits(k % 2 == 0 ? first / second : second / first, digits_of_cost));
  }
  return {{"ratios", all}};
}

// Of one packing: so that there are enough for an interval that holds the median in 95 of 100 cases.
int pairs_of(const Subject& subject, bool quick) {
  constexpr int enough = 6;
  return quick ? 1 : (enough + subject.packings - 1) / subject.packings;
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

struct Both {
  Ready ready;
  Run run;
};

// Settled and run once, when first asked for. A term of none: the whole model.
class Runs {
 public:
  const Both& of(const Subject& subject, const Term* term, int packing) {
    One* one = nullptr;
    {
      const std::scoped_lock lock(mutex_);
      std::unique_ptr<One>& place = runs_[{subject.name, term ? term->name : "", packing}];
      if (!place) place = std::make_unique<One>();
      one = place.get();
    }
    const std::scoped_lock lock(one->mutex);
    if (!one->both) {
      Ready settled = ready(subject, term, packing);
      Run run = run_of(settled);
      one->both.emplace(Both{std::move(settled), std::move(run)});
    }
    return *one->both;
  }
  const Both& whole(const Subject& subject, int packing) { return of(subject, nullptr, packing); }

 private:
  struct One {
    std::mutex mutex;
    std::optional<Both> both;
  };
  std::mutex mutex_;
  std::map<std::tuple<std::string, std::string, int>, std::unique_ptr<One>> runs_;
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

Json between_packings(const Subject& subject, Runs& runs) {
  Json effects = Json::array();
  for (int i = 0; i < subject.packings; ++i) {
    for (int j = 0; j < i; ++j)
      effects.push_back(to_digits(effect(runs.whole(subject, i).run, runs.whole(subject, j).run)[curve], digits));
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

// What is compared and what it cost are of one settled scene: the cost is asked for first, so that a result that is kept
// of one and old of the other is made of both again.
void measure_need(Measurement& measurement) {
  Runs runs;
  std::vector<Task> times, numbers;
  const std::vector<Subject> all = subjects(measurement.quick());
  for (const Subject& subject : all) {
    const std::string input = hash_of_scene(subject.scene());
    for (int k = 0; k < subject.packings; ++k) {
      numbers.push_back({whole_key(subject, k),
                         [&runs, &subject, k] {
                           return Json{{"values", json_of(runs.whole(subject, k).run.value)}};
                         },
                         input});
      for (const Term& term : terms_of(subject)) {
        times.push_back({cost_key(subject, term, k),
                         [&, term, k] {
                           return cost_ratios(runs.of(subject, &term, k).ready, runs.whole(subject, k).ready,
                                              pairs_of(subject, measurement.quick()));
                         },
                         input, true});
        numbers.push_back(
            {without_key(subject, term, k),
             [&, term, k] { return compared(runs.of(subject, &term, k).run, runs.whole(subject, k).run); }, input});
      }
    }
    if (subject.packings > 1)
      numbers.push_back({between_key(subject), [&] { return between_packings(subject, runs); }, input});
  }
  measurement.run(times);
  measurement.run(numbers);
}

}  // namespace furrow::benchmarks
