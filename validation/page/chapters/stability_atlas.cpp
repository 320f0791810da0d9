// How long may a step be, method by method and damping ratio by damping ratio?
#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/wording.h"
#include "validation/page/chapters/stability_parts.h"
#include "verification/studies/amplification.h"

namespace furrow::validation {
namespace {

using namespace verification;

double at(double zeta) { return std::max(zeta, undamped_at); }

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

Json real_axis(const AtlasEntry& e) {
  if (std::isnan(e.real_axis)) return "–";
  return e.real_axis < 100 ? Json(e.real_axis) : Json("any");
}

Json limit_at(const AtlasEntry& e, double zeta) {
  for (const AtlasLimit& l : e.limits)
    if (l.zeta == zeta) return l.theory < 100 ? Json(l.theory) : Json("any");
  return "–";
}

// The paper's scenes that are marked: each once, at the moment that sets it apart from the others.
std::vector<StandingScene> marked(const std::vector<StandingScene>& scenes) {
  std::vector<StandingScene> some;
  std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(some), [](const StandingScene& s) {
    return s.of_the_paper() && s.failed.empty() && !s.name.ends_with(", start");
  });
  return some;
}

Figure atlas_figure(const std::vector<AtlasEntry>& atlas, const std::vector<StandingScene>& scenes) {
  Figure figure{.name = "stability_atlas", .script = "stability_atlas.gp"};
  figure.variables["panels"] = atlas.size();
  int k = 0;
  for (const AtlasEntry& e : atlas) {
    const std::string n = std::to_string(++k);
    std::string title = e.methods.front();  // "odeint_symplectic_rkn_sb3a_mclachlan" would not fit
    if (const auto at = title.find("symplectic_rkn_"); at != std::string::npos) title.erase(at, 15);
    figure.variables["title_" + n] = title;
    figure.blocks["theory_" + n] = e.boundary;
    Json measured = Json::array();
    for (const AtlasLimit& l : e.limits) measured.push_back({at(l.zeta), l.spring, l.contact});
    figure.blocks["measured_" + n] = measured;
  }
  Json marks = Json::array();
  for (const StandingScene& s : scenes) marks.push_back({at(s.point.zeta), s.point.angle, moment_of(s).label});
  figure.blocks["points"] = marks;
  figure.variables["marks"] = scenes.size();
  figure.description =
      "Small multiples, one a method: the region of omega h against damping ratio in which it is stable, with the "
      "steps at which the solver blew up.";
  return figure;
}

std::string percent(double share) { return rounded(100 * share, 2) + " %"; }

// Beyond the last point of the boundary, where damping alone counts, the limit falls as 1/zeta: the dotted line.
bool outside(const AtlasEntry& e, const OperatingPoint& point) {
  if (e.boundary.empty()) return false;
  const auto& [zeta, limit] = e.boundary.back();
  return point.angle > (point.zeta <= zeta ? e.limit_at(point.zeta) : limit * zeta / point.zeta);
}

// Which moment each mark is of, and why that one.
std::string moments(const std::vector<StandingScene>& scenes) {
  std::string text;
  for (const StandingScene& s : scenes)
    text += (text.empty() ? " Each is marked at the moment that sets it apart from the others: " : "; ") +
            moment_of(s).label + ": " + moment_of(s).when;
  return text + ".";
}

// What the figure shows, from the numbers.
std::string conclusion(const std::vector<AtlasEntry>& atlas, const std::vector<StandingScene>& scenes) {
  const auto widest = [&](double zeta) {
    const AtlasEntry* best = nullptr;
    double most = 0;
    for (const AtlasEntry& e : atlas) {
      if (e.conservative) continue;
      const double limit = e.limit_at(zeta);
      if (limit < 100 && limit > most) best = &e, most = limit;
    }
    return best->methods.front() + " (" + std::to_string(most).substr(0, 5) + ")";
  };
  std::string text =
      "Stable below the line (amplification factor), blown up above the marks (the solver itself). Of the "
      "methods with a limit " +
      widest(0) + " reaches furthest without damping and " + widest(1) + " at critical damping.";
  int beyond = 0;
  const auto paper = std::find_if(atlas.begin(), atlas.end(), [](const AtlasEntry& e) {
    return std::find(e.methods.begin(), e.methods.end(), "pece") != e.methods.end();
  });
  for (const StandingScene& s : scenes) beyond += paper != atlas.end() && outside(*paper, s.point) ? 1 : 0;
  if (!scenes.empty())
    text += " Of the paper's scenes at its step, each by its fastest part with the neighbours held, " +
            std::to_string(beyond) + " of " + std::to_string(scenes.size()) + " stand outside the region of pece." +
            moments(scenes);
  return text;
}

}  // namespace

void report_atlas(Report& report, const std::vector<AtlasEntry>& atlas, const std::vector<StandingScene>& scenes) {
  Figure figure = atlas_figure(atlas, marked(scenes));
  figure.caption = conclusion(atlas, marked(scenes));
  std::vector<std::vector<Json>> rows;
  double worst = 0;
  std::string worst_of;
  int measured = 0;
  for (const AtlasEntry& e : atlas) {
    rows.push_back({joined(e.methods), real_axis(e), limit_at(e, 0), limit_at(e, 0.01), limit_at(e, 0.1),
                    limit_at(e, 0.5), limit_at(e, 1), limit_at(e, 5), percent(worst_deviation(e))});
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
  report.claim({.text = "The solver blows up at the step that the amplification factor says.",
                .value = "off by " + percent(worst) + " at worst (" + worst_of + "), of " + std::to_string(measured) +
                         " measurements",
                .aim = "less than 1 %",
                .holds = measured > 0 && !worst_of.empty() && worst < 0.01});
  report.text("Not in the atlas, since they choose their own step: " + joined(methods_outside(atlas)) + ".");
}

}  // namespace furrow::validation
