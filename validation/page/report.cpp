#include "page/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <utility>

#include "output/files.h"
#include "page/embedded.h"
#include "page/gnuplot.h"
#include "page/html.h"
#include "page/observables.h"
#include "page/studies.h"
#include "page/verification.h"

namespace furrow {
namespace {

std::string figure_file(const std::string& name) { return std::string(embedded("validation/figures/" + name)); }

// Replaces every {{key}}.
std::string filled(const std::string& page, const std::map<std::string, std::string>& values) {
  std::string result;
  for (std::size_t at = 0;;) {
    const std::size_t open = page.find("{{", at), close = page.find("}}", at);
    result += page.substr(at, open - at);
    if (open == std::string::npos) return result;
    result += values.at(page.substr(open + 2, close - open - 2));
    at = close + 2;
  }
}

// An entry of run.json as HTML.
std::string fact_shown(const RunRecord& run, const std::string& key) {
  const Fact* fact = run.fact(key);
  if (!fact) return missing;
  if (fact->fraction) return shown(std::strtod(fact->texts[0].c_str(), nullptr));
  std::string all;
  for (const std::string& text : fact->texts) all += (all.empty() ? "" : ", ") + escaped(text);
  return all.empty() ? "none" : all;
}

double speed(const RunRecord& run) {  // of the first plate, mm/s
  if (run.scene.plate.empty()) return 0;
  return 1e3 * std::hypot(run.scene.plate[0].velocity.x, run.scene.plate[0].velocity.y);
}

double travel(const RunRecord& run) { return speed(run) * run.scene.time.end; }  // mm

std::string ending(const RunRecord& run) {
  const std::string end = with_unit(run.scene.time.end, "s");
  std::string html, warnings;
  if (run.finished()) {
    html =
        element("p", "Ran to its end, " + end + " or " + with_unit(travel(run), "mm") + " of plate travel.", "ending");
  } else {
    html = element("p",
                   "This run is not complete: " + fact_shown(run, "ended") + " at " + fact_shown(run, "ended_at") +
                       " s of " + end + ". Reason: " + fact_shown(run, "reason"),
                   "failed");
  }
  if (const Fact* told = run.fact("warnings")) {
    for (const std::string& text : told->texts) warnings += element("p", "Warning: " + escaped(text));
  }
  return html + (warnings.empty() ? "" : element("div", warnings, "warnings"));
}

// The page's part of one run; `out` is where the SVG files go.
class SceneSection {
 public:
  SceneSection(const RunRecord& run, const Publication& paper, std::filesystem::path out)
      : run_(run), out_(std::move(out)) {
    for (const Statement& s : paper.statements) {
      if (s.scene == run.name) statements_.push_back(s);
    }
  }

  std::string html() const {
    return filled(figure_file("scene.html"), {{"name", run_.name},
                                              {"title", escaped(run_.scene.title)},
                                              {"ending", ending(run_)},
                                              {"force", force()},
                                              {"energy", energy()},
                                              {"snapshots", snapshots()},
                                              {"statements", statements()},
                                              {"torn", torn()}});
  }

 private:
  struct View {
    double x0 = infinity, x1 = -infinity, y0 = infinity, y1 = -infinity;  // m
    bool wide() const { return x1 - x0 > 1.3 * (y1 - y0); }
  };

  // Largest value in magnitude over all frames, and the one that ends the colour scale.
  struct Scale {
    double largest = 0, top = 1;
    bool used = false;
  };

  std::string drawn(const PlotInput& input, const std::string& script, const std::string& name,
                    const std::string& what) const {
    return draw(input, figure_file("palettes.gp") + figure_file(script), out_ / (run_.name + "_" + name + ".svg"),
                what);
  }

