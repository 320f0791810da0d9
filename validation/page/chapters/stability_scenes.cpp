// What do the limits of the methods mean for scenes where they stand?
#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/files.h"
#include "scene/wording.h"
#include "validation/page/chapters/stability_parts.h"

namespace furrow::validation {
namespace {

using namespace verification;

const StableStep* step_of(const StandingScene& s, const std::string& method) {
  const auto found =
      std::find_if(s.steps.begin(), s.steps.end(), [&](const StableStep& x) { return x.method == method; });
  return found == s.steps.end() ? nullptr : &*found;
}

// Between two directions of the rim along the straight line.
double radius_at(const std::vector<double>& rim, std::complex<double> z) {
  const double turned = std::arg(std::complex(z.real(), std::fabs(z.imag()))) / std::numbers::pi;  // 1/2 to 1
  const double at = std::clamp(2 * turned - 1, 0.0, 1.0) * static_cast<double>(rim.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), rim.size() - 2);
  return rim[k] + (at - static_cast<double>(k)) * (rim[k + 1] - rim[k]);
}

// Over the rim of the stable region of pece, the scenes with a bed.
Figure spectrum_figure(const std::vector<StandingScene>& scenes, const std::vector<double>& rim) {
  Figure figure{.name = "stability_spectrum", .script = "stability_spectrum.gp"};
  figure.description = "Eigenvalues of the scenes times the step, in the complex plane over the stable region of pece.";
  Json region = Json::array();
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const double angle = std::numbers::pi * (0.5 + 0.5 * static_cast<double>(k) / static_cast<double>(rim.size() - 1));
    region.push_back({rim[k] * std::cos(angle), rim[k] * std::sin(angle)});
  }
  figure.blocks["region"] = region;
  std::string text = "Eigenvalues times the scene's step. ";
  int n = 0;
  double farthest = -2.2;
  for (const StandingScene& s : scenes) {
    if (!s.of_the_paper() || !s.failed.empty()) continue;
    const std::string k = std::to_string(++n);
    Json values = Json::array();
    double left = -2.2;
    int outside = 0;
    for (const std::complex<double>& v : s.values) {
      const std::complex<double> z = s.own_step * v;
      const bool out = z.real() < 0 && std::abs(z) > radius_at(rim, z);
      outside += out ? 1 : 0;
      values.push_back({z.real(), z.imag(), out ? 1 : 0});
      left = std::min(left, 1.05 * z.real());
    }
    const Moment moment = moment_of(s);
    figure.variables["title_" + k] = moment.label + ", " + moment.when + ": " + std::to_string(outside) + " outside";
    farthest = std::min(farthest, left);
    figure.blocks["values_" + k] = values;
    text += (n > 1 ? "; " : "") + moment.label + ": the fastest at " + rounded(s.own_step * s.fastest.real(), 3) +
            ", " + std::to_string(outside) + " outside the stable region of pece";
  }
  figure.variables["panels"] = n;
  figure.variables["reach"] = farthest;
  figure.caption =
      text + ". Of large scenes the eigenvalues are those of a Krylov space: exact at the rim, a sample inside.";
  return figure;
}

void moments_table(Report& report, const std::vector<StandingScene>& scenes) {
  std::vector<std::vector<Json>> rows;
  for (const StandingScene& s : scenes) {
    if (!s.failed.empty()) continue;
    const double over = s.own_step / step_of(s, "pece")->measured;
    const Moment moment = moment_of(s);
    rows.push_back({moment.scene, moment.when + " (" + number(s.t) + " s)", over,
                    over > 1 ? "above the limit" : "below the limit", s.numbers,
                    rounded(s.fastest.real(), 4) +
                        (s.fastest.imag() != 0 ? " ± " + rounded(std::fabs(s.fastest.imag()), 4) + " i" : ""),
                    s.driver.name + " (" + s.driver.how + ", " + std::to_string(std::lround(100 * s.driver.share)) +
                        " % of the power)",
                    1e3 * s.own_step,
                    s.balance.diverged.empty() ? rounded(100 * s.balance.share(), 3) + " %" : "diverged"});
  }
  report.table(
      "Is the step of each scene below the largest stable one of the paper's method, pece? Its step over that limit, "
      "what sets the limit, and how far the energy balance of the next 200 steps is off, of the energy handled in "
      "them; what the method makes in a whole run stands with the finding.",
      {"scene", "moment", "step over limit", "verdict", "numbers", "lambda [1/s]", "driven by", "step [ms]",
       "balance off by"},
      rows);
}

std::string in_ms(double seconds) { return rounded(1e3 * seconds, 3); }

