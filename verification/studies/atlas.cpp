#include "verification/studies/atlas.h"

#include <algorithm>
#include <cmath>

#include "methods/method.h"
#include "scene/wording.h"
#include "verification/studies/amplification.h"
#include "verification/studies/blow_up.h"

namespace furrow::verification {
namespace {

constexpr double undamped_at = 0.002;  // where a logarithmic axis shows a damping ratio of zero

Json limits_of(const std::string& method, const std::vector<double>& zetas) {
  const bool conservative = make_method(method)->info().conservative;
  Json limits = Json::array();
  for (const double zeta : zetas) {
    if (conservative && zeta > 0) continue;
    const double theory = largest_stable_angle(method, zeta);
    limits.push_back({{"zeta", zeta},
                      {"theory", theory},
                      {"spring", measured_stable_angle(method, spring_oscillation(zeta), theory)},
                      {"contact", measured_stable_angle(method, contact_oscillation(zeta), theory)}});
  }
  return limits;
}

double at(double zeta) { return std::max(zeta, undamped_at); }

// Theory, finely, critical damping among it; up from the undamped edge.
Json boundary_of(const std::string& method) {
  const auto row = [&](double zeta) {
    const double limit = largest_stable_angle(method, zeta == undamped_at ? 0 : zeta);
    return Json{std::round(1e5 * zeta) / 1e5, std::round(1e5 * limit) / 1e5};
  };
  Json rows = Json::array();
  for (double zeta = undamped_at; zeta < 0.9; zeta *= 1.15) rows.push_back(row(zeta));
  for (double zeta = 0.9; zeta < 1.15; zeta += 0.02) rows.push_back(row(zeta));
  for (double zeta = 1.15; zeta < 31; zeta *= 1.1) rows.push_back(row(zeta));
  return rows;
}

double worst_deviation(const AtlasEntry& e) {
  double worst = 0;
  for (const AtlasLimit& l : e.limits) {
    for (const double measured : {l.spring, l.contact}) {
      const double off = std::fabs(measured / l.theory - 1);
      worst = std::max(worst, std::isnan(off) ? HUGE_VAL : off);
    }
  }
  return worst;
}

Json limit_at(const AtlasEntry& e, double zeta) {
  for (const AtlasLimit& l : e.limits)
    if (l.zeta == zeta) return l.theory < 100 ? Json(l.theory) : Json("any");
  return "–";
}

Figure atlas_figure(const std::vector<AtlasEntry>& atlas, const std::vector<OperatingPoint>& points) {
  Figure figure{.name = "stability_atlas", .script = "stability_atlas.gp"};
  figure.variables["panels"] = atlas.size();
  int k = 0;
  for (const AtlasEntry& e : atlas) {
    const std::string n = std::to_string(++k);
    std::string title = e.methods.front();  // "odeint_symplectic_rkn_sb3a_mclachlan" would not fit
    if (const auto at = title.find("symplectic_rkn_"); at != std::string::npos) title.erase(at, 15);
    figure.variables["title_" + n] = title;
    figure.blocks["theory_" + n] = boundary_of(e.methods.front());
    Json measured = Json::array();
    for (const AtlasLimit& l : e.limits) measured.push_back({at(l.zeta), l.spring, l.contact});
    figure.blocks["measured_" + n] = measured;
  }
  Json marks = Json::array();
  for (const OperatingPoint& p : points) marks.push_back({at(p.zeta), p.angle, p.label});
  figure.blocks["points"] = marks;
  figure.variables["marks"] = points.size();
  figure.description =
      "Small multiples, one a method: the region of omega h against damping ratio in which it is stable, with the "
      "steps "
      "at which the solver blew up.";
  return figure;
}

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

// What the figure shows, from the numbers.
std::string conclusion(const std::vector<AtlasEntry>& atlas, const std::vector<OperatingPoint>& points) {
  const auto widest = [&](double zeta) {
    const AtlasEntry* best = nullptr;
    double most = 0;
    for (const AtlasEntry& e : atlas) {
      if (make_method(e.methods.front())->info().conservative) continue;
      const double limit = largest_stable_angle(e.methods.front(), zeta);
      if (limit < 100 && limit > most) best = &e, most = limit;
    }
    return best->methods.front() + " (" + std::to_string(most).substr(0, 5) + ")";
  };
  std::string text =
      "Stable below the line (amplification factor), blown up above the marks (the solver itself). Of the "
      "methods with a limit " +
      widest(0) + " reaches furthest without damping and " + widest(1) + " at critical damping.";
  int beyond = 0;
  for (const OperatingPoint& p : points) beyond += p.angle > largest_stable_angle("pece", p.zeta) ? 1 : 0;
  if (!points.empty())
    text += " Of the paper's scenes at its step, each by its fastest part with the neighbours held, " +
            std::to_string(beyond) + " of " + std::to_string(points.size()) + " stand outside the region of pece.";
  return text;
}

}  // namespace

std::vector<AtlasEntry> atlas_by_theory() {
  std::vector<AtlasEntry> atlas;
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled) continue;
    const auto same = std::find_if(atlas.begin(), atlas.end(), [&](const AtlasEntry& e) {
      return same_amplification(e.methods.front(), info.name);
    });
    if (same != atlas.end()) {
      same->methods.push_back(info.name);
      continue;
    }
    AtlasEntry entry{.methods = {info.name}, .by_eigenvalue = acts_by_eigenvalue(info.name)};
    if (entry.by_eigenvalue) entry.real_axis = largest_stable_radius(info.name, -1);
    entry.imaginary_axis = largest_stable_angle(info.name, 0);
    atlas.push_back(entry);
  }
  return atlas;
}

