#include "validation/page/chapters/convergence_headline.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "validation/studies/members.h"

namespace furrow::validation {
namespace {

// Shares of the force at the finest step.
Json shares_of(const std::vector<ConvergedForce>& found) {
  Json blocks = Json::object();
  for (const ConvergedForce& f : found) {
    Json rows = Json::array();
    for (const Json& row : f.by_step) rows.push_back({row[0], row[1].get<double>() / f.finest});
    blocks["shares_" + f.c.scene.substr(9) + "_" + to_string(f.c.reading)] = rows;
  }
  return blocks;
}

Figure figure_of(const std::vector<ConvergedForce>& found, const std::string& finest_step) {
  double most = 0;
  for (const ConvergedForce& f : found) most = std::fmax(most, f.at_papers / f.finest);
  return {.name = "finding",
          .script = "finding.gp",
          .caption = "Largest force on the plate, of that at " + finest_step + ", against the time step.",
          .description =
              "Largest force against the time step, of that at the finest: near 1 for discs at every step up "
              "to the paper's, up to " +
              rounded(most) + " times for spheres at the paper's step",
          .blocks = shares_of(found)};
}

// "51 to 84 N": at the finer steps that make no energy to speak of.
std::string with_finer_steps(const ConvergedForce& f) {
  if (f.sound.empty()) return "no number that is the model's";
  const auto [least, most] = std::minmax_element(f.sound.begin(), f.sound.end());
  return rounded(*least) + " to " + rounded(*most) + " N";
}

}  // namespace

std::string rounded(double force) {
  return force >= 100 ? std::to_string(std::lround(force)) : number(std::round(10 * force) / 10);
}

void add_headline(Report& report, const std::vector<ConvergedForce>& found, std::pair<int, int> settled,
                  const std::string& finest_step) {
  double most = 0, made = 0, made_least = infinity;  // of the discs; of the spheres
  std::string spheres;
  bool settles = false;  // one of the spheres' forces
  for (const ConvergedForce& f : found) {
    if (f.c.scene == "scenario_1" || !std::isfinite(f.off())) continue;
    if (f.c.reading == Reading::disc) {
      most = std::max(most, f.off());
      made = std::max(made, f.made);
    } else {
      made_least = std::min(made_least, f.made);
      settles = settles || f.settles;
      spheres += (spheres.empty() ? "" : " and ") + with_finer_steps(f) + " instead of " + rounded(f.at_papers) + " N";
    }
  }
  const auto whole = [](double value) { return std::to_string(std::lround(value)); };
  report.headline(
      {.tile = "finding",
       .value = "If a particle is a disc 1 m deep, the largest forces at the paper's time step of 0.1 ms are off by no "
                "more than " +
                whole(100 * most) + " %, though the method makes up to " + whole(100 * made) +
                " % of all the energy there.",
       .text = "If it is a sphere, and the paper does not say which, that step makes them, and " +
               three_digits(made_least) +
               " times that energy or more; finer ones that make less than all of it, down to " + finest_step +
               ", give " + spheres + (settles ? "" : ", and none settles them") + ". Of " +
               std::to_string(settled.second) + " numbers in all, " + std::to_string(settled.first) +
               " do not depend on the paper's step."});
  report.first_figure(figure_of(found, finest_step));
}

}  // namespace furrow::validation
