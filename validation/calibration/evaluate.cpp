#include "validation/calibration/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "report/seal.h"
#include "report/sources.h"
#include "scene/wording.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

constexpr double not_finite = 1e30;  // stands for a misfit that is not, so that a mean of several can be compared

// What decides a run beside its scene: the solver's sources, and what defines the observables.
const std::string& hash_of_sources() {
  static const std::string hash = [] {
    std::string all;
    for (const auto& [file, text] : that_decide(
             sources_of_this_program(), {"validation/page/", "src/output/first_touch.",
                                         "validation/calibration/evaluate.", "validation/calibration/targets."}))
      all += file + " " + text + "\n";
    return hash_of(all);
  }();
  return hash;
}

// Of a watched run, as `furrow run` makes it: one that leaves the validity of its laws is no result.
Json asked_of(const Scene& scene, const std::vector<const CalibrationTarget*>& asked) {
  Prepared prepared = prepare(scene);
  const Timing time = prepared.scene.time;
  const RunRecord run = observed_run(std::move(prepared), time, Watch::on);
  if (!run.finished()) throw Divergence(run.fact("reason")->texts.at(0));
  Json values = Json::object();
  for (const CalibrationTarget* target : asked) values[target->asked()] = value_of(*target, run);
  return values;
}

// As a result of its own, so that a setting without any is known from one that could not be made.
Json judged_of(const Scene& scene, const std::vector<const CalibrationTarget*>& asked) {
  try {
    return asked_of(scene, asked);
  } catch (const Divergence& fault) {
    return {{"failed", fault.what()}, {"diverged", true}};
  }
}

using Way = std::array<double, 3>;  // velocity of the first plate, m/s; time, s

Way way_of(const Scene& scene) { return {scene.plate[0].velocity.x, scene.plate[0].velocity.y, scene.time.end}; }

// Every combination of the ends of those keys that change the way of the plate.
std::vector<Setting> farthest_settings(const Case& of, const std::vector<VariedKey>& keys) {
  const Setting middle = combinations(keys).front();
  std::vector<Setting> all{middle};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    std::vector<Setting> longer;
    bool changes = false;
    for (const std::string& value : keys[k].ends()) {
      Setting one = middle;
      one[k] = value;
      changes = changes || way_of(scene_with(of, keys, one, 0)) != way_of(scene_with(of, keys, middle, 0));
      for (Setting some : all) {
        some[k] = value;
        longer.push_back(std::move(some));
      }
    }
    if (changes) all = std::move(longer);
  }
  return all;
}

// By the setting that takes the plate the farthest, mm.
double farthest_reach(const Case& of, const std::vector<VariedKey>& keys) {
  double reach = 0;
  for (const Setting& setting : farthest_settings(of, keys)) {
    const Way way = way_of(scene_with(of, keys, setting, 0));
    reach = std::max(reach, 1e3 * std::hypot(way[0], way[1]) * way[2]);
  }
  return reach;
}

void judge_reach(const CalibrationTarget& target, const Case& of, const std::vector<VariedKey>& keys) {
  if (of.scene.plate.empty()) throw std::invalid_argument(of.name + ": has no plate whose force could be compared");
  const double wanted = target.curve ? target.curve->mm.back() : target.window ? (*target.window)[1] : 0;
  if (wanted == 0) return;
  const double reach = farthest_reach(of, keys);
  if (wanted > reach * (1 + 1e-9))
    throw std::invalid_argument("target " + in_quotes(target.name) + " asks for " + rounded(wanted, 6) +
                                " mm of displacement, but in " + of.name + " the plate goes " + rounded(reach, 6) +
                                " mm; let time.end be later, or cut the target");
}

}  // namespace

double Point::misfit() const {
  return std::accumulate(misfits.begin(), misfits.end(), 0.0) / static_cast<double>(misfits.size());
}

double Point::spread() const {
  if (misfits.size() < 2) return NAN;
  double sum = 0;
  for (const double m : misfits) sum += (m - misfit()) * (m - misfit());
  return std::sqrt(sum / static_cast<double>(misfits.size() - 1));
}

bool packed(const std::vector<Case>& cases) {
  return std::any_of(cases.begin(), cases.end(), [](const Case& of) { return !of.scene.packing.empty(); });
}

bool whole(const Point& point) { return point.failure.empty() && point.unsaid == 0; }

bool better(const Point& a, const Point& b) {
  if (a.failure.empty() != b.failure.empty()) return a.failure.empty();
  if (a.unsaid != b.unsaid) return a.unsaid < b.unsaid;
  return a.misfit() != b.misfit() ? a.misfit() < b.misfit() : a.setting < b.setting;
}

