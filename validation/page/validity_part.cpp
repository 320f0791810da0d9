#include "validation/page/validity_part.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/page/gnuplot.h"
#include "validation/page/html.h"
#include "validation/page/names.h"
#include "validation/page/run_words.h"

namespace furrow::validation {
namespace {

std::string in_words(const std::string& name) {
  static const std::map<std::string, std::string> words{
      {"energy_made", "energy that the method or a law made, of all that the scene was given"},
      {"energy_lost", "energy that it lost, of the same"},
      {"overlap", "greatest overlap, of the smaller radius"},
      {"behind_walls", "discs whose centres are behind a wall, at once"},
      {"through_plates", "centres that crossed the middle of a plate"},
      {"through_lattices", "centres that crossed the border of a lattice"},
      {"crossing_lattices",
       "pairs of border segments of lattices that cross, and cells that are inside out or folded over"},
      {"impact", "energy of a contact, of what carries the one through the other"},
      {"step", "step, of the largest stable one at the contacts that are there"},
      {"arrival", "step, of the largest stable one in an impact that may come"}};
  const auto found = words.find(name);
  return found == words.end() ? escaped(name) : found->second;
}

// What is a share of all the energy that the scene was given stands in percent, as everywhere on the page.
std::string amount(const WatchedFact& w, double value) {
  return w.name.starts_with("energy_") ? with_unit(100 * value, "%") : shown(value);
}

// Infinity stands for no limit.
std::string limit(const WatchedFact& w, double value) { return std::isinf(value) ? "–" : amount(w, value); }

std::string allowance(const WatchedFact& w) {
  if (!w.allowed) return "–";
  return std::isinf(*w.allowed) ? "any" : amount(w, *w.allowed);
}

std::string at_the_worst(const WatchedFact& w) {
  if (!(w.worst > 0)) return {};
  return with_unit(w.time, "s") + (w.where.empty() ? "" : element("small", typeset(escaped(w.where))));
}

std::string row_of(const WatchedFact& w) {
  if (std::isnan(w.time))
    return element("tr", element("td", in_words(w.name)) + element("td", chip_or_words(w.verdict)));
  std::string cells = element("td", in_words(w.name)) + element("td", chip_or_words(w.verdict));
  for (const std::string& cell : {amount(w, w.worst), limit(w, w.warns_above), limit(w, w.ends_above), allowance(w)})
    cells += element("td", cell, "number");
  return element("tr", cells + element("td", at_the_worst(w)));
}

std::string sentence(const std::string& verdict) {
  if (verdict == "kept") return "It keeps to all of it.";
  if (verdict == "allowed") return "It goes beyond, as its scene file allows.";
  if (verdict == "warned") return "It goes beyond what its scene file allows, and warns.";
  return "It goes beyond what any run may, and ends there.";
}

double worst_of(const RunRecord& run, const std::string& name) {
  const WatchedFact* watch = watch_of(run, name);
  return watch ? watch->worst : std::nan("");
}

// What becomes of a disc that is pressed into a plate.
std::string faces(const RunRecord& run) {
  if (std::isnan(worst_of(run, "through_plates")) || run.scene.plate.empty()) return {};
  return run.scene.model.tight_plates.value_or(false)
             ? " A disc that is pressed into a plate, however deep, is pushed back to the face on which it met it."
             : " A disc whose centre is pressed beyond the middle of a plate is pushed out behind it.";
}

}  // namespace

std::string validity_part(const RunRecord& run, Page& page) {
  if (run.watched.empty()) return element("p", "Validity of the laws: " + missing);
  std::string rows;
  for (const WatchedFact& w : run.watched) rows += row_of(w);
  return framed({page.id(run.name + " validity"),
                 "What this run does to the validity of its laws. " + sentence(run.validity) + faces(run),
                 escaped(capital(scene_words(run.name))) + ", validity", "study",
                 head_cell("Watched") + head_cell("Verdict") + head_cell("Measured", true) +
                     head_cell("Warns above", true) + head_cell("Ends the run above", true) +
                     head_cell("The scene allows", true) + head_cell("At the worst"),
                 rows});
}

std::string validity_table(const std::vector<RunRecord>& runs) {
  std::string table =
      "| scene | centres through the plate | through a lattice's border | behind a wall | greatest overlap, of R | "
      "energy made, of what was given | step, of the largest stable one | verdict "
      "|\n|---|--:|--:|--:|--:|--:|--:|---|\n";
  for (const RunRecord& run : runs) {
    table += "| " + scene_words(run.name);
    for (const char* name : {"through_plates", "through_lattices", "behind_walls", "overlap", "energy_made", "step"})
      table += " | " + (name == std::string("energy_made") ? with_unit(100 * worst_of(run, name), "%")
                                                           : shown(worst_of(run, name)));
    table += " | " + (run.validity.empty() ? missing : run.validity) + " |\n";
  }
  return table;
}

}  // namespace furrow::validation
