#include "validation/calibration/evaluate.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "report/seal.h"
#include "report/sources.h"
#include "scene/wording.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

// What decides a run beside its scene: the solver's sources, and what defines the observables.
const std::string& hash_of_sources() {
  static const std::string hash = [] {
    std::string all;
    for (const auto& [file, text] :
         that_decide(sources_of_this_program(), {"validation/page/", "src/output/first_touch."}))
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
  if (!run.finished()) throw std::runtime_error(run.fact("reason")->texts.at(0));
  Json values = Json::object();
  for (const CalibrationTarget* target : asked) values[target->asked()] = value_of(*target, run);
  return values;
}

void judge_reach(const CalibrationTarget& target, const Case& of) {
  if (of.scene.plate.empty()) throw std::invalid_argument(of.name + ": has no plate whose force could be compared");
  const double speed = std::hypot(of.scene.plate[0].velocity.x, of.scene.plate[0].velocity.y);
  const double reach = 1e3 * speed * of.scene.time.end;  // mm
  const double wanted = target.curve ? target.curve->mm.back() : target.window ? (*target.window)[1] : 0;
  if (wanted > reach + 1)
    throw std::invalid_argument("target " + in_quotes(target.name) + " asks for " + rounded(wanted, 6) +
                                " mm of displacement, but in " + of.name + " the plate goes " + rounded(reach, 6) +
                                " mm");
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

Evaluator::Evaluator(std::vector<Case> cases, std::vector<VariedKey> keys, Targets targets, Runs& runs)
    : cases_(std::move(cases)), keys_(std::move(keys)), targets_(std::move(targets)), runs_(runs) {
  for (const CalibrationTarget& target : targets_.all) {
    for (const Case& of : cases_) {
      if (of.name == target.scene) judge_reach(target, of);
    }
  }
}

bool Evaluator::packed() const {
  for (const Case& of : cases_) {
    if (!of.scene.packing.empty()) return true;
  }
  return false;
}

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
          [scene, asked] { return asked_of(scene, asked); },
          hash_of(hash_of_scene(scene) + "\n" + hash_of_sources() + "\n" + wanted)};
}

Point Evaluator::at(const Setting& setting, const Packings& packings) const {
  return at(std::vector<Setting>{setting}, packings).at(0);
}

std::vector<Point> Evaluator::at(const std::vector<Setting>& settings, const Packings& packings) const {
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
    points.push_back({setting, {}, {}, {}});
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
      if (runs[c].contains("failed")) point.failure = cases_[c].name + ": " + runs[c]["failed"].get<std::string>();
      values.push_back(runs[c].value(target.asked(), Json()));
    }
  }
  point.misfits.push_back(furrow::validation::misfit(targets_, values));
  point.values.push_back(std::move(values));
}

}  // namespace furrow::validation
