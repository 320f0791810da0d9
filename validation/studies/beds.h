// Settled beds of the paper's scenes, each settled once for all runs of a study that start from it.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "report/study.h"
#include "run/prepare.h"

namespace furrow::validation {

enum class Reading { disc, sphere };
inline std::string to_string(Reading reading) { return reading == Reading::disc ? "disc" : "sphere"; }

// s. Of the steps that the study of convergence tries the coarsest by which the method makes no more energy of spheres than
// `furrow run` lets pass, a tenth of what the scene was given. By the paper's it makes thousands of times all of that.
inline constexpr double step_for_spheres = 5e-6;

// The scene file, its discs read as discs or spheres, its packing with that seed. The bed of spheres settles by 1e-5 s:
// by the paper's 1e-4 s it never comes to rest.
inline Scene paper_scene(const std::string& name, Reading reading, std::uint64_t seed) {
  Scene scene = scene_named(name);
  scene.output.energy = false;
  scene.model.disc_mass = reading == Reading::disc ? DiscMass::disc : DiscMass::sphere;
  if (scene.settle && reading == Reading::sphere) scene.settle->step = 1e-5;
  for (Packing& p : scene.packing) p.seed = seed;
  return scene;
}

class Beds {
 public:
  // A copy to run. Throws what `prepare` throws, every time again.
  Prepared of(const std::string& name, Reading reading) {
    Bed* bed = nullptr;
    {
      const std::scoped_lock lock(mutex_);
      std::unique_ptr<Bed>& place = beds_[{name, reading}];
      if (!place) place = std::make_unique<Bed>();
      bed = place.get();
    }
    const std::scoped_lock lock(bed->mutex);
    if (!bed->prepared) bed->prepared.emplace(prepare(paper_scene(name, reading, 1)));
    return *bed->prepared;
  }

 private:
  struct Bed {
    std::mutex mutex;
    std::optional<Prepared> prepared;
  };
  std::mutex mutex_;
  std::map<std::pair<std::string, Reading>, std::unique_ptr<Bed>> beds_;
};

}  // namespace furrow::validation
