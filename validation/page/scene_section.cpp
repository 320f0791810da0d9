#include "validation/page/scene_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "output/files.h"
#include "validation/page/gnuplot.h"
#include "validation/page/html.h"
#include "validation/page/observables.h"
#include "validation/page/run_words.h"
#include "validation/page/snapshots.h"
#include "validation/page/template.h"
#include "validation/page/validity_part.h"

namespace furrow::validation {
namespace {

double travel(const RunRecord& run) { return plate_displacement(run, run.scene.time.end); }  // mm

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
  if (const Fact* fact = run.fact("warnings")) {
    for (const std::string& text : fact->texts) warnings += element("p", "Warning: " + typeset(escaped(text)) + ".");
  }
  return html + (warnings.empty() ? "" : element("div", warnings, "warnings"));
}

// The page's part of one run; `drawings` is where the figures go.
class SceneSection {
 public:
  SceneSection(const RunRecord& run, const Publication& paper, Page& page) : run_(run), page_(page) {
    for (const Statement& s : paper.statements) {
      if (s.scene == run.name) statements_.push_back(s);
    }
  }

  std::string html(const std::string& number, const SceneBeside& beside) const {
    return filled(page_file("scene.html"),
                  {{"id", page_.id(run_.name)},
                   {"heading", heading(3, page_.id(run_.name + " scene"),
                                       element("span", number, "section") + escaped(title_of(run_)))},
                   {"ending", ending(run_)},
                   {"player", beside.player},
                   {"force", force(beside.band)},
                   {"energy", energy()},
                   {"by_step", step_figure(run_, beside.by_step, page_)},
                   {"overlaps", overlap_figure(run_, page_)},
                   {"tears", tear_figure(run_, page_)},
                   {"snapshots", snapshots(run_, page_)},
                   {"validity", validity_part(run_, page_)},
                   {"statements_heading", heading(4, page_.id(run_.name + " beside the paper"), "Beside the paper")},
                   {"statements", statements()},
                   {"torn", torn()}});
  }

 private:
  static std::string plot(const std::string& svg) { return "<div class=\"plot\">" + svg + "</div>"; }

  std::string figure_name(const char* what) const { return run_.name + "_" + what; }

  std::string force(const ForceBand& packings) const {
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
    std::vector<PlotInput::Row> band;
    for (std::size_t k = 0; k < packings.mm.size(); ++k) {
      band.push_back({{packings.mm[k], packings.low[k], packings.high[k]}, ""});
      reach(packings.high[k]);
    }
    if (low == high) high = 1;
    PlotInput input;
    input.set("end", travel(run_))
        .set("bottom", low - 0.04 * (low < 0 ? high - low : 0))
        .set("top", high + 0.1 * (high - low));
    std::vector<PlotInput::Row> torn;
    for (const TornLink& link : run_.torn) torn.push_back({{link.mm}, ""});
    input.block("torn", torn)
        .block("force", curve)
        .block("peaks", peaks)
        .block("levels", levels)
        .block("uprights", uprights)
        .block("band", band);
    input.set("packings", static_cast<double>(packings.packings));
    return framed(page_,
                  {page_.id("figure " + figure_name("force")),
                   plot(drawn(input, "force.gp", page_.files, figure_name("force"),
                              title_of(run_) + ": the force on the plate against its displacement; it is largest, " +
                                  bare(largest()))),
                   "Force on the plate, drawn as resistance (F<sub>x</sub> positive when the plate is held back); the "
                   "sum is largest, " +
                       largest() + "; dotted: the numbers that the paper gives." +
                       (band.empty() ? ""
                                     : " Shaded: where the largest force in every 5 mm lies for nine tenths of " +
                                           std::to_string(packings.packings) + " packings."),
                   figure_name("force")});
  }

