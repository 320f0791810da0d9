#include "validation/calibration/calibration.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "output/owned_directory.h"
#include "scene/read.h"
#include "scene/wording.h"

namespace furrow::validation {
namespace {

constexpr const char* kept_runs = "runs.jsonl";
constexpr std::size_t most_candidates = 5;
constexpr int most_steps = 8;   // by slopes, from what the search found
constexpr double apart = 0.02;  // of a range: settings nearer to each other are one

std::vector<Case> cases_of(const std::vector<std::filesystem::path>& files) {
  std::vector<Case> cases;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.stem().string();
    for (const Case& other : cases) {
      if (other.name == name) throw std::invalid_argument("two scenes are named " + in_quotes(name));
    }
    cases.push_back({name, read_scene(file)});
  }
  return cases;
}

// A spread over packings of scenes that have none would be that of one run, copied.
void refuse_packings(const CalibrationRequest& request, const std::vector<Case>& cases) {
  if (packed(cases)) return;
  const auto refuse = [](const char* option, int count) {
    throw std::invalid_argument(std::string(option) + " " + std::to_string(count) +
                                ": no scene has a packing, so each setting has one run and no spread; leave it out, "
                                "or give a scene with a packing");
  };
  if (request.plan.packings > 1) refuse("--packings", request.plan.packings);
  if (request.fresh.value_or(1) > 1) refuse("--fresh", *request.fresh);
}

// What is read must not be what is written.
void refuse_own_input(const CalibrationRequest& request, const std::vector<Case>& cases) {
  std::vector<std::filesystem::path> read = request.scenes;
  read.push_back(request.targets);
  for (const std::string& file : files_of_calibration(cases)) {
    const std::filesystem::path written = std::filesystem::weakly_canonical(request.directory / file);
    for (const std::filesystem::path& input : read) {
      if (std::filesystem::weakly_canonical(input) == written)
        throw std::invalid_argument("--out " + request.directory.string() + ": the result would replace " +
                                    input.string() + ", which is read; choose another --out");
    }
  }
}

// Held while the runs are made, which it keeps for a search that begins again.
std::unique_ptr<OwnedDirectory> own_directory(const CalibrationRequest& request, const std::vector<Case>& cases) {
  if (request.directory.empty()) return {};
  refuse_own_input(request, cases);
  return std::make_unique<OwnedDirectory>(request.directory, "calibration", files_of_calibration(cases),
                                          OwnedDirectory::Earlier::kept);
}

// What an earlier calibration found is no result of this one, which may end without any. The runs stay.
void remove_earlier_results(OwnedDirectory& owned, const std::vector<Case>& cases) {
  owned.keep_only({kept_runs});
  // Those that are not there yet have an empty directory: it goes too.
  for (const std::string& file : files_of_calibration(cases)) {
    if (file != kept_runs) owned.discard(file);
  }
}

bool alike(const std::vector<VariedKey>& keys, const Setting& a, const Setting& b) {
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (keys[k].listed() ? a[k] != b[k] : std::fabs(keys[k].share_of(a[k]) - keys[k].share_of(b[k])) > apart)
      return false;
  }
  return true;
}

std::vector<Point> few(const std::vector<VariedKey>& keys, const std::vector<Point>& points) {
  std::vector<Point> best;
  for (const Point& point : points) {
    const bool known =
        std::any_of(best.begin(), best.end(), [&](const Point& b) { return alike(keys, b.setting, point.setting); });
    if (!known && point.failure.empty()) best.push_back(point);
    if (best.size() == most_candidates) break;
  }
  return best;
}

// Of beds a step by slopes would fit the packings that are there.
void refine(const Evaluator& evaluator, std::vector<Point>& points) {
  for (int k = 0; k < most_steps; ++k) {
    std::optional<Point> better = stepped(evaluator, points.front(), {0, 1});
    if (!better) return;
    points.insert(points.begin(), std::move(*better));
  }
}

// Those of the best few, judged by packings that did not choose them.
std::vector<Candidate> judged(const Evaluator& evaluator, const std::vector<Point>& best, const Packings& fresh) {
  std::vector<Setting> settings;
  for (const Point& point : best) settings.push_back(point.setting);
  std::vector<Point> again = evaluator.packed() ? evaluator.at(settings, fresh) : best;
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < best.size(); ++k) candidates.push_back({best[k], std::move(again[k])});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return better(a.fresh, b.fresh); });
  refuse_unsaid(evaluator.targets(), {candidates.front().fresh});
  return candidates;
}

}  // namespace

Calibration calibrate(const CalibrationRequest& request) {
  Calibration result;
  result.cases = cases_of(request.scenes);
  for (const std::string& text : request.vary) result.keys.push_back(VariedKey::of(text));
  judge_keys(result.keys, result.cases);
  refuse_packings(request, result.cases);
  std::vector<std::string> names;
  for (const Case& of : result.cases) names.push_back(of.name);
  result.targets = read_targets(request.targets, names);
  const std::unique_ptr<OwnedDirectory> owned = own_directory(request, result.cases);
  double all = 1;
  Runs runs(request.directory, request.plan.jobs,
            [&](long made) { return !request.progress || request.progress(static_cast<double>(made), all); });
  const Evaluator evaluator(result.cases, result.keys, result.targets, runs);
  if (owned) remove_earlier_results(*owned, result.cases);
  const Packings fresh =
      evaluator.packed() ? Packings{request.plan.packings, request.fresh.value_or(usual_fresh)} : Packings{0, 1};
  const int by_slopes = evaluator.packed() ? 0 : most_steps * runs_to_step(evaluator, 1);
  all = static_cast<double>(runs_of(request.plan, evaluator) + by_slopes + runs_to_identify(evaluator, fresh.count) +
                            static_cast<long>(most_candidates) * evaluator.runs_a_point(fresh.count));
  std::vector<Point> points = search(evaluator, request.plan);
  if (!evaluator.packed()) refine(evaluator, points);
  result.points = std::ssize(points);
  result.failed = std::count_if(points.begin(), points.end(), [](const Point& p) { return !p.failure.empty(); });
  result.best = judged(evaluator, few(result.keys, points), fresh);
  result.identified = identify(evaluator, result.best.front().fresh, fresh);
  result.made = runs.made();
  result.replayed = runs.replayed();
  if (owned) owned->conclude("searched");
  return result;
}

}  // namespace furrow::validation
