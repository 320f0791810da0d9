#include "verification/studies/scenes_stability.h"

#include "report/cases.h"
#include "run/stiffness.h"
#include "scene/wording.h"
#include "verification/studies/kept_numbers.h"

namespace furrow::verification {
namespace {

struct Chosen {
  std::string name, file;
  double t;  // s
  bool bed, spheres;
  std::string key() const { return "scene " + name + " at " + shortest(t); }
};
// The moments: a scene's start, or where its parts first act on each other.
const Chosen chosen[] = {{"single spring", "single_spring", 0, false, false},
                         {"cantilever", "cantilever", 0, false, false},
                         {"scene 1", "scenario_1", 0.03, false, false},
                         {"scene 2, discs", "scenario_2", 0, true, false},
                         {"scene 2, spheres", "scenario_2", 0, true, true},
                         {"scene 3, start", "scenario_3", 0, true, false},
                         {"scene 3, plate at the lattice", "scenario_3", 3.6, true, false}};

std::vector<Chosen> chosen_in(bool quick_form) {
  std::vector<Chosen> some;
  for (const Chosen& c : chosen) {
    if (!quick_form || !c.bed) some.push_back(c);
  }
  return some;
}

// So many eigenvalues of a bed are drawn; at their rim they are those of the whole.
constexpr Eigen::Index krylov = 400;

Scene scene_of(const Chosen& c) {
  Scene scene = scene_file(c.file);
  if (c.spheres) {  // at the paper's step the bed does not settle
    scene.model.disc_mass = DiscMass::sphere;
    scene.settle->step = 1e-5;
  }
  return scene;
}

Json pair_of(std::complex<double> value, int digits) {
  return {kept(value.real(), digits), kept(value.imag(), digits)};
}

std::complex<double> complex_of(const Json& pair) { return {number(pair[0]), number(pair[1])}; }

Json steps_of(const Standing& s) {
  Json steps = Json::object();
  for (const MethodInfo& info : method_catalogue()) {
    if (!has_stable_step(s, info)) continue;
    const StableStep step = stable_step(s, info.name);
    steps[info.name] = {kept(step.predicted, 5), kept(step.measured, 5)};
  }
  return steps;
}

Json measured(const Chosen& c) {
  const Scene scene = scene_of(c);
  const Standing s = [&] {
    Standing at = standing_at(scene, c.t);
    return c.bed ? standing(std::move(at.system), at.t, std::move(at.y), krylov) : at;
  }();
  Json values = Json::array();
  for (const std::complex<double>& v : s.values)
    if (v.imag() >= 0) values.push_back(pair_of(v, 5));
  const EnergyBalance balance = run_on(s, scene.time.method, scene.time.step);
  const Oscillator part = stiffest_part(s.system, s.t, s.y).oscillator;
  return {{"own_step", scene.time.step},
          {"numbers", s.linearised.acting.size()},
          {"fastest", pair_of(s.fastest, 6)},
          {"driver", s.driver.name},
          {"how", s.driver.how},
          {"share", kept(s.driver.share, 4)},
          {"own_growth", kept(s.own_growth, 5)},
          {"values", values},
          {"steps", steps_of(s)},
          {"diverged", balance.diverged},
          {"residual", kept(balance.residual, 5)},
          {"handled", kept(balance.handled, 5)},
          {"point", {kept(part.zeta, 5), kept(part.omega * scene.time.step, 5)}}};
}

StandingScene read(const Chosen& c, const Json& json) {
  StandingScene s{.name = c.name, .t = c.t};
  if (json.contains("failed")) {
    s.failed = json["failed"];
    return s;
  }
  s.own_step = json.at("own_step");
  s.numbers = json.at("numbers");
  s.fastest = complex_of(json.at("fastest"));
  s.driver = {json.at("driver"), number(json.at("share")), json.at("how")};
  s.own_growth = json.at("own_growth");
  for (const Json& v : json.at("values")) s.values.push_back(complex_of(v));
  for (const auto& [method, v] : json.at("steps").items())  // any step is kept as none
    s.steps.push_back({method, number(v[0], infinity), number(v[1], infinity)});
  s.balance = {json.at("diverged"), number(json.at("residual")), number(json.at("handled"))};
  s.point = {number(json.at("point")[0]), number(json.at("point")[1])};
  return s;
}

}  // namespace

void measure_standing_scenes(Measurement& measurement) {
  std::vector<Task> tasks;
  for (const Chosen& c : chosen_in(measurement.quick()))
    tasks.push_back({c.key(), [c] { return measured(c); }, hash_of_scene(scene_of(c))});
  measurement.run(tasks);
}

std::vector<StandingScene> standing_scenes(const Numbers& numbers) {
  std::vector<StandingScene> scenes;
  for (const Chosen& c : chosen_in(numbers.quick())) scenes.push_back(read(c, numbers.at(c.key())));
  return scenes;
}

}  // namespace furrow::verification
