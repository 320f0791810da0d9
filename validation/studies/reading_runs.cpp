#include "validation/studies/reading_runs.h"

#include <set>

#include "run/prepare.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "validation/calibration/varied_key.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/sentences.h"

namespace furrow::validation {
namespace {

std::vector<VariedKey> keys_of(const Alternative& alternative) {
  std::vector<VariedKey> keys;
  for (const std::string& set : alternative.set) keys.push_back(VariedKey::of(set));
  return keys;
}

std::string with_ids(const std::string& run, const Interpretation& reading, const std::string& name) {
  const std::string ids = ids_of(concerning(reading, name));
  return run + (ids.empty() ? "" : ": ") + ids;
}

bool changes(const Choice& choice, const std::string& name) {
  const Scene scene = literal_scene(name, 1);
  std::set<std::string> made;
  for (const Alternative& a : choice.alternatives) made.insert(canonical_text(read_as(name, scene, a)));
  return made.size() > 1;
}

// Of each choice.
const std::vector<bool>& concerns_of(const std::string& name) {
  static std::map<std::string, std::vector<bool>> known;
  const auto [place, fresh] = known.try_emplace(name);
  if (fresh) {
    for (const Choice& choice : the_readings().choices) place->second.push_back(changes(choice, name));
  }
  return place->second;
}

void refuse_wrong(const Scene& scene) {
  if (const auto wrong = problems_of(scene); !wrong.empty())
    throw std::runtime_error(wrong[0].path + ": " + wrong[0].message);
}

// As `furrow run` watches it.
Json watched(const Scene& scene) {
  const RunRecord run = observed_run(prepare(scene), scene.time, Watch::on);
  const std::size_t due = run.force.even();
  return {{"valid", run.finished()},
          {"reason", run.fact("reason")->texts.at(0)},
          {"reached", to_digits(due == 0 ? 0 : run.force.mm[due - 1], 5)},
          {"torn", run.torn.size()}};
}

}  // namespace

Scene literal_scene(const std::string& name, std::uint64_t packing) {
  static std::map<std::string, Scene> known;  // to read a file and to judge it takes longer than all else here
  const auto [place, fresh] = known.try_emplace(name);
  if (fresh) place->second = scene_named("literal/" + name);
  Scene scene = place->second;
  scene.output.energy = false;
  for (Packing& p : scene.packing) p.seed = packing;
  return scene;
}

bool concerns(std::size_t choice, const std::string& name) { return concerns_of(name).at(choice); }

Interpretation concerning(const Interpretation& reading, const std::string& name) {
  Interpretation concerned = reading;
  const std::vector<bool>& concerns = concerns_of(name);
  for (std::size_t k = 0; k < reading.size(); ++k) {
    if (!concerns[k]) concerned[k] = 0;
  }
  return concerned;
}

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

Scene scene_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing) {
  Scene scene = literal_scene(name, packing);
  for (std::size_t k = 0; k < reading.size(); ++k)
    scene =
        read_as(name, std::move(scene), the_readings().choices[k].alternatives[static_cast<std::size_t>(reading[k])]);
  if (scene.settle && scene.model.disc_mass == DiscMass::sphere) scene.settle->step = 1e-5;  // see paper_scene
  scene.time.step = step;
  return scene;
}

std::string key_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing) {
  return with_ids(name + " dt " + shortest(step) + " packing " + std::to_string(packing), reading, name);
}

Task task_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing) {
  const Scene scene = scene_of(name, reading, step, packing);
  return {key_of(name, reading, step, packing),
          [scene, name] {
            refuse_wrong(scene);
            return observed_rows(scene, name);
          },
          hash_of_observed_rows(scene, name)};
}

std::string watched_key(const std::string& name, const Interpretation& reading, std::uint64_t packing) {
  return with_ids(name + " watched packing " + std::to_string(packing), reading, name);
}

Task watched_task(const std::string& name, const Interpretation& reading, std::uint64_t packing) {
  Scene scene = scene_of(name, reading, paper_step, packing);
  scene.output.energy = true;
  if (scene.allow) {  // these two end a run where without them there would be a warning: they fit the literal one alone
    scene.allow->step.reset();
    if (scene.allow->overlap < 1.0) scene.allow->overlap.reset();
  }
  return {watched_key(name, reading, packing),
          [scene] {
            refuse_wrong(scene);
            return watched(scene);
          },
          hash_of_scene(scene)};
}

bool is_valid(const Json& watched) { return watched.value("valid", false); }

std::vector<Untorn> untorn_runs() {
  std::vector<Untorn> all;
  for (const double strength : {40.0, 80.0, 160.0, 1e9}) {
    for (const double step : {1e-4, 5e-5, 2e-5}) all.push_back({strength, step});
  }
  return all;
}

Wanted wanted(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing) {
  return {key_of(name, reading, step, packing), [=] { return task_of(name, reading, step, packing); }};
}

Wanted wanted_watched(const std::string& name, const Interpretation& reading, std::uint64_t packing) {
  return {watched_key(name, reading, packing), [=] { return watched_task(name, reading, packing); }};
}

Wanted wanted(const Untorn& run) {
  Scene scene = literal_scene("scenario_1", 1);
  scene.time.step = run.step;
  scene.output.energy = true;
  for (Lattice& l : scene.lattice) l.structural.strength = l.shear.strength = l.bending.strength = run.strength;
  const std::string key = "scenario_1 strength " + shortest(run.strength) + " dt " + shortest(run.step);
  return {key, [=] { return Task{key, [scene] { return watched(scene); }, hash_of_scene(scene)}; }};
}

}  // namespace furrow::validation
