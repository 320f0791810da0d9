#include "validation/page/tool_section.h"

#include <algorithm>
#include <cmath>

#include "validation/page/gnuplot.h"
#include "validation/page/html.h"
#include "validation/page/run_record.h"
#include "validation/page/template.h"

namespace furrow::validation {
namespace {

// Of the first driven nodes: mm, and N, its mean over a millimetre, since a curve of every sample is a band.
std::vector<PlotInput::Row> force_of(const OtherRun& tool, double which) {
  const Table drives(tool.directory / "drive_force.csv");
  const auto way = drives.numbers("displacement [m]"), f = drives.numbers("F [N]");
  const auto &lattice = drives.texts("lattice"), &drive = drives.texts("drive");
  std::vector<PlotInput::Row> rows;
  double sum = 0, count = 0, last = 0;  // last: mm
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (lattice[k] != lattice[0] || drive[k] != drive[0]) continue;
    const double mm = std::floor(1e3 * std::fabs(way[k]));
    if (mm != last && count > 0) {
      rows.push_back({{which, last + 0.5, sum / count}, ""});
      sum = count = 0;
    }
    sum += f[k], ++count, last = mm;
  }
  return rows;
}

std::string force_figure(const std::vector<OtherRun>& tools, Page& page) {
  std::vector<PlotInput::Row> rows, names;
  std::string said;
  for (std::size_t k = 0; k < tools.size(); ++k) {
    const auto one = force_of(tools[k], static_cast<double>(k));
    if (one.empty()) continue;
    rows.insert(rows.end(), one.begin(), one.end());
    names.push_back({{static_cast<double>(k)}, bare(tools[k].label)});
    const auto most =
        std::max_element(one.begin(), one.end(), [](const auto& a, const auto& b) { return a.first[2] < b.first[2]; });
    said += (said.empty() ? "" : ", ") + with_unit(most->first[2], "N") + " for " + tools[k].label;
  }
  if (rows.empty()) return {};
  PlotInput input;
  input.set("count", static_cast<double>(names.size())).block("force", rows).block("names", names);
  return framed(page, {page.id("figure tool force"),
                       "<div class=\"plot\">" +
                           drawn(input, "tool_force.gp", page.files, "tool_force",
                                 "Force on the driven nodes against their way: at most " + bare(said)) +
                           "</div>",
                       "Force on the driven nodes against their way, mean over every millimetre; at most " + said + ".",
                       "tool_force"});
}

}  // namespace

std::string tool_section(const std::vector<OtherRun>& tools, const std::vector<Film>& films, const std::string& number,
                         Page& page) {
  if (films.empty()) return {};
  return "<section id=\"tool\">\n" +
         heading(3, page.id("a tool that bends"), element("span", number, "section") + "A tool that bends") +
         element(
             "p",
             "The paper leaves a deformable tool to later. Here a lattice whose upper end is driven is drawn through "
             "the bed of scene 2; beside it the same lattice with all its nodes driven, which is rigid.") +
         player_element(films) + force_figure(tools, page) + "</section>\n";
}

}  // namespace furrow::validation
