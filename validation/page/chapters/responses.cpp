// The simplest cases, drawn: what the solver does beside closed forms, and beside numbers that others have published.
#include "verification/studies/responses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "methods/method.h"
#include "scene/wording.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/responses_parts.h"
#include "verification/damped_hertz.h"
#include "verification/studies/kept_numbers.h"
#include "verification/studies/order_trends.h"

namespace furrow::validation {
namespace {

using namespace verification;

// ---- contact loops ----

// Until the contact lets go, whether it may pull or not.
struct ExactLoop {
  Json rows = Json::array();
  double peak = 0;
  explicit ExactLoop(double damping_factor) {
    constexpr int points = 400;
    const DampedHertz exact(damping_factor);
    for (int k = 0; k <= points; ++k) {
      const long double s = exact.letting_go() * k / points, d = exact.overlap(s);
      const auto force = static_cast<double>(std::pow(d, 1.5L) +
                                             std::sqrt(5.0L) * damping_factor * std::pow(d, 0.25L) * exact.speed(s));
      rows.push_back({kept(static_cast<double>(d), 6), kept(std::fmax(0, force), 6)});
      peak = std::fmax(peak, force);
    }
  }
};

void add_loops(Report& report, const furrow::Numbers& numbers) {
  Figure figure{"contact_loops", "contact_loops.gp", {}, {}};
  double worst = 0;
  std::string elastic, most;
  for (std::size_t k = 0; k < loop_dampings().size(); ++k) {
    const double beta = loop_dampings()[k];
    const Json& got = numbers.at(loop_key(beta));
    const ExactLoop exact(beta);
    worst = std::fmax(worst, std::fabs(number(got["peak"]) / exact.peak - 1));
    const std::string which = std::to_string(k + 1);
    figure.blocks["solver_" + which] = got["rows"];
    figure.blocks["exact_" + which] = exact.rows;
    figure.variables["title_" + which] = "β = " + rounded(beta, 3) +
                                         (beta == 0    ? ", elastic"
                                          : beta == 20 ? ", the paper's"
                                                       : "");
    (beta == 0 ? elastic : most) = rounded(exact.peak, 3);
  }
  figure.variables["panels"] = loop_dampings().size();
  figure.caption =
      "A disc runs into a wall: force against overlap, by damping factor, the solver's points on the closed form "
      "(Hertz; Antypov and Elliott 2011). Units of the impact: length (m v²/K)^(2/5), force K times its power 3/2. "
      "With the paper's β = 20 the contact is a damper: its force is largest (" +
      most + " against " + elastic + ") before the spring has any.";
  figure.description = "Loops of force against overlap: elastic a single curve up to a force of " + elastic +
                       ", with the damping of the paper a loop up to " + most + " at a small overlap";
  report.heading("One contact");
  report.figure(figure);
  report.claim(
      {.text = "Largest force of the solver in a damped or elastic impact, off from the closed form, the worst of " +
               std::to_string(loop_dampings().size()) + " dampings.",
       .value = percent(worst),
       .aim = "at most 0.1 %, less than a line's width",
       .holds = worst <= 1e-3});
}

// ---- phase portraits ----

void add_phases(Report& report, const furrow::Numbers& numbers) {
  Json points = Json::array(), panels = Json::array();
  std::vector<std::vector<Json>> rows;
  const double periods = phase_steps * phase_angle / (2 * std::numbers::pi);
  double farthest = 1;
  for (std::size_t k = 0; k < phase_methods().size(); ++k) {
    const std::string& name = phase_methods()[k];
    const Json& path = numbers.at(phase_key(name));
    if (!path.is_array()) continue;
    double radius = 1;
    for (const Json& row : path) {
      radius = std::hypot(number(row[0]), number(row[1]));
      farthest = std::fmax(farthest, radius);
      points.push_back({k, row[0], row[1]});
    }
    panels.push_back({k, radius, name});
    const auto drift = predicted_drift(name);
    const double theory = drift ? std::exp(periods * drift->factor * std::pow(phase_angle, drift->power) / 2) : NAN;
    rows.push_back({name, radius, kept(theory, 4)});
  }
  const auto widest =
      std::max_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  report.heading("One spring, by each method");
  report.figure(
      {.name = "phase_portraits",
       .script = "phase_portraits.gp",
       .caption = "An undamped mass on a spring with steps of " + rounded(phase_angle, 2) + "/ω, " +
                  rounded(periods, 2) +
                  " periods: place against velocity, the circle is the exact motion. Out of it a method makes "
                  "energy, into it it loses some.",
       .description = "Phase portraits of a spring by method: " + widest->at(0).get<std::string>() +
                      " spirals out to " + rounded(widest->at(1), 3) + " times the amplitude",
       .variables = {{"count", phase_methods().size()}, {"reach", std::fmin(2.5, 1.1 * farthest)}},
       .blocks = {{"points", points}, {"panels", panels}}});
  report.table("Amplitude after " + rounded(periods, 2) +
                   " periods, of that at the start; beside it what the leading term of the method's amplification "
                   "says, where it has one.",
               {"method", "amplitude", "by the leading term"}, rows);
}

// ---- bent lattices ----

double end_of(const furrow::Numbers& numbers, int cells) { return numbers.at(bent_key(cells)).back()[1]; }

void add_bent(Report& report, const furrow::Numbers& numbers) {
  Figure figure{"bent_lattice", "bent_lattice.gp", {}, {}};
  std::vector<std::vector<Json>> rows;
  Json names = Json::array(), curves = Json::array();
  for (std::size_t k = 0; k < bent_cells().size(); ++k) {
    const int cells = bent_cells()[k];
    for (const Json& row : numbers.at(bent_key(cells))) curves.push_back({k + 1, row[0], row[1]});
    names.push_back({k + 1, std::to_string(cells) + " cells"});
    rows.push_back({cells, end_of(numbers, cells), 1 / (1 + 9.0 / (4 * cells))});
  }
  const int finest = bent_cells().back();
  figure.variables = {{"count", bent_cells().size()}, {"slender", slenderness}};
  figure.blocks = {{"cells", curves}, {"names", names}};
  const std::string reached = percent(end_of(numbers, finest), 3);
  figure.caption =
      "A clamped lattice, " + rounded(slenderness, 2) +
      " times as long as high, bent by a force at its end, by cells through its height; the line is Timoshenko's beam. "
      "Whole springs on the edges, where half of one belongs to the material, make a coarse lattice too stiff.";
  figure.description = "Deflection of the lattice along its length: with " + std::to_string(finest) +
                       " cells its end goes " + reached + " of the way of the beam of Timoshenko";
  report.heading("One bent lattice");
  report.figure(figure);
  report.table(
      "Deflection of the end, of Timoshenko's, and what the series of the edges' springs says, 1/(1 + 9/(4 n)).",
      {"cells through the height", "deflection", "by the series"}, rows);
  const double off = std::fabs(end_of(numbers, finest) * (1 + 9.0 / (4 * finest)) - 1);
  report.claim({.text = "Deflection of a lattice with " + std::to_string(finest) +
                        " cells through its height, off from the series of its edges' springs.",
                .value = percent(off),
                .aim = "at most " + percent(5.0 / (finest * finest)) + ", terms 1/n² of the series",
                .holds = off <= 5.0 / (finest * finest)});
}

}  // namespace

Report responses(const Shelf& shelf) {
  const furrow::Numbers& numbers = shelf.of("responses");
  Report report("The simplest cases, drawn",
                "What do one contact, one spring and one lattice do, beside what is known?");
  add_loops(report, numbers);
  add_phases(report, numbers);
  add_bent(report, numbers);
  add_published_impacts(report, numbers);
  return report;
}

}  // namespace furrow::validation
