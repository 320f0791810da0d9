#include "scene/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>

#include "physics/geometry.h"
#include "scene/interrupt.h"
#include "scene/stem.h"
#include "scene/unit_vector.h"

namespace furrow {
namespace {

constexpr int most_for_one = 20'000;  // attempts
constexpr int unsorted = 4096;        // discs of a packing: more than these are numbered by place, see sort_by_place

// Uniform in [0, 1) with 53 bits: std::uniform_real_distribution is not the same everywhere.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// The discs placed so far, in square cells as wide as the largest disc.
class PlacedDiscs {
 public:
  PlacedDiscs(const Scene& scene, double greatest_radius) : width_(2 * greatest_radius) {
    for (const Disc& d : scene.disc) width_ = std::max(width_, 2 * d.radius);
    for (const Disc& d : scene.disc) add(d);
  }

  void add(const Disc& d) {
    cells_[{std::floor(d.position.x / width_), std::floor(d.position.y / width_)}].push_back(d);
  }

  bool free(Vec2 at, double radius) const {
    const auto overlaps = [&](const Disc& d) {
      const Vec2 between = d.position - at;
      return dot(between, between) < (d.radius + radius) * (d.radius + radius);
    };
    for (const double row : {-1, 0, 1}) {
      for (const double column : {-1, 0, 1}) {
        const auto cell = cells_.find({std::floor(at.x / width_) + column, std::floor(at.y / width_) + row});
        if (cell != cells_.end() && std::any_of(cell->second.begin(), cell->second.end(), overlaps)) return false;
      }
    }
    return true;
  }

 private:
  double width_;                                                  // m
  std::map<std::pair<double, double>, std::vector<Disc>> cells_;  // by column and row
};

bool free_of_parts(const Scene& scene, Vec2 at, double radius) {
  const auto off_wall = [&](const Wall& w) {
    return nearest_on_wall(at, w.point, unit_vector(w.normal)).distance >= radius;
  };
  const auto off_rectangle = [&](double left, double lower, double width, double height) {
    return nearest_on_rectangle(at, {left, left + width, lower, lower + height}).distance >= radius;
  };
  return std::all_of(scene.wall.begin(), scene.wall.end(), off_wall) &&
         std::all_of(scene.plate.begin(), scene.plate.end(),
                     [&](const Plate& p) {
                       return !p.lower_edge || off_rectangle(p.left_edge, *p.lower_edge, p.width, p.height);
                     }) &&
         std::all_of(scene.lattice.begin(), scene.lattice.end(), [&](const Lattice& l) {
           return off_rectangle(l.origin.x, l.origin.y, (l.columns - 1) * l.spacing, (l.rows - 1) * l.spacing);
         });
}

// False if the attempts that are left were not enough.
bool place(Scene& scene, const Packing& p, std::size_t index, long& left) {
  std::mt19937_64 random(p.seed);
  PlacedDiscs placed(scene, p.radius_max);
  for (int n = 1; n <= p.count; ++n) {
    const double radius = p.radius_min + (p.radius_max - p.radius_min) * uniform(random);
    const double width = p.upper_right.x - p.lower_left.x - 2 * radius;
    const double height = p.upper_right.y - p.lower_left.y - 2 * radius;
    Vec2 at;
    bool found = false;
    throw_if_interrupted();
    for (int attempt = 0; attempt < most_for_one && !found; ++attempt) {
      if (--left < 0) return false;
      at.x = p.lower_left.x + radius + width * uniform(random);
      at.y = p.lower_left.y + radius + height * uniform(random);
      found = placed.free(at, radius) && free_of_parts(scene, at, radius);
    }
    if (!found) {
      throw NoRoom(index, "no room for disc " + std::to_string(n) + " of " + std::to_string(p.count) +
                              " in its rectangle; make the rectangle higher");
    }
    scene.disc.push_back({.position = at, .radius = radius, .velocity = {}, .spin = 0, .material = p.material});
    placed.add(scene.disc.back());
  }
  // A large bed is numbered by place, so that neighbours are near in memory.
  if (p.count <= unsorted) return true;
  const auto before = [&](const Disc& d, const Disc& e) {
    const double column_d = std::floor(d.position.x / p.radius_max), column_e = std::floor(e.position.x / p.radius_max);
    return column_d != column_e ? column_d < column_e : d.position.y < e.position.y;
  };
  std::stable_sort(scene.disc.end() - p.count, scene.disc.end(), before);
  return true;
}

}  // namespace

std::optional<Scene> place_packings(const Scene& scene, long most_attempts) {
  Scene placed = scene;
  fill_stems(placed);
  placed.packing.clear();
  for (std::size_t k = 0; k < scene.packing.size(); ++k)
    if (!place(placed, scene.packing[k], k, most_attempts)) return {};
  return placed;
}

Scene place_packings(const Scene& scene) { return *place_packings(scene, std::numeric_limits<long>::max()); }

}  // namespace furrow
