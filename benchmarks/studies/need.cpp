// No more than a scene needs: one term of the model switched off at a time, and what that does to what is observed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "benchmarks/studies/measured_run.h"
#include "benchmarks/studies/need_terms.h"
#include "benchmarks/studies/studies.h"
#include "scene/hash.h"
#include "scene/read.h"

namespace furrow::benchmarks {
namespace {

// ---- one run ----

Scene changed(const Subject& subject, const Term* term, int packing) {
  Scene scene = subject.scene();
  for (Packing& p : scene.packing) p.seed += static_cast<std::uint64_t>(packing);
  if (term) term->drop(scene);
  return scene;
}

Json run_of(const Subject& subject, const Term* term, int packing) {
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
  return {{"cpu", cpu[cpu.size() / 2]}, {"torn", outcome.torn},   {"work", work},
          {"force", outcome.force},     {"place", outcome.place}, {"reach", outcome.reach}};
}

// ---- what is observed ----

constexpr std::array<const char*, 6> observables{"largest force",     "mean force", "force curve",
                                                 "work of the plate", "links torn", "final positions"};
enum { largest, mean, curve, work, torn, place };

struct Run {
  double cpu = 0;
  std::array<double, 6> value{};  // of `curve` and `place` the units: root mean squares
  Outcome outcome;
};

Run run_from(const Json& json) {
  Run run;
  run.cpu = json.at("cpu");
  run.outcome.force = json.at("force").get<std::vector<double>>();
  run.outcome.place = json.at("place").get<std::vector<double>>();
  run.outcome.reach = json.at("reach").get<std::vector<double>>();
  const std::vector<double>& force = run.outcome.force;
  for (std::size_t k = 0; k + 1 < force.size(); k += 2) {
    const double size = std::hypot(force[k], force[k + 1]);
    run.value[largest] = std::max(run.value[largest], size);
    run.value[mean] += 2 * size / static_cast<double>(force.size());
  }
  run.value[curve] = root_mean_square(force);
  run.value[work] = json.at("work");
  run.value[torn] = json.at("torn");
  run.value[place] = root_mean_square(run.outcome.reach);
  return run;
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

struct Moments {
  double mean = 0, spread = 0;  // standard deviation of one
};

Moments moments(const std::vector<double>& values) {
  Moments m;
  const double n = static_cast<double>(values.size());
  for (const double v : values) m.mean += v / n;
  for (const double v : values) m.spread += (v - m.mean) * (v - m.mean) / std::max(1.0, n - 1);
  m.spread = std::sqrt(m.spread);
  return m;
}

struct Runs {
  Subject subject;
  std::vector<Run> base;                                           // by packing
  std::vector<std::pair<std::string, std::vector<Json>>> without;  // by term, by packing
};

// One packing: 1 % of the observable, and no link more or less. More: what another packing of the same discs does,
// since no one arranges them; a force curve has then to be as far off as two packings are.
std::array<double, 6> tolerances(const std::vector<Run>& base) {
  std::array<double, 6> t{0.01, 0.01, 0.01, 0.01, 0.5, 0.01};
  if (base.size() < 2) return t;
  for (const int k : {largest, mean, work, torn}) {
    std::vector<double> values;
    for (const Run& run : base) values.push_back(run.value[k]);
    const Moments m = moments(values);
    t[k] = std::max(t[k], k == torn ? m.spread : m.spread / m.mean);
  }
  std::vector<double> between;
  for (std::size_t i = 0; i < base.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) between.push_back(effect(base[i], base[j])[curve]);
  }
  t[curve] = moments(between).mean;
  t[place] = NAN;  // of discs that stand elsewhere
  return t;
}

std::string percent(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(),
                std::fabs(value) < 1e-4  ? "%.1g %%"
                : std::fabs(value) < 0.1 ? "%.2f %%"
                                         : "%.0f %%",
                100 * value);
  return std::isnan(value) ? "–" : value == 0 ? "0" : text.data();
}

std::string amount(int observable, double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%+.3g", value);
  return observable != torn ? percent(value) : std::isnan(value) ? "–" : value == 0 ? "0" : text.data();
}

// Forces only where there is a plate, torn links where there is a lattice.
bool shown(const Runs& runs, std::size_t observable) {
  const Scene scene = runs.subject.scene();
  if (observable == torn) return !scene.lattice.empty();
  return observable == place || !scene.plate.empty();
}

struct Verdict {
  std::vector<Json> row;
  bool needed = false, certain = true, failed = false;
  double saved = 0;
};

Verdict verdict_on(const Runs& runs, std::size_t term) {
  const auto& [name, results] = runs.without[term];
  Verdict v{.row = {name}};
  std::array<std::vector<double>, 6> effects;
  std::vector<double> cost;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (results[k].contains("failed")) {
      v.failed = v.needed = true;
      v.row.emplace_back("the scene does not run without: " + results[k]["failed"].get<std::string>());
      return v;
    }
    const Run run = run_from(results[k]);
    const std::array<double, 6> e = effect(run, runs.base[k]);
    for (std::size_t o = 0; o < e.size(); ++o) effects[o].push_back(e[o]);
    cost.push_back(run.cpu / runs.base[k].cpu);
  }
  const std::array<double, 6> tolerance = tolerances(runs.base);
  std::string which;
  for (std::size_t o = 0; o < effects.size(); ++o) {
    const Moments m = moments(effects[o]);
    const double doubt = m.spread / std::sqrt(static_cast<double>(effects[o].size()));
    if (shown(runs, o))
      v.row.emplace_back(amount(static_cast<int>(o), m.mean) +
                         (doubt > 0 ? " ± " + amount(static_cast<int>(o), doubt) : ""));
    if (std::isnan(tolerance[o]) || std::isnan(m.mean)) continue;
    if (std::fabs(m.mean) > tolerance[o]) which += (which.empty() ? "" : ", ") + std::string(observables[o]);
    v.certain = v.certain && std::fabs(std::fabs(m.mean) - tolerance[o]) >= doubt;
  }
  v.needed = !which.empty();
  v.saved = 1 - moments(cost).mean;
  v.row.emplace_back(percent(v.saved));
  v.row.emplace_back((v.needed ? "needed: " + which : "not needed") + (v.certain ? "" : " (not certain)"));
  return v;
}

