#include "validation/studies/statements.h"

#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

const std::vector<std::string> of_scene_1{"first_impact", "first_structural_tear"};
const std::vector<std::string> of_scene_2{"mean_force", "largest_force_discs"};
const std::vector<std::string> of_scene_3{"largest_force_coupled", "first_tear"};

Task task_of(const Gap& gap) {
  Scene scene = paper_scene(gap.scene, Reading::disc, 1);
  gap.change(scene);
  return {gap.key(), [gap, scene] { return only(gap.shown, observed(scene, gap.scene)); },
          hash_of_observed(scene, gap.scene)};
}

}  // namespace

std::vector<Gap> gaps(bool quick) {
  std::vector<Gap> all{
      {"lattice.damper = \"full\"", "scenario_1", of_scene_1,
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.damper = Damper::full;
       }},
      {"lattice.gravity = true", "scenario_1", of_scene_1,
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.gravity = true;
       }},
      {"lattice.tear = \"magnitude\"", "scenario_1", of_scene_1,
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.tear = TearRule::magnitude;
       }},
      {"model.pull = true", "scenario_2", of_scene_2, [](Scene& s) { s.model.pull = true; }},
      {"model.disc_mass = \"sphere\", time.step = 5e-6", "scenario_2", of_scene_2,
       [](Scene& s) {
         s.model.disc_mass = DiscMass::sphere;
         s.settle->step = 1e-5;
         s.time.step = step_for_spheres;
       }},
      {"lattice.auxiliary_points = 0", "scenario_3", of_scene_3,
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.auxiliary_points = 0;
       }},
      {"model.rolling_smoothing = 0.01", "scenario_2", of_scene_2, [](Scene& s) { s.model.rolling_smoothing = 0.01; }},
      {"plate.lower_edge = 0.075", "scenario_1", of_scene_1, [](Scene& s) { s.plate[0].lower_edge = 0.075; }},
      {"plate.working_depth = 0.03", "scenario_2", of_scene_2, [](Scene& s) { s.plate[0].working_depth = 0.03; }},
  };
  if (quick) std::erase_if(all, [](const Gap& gap) { return gap.scene != "scenario_1"; });
  return all;
}

void measure_statements(Measurement& measurement) {
  std::vector<Task> tasks;
  if (measurement.quick()) {
    for (const Member& member : paper_members(true)) tasks.push_back(member.task());
  }
  for (const Gap& gap : gaps(measurement.quick())) tasks.push_back(task_of(gap));
  measurement.run(tasks);
}

}  // namespace furrow::validation
