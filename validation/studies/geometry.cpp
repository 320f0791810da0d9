#include "validation/studies/geometry.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "report/seal.h"
#include "report/study.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

constexpr int lattice_rows = 10;
constexpr double never = 5;  // misfit of what does not happen, in units: no single miss shall outweigh all else

// ---- one setting ----

Scene scene_of(const Setting& s, const Scene& paper) {
  Scene scene = paper;
  Lattice& stem = scene.lattice.at(0);
  Plate& tool = scene.plate.at(0);
  stem.spacing = s.spacing;
  stem.contact_radius = s.contact_radius;
  stem.damper = s.full_damper ? Damper::full : Damper::axial;
  stem.tear = s.magnitude ? TearRule::magnitude : TearRule::tension;
  stem.origin = {tool.left_edge + tool.width + 0.002, 0};
  tool.lower_edge = (lattice_rows - 1) * s.spacing - s.depth;
  tool.height = s.depth + 0.05;
  return scene;
}

Json numbers_of(const Scene& scene) {
  Prepared prepared = prepare(scene);
  const Timing time = prepared.scene.time;
  const RunRecord run = observed_run(std::move(prepared), time);
  if (!run.finished()) throw Divergence(run.fact("reason")->texts.at(0));
  const std::vector<Reported> all = reported(run, the_paper(), "scenario_1");
  Json numbers = Json::array();
  for (const Target& target : targets()) {
    const double value =
        std::find_if(all.begin(), all.end(), [&](const Reported& r) { return r.id == target.id; })->ours.value;
    numbers.push_back(std::isnan(value) ? Json() : Json(to_digits(value, 4)));
  }
  while (!numbers.empty() && numbers.back().is_null()) numbers.erase(numbers.size() - 1);
  return numbers;
}

Tried tried_of(const Setting& setting, const Json& got) {
  Tried one{setting, {}, infinity};
  if (!got.is_array()) return one;
  double sum = 0;
  for (std::size_t k = 0; k < targets().size(); ++k) {
    one.numbers.push_back(k < got.size() && got[k].is_number() ? got[k].get<double>() : NAN);
    sum += std::pow(one.misfit_of(k), 2);
  }
  one.misfit = std::sqrt(sum / static_cast<double>(targets().size()));
  return one;
}

Task task_of(const Batch& batch, const Scene& paper) {
  std::string inputs;
  std::vector<Scene> scenes;
  for (const Setting& setting : batch.settings) {
    scenes.push_back(scene_of(setting, paper));
    inputs += hash_of_observed(scenes.back(), "scenario_1") + "\n";
  }
  const auto run = [scenes] {
    Json all = Json::array();
    for (const Scene& scene : scenes)
      all.push_back(result_of({.key = {}, .run = [&scene] { return numbers_of(scene); }}).first);
    return all;
  };
  return {batch.key, run, hash_of(inputs)};
}

// ---- which settings ----

// Uniform in (0, 1), from the 53 leading bits: the same on every library.
double uniform(std::mt19937_64& random) { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; }

double within(std::mt19937_64& random, double low, double high) { return low * std::pow(high / low, uniform(random)); }

Setting drawn(std::mt19937_64& random) {
  Setting s;
  s.spacing = within(random, 0.005, 0.03);
  s.depth = within(random, 0.3, 6) * s.spacing;
  s.contact_radius = within(random, 0.001, 0.1);
  s.full_damper = uniform(random) < 0.25;
  s.magnitude = uniform(random) < 0.25;
  return s;
}

// A neighbour of a good setting; `reach` shrinks from round to round.
Setting near(const Setting& s, std::mt19937_64& random, double reach) {
  Setting n = s;
  for (double* value : {&n.spacing, &n.depth, &n.contact_radius}) *value *= std::exp(reach * (2 * uniform(random) - 1));
  return n;
}

// The scene file's own is the first.
std::vector<Batch> drawn_batches(int batches, int settings, std::mt19937_64& random) {
  std::vector<Batch> all;
  for (int b = 0; b < batches; ++b) {
    all.push_back({"drawn " + std::to_string(b + 1), {}});
    for (int k = 0; k < settings; ++k) all.back().settings.push_back(b + k == 0 ? Setting() : drawn(random));
  }
  return all;
}

std::vector<Batch> neighbours_of(const std::vector<Tried>& best, int round, int settings, std::mt19937_64& random) {
  const double reach = 0.15 * std::pow(0.5, round);
  std::vector<Batch> all;
  for (std::size_t k = 0; k < 12 && k < best.size(); ++k) {
    all.push_back({"round " + std::to_string(round + 1) + " near " + std::to_string(k + 1), {}});
    for (int n = 0; n < settings; ++n) all.back().settings.push_back(near(best[k].setting, random, reach));
  }
  return all;
}

// A batch that failed as a whole has no number of any setting.
void take(Search& search, const std::vector<Batch>& batches, const std::vector<Json>& results) {
  const bool first = search.tried.empty();
  for (std::size_t b = 0; b < batches.size(); ++b) {
    for (std::size_t k = 0; k < batches[b].settings.size(); ++k)
      search.tried.push_back(
          tried_of(batches[b].settings[k], results.at(b).is_array() ? results.at(b).at(k) : results.at(b)));
  }
  if (first) search.own = search.tried.front();
  std::stable_sort(search.tried.begin(), search.tried.end(),
                   [](const Tried& a, const Tried& b) { return a.misfit < b.misfit; });
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all{{"first_impact", 238, 23.8, false},    {"free_flight_begins", 40, 2, false},
                                       {"free_flight_ends", 47, 2, false},    {"second_contact_fx", 50, 5, false},
                                       {"second_contact_fy", 150, 15, false}, {"first_structural_tear", 54, 2, true},
                                       {"fixed_links_torn", 116, 2, true}};
  return all;
}

double Tried::misfit_of(std::size_t target) const {
  if (failed()) return infinity;
  const Target& t = targets().at(target);
  const double off = numbers.at(target) - t.want;
  if (std::isnan(off)) return never;
  if (t.at_most && off < 0) return 0;
  return std::min(never, std::fabs(off) / t.unit_of_misfit);
}

Search search_geometry(bool quick, const Ask& ask) {
  std::mt19937_64 random(1);
  Search search{};
  const std::vector<Batch> first = drawn_batches(quick ? 3 : 120, quick ? 20 : 25, random);
  take(search, first, ask(first));
  for (int round = 0; round < (quick ? 1 : 4); ++round) {
    const std::vector<Batch> neighbours = neighbours_of(search.tried, round, quick ? 2 : 25, random);
    take(search, neighbours, ask(neighbours));
  }
  return search;
}

void measure_geometry(Measurement& measurement) {
  const Scene paper = scene_named("scenario_1");
  search_geometry(measurement.quick(), [&](const std::vector<Batch>& batches) {
    std::vector<Task> tasks;
    for (const Batch& batch : batches) tasks.push_back(task_of(batch, paper));
    return measurement.run(tasks);
  });
}

}  // namespace furrow::validation
