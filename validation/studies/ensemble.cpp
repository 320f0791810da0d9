#include "validation/studies/ensemble.h"

#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

Task task_of(const Change& change, int member) {
  Scene scene = paper_scene("scenario_2", Reading::disc, 201 + static_cast<std::uint64_t>(member));
  change.apply(scene, change.factor);
  return {change.key(member), [scene] { return only(few_observables, observed(scene, "scenario_2")); },
          hash_of_observed(scene, "scenario_2")};
}

std::vector<Task> tasks_of(bool quick) {
  std::vector<Task> tasks;
  for (const Member& member : paper_members(quick)) tasks.push_back(member.task());
  if (quick) return tasks;
  for (const Change& change : changes()) {
    for (int k = 0; k < changed_members; ++k) tasks.push_back(task_of(change, k));
  }
  return tasks;
}

}  // namespace

std::string Change::key(int member) const {
  return "scenario_2 disc, " + what + " times " + three_digits(factor) + " " + std::to_string(member + 1);
}

const std::vector<Change>& changes() {
  static const std::vector<Change> all = [] {
    std::vector<Change> list;
    for (const double factor : {0.5, 0.8, 1.25, 2.0}) {
      list.push_back({"stiffness", factor, [](Scene& s, double f) {
                        for (Material& m : s.material) {
                          if (m.young) *m.young *= f;
                          if (m.shear) *m.shear *= f;
                        }
                      }});
      list.push_back({"friction", factor, [](Scene& s, double f) { s.contact.friction *= f; }});
      list.push_back({"damping", factor, [](Scene& s, double f) { *s.contact.damping_factor *= f; }});
    }
    return list;
  }();
  return all;
}

std::vector<std::string> ensemble_keys(bool quick) {
  std::vector<std::string> keys;
  for (const Task& task : tasks_of(quick)) keys.push_back(task.key);
  return keys;
}

void measure_ensemble(Measurement& measurement) { measurement.run(tasks_of(measurement.quick())); }

}  // namespace furrow::validation
