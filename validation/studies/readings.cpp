#include "validation/studies/readings.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "run/prepare.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "validation/calibration/varied_key.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

constexpr double paper_step = 1e-4;  // s

std::vector<VariedKey> keys_of(const Alternative& alternative) {
  std::vector<VariedKey> keys;
  for (const std::string& set : alternative.set) keys.push_back(VariedKey::of(set));
  return keys;
}

// Whether a choice changes the scene at all.
bool concerns(const Choice& choice, const std::string& name) {
  static std::map<std::pair<std::string, std::string>, bool> known;
  const auto [place, fresh] = known.try_emplace({choice.id, name});
  if (fresh) {
    const Scene scene = paper_scene(name, Reading::disc, 1);
    std::set<std::string> made;
    for (const Alternative& a : choice.alternatives) made.insert(canonical_text(read_as(name, scene, a)));
    place->second = made.size() > 1;
  }
  return place->second;
}

Scene scene_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing) {
  Scene scene = paper_scene(name, Reading::disc, packing);
  for (std::size_t k = 0; k < reading.size(); ++k)
    scene =
        read_as(name, std::move(scene), the_readings().choices[k].alternatives[static_cast<std::size_t>(reading[k])]);
  if (scene.settle && scene.model.disc_mass == DiscMass::sphere) scene.settle->step = 1e-5;  // see paper_scene
  scene.time.step = step;
  return scene;
}

// Of what concerns the scene, so that two readings that make one scene share its run.
Task task_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing) {
  Interpretation concerned = reading;
  for (std::size_t k = 0; k < reading.size(); ++k) {
    if (!concerns(the_readings().choices[k], name)) concerned[k] = 0;
  }
  const Scene scene = scene_of(name, reading, step, packing);
  const std::string words = words_of(concerned);
  return {name + " dt " + shortest(step) + " packing " + std::to_string(packing) + (words.empty() ? "" : ": ") + words,
          [scene, name] {
            if (const auto wrong = problems_of(scene); !wrong.empty())
              throw std::runtime_error(wrong[0].path + ": " + wrong[0].message);
            return observed_rows(scene, name);
          },
          hash_of_observed_rows(scene, name)};
}

// Each run once, whoever asks for it.
class Once {
 public:
  explicit Once(const RunTasks& run) : run_(run) {}
  void make(const std::vector<Task>& tasks) {
    std::vector<Task> wanted;
    std::set<std::string> keys;
    for (const Task& task : tasks) {
      if (!known_.contains(task.key) && keys.insert(task.key).second) wanted.push_back(task);
    }
    const std::vector<Json> results = run_(wanted);
    for (std::size_t k = 0; k < wanted.size(); ++k) known_[wanted[k].key] = results[k];
  }
  const Json& of(const Task& task) const { return known_.at(task.key); }

 private:
  const RunTasks& run_;
  std::map<std::string, Json> known_{};
};

class Search {
 public:
  Search(const RunTasks& run, bool quick) : once_(run), quick_(quick) {
    found_.scenes = quick ? std::vector<std::string>{"scenario_1"}
                          : std::vector<std::string>{"scenario_1", "scenario_2", "scenario_3"};
  }

  ReadingsFound all() {
    const std::size_t choices = the_readings().choices.size();
    try_all({Interpretation(choices, 0)});
    try_all(changed(Interpretation(choices, 0)));
    found_.alone = found_.points.size() - 1;
    try_all(drawn());
    found_.random = found_.points.size() - 1 - found_.alone;
    for (int pass = 0; !quick_ && pass < the_readings().exchanges; ++pass) exchange();
    judge_finalists();
    found_.untorn = untorn();
    return std::move(found_);
  }

 private:
  void try_all(const std::vector<Interpretation>& readings) {
    std::vector<Task> tasks;
    for (const Interpretation& reading : readings) {
      for (const std::string& scene : found_.scenes) tasks.push_back(task_of(scene, reading, paper_step, 1));
    }
    once_.make(tasks);
    for (const Interpretation& reading : readings) {
      if (!tried_.insert(reading).second) continue;
      ReadPoint point{reading, {}};
      for (const std::string& scene : found_.scenes)
        point.said[scene] = once_.of(task_of(scene, reading, paper_step, 1));
      found_.points.push_back(std::move(point));
    }
  }

  bool matters(std::size_t choice) const {
    return std::any_of(found_.scenes.begin(), found_.scenes.end(),
                       [&](const std::string& s) { return concerns(the_readings().choices[choice], s); });
  }

  std::vector<Interpretation> changed_in(const Interpretation& from, std::size_t k) const {
    std::vector<Interpretation> all;
    for (int a = 0; a < std::ssize(the_readings().choices[k].alternatives); ++a) {
      if (a == from[k] || !matters(k)) continue;
      all.push_back(from);
      all.back()[k] = a;
    }
    return all;
  }

  std::vector<Interpretation> changed(const Interpretation& from) const {
    std::vector<Interpretation> all;
    for (std::size_t k = 0; k < from.size(); ++k) {
      for (Interpretation& one : changed_in(from, k)) all.push_back(std::move(one));
    }
    return all;
  }

