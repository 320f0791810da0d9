// Where the parts of a scene stand at t = 0, for every pair of kinds.
//
// A fault is what cannot be: two discs deeper in each other than the smaller radius; the centre of a disc behind a
// wall, in a plate or in a lattice, or on a lattice's border, where no direction leads out; nodes of a lattice in one
// place; a node deeper than a tenth of its contact radius in a plate or, if it can move, behind a wall; a wall or a
// plate given twice, whose stiffness would count twice. A lesser overlap, and parts that feel nothing of each other,
// may be meant: a warning. What [allow] says of discs holds at the start too.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "physics/geometry.h"
#include "scene/border.h"
#include "scene/findings.h"
#include "scene/grid.h"
#include "scene/lattice_parts.h"
#include "scene/one_surface.h"
#include "scene/paths.h"
#include "scene/unit_vector.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double touch = 1e-9;      // of a size: rounding of places that are meant to touch
constexpr double node_depth = 0.1;  // of the contact radius
constexpr int most_reported = 5;    // faults of one kind

std::string metres(double length) { return rounded(length, 3) + " m"; }

class StartJudge {
 public:
  StartJudge(const Scene& scene, Findings& found)
      : scene_(scene), allow_(scene.allow.value_or(Allow{})), found_(found) {
    for (const Lattice& l : scene.lattice) lattice_.push_back(std::make_unique<StandingLattice>(l));
    for (const Wall& w : scene.wall) normal_.push_back(unit_vector(w.normal));
  }

  void judge() {
    judge_discs();
    for (std::size_t i = 0; i < scene_.disc.size(); ++i) judge_disc(i);
    for (std::size_t k = 0; k < lattice_.size(); ++k) judge_lattice(k);
    for (std::size_t k = 0; k < scene_.plate.size(); ++k)
      if (scene_.plate[k].lower_edge) judge_plate(k);
    for (std::size_t k = 0; k < scene_.wall.size(); ++k) judge_wall(k);
    tell_overlaps();
  }

 private:
  enum Kind { pair_of_discs, in_plate, in_lattice, on_border, node_in_plate, node_behind, one_place, kinds };

  void fault(Kind kind, const std::string& path, const std::string& message) {
    const int count = ++reported_[kind];
    if (count <= most_reported) found_.error(path, message);
    if (count == most_reported + 1) found_.error(path, "and more of this kind");
  }

  void overlap(double depth, double size, const std::string& between) {
    if (depth < 1e-6 * size) return;  // of places that are written to a few digits
    if (++overlaps_; depth / size <= deepest_) return;
    deepest_ = depth / size;
    between_ = between;
  }

  void tell_overlaps() {
    if (overlaps_ == 0) return;
    found_.warning("", std::to_string(overlaps_) + (overlaps_ == 1 ? " contact overlaps" : " contacts overlap") +
                           " at the start, the deepest by " + rounded(deepest_, 2) + " of a radius, between " +
                           between_ + ": the energy of the overlap is let loose");
  }

  // Each pair is found by its larger disc, so that a large one costs no more than what lies around it.
  void judge_discs() {
    const std::vector<Disc>& disc = scene_.disc;
    if (disc.size() < 2) return;
    std::vector<double> x, y;
    std::vector<int> all(disc.size());
    std::iota(all.begin(), all.end(), 0);
    double sum = 0;
    for (const Disc& d : disc) {
      x.push_back(d.position.x);
      y.push_back(d.position.y);
      sum += d.radius;
    }
    Grid grid;
    grid.sort(x.data(), y.data(), all, 2 * sum / static_cast<double>(disc.size()));
    for (const int i : all) {
      const double r = disc[i].radius;
      grid.in_box({x[i] - 2 * r, x[i] + 2 * r}, {y[i] - 2 * r, y[i] + 2 * r}, [&](int j) {
        if (disc[j].radius < r || (disc[j].radius == r && j > i))
          judge_pair(static_cast<std::size_t>(std::min(i, j)), static_cast<std::size_t>(std::max(i, j)));
      });
    }
  }

  void judge_pair(std::size_t i, std::size_t j) {
    const Disc &a = scene_.disc[i], &b = scene_.disc[j];
    const double dx = a.position.x - b.position.x, dy = a.position.y - b.position.y;
    const double reach = a.radius + b.radius, smaller = std::min(a.radius, b.radius);
    if (dx * dx + dy * dy >= reach * reach || (dx == 0 && dy == 0)) return;  // one place for both is reported elsewhere
    const double distance = std::sqrt(dx * dx + dy * dy), depth = reach - distance;
    if (depth > smaller * std::max(1.0, allow_.overlap.value_or(1)))
      fault(pair_of_discs, item("disc", j) + ".position",
            metres(distance) + " from " + item("disc", i) + ": they overlap by more than the smaller radius");
    else if (depth > touch * smaller)
      overlap(depth, smaller, item("disc", i) + " and " + item("disc", j));
  }

