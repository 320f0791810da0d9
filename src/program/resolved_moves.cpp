#include "program/resolved_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/wording.h"

namespace furrow {
namespace {

// A step rounds a place x to half an ulp, at most eps/2 |x|. In the worst case all n steps round to the same side: of the
// way n v h the share eps/2 |x| / (v h) is lost. Above a tenth the motion that was asked for is another one.
constexpr double most_lost = 0.1;

// Of a body with a given velocity, along the axis on which it moves most. What falls does not keep it.
std::string lost_move(const Timing& time, bool falls, Vec2 at, Vec2 velocity) {
  const bool along_x = std::fabs(velocity.x) >= std::fabs(velocity.y);
  if (falls && !along_x) return {};
  const double far = std::fabs(along_x ? at.x : at.y), speed = std::fabs(along_x ? velocity.x : velocity.y);
  if (!(speed > 0) || std::numeric_limits<double>::epsilon() / 2 * far <= most_lost * speed * time.step) return {};
  return "so far out, " + rounded(far, 3) + " m, that a step of " + shortest(time.step) + " s at " + rounded(speed, 3) +
         " m/s is lost in rounding: move the scene towards the origin, or take longer steps";
}

}  // namespace

std::pair<std::string, std::string> unresolved_move(const Scene& scene) {
  const bool falls = scene.model.gravity != 0;
  for (std::size_t k = 0; k < scene.disc.size(); ++k) {
    const Disc& d = scene.disc[k];
    if (std::string lost = lost_move(scene.time, falls, d.position, d.velocity); !lost.empty())
      return {item("disc", k) + ".position", lost};
  }
  for (std::size_t k = 0; k < scene.lattice.size(); ++k) {
    const Lattice& l = scene.lattice[k];
    for (const NodeSetting& n : l.node) {
      const Vec2 at{l.origin.x + n.column * l.spacing, l.origin.y + n.row * l.spacing};
      if (std::string lost = lost_move(scene.time, falls && l.gravity, at, n.velocity); !lost.empty())
        return {item("lattice", k) + ".origin", lost};
    }
  }
  return {};
}

}  // namespace furrow