  std::string force() const {
    const ForceCurve& c = run_.force;
    if (c.mm.empty()) return element("p", "Force on the plate: " + missing);
    double low = 0, high = 0;
    const auto reach = [&](double value) {
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    };
    std::vector<PlotInput::Row> curve, peaks, levels, uprights;
    for (std::size_t k = 0; k < c.mm.size(); ++k) {
      curve.push_back({{c.mm[k], c.fx[k], c.fy[k], c.f[k]}, ""});
      for (const double value : {c.fx[k], c.fy[k], c.f[k]}) reach(value);
    }
    for (const auto& [mm, f] : maxima(c, 50)) peaks.push_back({{mm, f}, ""});
    for (const Statement& s : statements_) {
      const auto window = s.window.value_or(std::array{0.0, travel(run_)});
      if (s.mark == "upright") uprights.push_back({{s.value}, s.label});
      if (s.mark != "level") continue;
      const auto middle = std::lower_bound(c.mm.begin(), c.mm.end(), 0.5 * (window[0] + window[1])) - c.mm.begin();
      const bool under = middle < std::ssize(c.f) && c.f[static_cast<std::size_t>(middle)] > s.value;
      levels.push_back({{window[0], window[1], s.value, under ? 1.0 : 0.0}, s.label});
      reach(s.value);
    }
    if (low == high) high = 1;
    PlotInput input;
    input.set("end", travel(run_))
        .set("bottom", low - 0.04 * (low < 0 ? high - low : 0))
        .set("top", high + 0.1 * (high - low));
    input.block("force", curve).block("peaks", peaks).block("levels", levels).block("uprights", uprights);
    return figure(drawn(input, "force.gp", "force", "Force on the plate against its displacement"),
                  "Force on the plate, drawn as resistance (F<sub>x</sub> positive when the plate is held back); the "
                  "sum is largest, " +
                      with_unit(measure(run_, "largest_force").value, "N") + ", at " +
                      with_unit(measure(run_, "largest_force_at").value, "mm") +
                      "; dotted: the numbers that the paper gives.");
  }

  std::string energy() const {
    const Table& t = run_.energy;
    if (t.rows() == 0) return element("p", "Energy ledger: " + missing);
    const std::size_t last = t.rows() - 1;
    const auto at = [&](const char* column, std::size_t row) { return t.numbers(column)[row]; };
    const auto stored = [&](std::size_t row) {
      return at("kinetic [J]", row) + at("gravity [J]", row) + at("load [J]", row) + at("springs [J]", row) +
             at("contact elastic [J]", row);
    };
    const double work = at("plate work [J]", last), residual = at("residual [J]", last);
    std::string caption = "Of the " + with_unit(work, "J") + " of work that the plate did,";
    for (const auto& [name, column] : {std::pair{"sliding friction", "friction [J]"},
                                       {"contact damping", "contact viscous [J]"},
                                       {"rolling friction", "rolling [J]"},
                                       {"link damping", "link damping [J]"},
                                       {"tearing", "tear [J]"}}) {
      const double lost = at(column, last);
      if (lost != 0) caption += " " + std::string(name) + " took " + with_unit(lost, "J") + ",";
    }
    caption += " and " + with_unit(stored(last) - stored(0), "J") +
               " are stored; the residual, what the ledger cannot place, is " + with_unit(residual, "J") + " (" +
               with_unit(100 * residual / work, "%") + " of the work).";
    PlotInput input;
    input.set("end", travel(run_)).set("speed", speed(run_)).set("start", stored(0)).set("energy", t.file());
    input.set("rows_apart", std::max(1.0, std::floor(static_cast<double>(t.rows()) / 400)));
    return figure(drawn(input, "energy.gp", "energy", "Energy ledger against displacement"), caption);
  }

  bool has_weight() const {
    const auto heavy = [](const Lattice& l) { return l.gravity; };
    const Scene& s = run_.scene;
    return s.model.gravity != 0 &&
           (!s.disc.empty() || !s.packing.empty() || std::any_of(s.lattice.begin(), s.lattice.end(), heavy));
  }

  // All that is in some frame, within the walls, and some room above for the arrows.
  View view() const {
    View v;
    const auto include = [&](const Table& table, const char* x_column, const char* y_column, const char* reach_column) {
      const auto x = table.numbers(x_column), y = table.numbers(y_column);
      const auto reach = reach_column ? table.numbers(reach_column) : std::vector<double>(x.size(), 0);
      for (std::size_t k = 0; k < x.size(); ++k) {
        if (!std::isfinite(x[k] + y[k] + reach[k])) continue;
        v = {std::min(v.x0, x[k] - reach[k]), std::max(v.x1, x[k] + reach[k]), std::min(v.y0, y[k]),
             std::max(v.y1, y[k] + reach[k])};
      }
    };
    for (const Frame& f : run_.frames) {
      include(f.discs, "x [m]", "y [m]", "radius [m]");
      include(f.links, "x1 [m]", "y1 [m]", nullptr);
      include(f.links, "x2 [m]", "y2 [m]", nullptr);
      include(f.plates, "left [m]", "lower [m]", "width [m]");
    }
    for (const Wall& w : run_.scene.wall) {
      if (w.normal.y == 0) (w.normal.x > 0 ? v.x0 : v.x1) = w.point.x;
      if (w.normal.x == 0) (w.normal.y > 0 ? v.y0 : v.y1) = w.point.y;
    }
    if (!(v.x1 > v.x0)) v.x0 = 0, v.x1 = 1;
    if (!(v.y1 > v.y0)) v.y0 = 0, v.y1 = 1;
    const double width = v.x1 - v.x0, height = v.y1 - v.y0;
    return {v.x0 - 0.015 * width, v.x1 + 0.015 * width, v.y0 - 0.015 * width,
            v.y1 + std::max(0.2 * height, (width > 2 * height ? 0.08 : 0.18) * width)};
  }

