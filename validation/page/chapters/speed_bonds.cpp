// The paper's first scene, which has no soil, on LAMMPS's bonds. Measured by benchmarks/rivals/bonds.py.
#include <vector>

#include "benchmarks/measuring/samples.h"
#include "validation/page/chapters/speed_parts.h"

namespace furrow::validation {
namespace {

// Times of LAMMPS over those of furrow, round by round.
benchmarks::Interval over(const Json& theirs, const Json& ours) {
  return benchmarks::median_interval(
      benchmarks::ratios(theirs.get<std::vector<double>>(), ours.get<std::vector<double>>()));
}

double median(const Json& times) { return benchmarks::median_interval(times.get<std::vector<double>>()).middle; }

std::string in_ms(const Json& seconds) { return rounded(1e3 * seconds.get<double>(), 3) + " ms"; }

struct Pair {
  const char *ours, *theirs, *words;
  double aim;
};

constexpr Pair pairs[] = {
    {"furrow, PECE", "LAMMPS, fix bond/break", "PECE, two evaluations, against LAMMPS with fix bond/break", 1.3},
    {"furrow, PECE", "LAMMPS, nothing tears", "PECE, two evaluations, against LAMMPS where nothing tears", 0.9},
    {"furrow, symplectic Euler", "LAMMPS, fix bond/break", "symplectic Euler, one, against LAMMPS with fix bond/break",
     2.2},
    {"furrow, symplectic Euler", "LAMMPS, nothing tears", "symplectic Euler, one, against LAMMPS where nothing tears",
     1.4}};

void add_agreement(Report& report, const Json& compared) {
  const Json& early = compared.at("early");
  std::vector<std::vector<Json>> rows;
  std::string coarse, fine;
  for (const Json& part : early.at("parts")) {
    if (!part.contains("steps")) continue;  // no force in either
    coarse = in_ms(part.at("steps").front().at("step"));
    fine = in_ms(part.at("steps").back().at("step"));
    rows.push_back({part.at("part"), part.at("greatest"), part.at("steps").front().at("error"),
                    part.at("steps").back().at("error"), part.value("order", Json())});
  }
  const Json& links = compared.at("links");
  report.table("Error of the force over its greatest value up to " + rounded(early.at("until").get<double>(), 2) +
                   " s, against furrow's rk4 at " + in_ms(early.at("step")) + ". Links torn until then: LAMMPS " +
                   links.at("engine_early").dump() + ", furrow " + links.at("early").dump() +
                   "; in all: " + links.at("engine").dump() + " and " + links.at("furrow").dump() + " of " +
                   links.at("compared").dump() + ", of which " + links.at("both").dump() + " by both",
               {"on", "greatest [N]", "error at " + coarse, "error at " + fine, "order"}, rows);
}

// What is another law there, as the deck says.
std::string other_laws(const Json& compared) {
  std::string words;
  for (const Json& one : compared.at("deviations"))
    words +=
        (words.empty() ? "" : "; ") + one.at("text").get<std::string>() + " (" + one.at("key").get<std::string>() + ")";
  return words;
}

}  // namespace

void add_bonds(Report& report, const Numbers& numbers) {
  report.heading("The first scene on LAMMPS's bonds");
  const Json all = measured(numbers, "rivals_bonds.json");
  if (all.is_null() || !all.contains("engine"))
    return not_measured(report, "scene 1 on LAMMPS's bonds", "scripts/rivals");
  report.text(
      "Scene 1 has a plate and a lattice alone. `furrow export` makes bonds of its links, torn by fix bond/break. The "
      "dampers of links, which LAMMPS does not have, are left out on both sides, and furrow takes LAMMPS's rule after "
      "a "
      "slip. Another law there: " +
      other_laws(all.at("compared")) +
      ". So nothing is judged; what can be compared is the force until the first tear. " +
      all.at("engine").get<std::string>() + ", on " + all.at("context").at("made_by").at("machine").get<std::string>() +
      ".");
  add_agreement(report, all.at("compared"));
  const Json& times = all.at("us_a_step");
  std::vector<std::vector<Json>> rows;
  for (const Pair& pair : pairs) {
    const benchmarks::Interval ratio = over(times.at(pair.theirs), times.at(pair.ours));
    rows.push_back({pair.words, median(times.at(pair.ours)), median(times.at(pair.theirs)),
                    spread({ratio.low, ratio.middle, ratio.high}), pair.aim});
    report.claim({.text = std::string("Scene 1: CPU time of LAMMPS over furrow's, the low end of its interval, ") +
                          pair.words + ".",
                  .value = rounded(ratio.low, 3) + " times",
                  .aim = "at least " + rounded(pair.aim, 2),
                  .holds = ratio.low >= pair.aim,
                  .timed = true,
                  .numbers = {"rivals_bonds.json"}});
  }
  report.table("CPU time of a step in turn, without rows of output: medians of " +
                   std::to_string(times.begin()->size()) +
                   " rounds; the ratio round by round, median and its 95 % interval",
               {"furrow against LAMMPS", "furrow [µs]", "LAMMPS [µs]", "ratio", "aim"}, rows);
}

}  // namespace furrow::validation
