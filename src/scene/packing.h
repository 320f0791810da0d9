// Places the discs of a packing at random.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "scene/scene.h"

namespace furrow {

// The scene with every packing turned into single discs, in the order of the packings, none of which overlaps another
// disc, a wall, a plate with a known lower edge, or a lattice. Random sequential addition; the same seed gives the same
// discs. Throws NoRoom if a rectangle has no room for its discs.
Scene place_packings(const Scene& scene);

// The same with a limit on all attempts to place a disc; nothing if they were not enough. What `check` allows itself
// takes a few seconds.
inline constexpr long most_attempts_of_a_check = 20'000'000;
std::optional<Scene> place_packings(const Scene& scene, long most_attempts);

class NoRoom : public std::runtime_error {
 public:
  NoRoom(std::size_t packing, const std::string& why)
      : std::runtime_error("packing " + std::to_string(packing) + ": " + why), packing_(packing), why_(why) {}
  std::size_t packing() const { return packing_; }
  const std::string& why() const { return why_; }

 private:
  std::size_t packing_;
  std::string why_;
};

}  // namespace furrow
