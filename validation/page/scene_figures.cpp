#include "validation/page/scene_figures.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "validation/page/html.h"
#include "validation/page/observables.h"
#include "validation/page/run_words.h"
#include "validation/page/template.h"

namespace furrow::validation {
namespace {

std::string plot(const std::string& svg) { return "<div class=\"plot\">" + svg + "</div>"; }

// ---- overlaps ----

// Of discs with discs and walls, of the (smaller) radius.
std::vector<double> overlaps_of(const Frame& frame, const std::vector<Wall>& walls) {
  const auto x = frame.discs.numbers("x [m]"), y = frame.discs.numbers("y [m]"), r = frame.discs.numbers("radius [m]");
  std::vector<double> all;
  const auto add = [&](double overlap, double radius) {
    if (overlap > 0) all.push_back(overlap / radius);
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) add(r[i] + r[j] - std::hypot(x[i] - x[j], y[i] - y[j]), std::min(r[i], r[j]));
    for (const Wall& w : walls) {
      const double length = std::hypot(w.normal.x, w.normal.y);
      add(r[i] - ((x[i] - w.point.x) * w.normal.x + (y[i] - w.point.y) * w.normal.y) / length, r[i]);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

constexpr double bin = 0.05;  // of a radius

std::vector<PlotInput::Row> histogram(const std::vector<double>& overlaps) {
  std::vector<PlotInput::Row> rows;
  for (int k = 0; k * bin < 2; ++k) {
    const auto from = std::lower_bound(overlaps.begin(), overlaps.end(), k * bin),
               to = std::lower_bound(overlaps.begin(), overlaps.end(), (k + 1) * bin);
    rows.push_back({{k * bin, 100 * static_cast<double>(to - from) / static_cast<double>(overlaps.size())}, ""});
  }
  return rows;
}

// ---- by step ----

constexpr double stretch = 10;  // mm

// Root mean square of the difference in each stretch; b is read where a has its rows.
std::vector<PlotInput::Row> differences(const ForceCurve& a, const ForceCurve& b, double which) {
  std::vector<PlotInput::Row> rows;
  double sum = 0, count = 0;
  std::size_t k = 0;
  const auto close = [&](double end) {
    if (count > 0 && sum > 0) rows.push_back({{which, end - stretch / 2, std::sqrt(sum / count)}, ""});
    sum = count = 0;
  };
  double end = stretch;
  for (std::size_t i = 0; i < a.mm.size(); ++i) {
    while (k + 1 < b.mm.size() && std::fabs(b.mm[k + 1] - a.mm[i]) <= std::fabs(b.mm[k] - a.mm[i])) ++k;
    if (a.mm[i] > end) close(end), end += stretch;
    if (k < b.mm.size()) sum += std::pow(std::hypot(a.fx[i] - b.fx[k], a.fy[i] - b.fy[k]), 2), ++count;
  }
  close(end);
  return rows;
}

std::string step_name(double step) { return with_unit(1e3 * step, "ms"); }

// ---- tears ----

std::string place_of(const Parts& parts, int node) {
  return "row " + std::to_string(parts.node.row[node]) + ", column " + std::to_string(parts.node.column[node]);
}

double force_near(const ForceCurve& curve, double mm) {
  const auto at = std::lower_bound(curve.mm.begin(), curve.mm.end(), mm) - curve.mm.begin();
  return curve.f.empty() ? NAN : curve.f[std::min(static_cast<std::size_t>(at), curve.f.size() - 1)];
}

std::string tear_table(const RunRecord& run, Page& page) {
  const Parts& parts = run.lattices;
  std::string rows;
  for (std::size_t k = 0; k < run.torn.size(); ++k) {
    const TornLink& t = run.torn[k];
    const auto l = static_cast<std::size_t>(t.link);
    rows += element("tr", element("td", std::to_string(k + 1), "number") + element("td", shown(t.mm), "number") +
                              element("td", to_string(parts.link.kind[l])) +
                              element("td", place_of(parts, parts.link.a[l])) +
                              element("td", place_of(parts, parts.link.b[l])) +
                              element("td", shown(force_near(run.force, t.mm)), "number"));
  }
  return "<details class=\"unfold\"><summary>All " + std::to_string(run.torn.size()) + " tears, one by one</summary>" +
         framed({page.id("table " + run.name + " tears"),
                 "Links in the order in which they tear. Rows of nodes count from 0 at the lowest, columns from 0 at "
                 "the left, as in the scene file; the statements beside the paper count from 1.",
                 title_of(run) + ", tears one by one", "study",
                 head_cell("Tear", true) + head_cell("Plate at [mm]", true) + head_cell("Kind") + head_cell("From") +
                     head_cell("To") + head_cell("Force on the plate [N]", true),
                 rows}) +
         "</details>\n";
}

}  // namespace

ForceBand force_band(const Shelf& shelf, const std::string& scene) {
  constexpr double mm = 5;  // what the ensemble keeps, see stretch_of_way
  std::vector<std::vector<double>> by_stretch;
  ForceBand band;
  try {
    for (const Result& result : shelf.of("ensemble").results()) {
      const std::string& key = result.key;
      if (!key.starts_with(scene + " disc ") || !result.value.contains("force_by_way")) continue;
      ++band.packings;
      const Json& forces = result.value["force_by_way"];
      by_stretch.resize(std::max(by_stretch.size(), forces.size()));
      for (std::size_t k = 0; k < forces.size(); ++k) {
        if (forces[k].is_number()) by_stretch[k].push_back(forces[k]);
      }
    }
  } catch (const FileError&) {
    return {};
  }
  if (band.packings < 20) return {};  // no quantiles
  for (std::size_t k = 0; k < by_stretch.size(); ++k) {
    std::vector<double>& all = by_stretch[k];
    if (all.size() < 20) continue;
    std::sort(all.begin(), all.end());
    const auto quantile = [&](double p) {
      return all[static_cast<std::size_t>(std::lround(p * static_cast<double>(all.size() - 1)))];
    };
    band.mm.push_back(mm * (static_cast<double>(k) + 0.5));
    band.low.push_back(quantile(0.05)), band.high.push_back(quantile(0.95));
  }
  return band;
}

std::string overlap_figure(const RunRecord& run, Page& page) {
  if (run.frames.size() < 2 || run.frames[0].discs.rows() == 0) return {};
  const Frame &first = run.frames.front(), &last = run.frames.back();
  const auto start = overlaps_of(first, run.scene.wall), end = overlaps_of(last, run.scene.wall);
  if (start.empty() || end.empty()) return {};
  const auto median = [](const std::vector<double>& all) { return all[all.size() / 2]; };
  PlotInput input;
  input.set("first", "plate at " + bare(with_unit(first.mm, "mm"))).set("last", "at " + bare(with_unit(last.mm, "mm")));
  input.set("apart", bin).block("start", histogram(start)).block("end", histogram(end));
  const std::string said = "half of all overlaps are above " + bare(shown(median(end))) + " R, the largest is " +
                           bare(shown(end.back())) + " R";
  return framed(page,
                {page.id("figure " + run.name + " overlaps"),
                 plot(drawn(input, "overlaps.gp", page.files, run.name + "_overlaps",
                            title_of(run) + ": histogram of overlaps at the end, " + said)),
                 "How deep discs lie in each other and in walls, of the radius R, at two moments: at the end " + said +
                     ". The contact law holds for overlaps that are small against R; beyond 1 R the "
                     "centre of a disc is behind the surface of the other.",
                 run.name + "_overlaps"});
}

std::string tear_figure(const RunRecord& run, Page& page) {
  const Parts& parts = run.lattices;
  if (run.torn.empty() || parts.node.count() == 0) return {};
  std::vector<PlotInput::Row> links, torn, nodes;
  std::vector<int> order(static_cast<std::size_t>(parts.link.count()), 0);
  for (std::size_t k = 0; k < run.torn.size(); ++k)
    order[static_cast<std::size_t>(run.torn[k].link)] = static_cast<int>(k) + 1;
  for (std::size_t l = 0; l < order.size(); ++l) {
    const auto a = static_cast<std::size_t>(parts.link.a[l]), b = static_cast<std::size_t>(parts.link.b[l]);
    const std::vector<double> ends{parts.node.x[a], parts.node.y[a], parts.node.x[b] - parts.node.x[a],
                                   parts.node.y[b] - parts.node.y[a]};
    if (parts.link.kind[l] != LinkClass::bending && order[l] == 0) links.push_back({ends, ""});
  }
  for (std::size_t k = 0; k < run.torn.size(); ++k) {
    const auto l = static_cast<std::size_t>(run.torn[k].link);
    const auto a = static_cast<std::size_t>(parts.link.a[l]), b = static_cast<std::size_t>(parts.link.b[l]);
    torn.push_back({{parts.node.x[a], parts.node.y[a], parts.node.x[b] - parts.node.x[a],
                     parts.node.y[b] - parts.node.y[a], run.torn[k].mm, static_cast<double>(parts.link.kind[l])},
                    std::to_string(k + 1)});
  }
  for (int n = 0; n < parts.node.count(); ++n) nodes.push_back({{parts.node.x[n], parts.node.y[n]}, ""});
  const auto [left, right] = std::minmax_element(parts.node.x.begin(), parts.node.x.end());
  const auto [low, high] = std::minmax_element(parts.node.y.begin(), parts.node.y.end());
  PlotInput input;
  input.set("x0", *left).set("x1", *right).set("y0", *low).set("y1", *high);
  input.set("from", run.torn.front().mm).set("to", std::max(run.torn.back().mm, run.torn.front().mm + 1));
  input.block("links", links).block("torn", torn).block("nodes", nodes);
  const auto l = static_cast<std::size_t>(run.torn.front().link);
  const std::string first = "the first is a " + std::string(to_string(parts.link.kind[l])) + " link from " +
                            place_of(parts, parts.link.a[l]) + " to " + place_of(parts, parts.link.b[l]) + ", at " +
                            with_unit(run.torn.front().mm, "mm");
  return "<div class=\"tears\">" +
         framed(page,
                {page.id("figure " + run.name + " tears"),
                 plot(drawn(input, "tears.gp", page.files, run.name + "_tears",
                            title_of(run) + ": " + std::to_string(run.torn.size()) + " torn links on the lattice, " +
                                bare(first))),
                 "The " + std::to_string(run.torn.size()) +
                     " links that tear, numbered in their order, on the lattice as it stands at the start; colour: "
                     "where the plate is then. Dashed ones are bending links. Of all " +
                     first + ".",
                 run.name + "_tears"}) +
         tear_table(run, page) + "</div>\n";
}

std::string step_figure(const RunRecord& run, std::vector<RunByStep> others, Page& page) {
  if (others.size() < 2) return {};
  std::sort(others.begin(), others.end(), [](const RunByStep& a, const RunByStep& b) { return a.step > b.step; });
  const RunByStep& finest = others.back();
  std::vector<PlotInput::Row> rows, names;
  std::string said;
  for (std::size_t k = 0; k + 1 < others.size(); ++k) {
    const auto one = differences(others[k].force, finest.force, static_cast<double>(k));
    if (one.empty()) continue;
    rows.insert(rows.end(), one.begin(), one.end());
    names.push_back({{static_cast<double>(k)}, bare(step_name(others[k].step))});
    const auto worst =
        std::max_element(one.begin(), one.end(), [](const auto& a, const auto& b) { return a.first[2] < b.first[2]; });
    said += (said.empty() ? "" : "; ") + step_name(others[k].step) + ": up to " + with_unit(worst->first[2], "N") +
            " at " + with_unit(worst->first[1], "mm");
  }
  if (rows.empty()) return {};
  PlotInput input;
  input.set("end", finest.force.end()).set("count", static_cast<double>(names.size()));
  std::vector<PlotInput::Row> force;
  const std::size_t apart = std::max<std::size_t>(1, finest.force.mm.size() / 450);
  for (std::size_t k = 0; k < finest.force.mm.size(); k += apart)
    force.push_back({{finest.force.mm[k], finest.force.f[k]}, ""});
  input.block("off", rows).block("names", names).block("force", force);
  return framed(page, {page.id("figure " + run.name + " by step"),
                       plot(drawn(input, "by_step.gp", page.files, run.name + "_by_step",
                                  title_of(run) + ": how far the force is off by step; " + bare(said))),
                       "Where the step matters: difference of the force on the plate to that with steps of " +
                           step_name(finest.step) + ", root mean square over every " + with_unit(stretch, "mm") +
                           " of the way, from the same start. " + said + ". Grey: the force itself.",
                       run.name + "_by_step"});
}

}  // namespace furrow::validation
