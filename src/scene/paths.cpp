// Where plates and driven nodes go. Their motion is given, so they feel nothing of walls, of each other and of nodes that
// are held: what one of them passes through until the end of the run is said.
#include "scene/paths.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "physics/ramp.h"
#include "scene/border.h"
#include "scene/lattice_parts.h"
#include "scene/unit_vector.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double touch = 1e-9;    // of a plate's side: rounding of what is flush
constexpr int pieces = 64;        // of a path, straight, while speeds rise
constexpr double nowhere = 1e-3;  // m: a length where there is no plate

// A plate or a node, and its motion.
struct Mover {
  Box box;      // m, at the start
  Vec2 v;       // m/s
  double ramp;  // s
  Vec2 moved(double t) const {
    const double time = ramped(t, ramp).time;
    return {v.x * time, v.y * time};
  }
};

std::vector<double> times_of(double end, double ramp) {
  std::vector<double> times;
  const double last = std::min(ramp, end);
  for (int k = 0; k <= pieces; ++k) times.push_back(last * k / pieces);
  times.push_back(end);
  return times;
}

// The first time at which `goes`, of the share of a piece between two times, finds something; infinity: never.
template <class Goes>
double first_time(double end, double ramp, const Goes& goes) {
  const std::vector<double> times = times_of(end, ramp);
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double share = goes(times[k - 1], times[k]);
    if (share <= 1) return times[k - 1] + share * (times[k] - times[k - 1]);
  }
  return infinity;
}

// While one interval moves by `way` along another: the shares of the way between which they overlap.
struct Shares {
  double enters = 0, leaves = 1;
  void clip(double lower, double upper, double other_lower, double other_upper, double way) {
    if (way == 0) {
      if (!(lower < other_upper && other_lower < upper)) leaves = -1;
      return;
    }
    const double one = (other_lower - upper) / way, another = (other_upper - lower) / way;
    enters = std::max(enters, std::min(one, another));
    leaves = std::min(leaves, std::max(one, another));
  }
};

// s: when the one first is inside the other; 0: from the start on.
double meeting(const Mover& a, const Mover& b, double end) {
  return first_time(end, std::max(a.ramp, b.ramp), [&](double from, double to) {
    const Vec2 start = a.moved(from) - b.moved(from), way = a.moved(to) - b.moved(to) - start;
    Shares s;
    s.clip(a.box.left + start.x, a.box.right + start.x, b.box.left, b.box.right, way.x);
    s.clip(a.box.lower + start.y, a.box.upper + start.y, b.box.lower, b.box.upper, way.y);
    return s.enters < s.leaves ? s.enters : infinity;
  });
}

double passing(const Mover& a, const Wall& wall, double end) {
  const Vec2 n = unit_vector(wall.normal);
  const double x = n.x > 0 ? a.box.left : a.box.right, y = n.y > 0 ? a.box.lower : a.box.upper;
  const double size = std::min(a.box.right - a.box.left, a.box.upper - a.box.lower);
  const double height = (n.x == 0 ? 0 : (x - wall.point.x) * n.x) + (n.y == 0 ? 0 : (y - wall.point.y) * n.y) +
                        touch * (size > 0 ? size : nowhere);
  if (height < 0) return 0;
  return first_time(end, a.ramp, [&](double from, double to) {
    const double before = height + dot(a.moved(from), n), after = height + dot(a.moved(to), n);
    return after < 0 ? before / (before - after) : infinity;
  });
}

class PathJudge {
 public:
  PathJudge(const Scene& scene, Findings& found) : scene_(scene), found_(found) {
    for (const Plate& p : scene.plate) plate_.push_back(mover_of(p));
  }

  void judge() {
    for (std::size_t k = 0; k < plate_.size(); ++k) {
      for (std::size_t j = 0; j < scene_.wall.size(); ++j)
        if (placed(k) || scene_.wall[j].normal.y == 0)
          tell(item("plate", k), "reaches behind " + item("wall", j), passing(plate_[k], scene_.wall[j], end()));
      for (std::size_t j = 0; j < k; ++j)
        if (placed(k) && placed(j))
          tell(item("plate", k), "reaches into " + item("plate", j), meeting(plate_[k], plate_[j], end()));
    }
    for (std::size_t k = 0; k < scene_.lattice.size(); ++k) judge_lattice(k);
  }

 private:
  double end() const { return scene_.time.end; }
  bool placed(std::size_t plate) const { return scene_.plate[plate].lower_edge.has_value(); }

  static Mover mover_of(const Plate& p) {
    const double lower = p.lower_edge.value_or(0);
    return {{p.left_edge, p.left_edge + p.width, lower, lower + p.height}, p.velocity, p.ramp};
  }

  // What is so from the start on is said elsewhere.
  void tell(const std::string& path, const std::string& what, double when) {
    if (when > 0 && when < end())
      found_.warning(path, what + " from t = " + rounded(when, 3) + " s on: they do not feel each other");
  }

  // The nodes that plates do not move: of each kind of obstacle the first is said.
  void judge_lattice(std::size_t k) {
    const Lattice& l = scene_.lattice[k];
    const StandingLattice here(l);
    const std::vector<Held> held = held_nodes(l);
    std::vector<double> plate(plate_.size(), infinity), wall(scene_.wall.size(), infinity);
    for (std::size_t n = 0; n < held.size(); ++n) {
      if (!held[n].fixed()) continue;
      const Vec2 p = here.nodes()[n];
      Mover node{{p.x, p.x, p.y, p.y}, {}, 0};
      const bool driven = held[n].drive >= 0;
      if (driven) node.v = l.drive[held[n].drive].velocity, node.ramp = l.drive[held[n].drive].ramp;
      for (std::size_t j = 0; j < plate.size(); ++j)
        if (placed(j)) plate[j] = std::min(plate[j], meeting(plate_[j], node, end()));
      for (std::size_t j = 0; driven && j < wall.size(); ++j)
        wall[j] = std::min(wall[j], passing(node, scene_.wall[j], end()));
    }
    for (std::size_t j = 0; j < plate.size(); ++j)
      tell(item("plate", j), "passes through fixed or driven nodes of " + item("lattice", k), plate[j]);
    for (std::size_t j = 0; j < wall.size(); ++j)
      tell(item("lattice", k), "has driven nodes behind " + item("wall", j), wall[j]);
  }

  const Scene& scene_;
  Findings& found_;
  std::vector<Mover> plate_;
};

}  // namespace

void judge_paths(const Scene& scene, Findings& found) { PathJudge(scene, found).judge(); }

}  // namespace furrow
