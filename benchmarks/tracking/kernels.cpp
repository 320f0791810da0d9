#include "benchmarks/tracking/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "methods/method.h"
#include "output/run_files.h"
#include "run/observe.h"
#include "run/run.h"
#include "scene/hash.h"
#include "scene/read.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

void add(Fnv1a& hash, std::span<const double> values) {
  for (const double value : values) hash.add_word(std::bit_cast<std::uint64_t>(value));
}

std::uint64_t hash_of(std::span<const double> values) {
  Fnv1a hash;
  add(hash, values);
  return hash.value();
}

struct Ready {
  explicit Ready(const Scene& from) : scene(from), system(from), y(system.initial_state()), dydt(y.size()) {}
  Scene scene;
  System system;
  State y, dydt;
};

std::shared_ptr<Ready> ready(Scene scene, bool energy, double t = 0) {
  scene.output.energy = energy;
  auto r = std::make_shared<Ready>(scene);
  r->system.jump(t, r->y);
  return r;
}

Scene lattice() { return paper_scene("scenario_1"); }
Scene discs(const fs::path& beds) { return with_bed(paper_scene("scenario_2"), beds / "scenario_2"); }
Scene discs_and_lattice(const fs::path& beds) { return with_bed(paper_scene("scenario_3"), beds / "scenario_3"); }

std::function<void(long)> times(std::function<void()> once) {
  return [once = std::move(once)](long calls) {
    for (long k = 0; k < calls; ++k) once();
  };
}

// ---- evaluations ----

Work rhs_of(const std::shared_ptr<Ready>& r, double t) {
  const auto answer = [r] { return hash_of(r->dydt); };
  const double later = t + 1e-9;  // s: the accepted answers are of this time
  return {.run = times([r, later] { r->system.rhs(later, r->y, r->dydt); }), .answer = answer, .error = {}};
}

// Half a millimetre deep in the first column of nodes.
Work rhs_lattice(const fs::path& /*beds*/) { return rhs_of(ready(lattice(), false, 0.025), 0.025); }
Work rhs_discs(const fs::path& beds) { return rhs_of(ready(discs(beds), false), 0); }
Work rhs_both(const fs::path& beds) { return rhs_of(ready(discs_and_lattice(beds), false), 0); }
Work rhs_wide(const fs::path& beds) { return rhs_of(ready(repeated(discs(beds), 10), false), 0); }

// The lattice of the first scene, 40 by 40, no two neighbours moved alike; nothing else.
Work rhs_links(const fs::path& /*beds*/) {
  Scene scene = lattice();
  scene.plate.clear();
  scene.lattice[0].rows = scene.lattice[0].columns = 40;
  scene.output.energy = false;
  auto r = std::make_shared<Ready>(scene);
  for (std::size_t i = 0; i < r->y.size(); ++i) r->y[i] += 1e-4 * static_cast<double>(i * 7 % 13);
  return rhs_of(r, 0);
}

// The whole bed jumps up by half a metre and down again, so that no neighbour list outlives a call.
Work rebuild(const fs::path& beds) {
  const auto r = ready(discs(beds), false);
  const auto height = std::make_shared<double>(0.5);  // m
  const auto sum = std::make_shared<Fnv1a>();
  const auto once = [=] {
    for (int i = 0; i < r->system.parts().disc.count(); ++i) r->y[r->system.y_of(i)] += *height;
    *height = -*height;
    r->system.rhs(0, r->y, r->dydt);
    add(*sum, r->dydt);
  };
  return {.run = times(once), .answer = [=] { return sum->value(); }, .error = {}};
}

Work jump(const fs::path& beds) {
  const auto r = ready(discs(beds), true);
  return {.run = times([=] { r->system.jump(0, r->y); }),
          .answer = [=] { return r->system.state_hash(r->y); },
          .error = {}};
}

Work observation(const fs::path& beds) {
  const auto r = ready(discs(beds), true);
  const auto sum = std::make_shared<Fnv1a>();
  const auto once = [=] {
    const Observation seen = observe(r->system, 0, r->y);
    const Energies& e = seen.energy;
    add(*sum, std::vector{seen.plate[0].x, seen.plate[0].y, e.kinetic, e.gravity, e.contact_elastic,
                          seen.momentum.angular, seen.overlap.depth});
    for (const Stress& s : disc_stresses(r->system, 0, r->y)) add(*sum, std::vector{von_mises(s)});
  };
  return {.run = times(once), .answer = [=] { return sum->value(); }, .error = {}};
}