  // The scale ends where the share `covered` of all values is below it.
  Scale scale_of(Table Frame::*table, const char* column, double covered) const {
    std::vector<double> values;
    for (const Frame& f : run_.frames) {
      for (const double v : (f.*table).numbers(column)) {
        if (std::isfinite(v)) values.push_back(std::abs(v));
      }
    }
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const double top = values[static_cast<std::size_t>(covered * static_cast<double>(values.size() - 1))];
    return {values.back(), top > 0 ? top : 1, true};
  }

  std::string panel(std::size_t index, const View& v, const Scale& stress, const Scale& force) const {
    const Frame& f = run_.frames[index];
    const std::string letter(1, static_cast<char>('a' + index % 26)), mm = std::to_string(std::lround(f.mm)) + " mm";
    const double strip = 30, width = v.wide() ? 560 : 280;
    std::vector<PlotInput::Row> walls, discs;
    for (const Wall& w : run_.scene.wall) walls.push_back({{w.point.x, w.point.y, w.normal.x, w.normal.y}, ""});
    const auto x = f.discs.numbers("x [m]"), y = f.discs.numbers("y [m]"), r = f.discs.numbers("radius [m]"),
               von_mises = f.discs.numbers("von Mises [Pa]");
    for (std::size_t k = 0; k < x.size(); ++k) {
      discs.push_back({{x[k], y[k], r[k], -1}, ""});
      discs.push_back({{x[k], y[k], 0.9 * r[k], von_mises[k] / 1e3}, ""});
    }
    PlotInput input;
    input.set("width", width)
        .set("strip", strip)
        .set("height", std::round(width * (v.y1 - v.y0) / (v.x1 - v.x0) + strip));
    input.set("x0", v.x0).set("x1", v.x1).set("y0", v.y0).set("y1", v.y1).set("caption", letter + ") " + mm);
    input.set("stress_top", stress.top / 1e3).set("force_top", force.top).set("weight", has_weight() ? 1 : 0);
    input.set("links", f.links.file()).set("plates", f.plates.file()).block("walls", walls).block("discs", discs);
    return drawn(input, "panel.gp", "snapshot_" + letter, "Snapshot at " + mm);
  }

  std::string bar(const std::string& name, double low, double high, const std::string& title,
                  const std::string& palette) const {
    PlotInput input;
    input.set("low", low).set("high", high).set("title", title).set("palette_name", palette);
    return drawn(input, "bar.gp", name, "Colour scale: " + title);
  }

  std::string snapshots() const {
    const View v = view();
    const Scale stress = scale_of(&Frame::discs, "von Mises [Pa]", 0.99),
                force = scale_of(&Frame::links, "force [N]", 1);
    std::string bars, panels, caption = "Snapshots true to scale, all with the same colours.";
    if (stress.used) {
      bars += bar("stress_scale", 0, stress.top / 1e3, "von Mises stress of the discs [kPa]", "sequential");
      caption += " The stress scale ends where 99 % of the discs are below it; the largest value is " +
                 with_unit(stress.largest / 1e3, "kPa") + ".";
    }
    if (force.used) {
      bars += bar("link_scale", -force.top, force.top, "force in the links [N], tension positive", "diverging");
      caption += " Bending links are the wide bands under the others; the largest link force is " +
                 with_unit(force.largest, "N") + ".";
    }
    if (!has_weight()) caption += " Nothing in this scene has weight.";
    for (std::size_t k = 0; k < run_.frames.size(); ++k) panels += panel(k, v, stress, force);
    for (std::size_t k = run_.frames.size(); k < run_.scene.output.frames.size(); ++k) {
      panels += element("p", with_unit(speed(run_) * run_.scene.output.frames[k], "mm") + ": " + missing, "absent");
    }
    return figure(element("div", bars, "bars") + element("div", panels, v.wide() ? "panels" : "panels tall"), caption);
  }

