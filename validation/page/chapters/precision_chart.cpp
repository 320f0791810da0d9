#include "validation/page/chapters/precision_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "validation/page/names.h"

namespace furrow::validation {
namespace {

using namespace benchmarks;

constexpr double useless = 1;  // an error as large as what happens
constexpr std::array<double WorkPrecisionPoint::*, 2> costs{&WorkPrecisionPoint::evaluations, &WorkPrecisionPoint::cpu};
constexpr std::array<const char*, 2> cost_names{"evaluations", "cpu"};

// Line styles of the script work_precision.gp, in its order.
const std::vector<std::string> styled{
    "pece", "pec",     "pecece",           "ab2",    "pece_adaptive", "symplectic_euler", "verlet", "rk4",
    "rkc",  "pece +t", "pece_adaptive +t", "rk4 +t", "pece +e",       "pece_adaptive +e", "rk4 +e"};
const std::vector<std::string> located(styled.begin() + 9, styled.end());
const std::vector<std::string> families{"odeint Runge-Kutta", "odeint Adams", "odeint controlled", "odeint symplectic",
                                        "odeint implicit"};
constexpr int first_family_style = 21;

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::string family_of(const std::string& method) {
  if (!method.starts_with("odeint_")) return method;
  for (const MethodInfo& info : method_catalogue()) {
    if (info.name == method && info.controlled) return families[2];
  }
  for (const char* adams : {"ab", "adams"}) {
    if (method.starts_with("odeint_" + std::string(adams))) return families[1];
  }
  if (contains(method, "symplectic") || contains(method, "verlet")) return families[3];
  if (contains(method, "implicit") || contains(method, "rosenbrock")) return families[4];
  return families[0];
}

int style_of(const std::string& curve) {
  const auto family = std::find(families.begin(), families.end(), curve);
  if (family != families.end()) return first_family_style + static_cast<int>(family - families.begin());
  const auto own = std::find(styled.begin(), styled.end(), curve);
  return 1 + static_cast<int>(own - styled.begin());
}

using Winners = std::vector<std::string>;

bool wins(const Winners& winners, const std::string& name) {
  return std::find(winners.begin(), winners.end(), name) != winners.end();
}

// Of the variants that locate events the chart shows some, and those that win; all are in the tables and the data.
std::string curve_of(const WorkPrecisionCurve& method_curve, const Winners& winners) {
  if (wins(winners, method_curve.name())) return method_curve.name();
  std::string family = family_of(method_curve.method);
  if (family != method_curve.method) return family;
  const bool drawn = std::find(located.begin(), located.end(), method_curve.name()) != located.end();
  return method_curve.locate != Locate::none && !drawn ? "" : method_curve.name();
}

struct Mark {
  double cost, error, least, most;
};

struct Curve {
  std::array<std::vector<Mark>, 2> marks;  // by cost
  std::array<std::vector<double>, 2> failures;
};

void add(Curve& curve, const WorkPrecisionCurve& method_curve, bool by_force) {
  double each = NAN;  // s, of CPU an evaluation
  for (const WorkPrecisionPoint& p : method_curve.points) {
    if (p.failure.empty()) each = p.cpu / p.evaluations;
  }
  for (const WorkPrecisionPoint& p : method_curve.points) {
    const bool failed = !p.failure.empty() || p.error_by(by_force) > useless;
    if (failed) {
      curve.failures[0].push_back(p.evaluations);
      curve.failures[1].push_back(p.failure.empty() ? p.cpu : p.evaluations * each);
    } else {
      const double error = p.error_by(by_force);
      curve.marks[0].push_back({p.evaluations, error, p.evaluations, p.evaluations});
      curve.marks[1].push_back({p.cpu, error, p.cpu_least, p.cpu_most});
    }
  }
}

// What some member reaches at a cost: dearer marks that are not more accurate go.
void keep_envelope(std::vector<Mark>& marks) {
  std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.cost < b.cost; });
  double best = infinity;
  std::erase_if(marks, [&best](const Mark& m) {
    if (m.error >= best) return true;
    best = m.error;
    return false;
  });
}

std::map<std::pair<int, std::string>, Curve> curves_of(const std::vector<WorkPrecisionCurve>& method_curves,
                                                       bool by_force, const Winners& winners) {
  std::map<std::pair<int, std::string>, Curve> curves;
  for (const WorkPrecisionCurve& method_curve : method_curves) {
    const std::string family = curve_of(method_curve, winners);
    if (family.empty()) continue;
    add(curves[{style_of(family), family}], method_curve, by_force);
  }
  for (auto& [key, curve] : curves) {
    if (key.first < first_family_style) continue;
    for (std::vector<Mark>& marks : curve.marks) keep_envelope(marks);
  }
  std::erase_if(curves,
                [](const auto& entry) { return entry.second.marks[0].empty() && entry.second.failures[0].empty(); });
  return curves;
}

std::string joined(const Winners& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "none" : list;
}

Json digits(double value) {
  if (!std::isfinite(value)) return {};
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3);
  return std::round(value / unit) * unit;
}

}  // namespace

Figure precision_chart(const CaseInfo& info, const std::vector<WorkPrecisionCurve>& method_curves, double floor,
                       const WorkPrecisionPoint* paper, const std::vector<std::string>& winners) {
  Figure figure{.name = "work_precision_" + info.name, .script = "work_precision.gp"};
  figure.caption = "Error of the " + std::string(info.by_force ? "force curve" : "positions at the end") +
                   " against evaluations and CPU time. Least for the paper's own error: " + joined(winners) + ".";
  figure.description = scene_words(info.name) + ", " + without_scene(info.title) +
                       ": error against cost; the paper's error is reached for least by " + joined(winners);
  std::string names, styles, first;
  int count = 0;
  for (const char* name : cost_names) {
    figure.blocks["curves_" + std::string(name)] = Json::array();
    figure.blocks["failures_" + std::string(name)] = Json::array();
    figure.blocks["star_" + std::string(name)] = Json::array();
  }
  for (const auto& [key, curve] : curves_of(method_curves, info.by_force, winners)) {
    const bool in_front = key.second == "pece" || wins(winners, key.second);
    first += in_front ? " 1" : " 0";
    names += (count == 0 ? "" : ";") + key.second;
    styles += " " + std::to_string(key.first);
    ++count;
    for (std::size_t k = 0; k < costs.size(); ++k) {
      for (const Mark& m : curve.marks[k])
        figure.blocks["curves_" + std::string(cost_names[k])].push_back(
            {count, digits(m.cost), digits(std::max(m.error, floor)), digits(m.least), digits(m.most), key.second});
      for (const double cost : curve.failures[k])
        figure.blocks["failures_" + std::string(cost_names[k])].push_back({count, digits(cost), key.second});
    }
  }
  if (paper) {
    for (std::size_t k = 0; k < costs.size(); ++k)
      figure.blocks["star_" + std::string(cost_names[k])].push_back(
          {digits(paper->*costs[k]), digits(std::clamp(paper->error_by(info.by_force), floor, useless))});
  }
  figure.variables = {
      {"names", names}, {"styles", styles},
      {"first", first}, {"count", count},
      {"low", floor},   {"need", paper ? std::clamp(paper->error_by(info.by_force), floor, useless) : useless}};
  return figure;
}

}  // namespace furrow::validation
