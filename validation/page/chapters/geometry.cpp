// What geometry was it? Which setting of what the paper leaves open comes closest to its numbers of the first scene, and
// how near does any setting come to each of them alone?
#include "validation/studies/geometry.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/page/chapters/chapters.h"

namespace furrow::validation {
namespace {

struct Words {
  std::string quantity;
  std::string never;  // where it does not happen
};

const Words& words_of(const Target& target) {
  static const std::map<std::string, Words> all{
      {"first_impact", {"first impact [N]", ""}},
      {"free_flight_begins", {"free flight from [mm]", "not by the end"}},
      {"free_flight_ends", {"free flight to [mm]", "not by the end"}},
      {"second_contact_fx", {"second contact, Fx [N]", "no second contact"}},
      {"second_contact_fy", {"second contact, Fy [N]", "no second contact"}},
      {"first_structural_tear", {"first structural tear by [mm]", "not by the end"}},
      {"fixed_links_torn", {"all links to fixed nodes torn by [mm]", "not by the end"}}};
  return all.at(target.id);
}

// What a study of this form has kept.
Search search_in(const Numbers& numbers) {
  return search_geometry(numbers.quick(), [&](const std::vector<Batch>& batches) {
    std::vector<Json> results;
    for (const Batch& batch : batches) results.push_back(numbers.at(batch.key));
    return results;
  });
}

Json cell(const Tried& t, std::size_t target) {
  if (t.failed()) return "diverged";
  return std::isnan(t.numbers[target]) ? Json(words_of(targets()[target]).never) : Json(t.numbers[target]);
}

std::vector<Json> row_of(const std::string& name, const Tried& t) {
  std::vector<Json> row{name,
                        1e3 * t.setting.spacing,
                        1e3 * t.setting.depth,
                        1e3 * t.setting.contact_radius,
                        t.setting.full_damper ? "full" : "axial",
                        t.setting.magnitude ? "magnitude" : "tension"};
  for (std::size_t k = 0; k < targets().size(); ++k) row.emplace_back(cell(t, k));
  row.emplace_back(t.misfit);
  return row;
}

std::vector<std::string> headings() {
  std::vector<std::string> head{"setting", "spacing [mm]", "depth [mm]", "R* of a node [mm]", "damper", "tear rule"};
  for (const Target& target : targets()) head.emplace_back(words_of(target).quantity);
  head.emplace_back("misfit");
  return head;
}

std::vector<Json> row_of_the_paper() {
  std::vector<Json> row{"the paper", "not given",         "40, of scenes 2 and 3",
                        "not given", "in its text axial", "not said"};
  for (const Target& target : targets()) row.emplace_back(target.want);
  row.emplace_back(0);
  return row;
}

void add_best(Report& report, const Search& search) {
  std::vector<std::vector<Json>> rows{row_of_the_paper(), row_of("the scene file", search.own)};
  for (std::size_t k = 0; k < 5 && k < search.tried.size() && !search.tried[k].failed(); ++k)
    rows.push_back(row_of("best " + std::to_string(k + 1), search.tried[k]));
  report.table("The best settings beside the paper's numbers and today's scene file.", headings(), rows);
}

// For each target the setting that comes nearest to it alone, and what else it gives.
void add_single_targets(Report& report, const std::vector<Tried>& tried) {
  std::vector<std::vector<Json>> rows;
  for (std::size_t k = 0; k < targets().size(); ++k) {
    const auto best = std::min_element(tried.begin(), tried.end(), [&](const Tried& a, const Tried& b) {
      return std::pair(a.misfit_of(k), a.misfit) < std::pair(b.misfit_of(k), b.misfit);
    });
    const auto met = std::count_if(tried.begin(), tried.end(), [&](const Tried& t) { return t.misfit_of(k) <= 1; });
    rows.push_back({words_of(targets()[k]).quantity, targets()[k].want, cell(*best, k), best->misfit,
                    100 * static_cast<double>(met) / static_cast<double>(tried.size())});
  }
  report.table(
      "Each number of the paper alone: the nearest that any setting comes, the misfit of all numbers at that setting, "
      "and the share of all settings that come within a tenth of a force or 2 mm of a place.",
      {"number", "the paper", "nearest", "misfit there", "settings that meet it [%]"}, rows);
}

void add_figure(Report& report, const Search& search) {
  const Tried& own = search.own;
  Json points = Json::array();
  for (const Tried& t : search.tried) {
    if (!t.failed() && points.size() < 1500)
      points.push_back({1e3 * t.setting.spacing, t.setting.depth / t.setting.spacing, t.misfit});
  }
  report.figure(
      {.name = "geometry",
       .script = "geometry.gp",
       .caption = "Misfit of the settings tried, the best on top: " +
                  (points.empty() ? "" : "the least is " + std::to_string(search.tried[0].misfit).substr(0, 4)) +
                  ", that of the scene file " + std::to_string(own.misfit).substr(0, 4) + ".",
       .description = "Misfit against spacing and depth of the plate",
       .variables = {{"own_spacing", 1e3 * own.setting.spacing}, {"own_rows", own.setting.depth / own.setting.spacing}},
       .blocks = {{"settings", points}}});
}

bool meets_all(const Tried& t) {
  for (std::size_t k = 0; k < targets().size(); ++k) {
    if (!(t.misfit_of(k) <= 1)) return false;
  }
  return true;
}

}  // namespace

Report geometry(const Shelf& shelf) {
  const Search search = search_in(shelf.of("geometry"));
  const std::vector<Tried>& tried = search.tried;
  Report report(
      "What geometry was scene 1?",
      "The paper gives neither the spacing of its lattice, nor the height of the plate, nor the radius in the "
      "contact of node and plate. Which setting comes closest to what it reports of its first scene, scene 1?");
  const auto failed = std::count_if(tried.begin(), tried.end(), [](const Tried& t) { return t.failed(); });
  report.text(
      std::to_string(tried.size()) + " settings were tried, " + std::to_string(failed) +
      " of them diverged. The misfit is the root mean square of the seven differences, a tenth of a force or 2 mm of a "
      "place counting as one, and at most five.");
  add_best(report, search);
  add_single_targets(report, tried);
  add_figure(report, search);
  const auto met = std::count_if(tried.begin(), tried.end(), meets_all);
  report.claim(
      {.text = "No setting tried meets all of the paper's numbers for scene 1 within a tenth of a force and 2 mm.",
       .value = std::to_string(met) + " of " + std::to_string(tried.size()) + " settings",
       .aim = "none",
       .holds = met == 0});
  return report;
}

}  // namespace furrow::validation
