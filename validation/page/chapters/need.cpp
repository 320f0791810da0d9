// Which terms of the model could each scene do without, and what would that save?
#include "benchmarks/studies/need.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "benchmarks/measuring/samples.h"
#include "scene/wording.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/failures.h"
#include "validation/page/names.h"

namespace furrow::validation {
namespace {

using namespace benchmarks;

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

using Values = std::array<double, 6>;  // by observable

Values values_in(const Json& json) {
  Values values{};
  for (std::size_t o = 0; o < values.size(); ++o) values[o] = json.at(o).is_null() ? NAN : json.at(o).get<double>();
  return values;
}

// One packing: 1 % of the observable, and no link more or less. More: what another packing of the same discs does,
// since no one arranges them; a force curve has then to be as far off as two packings are.
Values tolerances(const Numbers& numbers, const Subject& subject) {
  Values t{0.01, 0.01, 0.01, 0.01, 0.5, 0.01};
  if (subject.packings < 2) return t;
  for (const int o : {largest, mean, work, torn}) {
    std::vector<double> values;
    for (int k = 0; k < subject.packings; ++k)
      values.push_back(values_in(numbers.at(whole_key(subject, k)).at("values"))[o]);
    const Moments m = moments(values);
    t[o] = std::max(t[o], o == torn ? m.spread : m.spread / m.mean);
  }
  t[curve] = moments(numbers.at(between_key(subject)).get<std::vector<double>>()).mean;
  t[place] = NAN;  // of discs that stand elsewhere
  return t;
}

std::string percent(double value) {
  if (std::isnan(value)) return "–";
  if (std::fabs(value) < 1e-12) return "0";  // but for round-off
  const double size = std::fabs(value), percent = 100 * value;
  return (size < 1e-4 ? rounded(percent, 1) : fixed(percent, size < 0.1 ? 2 : 0)) + " %";
}

// with_sign: a plus before what is more.
std::string amount(int observable, double value, bool with_sign = true) {
  if (observable != torn || std::isnan(value) || value == 0) return percent(value);
  return (with_sign && value > 0 ? "+" : "") + rounded(value, 3);
}

// Forces only where there is a plate, torn links where there is a lattice.
bool is_shown(const Subject& subject, std::size_t observable) {
  const Scene scene = subject.scene();
  if (observable == torn) return !scene.lattice.empty();
  return observable == place || !scene.plate.empty();
}

struct Verdict {
  std::vector<Json> row;
  bool needed = false, certain = true;
};

// What is shown to be saved: the median and its interval. More than nothing if that leaves out nothing.
std::string saved(const std::vector<double>& ratios) {
  const Interval cost = median_interval(ratios);
  if (cost.samples < 6) return "not judged: too few pairs for an interval";
  const std::string interval = percent(1 - cost.high) + " to " + percent(1 - cost.low);
  return cost.low <= 1 && cost.high >= 1 ? "none shown: " + interval : percent(1 - cost.middle) + " (" + interval + ")";
}

// A term for which nothing can be compared is not judged, which is not to say that it is not needed.
Verdict verdict_on(const Numbers& numbers, const Subject& subject, const Term& term, const Values& tolerance) {
  Verdict v{.row = {term.name}};
  std::array<std::vector<double>, 6> effects;
  std::vector<double> cost;
  for (int k = 0; k < subject.packings; ++k) {
    const Json& run = numbers.at(without_key(subject, term, k));
    if (run.contains("failed")) {
      v.needed = true;
      v.row.emplace_back("needed: the scene does not run without; " + in_short(run["failed"].get<std::string>()));
      return v;
    }
    const Values e = values_in(run.at("effects"));
    for (std::size_t o = 0; o < e.size(); ++o) effects[o].push_back(e[o]);
    for (const Json& ratio : numbers.at(cost_key(subject, term, k)).at("ratios")) cost.push_back(ratio.get<double>());
  }
  std::string which;
  int compared = 0;
  for (std::size_t o = 0; o < effects.size(); ++o) {
    const Moments m = moments(effects[o]);
    const double doubt = m.spread / std::sqrt(static_cast<double>(effects[o].size()));
    if (is_shown(subject, o))
      v.row.emplace_back(amount(static_cast<int>(o), m.mean) +
                         (doubt > 0 ? " ± " + amount(static_cast<int>(o), doubt, false) : ""));
    if (std::isnan(tolerance[o]) || std::isnan(m.mean) || !is_shown(subject, o)) continue;
    ++compared;
    if (std::fabs(m.mean) > tolerance[o]) which += (which.empty() ? "" : ", ") + std::string(observables[o]);
    v.certain = v.certain && std::fabs(std::fabs(m.mean) - tolerance[o]) >= doubt;
  }
  v.needed = !which.empty() || compared == 0;
  v.row.emplace_back(saved(cost));
  v.row.insert(v.row.begin() + 1, compared == 0 ? "not judged: nothing to compare"
                                                : (v.needed ? "needed: " + which : std::string("not needed")) +
                                                      (v.certain ? "" : " (not certain)"));
  return v;
}

void add_subject(Report& report, const Numbers& numbers, const Subject& subject) {
  report.heading(capital(scene_words(subject.name)));
  std::vector<std::string> head{"without", "verdict"};
  std::vector<Json> limit{"tolerance", ""};
  const Values tolerance = tolerances(numbers, subject);
  for (std::size_t o = 0; o < observables.size(); ++o) {
    if (!is_shown(subject, o)) continue;
    head.emplace_back(observables[o]);
    limit.emplace_back(amount(static_cast<int>(o), tolerance[o]));
  }
  head.emplace_back("CPU time saved");
  std::vector<std::vector<Json>> rows{limit};
  std::string spare;
  for (const Term& term : terms_of(subject)) {
    const Verdict v = verdict_on(numbers, subject, term, tolerance);
    rows.push_back(v.row);
    if (!v.needed) spare += (spare.empty() ? "" : "; ") + term.name + (v.certain ? "" : " (not certain)");
  }
  report.table("Change against the whole model" +
                   std::string(subject.packings > 1 ? ", mean over packings ± its standard error" : ""),
               head, rows);
  report.text(spare.empty() ? "No term is shown to be of no need." : "Not needed: " + spare + ".");
}

void add_ledger_claim(Report& report, const Numbers& numbers, const std::vector<Subject>& all) {
  int same = 0, compared = 0;
  for (const Subject& subject : all) {
    for (const Term& term : terms_of(subject)) {
      if (term.name != "energy ledger") continue;
      for (int k = 0; k < subject.packings; ++k, ++compared)
        same += numbers.at(without_key(subject, term, k)).value("same", false) ? 1 : 0;
    }
  }
  report.claim({.text = "Without the energy ledger every scene gives the same forces and positions to the last bit.",
                .value = std::to_string(same) + " of " + std::to_string(compared) + " runs",
                .aim = "all",
                .holds = same == compared && compared > 0});
}

}  // namespace

Report need(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("need");
  const std::vector<Subject> all = subjects(numbers.quick());
  Report report("No more than a scene needs",
                "Which terms of the model could each scene do without, and what would that save?");
  report.text(
      "One term at a time is switched off in the scene, which is then settled and run as before. Largest and mean "
      "force on the plate, and its work, are compared as fractions of the whole model's; force curve and final "
      "positions by the root mean square of the difference over that of the force, or of how far bodies get. "
      "Tolerance: 1 % and half a link; for beds of discs what another random packing of them changes (standard "
      "deviation over the packings, for the curve the mean difference of two), since no one arranges the discs. "
      "Positions of discs are then shown, not judged. Runs by rk4 with a step below every stability limit, so that "
      "the chatter of the paper's step is not mistaken for an effect.");
  report.text(
      "CPU time saved is of the run, without settling. Runs with the term and without it are made side by side, in "
      "turn the one and the other first, six pairs or more (in the quick form one, which shows nothing): shown are the "
      "median of their "
      "ratios and the interval that holds it in 95 of 100 cases. None is shown where that interval holds no change.");
  report.text(
      "What no scene of the paper has stands in brackets and is put in the place of what it has: 'not needed' then "
      "says that one does as well as the other, 'needed' that the choice changes what is observed. A restitution and "
      "Tsuji's alpha are other ways to give the damping factor, and no rows.");
  report.text(
      "A scene cannot express: discs that rub but do not turn, since the tangential spring acts at the surface of a "
      "disc and spins exist where friction does; a tangential spring without its Coulomb limit. Gravity and the "
      "damping of contacts cannot be left out of a bed: without them it never settles.");
  for (const Subject& subject : all) add_subject(report, numbers, subject);
  add_ledger_claim(report, numbers, all);
  return report;
}

}  // namespace furrow::validation