void refuse_unsaid(const Targets& targets, const std::vector<Point>& points) {
  for (std::size_t k = 0; k < targets.all.size(); ++k) {
    const CalibrationTarget& target = targets.all[k];
    const auto says = [&](const Json& values) { return comparable(target, values[k]); };
    const auto any = [&](const Point& p) { return std::any_of(p.values.begin(), p.values.end(), says); };
    if (std::any_of(points.begin(), points.end(), any)) continue;
    const auto failed = std::find_if(points.begin(), points.end(), [](const Point& p) { return !p.failure.empty(); });
    throw NothingCompared("no run says target " + in_quotes(target.name) + " of " + target.scene + ", in " +
                          std::to_string(points.size()) + (points.size() == 1 ? " setting" : " settings") +
                          (failed == points.end() ? "" : ", of which some failed, one so: " + failed->failure) +
                          (target.curve || target.window ? ": let the plate go through all of its displacements"
                                                         : ": vary other keys or ranges, or leave the target out"));
  }
}

void require_values(const Point& point, const Targets& targets, int packings) {
  const auto wanted = static_cast<std::size_t>(packings);
  bool fits = point.values.size() == wanted && point.misfits.size() == wanted;
  for (const Json& values : point.values) fits = fits && values.size() == targets.all.size();
  if (!fits)
    throw std::logic_error("a point has the values of " + std::to_string(point.values.size()) + " packings, not of " +
                           std::to_string(packings) + ", or not one of each target");
}

Evaluator::Evaluator(std::vector<Case> cases, std::vector<VariedKey> keys, Targets targets, Runs& runs)
    : cases_(std::move(cases)), keys_(std::move(keys)), targets_(std::move(targets)), runs_(runs) {
  for (const CalibrationTarget& target : targets_.all) {
    for (const Case& of : cases_) {
      if (of.name == target.scene) judge_reach(target, of, keys_);
    }
  }
}

bool Evaluator::packed() const { return furrow::validation::packed(cases_); }

int Evaluator::runs_a_point(int packings) const {
  int runs = 0;
  for (const Case& of : cases_) runs += of.scene.packing.empty() ? 1 : packings;
  return runs;
}

Task Evaluator::task(const Case& of, const Setting& setting, int packing) const {
  const int seed = of.scene.packing.empty() ? 0 : packing;
  std::vector<const CalibrationTarget*> asked;
  std::string wanted;
  for (const CalibrationTarget& target : targets_.all) {
    if (target.scene != of.name) continue;
    asked.push_back(&target);
    wanted += target.asked() + "\n";
  }
  const Scene scene = scene_with(of, keys_, setting, seed);
  return {of.name + (seed > 0 ? " packing " + std::to_string(seed) : "") + " " + text_of(keys_, setting),
          [scene, asked] { return judged_of(scene, asked); },
          hash_of(hash_of_scene(scene) + "\n" + hash_of_sources() + "\n" + wanted)};
}

Point Evaluator::at(const Setting& setting, const Packings& packings) const {
  return at(std::vector<Setting>{setting}, packings).at(0);
}

std::vector<Point> Evaluator::at(const std::vector<Setting>& settings, const Packings& packings) const {
  if (packings.count != 1 && !packed())
    throw std::logic_error("scenes without a packing have one run a setting, not " + std::to_string(packings.count));
  std::vector<Task> tasks;
  for (const Setting& setting : settings) {
    for (int p = packings.first; p < packings.first + packings.count; ++p) {
      for (const Case& of : cases_) tasks.push_back(task(of, setting, p));
    }
  }
  const std::vector<Json> results = runs_.of(tasks);
  std::vector<Point> points;
  auto next = results.begin();
  for (const Setting& setting : settings) {
    points.push_back({.setting = setting, .values = {}, .misfits = {}, .failure = {}});
    for (int p = 0; p < packings.count; ++p, next += std::ssize(cases_))
      take({next, next + std::ssize(cases_)}, points.back());
  }
  return points;
}

// What the scenes gave with one packing, in the order of the targets.
void Evaluator::take(const std::vector<Json>& runs, Point& point) const {
  Json values = Json::array();
  for (const CalibrationTarget& target : targets_.all) {
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      if (cases_[c].name != target.scene) continue;
      if (runs[c].contains("failed")) {
        point.diverged = (point.failure.empty() || point.diverged) && runs[c].value("diverged", false);
        point.failure = cases_[c].name + ": " + runs[c]["failed"].get<std::string>();
      }
      values.push_back(runs[c].value(target.asked(), Json()));
      point.unsaid += comparable(target, values.back()) ? 0 : 1;
    }
  }
  const double misfit = furrow::validation::misfit(targets_, values);
  if (!std::isfinite(misfit) && point.failure.empty()) point.failure = "its misfit is not finite";
  point.misfits.push_back(std::isfinite(misfit) ? misfit : not_finite);
  point.values.push_back(std::move(values));
}

}  // namespace furrow::validation
