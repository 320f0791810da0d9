#include "validation/page/snapshots.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "validation/page/html.h"
#include "validation/page/template.h"

namespace furrow::validation {
namespace {

class Snapshots {
 public:
  Snapshots(const RunRecord& run, Page& page) : run_(run), page_(page) {}

  std::string html() const {
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
    if (stress.used) caption += overlap_words();
    for (std::size_t k = 0; k < run_.frames.size(); ++k) panels += panel(k, v, stress, force);
    for (std::size_t k = run_.frames.size(); k < run_.scene.output.frames.size(); ++k) {
      panels += element("p", with_unit(plate_displacement(run_, run_.scene.output.frames[k]), "mm") + ": " + missing,
                        "absent");
    }
    return framed(page_, {page_.id("figure " + run_.name + " snapshots"),
                          element("div", bars, "bars") + element("div", panels, v.wide() ? "panels" : "panels tall"),
                          caption, "", "<a href=\"" + run_.name + "/frames/frames.csv\">data (CSV)</a>"});
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

  bool has_weight() const {
    const auto heavy = [](const Lattice& l) { return l.gravity; };
    const Scene& s = run_.scene;
    return s.model.gravity != 0 &&
           (!s.disc.empty() || !s.packing.empty() || std::any_of(s.lattice.begin(), s.lattice.end(), heavy));
  }

  // Why discs are drawn across what stops them.
  std::string overlap_words() const {
    const Fact* fact = run_.fact("greatest_relative_overlap");
    const double worst = fact && !fact->texts.empty() ? std::strtod(fact->texts[0].c_str(), nullptr) : 0;
    if (!(worst > 0.1)) return {};
    return " Discs cross the floor, the walls and each other since the contact law lets them: the deepest overlap of "
           "all "
           "steps is " +
           with_unit(worst, "radii") + (worst > 1 ? ", more than a radius." : ".");
  }

  // All that is in some frame, discs that are pressed into walls among it, and some room above for the arrows.
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
      if (w.normal.y == 0) v.x0 = std::min(v.x0, w.point.x), v.x1 = std::max(v.x1, w.point.x);
      if (w.normal.x == 0) v.y0 = std::min(v.y0, w.point.y);
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
    return drawn(input, "panel.gp", page_.files, figure_name("snapshot_" + letter), "Snapshot at " + mm);
  }

  std::string bar(const std::string& name, double low, double high, const std::string& title,
                  const std::string& palette) const {
    PlotInput input;
    input.set("low", low).set("high", high).set("title", title).set("palette_name", palette);
    return drawn(input, "bar.gp", page_.files, figure_name(name), "Colour scale: " + title);
  }

  std::string figure_name(const std::string& what) const { return run_.name + "_" + what; }

  const RunRecord& run_;
  Page& page_;
};

}  // namespace

std::string snapshots(const RunRecord& run, Page& page) { return Snapshots(run, page).html(); }

}  // namespace furrow::validation
