#include "verification/studies/scenes_stability.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "report/cases.h"
#include "run/stiffness.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "verification/studies/amplification.h"

namespace furrow::verification {
namespace {

struct Chosen {
  std::string name, file;
  double t;  // s
  bool bed, spheres;
};
// The moments: a scene's start, or where its parts first act on each other.
const Chosen chosen[] = {{"single spring", "single_spring", 0, false, false},
                         {"cantilever", "cantilever", 0, false, false},
                         {"scene 1", "scenario_1", 0.03, false, false},
                         {"scene 2, discs", "scenario_2", 0, true, false},
                         {"scene 2, spheres", "scenario_2", 0, true, true},
                         {"scene 3, start", "scenario_3", 0, true, false},
                         {"scene 3, plate at the lattice", "scenario_3", 3.6, true, false}};

// So many eigenvalues of a bed are drawn; at their rim they are those of the whole.
constexpr Eigen::Index krylov = 400;

double rounded(double value) { return std::strtod((std::ostringstream() << value).str().c_str(), nullptr); }

Scene scene_of(const Chosen& c) {
  Scene scene = scene_file(c.file);
  if (c.spheres) {  // at the paper's step the bed does not settle
    scene.model.disc_mass = DiscMass::sphere;
    scene.settle->step = 1e-5;
  }
  return scene;
}

Json measured(const Chosen& c) {
  const Scene scene = scene_of(c);
  const Standing s = [&] {
    Standing at = standing_at(scene, c.t);
    return c.bed ? standing(std::move(at.system), at.t, std::move(at.y), krylov) : at;
  }();
  Json steps = Json::array();
  for (const MethodInfo& info : method_catalogue()) {
    if (!has_stable_step(s, info)) continue;
    const StableStep step = stable_step(s, info.name);
    steps.push_back({info.name, rounded(step.predicted), rounded(step.measured)});
  }
  Json values = Json::array();
  for (const std::complex<double>& v : s.values)
    if (v.imag() >= 0) values.push_back({rounded(v.real()), rounded(v.imag())});
  const EnergyBalance balance = run_on(s, scene.time.method, scene.time.step);
  const Oscillator part = stiffest_part(s.system, s.t, s.y).oscillator;
  const std::string driver = s.driver.name + " (" + s.driver.how + ", " +
                             std::to_string(std::lround(100 * s.driver.share)) + " % of the power)";
  return {{"own_step", scene.time.step},
          {"numbers", s.linearised.acting.size()},
          {"fastest", {s.fastest.real(), s.fastest.imag()}},
          {"driver", driver},
          {"own_growth", rounded(s.own_growth)},
          {"values", values},
          {"steps", steps},
          {"diverged", balance.diverged},
          {"residual", balance.residual},
          {"handled", balance.handled},
          {"point", {part.zeta, part.omega * scene.time.step}}};
}

StandingScene read(const Chosen& c, const Json& json) {
  StandingScene s{.name = c.name, .t = c.t, .own_step = json.at("own_step"), .numbers = json.at("numbers")};
  s.fastest = {json["fastest"][0], json["fastest"][1]};
  s.driver = json["driver"];
  s.own_growth = json["own_growth"];
  for (const Json& v : json["values"]) s.values.emplace_back(v[0].get<double>(), v[1].get<double>());
  for (const Json& v : json["steps"]) s.steps.push_back({v[0], v[1], v[2]});
  s.balance = {json["diverged"], json["residual"], json["handled"]};
  s.point = {json["point"][0], json["point"][1], c.name};
  return s;
}

const StableStep* step_of(const StandingScene& s, const std::string& method) {
  const auto found =
      std::find_if(s.steps.begin(), s.steps.end(), [&](const StableStep& x) { return x.method == method; });
  return found == s.steps.end() ? nullptr : &*found;
}

std::string with_digits(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

// Over the rim of the stable region of pece, the scenes with a bed.
Figure spectrum_figure(const std::vector<StandingScene>& scenes) {
  Figure figure{.name = "stability_spectrum", .script = "stability_spectrum.gp"};
  figure.description = "Eigenvalues of the scenes times the step, in the complex plane over the stable region of pece.";
  Json region = Json::array();
  for (int k = 0; k <= 120; ++k) {
    const std::complex<double> direction = std::polar(1.0, std::numbers::pi * (0.5 + k / 240.0));
    const std::complex<double> rim = largest_stable_radius("pece", direction) * direction;
    region.push_back({rounded(rim.real()), rounded(rim.imag())});
  }
  figure.blocks["region"] = region;
  std::string text = "Eigenvalues times the scene's step. ";
  int n = 0;
  for (const StandingScene& s : scenes) {
    if (s.name.find("scene ") != 0) continue;
    const std::string k = std::to_string(++n);
    Json values = Json::array();
    double left = -2.2;
    int outside = 0;
    for (const std::complex<double>& v : s.values) {
      const std::complex<double> z = s.own_step * v;
      const bool out = z.real() < 0 && std::abs(z) > largest_stable_radius("pece", z, growth_seen, 10);
      outside += out ? 1 : 0;
      values.push_back({rounded(z.real()), rounded(z.imag()), out ? 1 : 0});
      left = std::min(left, 1.05 * z.real());
    }
    figure.variables["title_" + k] = s.name + ": " + std::to_string(outside) + " outside";
    figure.variables["reach_" + k] = rounded(left);
    figure.blocks["values_" + k] = values;
    text += (n > 1 ? "; " : "") + s.name + ": the fastest at " + with_digits(s.own_step * s.fastest.real(), 3) + ", " +
            std::to_string(outside) + " outside the stable region of pece";
  }
  figure.variables["panels"] = n;
  figure.caption =
      text + ". Of large scenes the eigenvalues are those of a Krylov space: exact at the rim, a sample inside.";
  return figure;
}

}  // namespace

std::vector<StandingScene> standing_scenes(const Settings& settings) {
  std::vector<Task> tasks;
  std::vector<const Chosen*> which;
  for (const Chosen& c : chosen) {
    if (settings.quick && c.bed) continue;
    which.push_back(&c);
    tasks.push_back({"scene " + c.name + " at " + shortest(c.t), [&c] { return measured(c); }});
  }
  const std::vector<Json> results = run_tasks("stability", settings, tasks);
  std::vector<StandingScene> scenes;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (results[k].contains("failed"))
      throw std::runtime_error(which[k]->name + ": " + results[k]["failed"].get<std::string>());
    scenes.push_back(read(*which[k], results[k]));
  }
  return scenes;
}

void report_scenes(Report& report, const std::vector<StandingScene>& scenes) {
  std::vector<std::vector<Json>> standing;
  double worst = 0;
  std::string worst_where, moving;
  int compared = 0;
  for (const StandingScene& s : scenes) {
    const StableStep& paper = *step_of(s, "pece");
    standing.push_back({s.name, s.t, s.numbers,
                        with_digits(s.fastest.real(), 4) +
                            (s.fastest.imag() != 0 ? " ± " + with_digits(std::fabs(s.fastest.imag()), 4) + " i" : ""),
                        s.driver, s.own_step, s.own_step / paper.measured,
                        s.balance.diverged.empty() ? Json(s.balance.share()) : Json("diverged")});
    if (s.own_growth > 0)
      moving +=
          " " + s.name + " does not rest: small changes grow by themselves by " + with_digits(s.own_growth, 2) +
          " a second, in the two thousand steps of a search many times over. Its measured steps are shown, but no "
          "agreement is claimed.";
    for (const StableStep& step : s.steps) {
      if (s.own_growth > 0) break;
      if (!std::isfinite(step.predicted)) continue;  // any step, or not known
      const double off = std::fabs(step.measured / step.predicted - 1);
      ++compared;
      if (!(off <= worst)) worst = std::isnan(off) ? HUGE_VAL : off, worst_where = step.method + " in " + s.name;
    }
  }
  report.heading("Scenes where they stand");
  report.text(
      "Each scene is linearised at a moment: central differences of the right-hand side for all numbers that act, "
      "eigenvalues by Eigen. The predicted step is the least, over the spectrum, of the distance to the rim of the "
      "method's region; for methods that treat positions and velocities differently, the step at which their linear "
      "form grows on the whole Jacobian. The measured one is found by bisection with the method and the solver's "
      "right-hand side themselves: a random change of 1e-11 m of the scene held still must not grow." +
      moving);
  report.figure(spectrum_figure(scenes));
  report.table(
      "What limits the step of each scene. The last two columns: the scene's own step over the largest stable one "
      "of pece, and the energy that its method makes or loses in the next 200 steps over the energy handled in them.",
      {"scene", "t [s]", "numbers", "lambda [1/s]", "driven by", "step [s]", "over the limit", "energy made up"},
      standing);
  std::vector<std::string> head{"method"};
  for (const StandingScene& s : scenes) head.push_back(s.name);
  std::vector<std::vector<Json>> rows;
  for (const MethodInfo& info : method_catalogue()) {
    std::vector<Json> row{info.name};
    bool any = false;
    for (const StandingScene& s : scenes) {
      const StableStep* step = step_of(s, info.name);
      any = any || step;
      row.push_back(step ? Json(with_digits(step->predicted, 3) + " / " + with_digits(step->measured, 3))
                         : Json(nullptr));
    }
    if (any) rows.push_back(row);
  }
  report.table("Largest stable step in seconds, predicted / measured.", head, rows);
  report.claim(
      "On the scenes too the step at which small changes begin to grow is the one that the spectrum predicts: " +
          std::to_string(compared) + " pairs, off by " + with_digits(100 * worst, 2) + " % at worst (" + worst_where +
          ").",
      compared > 0 && worst < 0.03);
  for (const StandingScene& s : scenes) {
    if (s.name.find("scene 2") != 0) continue;
    const double ratio = s.own_step / step_of(s, "pece")->measured;
    report.claim(s.name + ": the paper's step is " + with_digits(ratio, 2) +
                     " times the largest stable one of its method, and " + with_digits(100 * s.balance.share(), 3) +
                     " % of the energy handled is made up.",
                 ratio > 1);
  }
}

}  // namespace furrow::verification
