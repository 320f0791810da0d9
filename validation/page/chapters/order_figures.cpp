// Observed orders as matrices, as slopes, and the energy of an oscillator.
#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "validation/page/chapters/order_parts.h"

namespace furrow::validation {

using namespace verification;

std::string shown_order(double order) { return rounded(order, 6); }

namespace {

// Own methods of fixed steps. The first five have a style of order_slopes.gp each, any others share the last one; pec and
// pecece would lie on pece.
std::vector<std::string> drawn() {
  std::vector<std::string> names{"pece", "ab2", "verlet", "symplectic_euler", "rk4"};
  for (const MethodInfo& m : method_catalogue()) {
    const bool seen =
        m.name == "pec" || m.name == "pecece" || std::find(names.begin(), names.end(), m.name) != names.end();
    if (m.family == "own" && !m.controlled && !seen) names.push_back(m.name);
  }
  return names;
}

}  // namespace

Figure matrix_figure(const Observations& all, bool of_velocity) {
  Json cells = Json::array(), wanted = Json::array(), columns = Json::array(), rows = Json::array();
  double y = 0;
  int held = 0, count = 0;
  for (const MethodInfo& method : method_catalogue()) {
    if (method.controlled) continue;
    rows.push_back({0, y, method.name});
    double x = -1;
    for (const Problem& p : problems()) {
      ++x;
      const auto found = all.verdicts.find({method.name, p.name});
      if (found == all.verdicts.end()) {
        cells.push_back({x, y, -1, 0, "-"});
        continue;
      }
      const Verdict& v = found->second;
      const Slope& slope = of_velocity ? v.velocity : v.position;
      const bool holds = of_velocity ? v.velocity_holds : v.position_holds;
      ++count;
      held += holds ? 1 : 0;
      const bool known = slope.points >= 4;
      cells.push_back({x, y, known ? slope.value : 0, holds ? 0 : 1, known ? in_short(slope) : std::string("none")});
      const double least = of_velocity ? v.predicted->velocity : v.predicted->position;
      const double room = v.predicted->most - v.predicted->position;
      const bool open = of_velocity && v.predicted->at_least;
      wanted.push_back({x, y,
                        (open ? "≥ " : "") + shown_order(least) +
                            (room > 0 && !open ? " to " + shown_order(least + room) : std::string())});
    }
    ++y;
  }
  double x = 0;
  for (const Problem& p : problems()) columns.push_back({x++, 0, p.title});
  const std::string what = of_velocity ? "velocity" : "position";
  Figure figure{"order_of_" + what, "order_matrix.gp", {}, "orders of the " + what + ", methods by kinds of force"};
  figure.caption = "Observed order of the " + what +
                   ", in brackets its standard error in units of the last digit; below it the predicted one; " +
                   std::to_string(held) + " of " + std::to_string(count) +
                   " agree, others are framed; -: a method that cannot carry forces that depend on velocity.";
  figure.variables = {{"width", static_cast<double>(problems().size())}, {"height", y}};
  figure.blocks = {{"cells", cells}, {"wanted", wanted}, {"columns", columns}, {"rows", rows}};
  if (of_velocity)
    figure.folded = "The same of the velocity: " + std::to_string(held) + " of " + std::to_string(count) + " agree";
  return figure;
}

// What a problem's unit of time is.
bool in_contact_times(const Problem& p) { return p.touch > 0 || p.rebounds || p.name == "sticking"; }

Figure slopes_figure(const Observations& all) {
  Json points = Json::array(), theory = Json::array(), panels = Json::array(), labels = Json::array();
  double panel = 0;
  const std::vector<std::string> curves = drawn();
  for (const Problem& p : problems()) {
    double least = 1, most = 1e-16;
    std::vector<double> labelled;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const auto found = all.points.find({curves[k], p.name});
      if (found == all.points.end()) continue;
      const std::vector<Point>& series = found->second;
      for (const Point& point : series) {
        if (!(point.position > 0)) continue;
        points.push_back({panel, static_cast<double>(k), point.step / p.unit, point.position});
        least = std::min(least, point.position);
        most = std::max(most, point.position);
      }
      const Verdict& v = all.verdicts.at({curves[k], p.name});
      if (!v.predicted || v.position.points < 4) continue;
      // The predicted slope through the middle of the measured points.
      const Point& middle = series[series.size() / 2];
      const auto at = [&](const Point& end) {
        return middle.position * std::pow(end.step / middle.step, v.predicted->position);
      };
      theory.push_back(
          {panel, series.front().step / p.unit, at(series.front()), series.back().step / p.unit, at(series.back())});
      const double slope = v.predicted->position;
      if (std::find(labelled.begin(), labelled.end(), slope) != labelled.end()) continue;
      labelled.push_back(slope);
      labels.push_back({panel, series.back().step / p.unit, at(series.back()), shown_order(slope)});
    }
    panels.push_back({panel, std::pow(10, std::floor(std::log10(least))), std::pow(10, std::ceil(std::log10(most))),
                      in_contact_times(p) ? 1 : 0, p.title});
    ++panel;
  }
  Json names = Json::array();
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (all.trends.contains(curves[k])) names.push_back({static_cast<double>(k), 0, curves[k]});
  }
  const auto order = [&](const char* method, const char* p) {
    return fixed(all.verdicts.at({method, p}).position.value, 2);
  };
  Figure figure{"order_slopes",
                "order_slopes.gp",
                {},
                "error of the position against the step, a panel for each kind of force: the slopes are the orders"};
  figure.caption =
      "Error of the position, over the problem's length, against the step, over how long the contact lasts, T, or "
      "times "
      "the frequency of the spring, ω; grey: the predicted slope, with its number. On a smooth force rk4 has order " +
      order("rk4", "lattice") + ", through a Hertz contact " + order("rk4", "hertz") + ", through a damped one " +
      order("rk4", "damped_hertz") + " like pece with " + order("pece", "damped_hertz") + ".";
  figure.variables = {{"panels", panel}, {"curves", curves.size()}};
  figure.blocks = {{"points", points}, {"theory", theory}, {"panel", panels}, {"labels", labels}, {"names", names}};
  return figure;
}