void steps_table(Report& report, const std::vector<StandingScene>& scenes) {
  std::vector<std::string> head{"method"};
  for (const StandingScene& s : scenes) head.push_back(moment_of(s).label);
  std::vector<std::vector<Json>> rows;
  for (const MethodInfo& info : method_catalogue()) {
    std::vector<Json> row{info.name};
    bool any = false;
    for (const StandingScene& s : scenes) {
      const StableStep* step = step_of(s, info.name);
      any = any || step;
      row.push_back(step ? Json(in_ms(step->predicted) + " / " + in_ms(step->measured)) : Json(nullptr));
    }
    if (any) rows.push_back(row);
  }
  report.table("Largest stable step in ms, predicted / measured.", head, rows);
}

// Of scenes that rest, the steps that have a limit.
void agreement_claim(Report& report, const std::vector<StandingScene>& scenes) {
  double worst = 0;
  std::string worst_where;
  int compared = 0;
  for (const StandingScene& s : scenes) {
    if (!s.failed.empty()) worst = HUGE_VAL, worst_where = moment_of(s).label + ", which has no numbers";
    for (const StableStep& step : s.steps) {
      if (s.own_growth > 0) break;
      if (!std::isfinite(step.predicted)) continue;  // any step
      const double off = std::fabs(step.measured / step.predicted - 1);
      ++compared;
      if (!(off <= worst))
        worst = std::isnan(off) ? HUGE_VAL : off, worst_where = step.method + " in " + moment_of(s).label;
    }
  }
  report.claim(
      {.text = "On the scenes too the step at which small changes begin to grow is the one that the spectrum predicts.",
       .value = "off by " + rounded(100 * worst, 2) + " % at worst (" + worst_where + "), of " +
                std::to_string(compared) + " pairs",
       .aim = "less than 3 %",
       .holds = compared > 0 && worst < 0.03});
}

// What is found of the paper's scenes; no aim of this page.
void tell_of_the_paper(Report& report, const std::vector<StandingScene>& scenes) {
  for (const StandingScene& s : scenes) {
    if (!s.of_the_paper() || !s.failed.empty()) continue;
    const Moment moment = moment_of(s);
    report.text(moment.scene + ", " + moment.when + ": the paper's step is " +
                rounded(s.own_step / step_of(s, "pece")->measured, 2) + " times the largest stable one of its method.");
  }
}

// The first screen: the paper's step over the largest stable one, all at one moment.
void add_headline(Report& report, const std::vector<StandingScene>& scenes) {
  std::string text;
  double most = 0;
  for (const StandingScene& s : scenes) {
    if (!s.of_the_paper() || s.t > 0 || !s.failed.empty()) continue;
    const double ratio = s.own_step / step_of(s, "pece")->measured;
    most = std::max(most, ratio);
    text += (text.empty() ? " " : "; ") + moment_of(s).scene + ": " + rounded(ratio, 2);
  }
  if (!text.empty())
    report.headline({.tile = "breaks",
                     .value = "up to " + rounded(most, 2) + " times",
                     .text = "the largest stable step of its method is what the paper's step takes, in the settled bed "
                             "as the plate starts:" +
                             text + ". Below 1 it is stable."});
}

// Of those that do not rest.
std::string exceptions(const std::vector<StandingScene>& scenes) {
  std::string text;
  for (const StandingScene& s : scenes) {
    if (s.own_growth > 0)
      text += " " + moment_of(s).label + " does not rest: small changes grow by themselves by " +
              rounded(s.own_growth, 2) +
              " a second, in the two thousand steps of a search many times over. Its measured steps are shown, but no "
              "agreement is claimed.";
  }
  return text;
}

}  // namespace

void report_scenes(Report& report, const std::vector<StandingScene>& scenes, const std::vector<double>& rim) {
  report.heading("Scenes where they stand");
  report.text(
      "Each scene is linearised at a moment: central differences of the right-hand side for all numbers that act, "
      "eigenvalues by Eigen. The predicted step is the least, over the spectrum, of the distance to the rim of the "
      "method's region; for methods that treat positions and velocities differently, the step at which their linear "
      "form grows on the whole Jacobian. The measured one is found by bisection with the method and the solver's "
      "right-hand side themselves: a random change of 1e-11 m of the scene held still must not grow." +
      exceptions(scenes));
  moments_table(report, scenes);
  report.figure(spectrum_figure(scenes, rim));
  steps_table(report, scenes);
  add_headline(report, scenes);
  agreement_claim(report, scenes);
  tell_of_the_paper(report, scenes);
}

}  // namespace furrow::validation
