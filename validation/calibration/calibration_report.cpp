// A calibration in words, tables and figures.
#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "validation/calibration/calibration.h"

namespace furrow::validation {
namespace {

std::string digits(double value) { return std::isfinite(value) ? rounded(value, 3) : "–"; }

std::string with_error(double value, double error) {
  return digits(value) + (std::isfinite(error) ? " ± " + digits(error) : "");
}

std::string misfit_text(const Point& point) { return with_error(point.misfit(), point.spread()); }

// Mean over the packings of what stands for a target's value, or its words.
std::string value_text(const Point& point, std::size_t k) {
  if (point.values[0][k].is_string()) return point.values[0][k];
  double sum = 0;
  for (const Json& values : point.values) sum += number_of(values[k]);
  return digits(sum / static_cast<double>(point.values.size()));
}

double misfit_of(const Calibration& c, const Point& point, std::size_t k) {
  double sum = 0;
  for (const Json& values : point.values) sum += misfit(c.targets.all[k], values[k], c.targets.missing);
  return sum / static_cast<double>(point.values.size());
}

std::string wanted(const CalibrationTarget& t) {
  if (t.curve) return t.curve->file + ", " + t.curve->component;
  if (t.relation == Relation::says) return t.words;
  if (t.relation == Relation::between) return digits(t.value[0]) + " to " + digits(t.value[1]);
  const char* word = t.relation == Relation::below ? "below " : t.relation == Relation::above ? "above " : "";
  return word + digits(t.value[0]);
}

void add_best(Report& report, const Calibration& c) {
  std::vector<std::string> head;
  for (const VariedKey& key : c.keys) head.push_back(key.name);
  head.insert(head.end(), {"misfit in the search", "misfit, packings not searched"});
  std::vector<std::vector<Json>> rows;
  for (const Candidate& candidate : c.best) {
    std::vector<Json> row(candidate.searched.setting.begin(), candidate.searched.setting.end());
    row.insert(row.end(), {misfit_text(candidate.searched), misfit_text(candidate.fresh)});
    rows.push_back(std::move(row));
  }
  report.heading("Best settings");
  report.table(
      "Settings that differ by more than a fiftieth of a range in some key. Misfit: root of the weighted mean " +
          std::string(c.targets.bounded ? "of r^2 / (1 + r^2), " : "of r^2, ") +
          "r in tolerances; ± its standard deviation over packings.",
      head, rows);
}

void add_targets(Report& report, const Calibration& c) {
  const Point& best = c.best.front().fresh;
  std::vector<std::vector<Json>> rows;
  int met = 0;
  for (std::size_t k = 0; k < c.targets.all.size(); ++k) {
    const CalibrationTarget& t = c.targets.all[k];
    const double off = misfit_of(c, best, k);
    const bool said = std::all_of(best.values.begin(), best.values.end(),
                                  [&](const Json& values) { return comparable(t, values[k]); });
    const bool within = said && (t.relation == Relation::says ? off == 0 : off <= 1);
    met += within ? 1 : 0;
    rows.push_back({t.name, t.scene, wanted(t), value_text(best, k),
                    t.relation == Relation::says ? "–" : digits(t.tolerance), digits(off), within ? "yes" : "no"});
  }
  report.heading("What the best setting gives");
  report.table("Mean over packings; of a curve the mean force at the measured points.",
               {"target", "scene", "wanted", "ours", "tolerance", "misfit, in tolerances", "within"}, rows);
  report.claim({.text = "Targets that the best setting meets within their tolerances.",
                .value = std::to_string(met) + " of " + std::to_string(rows.size()),
                .aim = "all",
                .holds = met == static_cast<int>(rows.size())});
}

void add_curves(Report& report, const Calibration& c) {
  for (std::size_t k = 0; k < c.targets.all.size(); ++k) {
    const CalibrationTarget& t = c.targets.all[k];
    const Json& ours = c.best.front().fresh.values[0][k];
    if (!t.curve || !ours.is_array()) continue;
    Json measured = Json::array(), best = Json::array();
    for (std::size_t i = 0; i < t.curve->mm.size(); ++i) {
      measured.push_back({t.curve->mm[i], t.curve->force[i]});
      best.push_back({t.curve->mm[i], ours[i]});
    }
    report.figure({.name = "calibration_" + std::to_string(k),
                   .script = "calibration.gp",
                   .caption = t.name + ": the measured curve, and the best setting.",
                   .description = "Force against displacement, measured and calibrated.",
                   .variables = {{"component", t.curve->component}},
                   .blocks = {{"measured", measured}, {"best", best}}});
  }
}

void add_known(Report& report, const Calibration& c) {
  const Identified& found = c.identified;
  report.heading("How well each key is known");
  if (c.best.front().fresh.misfit() > 2)
    report.text(
        "The best setting misses by more than twice the tolerances: the scene cannot follow what was measured, and "
        "the intervals are those of its best compromise, not of the truth.");
  if (!found.why_not.empty()) report.text("No intervals: " + found.why_not + ".");
  std::vector<std::vector<Json>> rows;
  for (const Known& k : found.known) rows.push_back({k.key, k.value, interval_of(k), k.at_edge ? at_the_edge : ""});
  if (!rows.empty())
    report.table(
        "95 % intervals by the linear theory of least squares, errors independent and at least as large as the "
        "tolerances; not identifiable: longer than the range; not a minimum yet: the step that the slopes ask for is "
        "longer than an interval.",
        {"key", "best", "95 % interval", "note"}, rows);
  for (const Flat& flat : found.flat) {
    std::string text;
    for (std::size_t k = 0; k < flat.direction.size(); ++k) {
      if (std::fabs(flat.direction[k]) < 0.1) continue;
      text += (text.empty() ? "" : ", ") + rounded(flat.direction[k], 2) + " of the range of " + found.ranged[k];
    }
    report.text("Flat direction: together by " + text + ". As far along it as the ranges allow the misfit is " +
                digits(flat.backward) + " and " + digits(flat.forward) + ", at the best " + digits(flat.misfit) + ".");
  }
  const bool all_arrived =
      std::all_of(found.known.begin(), found.known.end(), [](const Known& known) { return known.arrived; });
  if (!all_arrived)
    report.text(
        "The search has not arrived at a minimum: how well the keys are known is not said. Calibrate with more "
        "--points.");
  if (found.flat.empty() && !found.known.empty() && all_arrived)
    report.text("No direction is flat: every key is told from the others.");
}

// Bold would be typed words: an effect that is less than twice its standard error is marked by brackets.
void add_effects(Report& report, const Calibration& c) {
  std::vector<std::string> head{"key", "change"};
  for (const CalibrationTarget& target : c.targets.all) head.push_back(target.name);
  head.emplace_back("misfit");
  std::vector<std::vector<Json>> rows;
  for (const Effect& effect : c.identified.effects) {
    std::vector<Json> row{effect.key, effect.change};
    for (std::size_t k = 0; k < effect.effect.size(); ++k) {
      const bool noise = std::isfinite(effect.error[k]) && std::fabs(effect.effect[k]) < 2 * effect.error[k];
      const std::string text = with_error(effect.effect[k], effect.error[k]);
      row.emplace_back(noise ? "(" + text + ")" : text);
    }
    row.emplace_back(digits(effect.misfit));
    rows.push_back(std::move(row));
  }
  report.heading("Which key moves what");
  report.table(
      "Change of each target's value when one key goes up by a tenth of its range, the others at their best, or "
      "takes another listed value; ± standard error over packings, in brackets what is less than twice that.",
      head, rows);
}

}  // namespace

Report report_of(const Calibration& c) {
  Report report("Calibration: " + c.targets.title, "Which settings of the scenes come closest to what was measured?");
  std::string scenes;
  for (const Case& of : c.cases) scenes += (scenes.empty() ? "" : ", ") + of.name;
  report.text(std::to_string(c.points) + " settings of " + scenes + " were tried, of which " +
              std::to_string(c.failed) + " did not run to their valid end.");
  add_best(report, c);
  add_targets(report, c);
  add_curves(report, c);
  add_known(report, c);
  add_effects(report, c);
  return report;
}

}  // namespace furrow::validation