Figure energy_figure(const Observations& all) {
  const auto& angles = drift_angles;
  Json points = Json::array(), theory = Json::array(), names = Json::array();
  double curve = 0;
  std::vector<double> labelled;
  for (const MethodInfo& method : method_catalogue()) {
    const auto drift = predicted_drift(method.name);
    const auto found = all.trends.find(method.name);
    if (found == all.trends.end() || found->second.drift.empty() || method.name.starts_with("odeint_rk") ||
        method.name.starts_with("odeint_ab") || method.name.starts_with("odeint_s") ||
        method.name.starts_with("odeint_v"))
      continue;
    double first = 0;  // at the greatest angle
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const double value = found->second.drift.at(k);
      if (!(std::fabs(value) > 1e-13)) continue;
      if (k == 0) first = value;
      points.push_back({curve, angles[k], std::fabs(value), value > 0 ? 1 : 0});
    }
    if (drift && drift->factor != 0) {
      for (const double angle : {angles.front(), angles.back()})
        theory.push_back({curve, angle, std::fabs(drift->factor) * std::pow(angle, drift->power)});
    }
    // Labels keep a distance of a factor; a line leads from the end of the curve to its label.
    double at = std::fabs(first);
    for (bool free = false; !free;) {
      free = true;
      for (const double other : labelled) free = free && (at > 5 * other || at < other / 5);
      if (!free) at /= 1.5;
    }
    labelled.push_back(at);
    names.push_back({curve, at, first > 0 ? 1 : 0, std::fabs(first), method.name});
    ++curve;
  }
  Figure figure{"order_energy", "order_energy.gp", {}, "relative change of energy in a period against h omega"};
  figure.caption =
      "Undamped oscillator, 64 periods: relative change of the energy in a period. Filled: gain, open: loss; "
      "grey: the leading term of the amplification.";
  figure.variables = {{"curves", curve}, {"last", angles.front()}};
  figure.blocks = {{"points", points}, {"theory", theory}, {"names", names}};
  return figure;
}

}  // namespace furrow::validation
