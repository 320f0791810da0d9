#include "validation/page/runs_table.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "validation/page/html.h"
#include "validation/page/names.h"
#include "validation/page/scene_section.h"

namespace furrow::validation {
namespace {

// In the order of the table; run.json has more: hashes of all files, the largest forces, the watches of the validity.
constexpr std::array<std::pair<const char*, const char*>, 29> shown_facts{
    {{"scene", "scene file"},
     {"method", "method"},
     {"step", "step [ms]"},
     {"end", "end [s]"},
     {"seed", "seed"},
     {"discs", "discs"},
     {"nodes", "nodes of lattices"},
     {"links", "links of lattices"},
     {"settling_time", "settling time [s]"},
     {"settling_steps", "steps of the settling"},
     {"settling_cpu_seconds", "settling, CPU time [s]"},
     {"surface", "height of the settled bed [m]"},
     {"state_size", "numbers in the state"},
     {"steps", "steps"},
     {"rhs_evaluations", "evaluations of the right-hand side"},
     {"rejected", "rejected steps"},
     {"cpu_seconds", "CPU time [s]"},
     {"wall_seconds", "wall-clock time [s]"},
     {"greatest_relative_overlap", "greatest overlap, of a radius"},
     {"greatest_overlap_between", "where that is"},
     {"greatest_speed", "greatest speed [m/s]"},
     {"plate_meets_lattice", "plate meets lattice [s]"},
     {"ended", "ended"},
     {"ended_at", "ended at [s]"},
     {"commit", "commit"},
     {"compiler", "compiler"},
     {"flags", "flags"},
     {"machine", "machine"},
     {"state_hash", "hash of the final state"}}};

std::string cell_of(const RunRecord& run, const std::string& key) {
  const std::string cell = run.fact(key) ? fact_shown(run, key) : "–";
  if (key == "step" && run.fact(key)) return shown(1e3 * std::strtod(run.fact(key)->texts.at(0).c_str(), nullptr));
  if (cell.find_first_not_of("0123456789") == std::string::npos) return in_groups(cell);
  return key == "scene" ? std::filesystem::path(cell).filename().string() : cell;
}

}  // namespace

std::string runs_table(const std::vector<RunRecord>& runs, const std::vector<std::string>& records, Page& page) {
  if (runs.empty()) return {};
  std::string head = head_cell("fact"), rows, links;
  for (const RunRecord& run : runs) head += head_cell(escaped(scene_words(run.name)));
  for (const auto& fact : shown_facts) {
    const std::string key = fact.first, label = fact.second;
    const auto has = [&](const RunRecord& run) { return run.fact(key) != nullptr; };
    if (std::none_of(runs.begin(), runs.end(), has)) continue;
    std::vector<std::string> cells;
    for (const RunRecord& run : runs) cells.push_back(cell_of(run, key));
    std::string row;
    const bool shared = std::count(cells.begin(), cells.end(), cells[0]) == static_cast<long>(cells.size());
    if (shared) row = "<td colspan=\"" + std::to_string(cells.size()) + "\">" + cells[0] + "</td>";
    for (std::size_t k = 0; k < cells.size() && !shared; ++k) row += element("td", cells[k]);
    rows += element("tr", "<th scope=\"row\">" + label + "</th>" + row);
  }
  if (std::any_of(records.begin(), records.end(), [](const std::string& link) { return !link.empty(); })) {
    for (const std::string& link : records)
      links += element("td", link.empty() ? "–" : "<a href=\"" + escaped(link) + "\">run.json</a>");
    rows += element("tr", "<th scope=\"row\">all that is recorded</th>" + links);
  }
  return framed({page.id("table runs"), "The runs of this page. Hashes of all their files are in run.json.", "The runs",
                 "made plain", head, rows});
}

std::string link_to_record(const std::filesystem::path& page, const std::filesystem::path& run) {
  if (!std::filesystem::exists(run / "run.json")) return {};
  const std::filesystem::path link =
      std::filesystem::absolute(run / "run.json").lexically_relative(std::filesystem::absolute(page));
  return link.empty() || *link.begin() == ".." ? "" : link.generic_string();
}

}  // namespace furrow::validation