Work reading(const fs::path& /*beds*/) {
  std::ifstream stream(fs::path(FURROW_SOURCE_DIR) / "validation/scenes/scenario_3.toml", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto scene = std::make_shared<Scene>();
  const auto answer = [=] {  // of some values only: a new key of the schema does not change it
    return hash_of(std::vector{scene->time.end, scene->material.at(0).density, scene->wall.at(2).point.x,
                               scene->lattice.at(0).shear.strength, scene->output.frames.at(5)});
  };
  return {.run = times([=] { *scene = parse_scene(text, "scenario_3"); }), .answer = answer, .error = {}};
}

// ---- steps ----

void step(Ready& r, const std::string& method, double start, long steps, double h) {
  const RunEnd end = run(r.system, *make_method(method), r.y,
                         {.start = start, .end = start + static_cast<double>(steps) * h, .step = h, .stop = {}},
                         [](double, const State&, const JumpReport&) { return true; });
  if (end.ending != Ending::finished || end.steps != steps) throw std::runtime_error("diverged: " + end.reason);
}

// m: the greatest distance of a body from where it is in `other`.
double distance(const Ready& one, const Ready& other) {
  const System& s = one.system;
  double greatest = 0;
  for (int i = 0; i < s.parts().bodies(); ++i) {
    const double x = one.y[s.x_of(i)] - other.y[s.x_of(i)], y = one.y[s.y_of(i)] - other.y[s.y_of(i)];
    greatest = std::max(greatest, std::hypot(x, y));
  }
  return greatest;
}

Work steps_of(const std::shared_ptr<Ready>& r, double start) {
  const auto fine = std::make_shared<Ready>(*r);
  const auto steps = std::make_shared<long>(0);
  const double h = r->scene.time.step;  // s
  const auto work = [=](long calls) { step(*r, "pece", start, *steps = calls, h); };
  const auto error = [=] {
    constexpr int finer = 8;
    step(*fine, "rk4", start, finer * *steps, h / finer);
    return distance(*r, *fine);
  };
  return {.run = work, .answer = [=] { return r->system.state_hash(r->y); }, .error = error};
}

Work step_lattice(const fs::path& /*beds*/) { return steps_of(ready(lattice(), true, 0.02), 0.02); }
Work step_discs(const fs::path& beds) { return steps_of(ready(discs(beds), true), 0); }
Work step_both(const fs::path& beds) { return steps_of(ready(discs_and_lattice(beds), true), 0); }
Work settling(const fs::path& beds) {
  auto r = ready(with_bed(paper_scene("scenario_2"), beds / "falling"), true);
  r->system.prepare(true);
  return steps_of(r, 0);
}

// ---- whole scenes ----

// As `furrow run` does it, files included, from the nearly settled bed.
Work scene_run(const Scene& scene, const fs::path& directory) {
  const auto hash = std::make_shared<std::uint64_t>(0);
  const auto work = [=](long steps) {
    RunRequest request{.scene_file = "profile", .scene = scene, .directory = directory};
    request.scene.time.end = static_cast<double>(steps) * scene.time.step;
    std::erase_if(request.scene.output.frames, [&](double t) { return t > request.scene.time.end; });
    const RunOutcome outcome = run_with_files(request);
    if (outcome.ended != "finished") throw std::runtime_error("diverged: " + outcome.reason);
    *hash = std::stoull(nlohmann::json::parse(outcome.json).at("state_hash").get<std::string>(), nullptr, 16);
  };
  return {.run = work, .answer = [=] { return *hash; }, .error = {}};
}

Work whole_lattice(const fs::path& beds) { return scene_run(lattice(), beds / "runs/scenario_1"); }
Work whole_discs(const fs::path& beds) { return scene_run(discs(beds), beds / "runs/scenario_2"); }
Work whole_both(const fs::path& beds) { return scene_run(discs_and_lattice(beds), beds / "runs/scenario_3"); }

}  // namespace

const std::vector<Kernel>& whole_scenes() {
  static const std::vector<Kernel> all{
      {"scenario_1", "the first scene, to its end", 12'000, whole_lattice},
      {"scenario_2", "the second scene, to its end", 45'000, whole_discs},
      {"scenario_3", "the third scene, to its end", 45'000, whole_both},
  };
  return all;
}

const std::vector<Kernel>& kernels() {
  static const std::vector<Kernel> all{
      {"rhs_scenario_1", "right-hand side, plate against the lattice", 2000, rhs_lattice},
      {"rhs_scenario_2", "right-hand side, plate in a bed of 230 discs", 200, rhs_discs},
      {"rhs_scenario_3", "right-hand side, the same with a lattice", 200, rhs_both},
      {"rhs_2300_discs", "right-hand side, bed of 2,300 discs", 20, rhs_wide},
      {"rhs_links", "right-hand side, lattice of 40 by 40 nodes alone", 40, rhs_links},
      {"neighbour_rebuild", "right-hand side with a new neighbour list, 230 discs", 60, rebuild},
      {"jump_scenario_2", "jump map after a step, 230 discs", 200, jump},
      {"step_scenario_1", "step of pece with jump and ledger, from the first touch", 600, step_lattice},
      {"step_scenario_2", "step of pece with jump and ledger", 100, step_discs},
      {"step_scenario_3", "step of pece with jump and ledger", 100, step_both},
      {"settle_230_discs", "settling, in the middle of the fall", 200, settling},
      {"observe", "all observables and the stress of every disc, 230 discs", 100, observation},
      {"read_scene", "reads and checks the third scene", 20, reading},
  };
  return all;
}

}  // namespace furrow::benchmarks
