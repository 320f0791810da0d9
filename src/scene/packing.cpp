#include "scene/packing.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "system/geometry.h"

namespace furrow {
namespace {

constexpr int most_attempts = 20'000;  // for one disc

// Uniform in [0, 1) with 53 bits: std::uniform_real_distribution is not the same everywhere.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// The discs placed so far, in cells as wide as the largest disc.
class PlacedDiscs {
 public:
  PlacedDiscs(const Scene& scene, const Packing& p) : left_(p.lower_left.x), lower_(p.lower_left.y) {
    double greatest = p.radius_max;
    for (const Disc& d : scene.disc) greatest = std::max(greatest, d.radius);
    cell_ = 2 * greatest;
    columns_ = static_cast<int>((p.upper_right.x - left_) / cell_) + 1;
    rows_ = static_cast<int>((p.upper_right.y - lower_) / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const Disc& d : scene.disc) add(d);
  }

  void add(const Disc& d) { cells_[row(d.position.y) * columns_ + column(d.position.x)].push_back(d); }

  bool free(double x, double y, double radius) const {
    for (int r = std::max(0, row(y) - 1); r <= std::min(rows_ - 1, row(y) + 1); ++r) {
      for (int c = std::max(0, column(x) - 1); c <= std::min(columns_ - 1, column(x) + 1); ++c) {
        for (const Disc& d : cells_[r * columns_ + c]) {
          const double dx = d.position.x - x;
          const double dy = d.position.y - y;
          if (dx * dx + dy * dy < (d.radius + radius) * (d.radius + radius)) return false;
        }
      }
    }
    return true;
  }

 private:
  int row(double y) const { return std::clamp(static_cast<int>(std::floor((y - lower_) / cell_)), 0, rows_ - 1); }
  int column(double x) const { return std::clamp(static_cast<int>(std::floor((x - left_) / cell_)), 0, columns_ - 1); }

  double left_, lower_, cell_;
  int columns_, rows_;
  std::vector<std::vector<Disc>> cells_;
};

bool free_of_parts(const Scene& scene, double x, double y, double radius) {
  for (const Wall& w : scene.wall) {
    const double length = std::sqrt(w.normal.x * w.normal.x + w.normal.y * w.normal.y);
    if (nearest_on_wall(x, y, w.point.x, w.point.y, w.normal.x / length, w.normal.y / length).distance < radius)
      return false;
  }
  for (const Plate& p : scene.plate) {
    if (!p.lower_edge) continue;
    if (nearest_on_rectangle(x, y, p.left_edge, p.left_edge + p.width, *p.lower_edge, *p.lower_edge + p.height)
            .distance < radius) {
      return false;
    }
  }
  return std::all_of(scene.lattice.begin(), scene.lattice.end(), [&](const Lattice& l) {
    return nearest_on_rectangle(x, y, l.origin.x, l.origin.x + (l.columns - 1) * l.spacing, l.origin.y,
                                l.origin.y + (l.rows - 1) * l.spacing)
               .distance >= radius;
  });
}

void place(Scene& scene, const Packing& p, std::size_t index) {
  std::mt19937_64 random(p.seed);
  PlacedDiscs placed(scene, p);
  for (int n = 0; n < p.count; ++n) {
    const double radius = p.radius_min + (p.radius_max - p.radius_min) * uniform(random);
    const double width = p.upper_right.x - p.lower_left.x - 2 * radius;
    const double height = p.upper_right.y - p.lower_left.y - 2 * radius;
    bool found = false;
    for (int attempt = 0; attempt < most_attempts && !found; ++attempt) {
      const double x = p.lower_left.x + radius + width * uniform(random);
      const double y = p.lower_left.y + radius + height * uniform(random);
      found = placed.free(x, y, radius) && free_of_parts(scene, x, y, radius);
      if (!found) continue;
      scene.disc.push_back({.position = {x, y}, .radius = radius, .velocity = {}, .spin = 0, .material = p.material});
      placed.add(scene.disc.back());
    }
    if (!found) {
      throw std::runtime_error("packing " + std::to_string(index) + ": no room for disc " + std::to_string(n + 1) +
                               " of " + std::to_string(p.count) + " in its rectangle; make the rectangle higher");
    }
  }
}

}  // namespace

Scene place_packings(const Scene& scene) {
  Scene placed = scene;
  placed.packing.clear();
  for (std::size_t k = 0; k < scene.packing.size(); ++k) place(placed, scene.packing[k], k);
  return placed;
}

}  // namespace furrow