  // Centres behind a wall are reported by validate.cpp.
  void judge_disc(std::size_t i) {
    const Disc& d = scene_.disc[i];
    const Vec2 p = d.position;
    const auto lesser = [&](double distance, const char* list, std::size_t k) {
      const double depth = d.radius - distance;
      if (depth > touch * d.radius) overlap(depth, d.radius, item("disc", i) + " and " + item(list, k));
    };
    for (std::size_t k = 0; k < scene_.wall.size(); ++k) lesser(distance_to_wall(k, p), "wall", k);
    for (std::size_t k = 0; k < scene_.plate.size(); ++k) {
      if (!scene_.plate[k].lower_edge) continue;
      const double distance = distance_to_plate(k, p);
      if (distance <= 0 && !allow_.through_plates)
        fault(in_plate, item("disc", i) + ".position", "the centre is inside " + item("plate", k));
      else
        lesser(distance, "plate", k);
    }
    for (std::size_t k = 0; k < lattice_.size(); ++k) {
      if (!lattice_[k]->box().holds(p, d.radius)) continue;
      const auto [distance, inside] = lattice_[k]->of(p);
      if (distance <= touch * d.radius)
        fault(on_border, item("disc", i) + ".position", "the centre is on the border of " + item("lattice", k));
      else if (inside && !allow_.through_lattices)
        fault(in_lattice, item("disc", i) + ".position", "the centre is inside " + item("lattice", k));
      else
        lesser(distance, "lattice", k);
    }
  }

  double distance_to_wall(std::size_t k, Vec2 p) const {
    return nearest_on_wall(p, scene_.wall[k].point, normal_[k]).distance;
  }

  double distance_to_plate(std::size_t k, Vec2 p) const {
    const Plate& r = scene_.plate[k];
    return nearest_on_rectangle(p, {r.left_edge, r.left_edge + r.width, *r.lower_edge, *r.lower_edge + r.height})
        .distance;
  }

  void judge_lattice(std::size_t k) {
    const Lattice& l = scene_.lattice[k];
    const StandingLattice& here = *lattice_[k];
    const std::vector<Held> held = held_nodes(l);
    for (int row = 0; row < l.rows; ++row)
      for (int column = 0; column < l.columns; ++column) judge_node(k, row, column, held[here.index(row, column)]);
    if (!l.node.empty()) judge_places(k);
    for (std::size_t j = 0; j < k; ++j)
      if (here.box().meets(lattice_[j]->box()) && here.crosses(*lattice_[j]))
        found_.warning(item("lattice", k), "crosses " + item("lattice", j) + ": lattices do not feel each other");
  }

  std::string node_path(std::size_t k, int row, int column) const {
    return item("lattice", k) + ": node (row " + std::to_string(row) + ", column " + std::to_string(column) + ")";
  }

  void judge_node(std::size_t k, int row, int column, const Held& held) {
    const Lattice& l = scene_.lattice[k];
    const Vec2 p = lattice_[k]->nodes()[lattice_[k]->index(row, column)];
    const auto judge_depth = [&](Kind kind, double depth, const char* where, const char* list, std::size_t j) {
      if (depth > node_depth * l.contact_radius)
        fault(kind, item("lattice", k),
              "its node of row " + std::to_string(row) + " and column " + std::to_string(column) + " is " +
                  metres(depth) + where + item(list, j));
      else if (depth > touch * l.contact_radius)
        overlap(depth, l.contact_radius, node_path(k, row, column) + " and " + item(list, j));
    };
    for (std::size_t j = 0; j < scene_.plate.size(); ++j)
      if (scene_.plate[j].lower_edge) judge_depth(node_in_plate, -distance_to_plate(j, p), " inside ", "plate", j);
    if (scene_.wall.empty() || held.fixed()) return;
    for (std::size_t j = 0; j < scene_.wall.size(); ++j)
      judge_depth(node_behind, -distance_to_wall(j, p), " behind ", "wall", j);
  }

  // A link of no length has no direction.
  void judge_places(std::size_t k) {
    const Lattice& l = scene_.lattice[k];
    const std::vector<Vec2>& node = lattice_[k]->nodes();
    std::set<std::pair<double, double>> places;
    for (const Vec2& p : node)
      if (!places.insert({p.x, p.y}).second)
        fault(one_place, item("lattice", k),
              "two of its nodes are in one place, (" + shortest(p.x) + ", " + shortest(p.y) + ") m");
    for (const NodeSetting& s : l.node)
      for (int row = std::max(0, s.row - 2); row <= std::min(l.rows - 1, s.row + 2); ++row)
        for (int column = std::max(0, s.column - 2); column <= std::min(l.columns - 1, s.column + 2); ++column) {
          const Vec2 a = node[lattice_[k]->index(s.row, s.column)], b = node[lattice_[k]->index(row, column)];
          const double distance = std::hypot(a.x - b.x, a.y - b.y);
          if (distance > 0 && distance < touch * l.spacing)
            fault(one_place, item("lattice", k), "two of its nodes are only " + metres(distance) + " apart");
        }
  }