  // The literal alternative with an even chance. Own arithmetic: distributions of the library differ.
  std::vector<Interpretation> drawn() const {
    std::mt19937_64 random(the_readings().seed);
    std::vector<Interpretation> all(static_cast<std::size_t>(quick_ ? 8 : the_readings().random));
    for (Interpretation& one : all) {
      for (const Choice& choice : the_readings().choices) {
        std::vector<int> others;
        for (int a = 1; a < std::ssize(choice.alternatives); ++a) {
          if (choice.alternatives[static_cast<std::size_t>(a)].drawn) others.push_back(a);
        }
        const bool literal = (random() >> 63) != 0;
        const std::uint64_t which = random();
        one.push_back(literal || others.empty() ? 0 : others[which % others.size()]);
      }
    }
    return all;
  }

  void exchange() {
    for (std::size_t k = 0; k < the_readings().choices.size(); ++k)
      try_all(changed_in(found_.best(found_.scenes).reading, k));
  }

  std::vector<Interpretation> finalists() const {
    std::vector<const ReadPoint*> order;
    for (const ReadPoint& point : found_.points) order.push_back(&point);
    std::stable_sort(order.begin(), order.end(), [&](const ReadPoint* a, const ReadPoint* b) {
      return a->misfit(found_.scenes) < b->misfit(found_.scenes);
    });
    std::vector<Interpretation> best{found_.points.front().reading};
    for (const ReadPoint* point : order) {
      if (std::ssize(best) > (quick_ ? 1 : the_readings().finalists)) break;
      if (point->reading != best.front()) best.push_back(point->reading);
    }
    return best;
  }

  void judge_finalists() {
    const std::uint64_t packings = quick_ ? 1 : static_cast<std::uint64_t>(the_readings().packings);
    const auto task = [](const std::string& scene, const Interpretation& reading, bool fine, std::uint64_t p) {
      return task_of(scene, reading, fine ? the_readings().fine_step : paper_step, 2 + p);
    };
    std::vector<Task> tasks;
    const std::vector<Interpretation> best = finalists();
    const auto each = [&](const auto& what) {
      for (const Interpretation& reading : best) {
        for (const std::string& scene : found_.scenes) {
          for (const bool fine : {false, true}) {
            for (std::uint64_t p = 0; p < (scene == "scenario_1" ? 1 : packings); ++p) what(reading, scene, fine, p);
          }
        }
      }
    };
    each([&](const Interpretation& r, const std::string& s, bool fine, std::uint64_t p) {
      tasks.push_back(task(s, r, fine, p));
    });
    once_.make(tasks);
    each([&](const Interpretation& r, const std::string& s, bool fine, std::uint64_t p) {
      if (found_.finalists.empty() || found_.finalists.back().reading != r) found_.finalists.push_back({r, {}, {}});
      Finalist& finalist = found_.finalists.back();
      (fine ? finalist.finer : finalist.said)[s].push_back(once_.of(task(s, r, fine, p)));
    });
  }

  std::vector<Json> untorn() {
    std::vector<Task> tasks;
    for (const Untorn& u : untorn_runs()) {
      Scene scene = paper_scene("scenario_1", Reading::disc, 1);
      scene.time.step = u.step;
      scene.output.energy = true;
      for (Lattice& l : scene.lattice) l.structural.strength = l.shear.strength = l.bending.strength = u.strength;
      tasks.push_back({u.key(),
                       [scene] {
                         const RunRecord run = observed_run(prepare(scene), scene.time, Watch::on);
                         return Json{{"valid", run.finished()},
                                     {"reason", run.fact("reason")->texts.at(0)},
                                     {"reached", to_digits(run.force.end(), 5)},
                                     {"torn", run.torn.size()}};
                       },
                       hash_of_scene(scene)});
    }
    once_.make(tasks);
    std::vector<Json> results;
    for (const Task& task : tasks) results.push_back(once_.of(task));
    return results;
  }

  Once once_;
  bool quick_;
  ReadingsFound found_{};
  std::set<Interpretation> tried_{};
};

}  // namespace

Scene read_as(const std::string& name, Scene scene, const Alternative& alternative) {
  Setting setting;
  const std::vector<VariedKey> keys = keys_of(alternative);
  for (const VariedKey& key : keys) {
    setting.push_back(key.values.at(0));
    if (key.name.starts_with("contact.damping"))
      scene.contact.damping_factor = scene.contact.damping = {};  // one of them
  }
  return scene_with({name, std::move(scene)}, keys, setting, 0);
}

std::string Untorn::key() const { return "scenario_1 strength " + shortest(strength) + " dt " + shortest(step); }

std::vector<Untorn> untorn_runs() {
  std::vector<Untorn> all;
  for (const double strength : {40.0, 80.0, 160.0, 1e9}) {
    for (const double step : {1e-4, 5e-5, 2e-5}) all.push_back({strength, step});
  }
  return all;
}

std::string words_of(const Interpretation& reading) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < reading.size(); ++k) {
    const Choice& choice = the_readings().choices[k];
    if (reading[k] != 0)
      words.push_back(choice.id + " " + choice.alternatives[static_cast<std::size_t>(reading[k])].name);
  }
  return joined(words);
}

const ReadPoint& ReadingsFound::best(const std::vector<std::string>& of) const {
  return *std::min_element(points.begin(), points.end(),
                           [&](const ReadPoint& a, const ReadPoint& b) { return a.misfit(of) < b.misfit(of); });
}

ReadingsFound search_readings(const RunTasks& run, bool quick) { return Search(run, quick).all(); }

void measure_readings(Measurement& measurement) {
  search_readings([&](const std::vector<Task>& tasks) { return measurement.run(tasks); }, measurement.quick());
}

}  // namespace furrow::validation