  std::string statements() const {
    std::string rows;
    for (const Statement& s : statements_) {
      const Measured ours = measure(run_, s.observable, s.window);
      const double difference = ours.value - s.value;
      const std::string sign = difference > 0 ? "+" : "";
      std::string said = escaped(s.words), apart;
      if (s.words.empty()) {
        said = s.relation + (s.relation.empty() ? "" : " ") + number(s.value) + " " + s.unit;
        if (ours.words.empty()) apart = sign + with_unit(difference, s.unit);
        if (std::isfinite(difference) && s.value != 0 && s.unit != "mm") {
          apart += element("small", sign + shown(100 * difference / s.value) + " %");
        }
      }
      std::string got = ours.words.empty() ? with_unit(ours.value, s.unit) : escaped(ours.words);
      if (!run_.finished() && got != missing) got += element("small", "of the part that ran");
      rows += element("tr", element("td", escaped(s.quantity) + element("small", "ours: " + escaped(s.ours))) +
                                element("td", said + element("small", escaped(s.where)), "words") +
                                element("td", got, ours.words.empty() ? "number" : "words") +
                                element("td", apart, "number"));
    }
    return rows;
  }

  std::string torn() const {
    const Parts& parts = run_.lattices;
    if (parts.link.count() == 0 || run_.force.mm.empty()) return {};
    std::string rows;
    for (const LinkClass kind : {LinkClass::structural, LinkClass::shear, LinkClass::bending}) {
      const auto all = std::count(parts.link.kind.begin(), parts.link.kind.end(), kind);
      std::vector<double> at;
      int half = 0;
      for (const TornLink& t : run_.torn) {
        if (parts.link.kind[t.link] == kind) at.push_back(t.mm), half += half_fixed(parts, t.link);
      }
      std::string row = element("td", to_string(kind));
      for (const std::string& cell :
           {std::to_string(all), std::to_string(at.size()), std::to_string(half),
            at.empty() ? "none" : with_unit(at.front(), "mm"), at.empty() ? "none" : with_unit(at.back(), "mm")}) {
        row += element("td", cell, "number");
      }
      rows += element("tr", row);
    }
    return filled(figure_file("torn.html"), {{"rows", rows}});
  }

  const RunRecord& run_;
  std::filesystem::path out_;
  std::vector<Statement> statements_;
};

// run.json of all runs, one row a fact; what all runs share fills one cell.
std::string how_made(const std::vector<RunRecord>& runs) {
  const std::map<std::string, std::string> units{
      {"step", " [s]"}, {"end", " [s]"}, {"ended_at", " [s]"}, {"settling_time", " [s]"}, {"surface", " [m]"}};
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
    rows += element("tr", element("th", escaped(label) + (units.contains(key) ? units.at(key) : "")) + row);
  }
  return rows;
}

// The runs in a table for a page in Markdown.
std::string scene_table(const std::vector<RunRecord>& runs) {
  std::string table =
      "| scene | steps | evaluations | CPU [s] | largest force [N] | links torn | energy residual, of the plate's work "
      "| "
      "state hash |\n|---|--:|--:|--:|--:|--:|--:|---|\n";
  for (const RunRecord& run : runs) {
    const auto last = [&](const char* column) {
      return run.energy.rows() > 0 ? run.energy.numbers(column).back() : NAN;
    };
    table += "| " + run.name + (run.finished() ? "" : " (" + fact_shown(run, "ended") + ")") + " | " +
             fact_shown(run, "steps") + " | " + fact_shown(run, "rhs_evaluations") + " | " +
             fact_shown(run, "cpu_seconds") + " | " + shown(measure(run, "largest_force").value) + " | " +
             std::to_string(run.torn.size()) + " | " + shown(100 * last("residual [J]") / last("plate work [J]")) +
             " % | `" + fact_shown(run, "state_hash") + "` |\n";
  }
  return table;
}

}  // namespace

void write_report(const std::filesystem::path& out, const std::vector<ReportedRun>& reported,
                  const Evidence& evidence) {
  const Publication paper = read_publication(embedded("reference_data/published/paper.toml"));
  std::vector<RunRecord> runs;
  for (const ReportedRun& r : reported) runs.push_back(read_run(r.name, r.directory));
  std::filesystem::create_directories(out);
  std::string contents, scenes;
  for (const RunRecord& run : runs) {
    contents +=
        element("li", "<a href=\"#" + run.name + "\">" + escaped(run.scene.title) + "</a>" +
                          (run.finished() ? "" : ": " + element("strong", fact_shown(run, "ended"), "missing")));
    scenes += SceneSection(run, paper, out).html();
  }
  OutputFile page(out / "index.html");
  page << filled(figure_file("page.html"), {{"style", figure_file("page.css")},
                                            {"paper", escaped(paper.title)},
                                            {"contents", contents},
                                            {"scenes", scenes},
                                            {"study_contents", study_contents(evidence.studies)},
                                            {"studies", study_sections(evidence.studies, out)},
                                            {"verification", verification_section(evidence)},
                                            {"made", how_made(runs)}});
  page.finish();
  OutputFile table(out / "scenes.md");
  table << scene_table(runs);
  table.finish();
}

}  // namespace furrow