std::vector<AtlasEntry> make_atlas(const Settings& settings, const std::vector<double>& zetas) {
  std::vector<AtlasEntry> atlas = atlas_by_theory();
  std::vector<Task> tasks;
  for (const AtlasEntry& e : atlas)
    for (const std::string& method : e.methods) {
      std::string key = "atlas " + method;
      for (const double zeta : zetas) key += " " + shortest(zeta);
      tasks.push_back({key, [method, &zetas] { return limits_of(method, zetas); }});
    }
  const std::vector<Json> results = run_tasks("stability", settings, tasks);
  std::size_t task = 0;
  for (AtlasEntry& e : atlas) {
    for (std::size_t m = 0; m < e.methods.size(); ++m, ++task) {
      if (!results[task].is_array()) throw std::runtime_error(tasks[task].key + ": " + results[task].dump());
      for (const Json& l : results[task]) e.limits.push_back({l["zeta"], l["theory"], l["spring"], l["contact"]});
    }
  }
  return atlas;
}

std::vector<std::string> methods_outside(const std::vector<AtlasEntry>& atlas) {
  std::vector<std::string> outside;
  for (const MethodInfo& info : method_catalogue()) {
    const bool inside = std::any_of(atlas.begin(), atlas.end(), [&](const AtlasEntry& e) {
      return std::find(e.methods.begin(), e.methods.end(), info.name) != e.methods.end();
    });
    if (!inside) outside.push_back(info.name);
  }
  return outside;
}

void report_atlas(Report& report, const std::vector<AtlasEntry>& atlas, const std::vector<OperatingPoint>& points) {
  Figure figure = atlas_figure(atlas, points);
  figure.caption = conclusion(atlas, points);
  std::vector<std::vector<Json>> rows;
  double worst = 0;
  std::string worst_of;
  int measured = 0;
  for (const AtlasEntry& e : atlas) {
    rows.push_back({joined(e.methods),
                    e.by_eigenvalue ? (e.real_axis < 100 ? Json(e.real_axis) : Json("any")) : Json("–"), limit_at(e, 0),
                    limit_at(e, 0.01), limit_at(e, 0.1), limit_at(e, 0.5), limit_at(e, 1), limit_at(e, 5),
                    percent(worst_deviation(e))});
    if (worst_deviation(e) > worst) worst = worst_deviation(e), worst_of = e.methods.front();
    measured += 2 * static_cast<int>(e.limits.size());
  }
  report.heading("The atlas").figure(figure);
  report.table(
      "Largest stable h |lambda| on the negative real axis and omega h at six damping ratios, by the amplification "
      "factor, and how far the solver's own blow-up is from it at worst. A growth of less than " +
          shortest(growth_seen) +
          " a step passes, so that a method that grows at any step has a small limit instead of none.",
      {"method", "real axis", "zeta = 0", "0.01", "0.1", "0.5", "1", "5", "measured off by"}, rows);
  report.claim(
      "The solver blows up within 1 % of the step that the amplification factor says: " + std::to_string(measured) +
          " measurements, off by " + percent(worst) + " at worst (" + worst_of + ").",
      measured > 0 && !worst_of.empty() && worst < 0.01);
  report.text("Not in the atlas, since they choose their own step: " + joined(methods_outside(atlas)) + ".");
}

}  // namespace furrow::verification
