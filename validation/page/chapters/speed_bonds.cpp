// The paper's first scene, which has no soil, on LAMMPS's bonds. Measured by benchmarks/rivals/bonds.py.
#include <algorithm>
#include <vector>

#include "validation/page/chapters/speed_parts.h"

namespace furrow::validation {
namespace {

double median(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return (all.at((all.size() - 1) / 2) + all.at(all.size() / 2)) / 2;
}

// Times of LAMMPS over those of furrow, round by round: least, median, most.
Json ratios(const Json& theirs, const Json& ours) {
  std::vector<double> all;
  for (std::size_t k = 0; k < theirs.size(); ++k) all.push_back(theirs[k].get<double>() / ours.at(k).get<double>());
  return {*std::min_element(all.begin(), all.end()), median(all), *std::max_element(all.begin(), all.end())};
}

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
  for (const Json& part : early.at("parts")) {
    if (!part.contains("steps")) continue;  // no force in either
    rows.push_back({part.at("part"), part.at("greatest"), part.at("steps").front().at("error"),
                    part.at("steps").back().at("error"), part.value("order", Json())});
  }
  const Json& links = compared.at("links");
  report.table("Error of the force over its greatest value up to " + rounded(early.at("until").get<double>(), 2) +
                   " s, against furrow's rk4 at 0.01 ms. Links torn until then: LAMMPS " +
                   links.at("engine_early").dump() + ", furrow " + links.at("early").dump() +
                   "; in all: " + links.at("engine").dump() + " and " + links.at("furrow").dump() + " of " +
                   links.at("compared").dump() + ", of which " + links.at("both").dump() + " by both",
               {"on", "greatest [N]", "error at 0.1 ms", "error at 0.01 ms", "order"}, rows);
}

}  // namespace

void add_bonds(Report& report, const Numbers& numbers) {
  report.heading("The first scene on LAMMPS's bonds");
  const Json all = measured(numbers, "rivals_bonds.json");
  if (all.is_null() || !all.contains("engine"))
    return not_measured(report, "scene 1 on LAMMPS's bonds", "scripts/rivals");
  report.text(
      "Scene 1 has a plate and a lattice alone. `furrow export` makes bonds of its links, torn by fix bond/break. What "
      "LAMMPS does not have is left out on both sides, the dampers of links, or is another law, the rule after a slip "
      "and the corners of the plate, which are round there. So nothing is judged; what can be compared is the force "
      "until "
      "the first tear. " +
      all.at("engine").get<std::string>() + ", on " + all.at("context").at("made_by").at("machine").get<std::string>() +
      ".");
  add_agreement(report, all.at("compared"));
  const Json& times = all.at("us_a_step");
  std::vector<std::vector<Json>> rows;
  for (const Pair& pair : pairs) {
    const Json ratio = ratios(times.at(pair.theirs), times.at(pair.ours));
    rows.push_back({pair.words, median(times.at(pair.ours).get<std::vector<double>>()),
                    median(times.at(pair.theirs).get<std::vector<double>>()), spread(ratio), pair.aim});
    if (std::string(pair.ours) == "furrow, PECE")
      report.claim({.text = std::string("Scene 1: CPU time of LAMMPS over furrow's, ") + pair.words + ".",
                    .value = rounded(ratio[1].get<double>(), 3) + " times",
                    .aim = "at least " + rounded(pair.aim, 2),
                    .holds = ratio[1].get<double>() >= pair.aim,
                    .timed = true,
                    .numbers = {"rivals_bonds.json"}});
  }
  report.table(
      "CPU time of a step in turn, without rows of output: medians, and the ratio round by round, median with the "
      "least and the greatest of " +
          std::to_string(times.begin()->size()) + " rounds",
      {"furrow against LAMMPS", "furrow [µs]", "LAMMPS [µs]", "ratio", "aim"}, rows);
}

}  // namespace furrow::validation
