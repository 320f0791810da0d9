#include "program/resolved_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/wording.h"

namespace furrow {
namespace {

// A step rounds a place x to half an ulp, at most eps/2 |x|. In the worst case all n steps round to the same side: of the
// way n v h the share eps/2 |x| / (v h) is lost.
constexpr double most_lost = 1e-3;

double size_of(Vec2 v) { return std::max(std::fabs(v.x), std::fabs(v.y)); }

class Moves {
 public:
  explicit Moves(const Scene& scene) : step_(scene.time.step) {
    fastest_ = std::fabs(scene.model.gravity) * scene.time.end;
    for (const Disc& d : scene.disc) fastest_ = std::max(fastest_, size_of(d.velocity));
    for (const Plate& p : scene.plate) fastest_ = std::max(fastest_, size_of(p.velocity));
    for (const Lattice& l : scene.lattice) {
      for (const NodeSetting& n : l.node) fastest_ = std::max(fastest_, size_of(n.velocity));
      for (const Drive& d : l.drive) fastest_ = std::max(fastest_, size_of(d.velocity));
    }
  }

  void look(const std::string& path, double far, double speed) {
    if (!found_.first.empty() || !(speed > 0)) return;
    if (std::numeric_limits<double>::epsilon() / 2 * far <= most_lost * speed * step_) return;
    found_ = {path, "so far out, " + rounded(far, 3) + " m, that a step of " + shortest(step_) + " s at " +
                        rounded(speed, 3) +
                        " m/s is lost in rounding: move the scene towards the origin, or take "
                        "longer steps"};
  }

  // What forces move may be slow for a while: the fastest part of the scene is what counts.
  double fastest() const { return fastest_; }
  const std::pair<std::string, std::string>& found() const { return found_; }

 private:
  double step_, fastest_;
  std::pair<std::string, std::string> found_{};
};

}  // namespace

std::pair<std::string, std::string> unresolved_move(const Scene& scene) {
  Moves moves(scene);
  for (std::size_t k = 0; k < scene.disc.size() && moves.found().first.empty(); ++k)
    moves.look(item("disc", k) + ".position", size_of(scene.disc[k].position), moves.fastest());
  for (std::size_t k = 0; k < scene.packing.size(); ++k)
    moves.look(item("packing", k) + ".lower_left", size_of(scene.packing[k].lower_left), moves.fastest());
  for (std::size_t k = 0; k < scene.plate.size(); ++k) {
    const Plate& p = scene.plate[k];
    const bool along_x = std::fabs(p.velocity.x) >= std::fabs(p.velocity.y);
    moves.look(item("plate", k) + (along_x || !p.lower_edge ? ".left_edge" : ".lower_edge"),
               along_x ? std::fabs(p.left_edge) : std::fabs(p.lower_edge.value_or(0)), size_of(p.velocity));
  }
  for (std::size_t k = 0; k < scene.lattice.size(); ++k)
    moves.look(item("lattice", k) + ".origin", size_of(scene.lattice[k].origin), moves.fastest());
  return moves.found();
}

}  // namespace furrow