// Returns the terms that are not needed, for furrow explain.
Json add_subject(Report& report, const Runs& runs) {
  report.heading(runs.subject.name);
  std::vector<std::string> head{"without"};
  std::vector<Json> limit{"tolerance"};
  const std::array<double, 6> tolerance = tolerances(runs.base);
  for (std::size_t o = 0; o < observables.size(); ++o) {
    if (!shown(runs, o)) continue;
    head.emplace_back(observables[o]);
    limit.emplace_back(amount(static_cast<int>(o), tolerance[o]));
  }
  head.insert(head.end(), {"CPU saved", "so"});
  std::vector<std::vector<Json>> rows{limit};
  std::string spare;
  Json not_needed = Json::array();
  for (std::size_t k = 0; k < runs.without.size(); ++k) {
    const Verdict v = verdict_on(runs, k);
    rows.push_back(v.row);
    if (v.needed) continue;
    spare += (spare.empty() ? "" : "; ") + runs.without[k].first + (v.certain ? "" : " (not certain)");
    not_needed.push_back({{"term", runs.without[k].first}, {"certain", v.certain}, {"saved", percent(v.saved)}});
  }
  report.table("Change against the whole model" +
                   std::string(runs.base.size() > 1 ? ", mean over packings ± its standard error" : ""),
               head, rows);
  report.text(spare.empty() ? "Every term is needed." : "Not needed: " + spare + ".");
  return not_needed;
}

// The ledger looks on; it must not touch what it looks at.
void add_ledger_claim(Report& report, const std::vector<Runs>& all) {
  bool same = true;
  std::size_t compared = 0;
  for (const Runs& runs : all) {
    for (const auto& [name, results] : runs.without) {
      if (name != "energy ledger") continue;
      for (std::size_t k = 0; k < results.size(); ++k) {
        const Outcome without = run_from(results[k]).outcome;
        ++compared;
        same = same && without.place == runs.base[k].outcome.place && without.force == runs.base[k].outcome.force;
      }
    }
  }
  report.claim("Without the energy ledger every scene gives the same forces and positions to the last bit",
               same && compared > 0);
}

}  // namespace

Json need(const Settings& settings) {
  std::vector<Runs> all;
  std::vector<Task> tasks;
  for (const Subject& subject : subjects(settings.quick)) {
    all.push_back({subject, {}, {}});
    const Scene scene = subject.scene();
    const auto add = [&](const Term* term) {
      for (int k = 0; k < subject.packings; ++k)
        tasks.push_back({subject.name + " " + std::to_string(k) + (term ? " without " + term->name : ""),
                         [subject, term, k] { return run_of(subject, term, k); }});
    };
    add(nullptr);
    for (const Term& term : terms()) {
      if (!term.present(scene)) continue;
      add(&term);
      all.back().without.emplace_back(term.name, std::vector<Json>());
    }
  }
  const std::vector<Json> results = run_tasks("need", settings, tasks);
  std::size_t next = 0;
  for (Runs& runs : all) {
    for (int k = 0; k < runs.subject.packings; ++k, ++next) {
      if (results[next].contains("failed"))
        throw Divergence(tasks[next].key + ": " + results[next]["failed"].get<std::string>());
      runs.base.push_back(run_from(results[next]));
    }
    for (auto& [name, list] : runs.without) {
      for (int k = 0; k < runs.subject.packings; ++k, ++next) list.push_back(results[next]);
    }
  }
  Report report("No more than a scene needs",
                "Which terms of the model could each scene do without, and what would that save?");
  report.text(
      "One term at a time is switched off in the scene, which is then settled and run as before. Largest and mean "
      "force on the plate, and its work, are compared as fractions of the whole model's; force curve and final "
      "positions "
      "by the root mean square of the difference over that of the force, or of how far bodies get. Tolerance: 1 % and "
      "half a link; for beds of discs what another random packing of them changes (standard deviation over the "
      "packings, "
      "for the curve the mean difference of two), since no one arranges the discs. Positions of discs are then shown, "
      "not judged. Runs by rk4 with a step below every stability limit, so that the chatter of the paper's step is not "
      "mistaken for an effect. CPU saved is of the run, without settling.");
  report.text(
      "A scene cannot express: discs that rub but do not turn, since the tangential spring acts at the surface of a "
      "disc and spins exist where friction does; a tangential spring without its Coulomb limit. Gravity and the "
      "damping of contacts cannot be left out of a bed: without them it never settles. What a scene leaves out "
      "already, and so cannot be switched off, is what furrow explain lists.");
  Json not_needed = Json::object();
  for (const Runs& runs : all) not_needed[hexadecimal(scene_hash(runs.subject.scene()))] = add_subject(report, runs);
  report.data({{"not_needed", not_needed}});
  add_ledger_claim(report, all);
  return report.json();
}

}  // namespace furrow::benchmarks
