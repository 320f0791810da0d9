#include "validation/page/report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "output/files.h"
#include "report/embedded.h"
#include "validation/page/gnuplot.h"
#include "validation/page/html.h"
#include "validation/page/observables.h"
#include "validation/page/scene_section.h"
#include "validation/page/studies.h"
#include "validation/page/template.h"
#include "validation/page/validity_part.h"
#include "validation/page/verification.h"

namespace furrow::validation {
namespace {

// run.json of all runs, one row a fact; what all runs share fills one cell.
std::string how_made(const std::vector<RunRecord>& runs) {
  const std::map<std::string, std::string> labels{{"step", "step [s]"},
                                                  {"end", "end [s]"},
                                                  {"ended_at", "ended at [s]"},
                                                  {"settling_time", "settling time [s]"},
                                                  {"settling_cpu_seconds", "settling, CPU time [s]"},
                                                  {"surface", "height of the settled bed [m]"},
                                                  {"state_size", "numbers in the state"},
                                                  {"rhs_evaluations", "evaluations of the right-hand side"},
                                                  {"rejected", "rejected steps"},
                                                  {"cpu_seconds", "CPU time [s]"},
                                                  {"wall_seconds", "wall-clock time [s]"},
                                                  {"greatest_relative_overlap", "greatest overlap, of a radius"},
                                                  {"greatest_overlap_between", "where that is"},
                                                  {"plate_meets_lattice", "plate meets lattice [s]"}};
  if (runs.empty()) return {};
  const auto fewer = [](const RunRecord& a, const RunRecord& b) { return a.facts.size() < b.facts.size(); };
  std::string rows = "<tr><th></th>";
  for (const RunRecord& run : runs) rows += element("th", escaped(run.name));
  rows = element("thead", rows + "</tr>");
  for (const Fact& fact : std::max_element(runs.begin(), runs.end(), fewer)->facts) {
    const std::string& key = fact.key;
    if (key == "title" || key == "warnings") continue;
    std::vector<std::string> cells;
    for (const RunRecord& run : runs) cells.push_back(fact_shown(run, key));
    if (key == "scene") {
      for (std::string& cell : cells) cell = std::filesystem::path(cell).filename().string();
    }
    std::string label = key, row;
    std::replace(label.begin(), label.end(), '_', ' ');
    const bool shared = std::count(cells.begin(), cells.end(), cells[0]) == static_cast<long>(cells.size());
    if (shared) row = "<td colspan=\"" + std::to_string(cells.size()) + "\">" + cells[0] + "</td>";
    for (std::size_t k = 0; k < cells.size() && !shared; ++k) row += element("td", cells[k]);
    rows += element("tr", element("th", labels.contains(key) ? labels.at(key) : escaped(label)) + row);
  }
  return rows;
}

// N, of all steps, where run.json says it.
double largest_force(const RunRecord& run) {
  return run.largest_force.empty() ? measure(run, "largest_force").value : run.largest_force.front().f;
}

// The runs in a table for a page in Markdown.
std::string scene_table(const std::vector<RunRecord>& runs) {
  std::string table =
      "| scene | steps | evaluations | CPU [s] | largest force [N] | links torn | energy residual, of the plate's work "
      "| state hash |\n|---|--:|--:|--:|--:|--:|--:|---|\n";
  for (const RunRecord& run : runs) {
    const auto last = [&](const char* column) {
      return run.energy.rows() > 0 ? run.energy.numbers(column).back() : NAN;
    };
    table += "| " + run.name + (run.finished() ? "" : " (" + fact_shown(run, "ended") + ")") + " | " +
             fact_shown(run, "steps") + " | " + fact_shown(run, "rhs_evaluations") + " | " +
             fact_shown(run, "cpu_seconds") + " | " + shown(largest_force(run)) + " | " +
             std::to_string(run.torn.size()) + " | " + shown(100 * last("residual [J]") / last("plate work [J]")) +
             " % | `" + fact_shown(run, "state_hash") + "` |\n";
  }
  return table;
}

std::string missing_part(const Evidence& evidence) {
  std::string lines;
  for (const std::string& why : missing_evidence(evidence)) lines += element("li", escaped(why));
  return lines.empty() ? lines
                       : element("section", element("h2", "What is missing here") + element("ul", lines, "missing"));
}

}  // namespace

std::vector<std::string> page_files() { return {"index.html", "scenes.md"}; }

void write_report(OwnedDirectory& directory, const std::vector<ReportedRun>& reported, const Evidence& evidence) {
  const Publication paper = read_publication(embedded("validation/statements.toml"));
  std::vector<RunRecord> runs;
  for (const ReportedRun& r : reported) runs.push_back(read_run(r.name, r.directory));
  Drawings files;
  std::string contents, scenes;
  for (const RunRecord& run : runs) {
    contents +=
        element("li", "<a href=\"#" + run.name + "\">" + escaped(run.scene.title) + "</a>" +
                          (run.finished() ? "" : ": " + element("strong", fact_shown(run, "ended"), "missing")));
    scenes += scene_section(run, paper, files);
  }
  const StudyPlace before = StudyPlace::before_scenes, after = StudyPlace::after_scenes;
  files["index.html"] = filled(figure_file("page.html"),
                               {{"style", figure_file("page.css")},
                                {"paper", escaped(paper.title)},
                                {"contents", contents},
                                {"scenes", scenes},
                                {"first_contents", study_contents(evidence, before)},
                                {"first_study", missing_part(evidence) + study_sections(evidence, before, files)},
                                {"study_contents", study_contents(evidence, after)},
                                {"studies", study_sections(evidence, after, files)},
                                {"verification", verification_section(evidence)},
                                {"made", how_made(runs)}});
  files["scenes.md"] = scene_table(runs) + "\nWhat they do to the validity of their laws:\n\n" + validity_table(runs);
  std::vector<std::string> names;
  for (const auto& [name, text] : files) names.push_back(name);
  directory.add(names);
  for (const auto& [name, text] : files) {
    OutputFile file(directory.path() / name);
    file << text;
    file.finish();
  }
}

}  // namespace furrow::validation