  std::array<Vec2, 4> corners(std::size_t k) const {
    const Plate& p = scene_.plate[k];
    const double left = p.left_edge, right = left + p.width, lower = *p.lower_edge, upper = lower + p.height;
    return {{{left, lower}, {right, lower}, {right, upper}, {left, upper}}};
  }

  void judge_plate(std::size_t k) {
    const Plate& p = scene_.plate[k];
    const std::string path = item("plate", k);
    const double size = touch * std::min(p.width, p.height);
    for (std::size_t j = 0; j < scene_.wall.size(); ++j) {
      int behind = 0, on = 0;
      for (const Vec2& corner : corners(k)) {
        const double distance = distance_to_wall(j, corner);
        behind += distance < -size;
        on += std::fabs(distance) <= size;
      }
      if (behind > 0) found_.warning(path, "reaches behind " + item("wall", j) + ": they do not feel each other");
      if (on == 2 && !are_one_surface(scene_, p, normal_[j]))
        found_.warning(path,
                       "shares a surface with " + item("wall", j) + ": what lies on their common edge feels both");
    }
    for (std::size_t j = 0; j < k; ++j)
      if (scene_.plate[j].lower_edge) judge_plates(k, j, size);
    for (std::size_t j = 0; j < lattice_.size(); ++j)
      if (stands_in(k, *lattice_[j]))
        found_.warning(path, "stands in " + item("lattice", j) + ", whose nodes alone feel it");
  }

  void judge_plates(std::size_t k, std::size_t j, double size) {
    const Plate &a = scene_.plate[k], &b = scene_.plate[j];
    const std::string path = item("plate", k), other = item("plate", j);
    const double across = std::min(a.left_edge + a.width, b.left_edge + b.width) - std::max(a.left_edge, b.left_edge);
    const double up =
        std::min(*a.lower_edge + a.height, *b.lower_edge + b.height) - std::max(*a.lower_edge, *b.lower_edge);
    const bool same =
        a.left_edge == b.left_edge && a.lower_edge == b.lower_edge && a.width == b.width && a.height == b.height;
    if (same)
      found_.error(path, "in the place of " + other + ": what touches one touches both");
    else if (across > size && up > size)
      found_.warning(path, "overlaps " + other + ": what touches both feels both");
    else if (((across > size && up >= -size) || (up > size && across >= -size)) && !are_one_surface(scene_, a, b))
      found_.warning(path, "shares a surface with " + other + ": what lies on their common edge feels both");
  }

  bool stands_in(std::size_t k, const StandingLattice& l) const {
    const auto corner = corners(k);
    Box box;
    for (const Vec2& p : corner) box.add(p);
    if (!box.meets(l.box())) return false;
    if (std::any_of(corner.begin(), corner.end(), [&](Vec2 p) { return l.of(p).inside; })) return true;
    for (std::size_t c = 0; c < 4; ++c)
      if (l.crosses(corner[c], corner[(c + 1) % 4])) return true;
    return false;
  }

  void judge_wall(std::size_t k) {
    for (std::size_t j = 0; j < k; ++j) {
      const double across = normal_[k].x * normal_[j].y - normal_[k].y * normal_[j].x;
      const bool same_side = normal_[k].x * normal_[j].x + normal_[k].y * normal_[j].y > 0;
      if (std::fabs(across) > touch || !same_side) continue;
      const Vec2 p = scene_.wall[k].point;
      const double distance = distance_to_wall(j, p);
      const double size = touch * std::max({std::fabs(p.x), std::fabs(p.y), 1e-3});
      if (std::fabs(distance) <= size)
        return found_.error(item("wall", k), "the same as " + item("wall", j) + ": its stiffness would count twice");
      const std::size_t behind = distance < 0 ? k : j;
      if (across == 0 && hidden_.insert(behind).second)
        found_.warning(item("wall", behind), "lies behind " + item("wall", behind == k ? j : k));
    }
  }

  const Scene& scene_;
  Allow allow_;
  Findings& found_;
  std::vector<std::unique_ptr<StandingLattice>> lattice_;
  std::vector<Vec2> normal_;      // of the walls, of length 1
  std::set<std::size_t> hidden_;  // walls behind another
  std::array<int, kinds> reported_{};
  long overlaps_ = 0;
  double deepest_ = 0;  // share of a radius
  std::string between_;
};

}  // namespace

void judge_start(const Scene& scene, Findings& found) {
  if (found.any_error()) return;  // a scene that is wrong elsewhere may have no places
  for (const char* list : {"disc", "wall", "plate", "lattice"})
    if (!found.known(list)) return;
  StartJudge(scene, found).judge();
  judge_paths(scene, found);
}

}  // namespace furrow