  // Of all steps, where run.json says it; the rows of the curve miss what is between them.
  std::string largest() const {
    if (run_.largest_force.empty())
      return with_unit(measure(run_, "largest_force").value, "N") + ", at " +
             with_unit(measure(run_, "largest_force_at").value, "mm");
    const LargestForce& f = run_.largest_force.front();
    return with_unit(f.f, "N") + " of all steps, at " + with_unit(plate_displacement(run_, f.time), "mm");
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
    caption += " and " + with_unit(stored(last) - stored(0), "J") + " are stored; " + unaccounted(residual);
    PlotInput input;
    input.set("end", travel(run_))
        .set("speed", plate_speed(run_))
        .set("ramp", run_.scene.plate[0].ramp)
        .set("start", stored(0))
        .set("energy", t.file());
    input.set("rows_apart", std::max(1.0, std::floor(static_cast<double>(t.rows()) / 400)));
    const std::string said =
        "Energy against displacement: " + bare(with_unit(work, "J")) + " of work; " + bare(unaccounted(residual));
    return framed(page_, {page_.id("figure " + figure_name("energy")),
                          plot(drawn(input, "energy.gp", page_.files, figure_name("energy"), said)), caption,
                          figure_name("energy"), "<a href=\"" + run_.name + "/energy.csv\">data (CSV)</a>"});
  }

  // In J and, as everywhere on the page, of all the energy that the scene was given.
  std::string unaccounted(double residual) const {
    std::string words = "the residual, what the ledger cannot place, is " + with_unit(residual, "J");
    const WatchedFact* made = watch_of(run_, "energy_made");
    if (made == nullptr) return words + ".";
    words += ": the method or a law made " + with_unit(100 * made->worst, "%") +
             " of all the energy that the scene was given";
    if (made->worst > made->warns_above)
      words += ", out of nothing, since the step is too long: the stack rises above the dashed line";
    return words + ".";
  }

  std::string statements() const {
    std::string rows;
    for (const Statement& s : statements_) {
      const Measured ours = measure(run_, s.observable, s.window);
      const double difference = ours.value - s.value;
      const std::string sign = difference > 0 ? "+" : "";
      std::string said = escaped(s.words), difference_cell;
      if (s.words.empty()) {
        said = s.relation + (s.relation.empty() ? "" : " ") + number(s.value) + " " + s.unit;
        if (ours.words.empty()) difference_cell = sign + with_unit(difference, s.unit);
        if (std::isfinite(difference) && s.value != 0 && s.unit != "mm") {
          difference_cell += element("small", sign + shown(100 * difference / s.value) + " %");
        }
      }
      std::string got = ours.words.empty() ? with_unit(ours.value, s.unit) : escaped(ours.words);
      if (!run_.finished() && got != missing) got += element("small", "of the part that ran");
      rows += element("tr", element("td", escaped(s.quantity) + element("small", "ours: " + escaped(s.ours))) +
                                element("td", said + element("small", escaped(s.where)), "words") +
                                element("td", got, ours.words.empty() ? "number" : "words") +
                                element("td", difference_cell, "number"));
    }
    return framed({page_.id("table " + run_.name + " beside the paper"), "", title_of(run_) + ", beside the paper",
                   "statements",
                   head_cell("Quantity") + head_cell("Paper") + head_cell("furrow") + head_cell("Difference"), rows});
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
    return framed({page_.id("table " + run_.name + " torn links"),
                   "Torn links by kind, and the displacement of the plate at the first and the last.",
                   title_of(run_) + ", torn links", "study",
                   head_cell("Kind") + head_cell("Links", true) + head_cell("Torn", true) +
                       head_cell("Of them to a fixed node", true) + head_cell("First", true) + head_cell("Last", true),
                   rows});
  }

  const RunRecord& run_;
  Page& page_;
  std::vector<Statement> statements_;
};

}  // namespace

std::string fact_shown(const RunRecord& run, const std::string& key) {
  const Fact* fact = run.fact(key);
  if (!fact) return missing;
  if (fact->fraction) return shown(std::strtod(fact->texts[0].c_str(), nullptr));
  std::string all;
  for (const std::string& text : fact->texts) all += (all.empty() ? "" : ", ") + escaped(text);
  return all.empty() ? "none" : all;
}

std::string scene_section(const RunRecord& run, const Publication& paper, const std::string& number,
                          const SceneBeside& beside, Page& page) {
  return SceneSection(run, paper, page).html(number, beside);
}

}  // namespace furrow::validation
