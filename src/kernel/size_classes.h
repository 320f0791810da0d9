// Discs or nodes by size, each class in a grid of its own: one large disc among many small ones then does not enlarge
// the cells of the small ones.
#pragma once

#include "scene/grid.h"
#include "system/parts.h"

namespace furrow {

class SizeClasses {
 public:
  SizeClasses() = default;
  // `bodies`: those to be found, ascending; radius: m, of all bodies; empty: all 0.
  SizeClasses(std::vector<int> bodies, const std::vector<double>& radius);

  // Sorts the bodies at x, y (m) into cells. cell: m, side of the cells; 0: greatest diameter of the class, plus reach.
  void sort(const double* x, const double* y, double reach, double cell);

  int count() const { return static_cast<int>(classes_.size()); }
  int class_of(int body) const { return class_of_[body]; }
  const std::vector<int>& bodies() const { return bodies_; }

  // Each calls visit(body) for all bodies of a class whose surface is closer than `reach` (m) to the part, and for some
  // that are not. They return the number of rows of cells visited.
  template <class Visit>
  long near_disc(int of, double x, double y, double reach, Visit&& visit) const {
    const double within = classes_[of].greatest + reach;
    return classes_[of].grid.in_box({x - within, x + within}, {y - within, y + within}, visit);
  }
  // For all classes:
  template <class Visit>
  long near_box(Extent x, Extent y, double reach, Visit&& visit) const;
  template <class Visit>
  long near_wall(const WallPart& wall, double reach, Visit&& visit) const;
  template <class Visit>
  long near_segment(Vec2 a, Vec2 b, double reach, Visit&& visit) const;

 private:
  struct Class {
    double greatest;  // m, radius
    std::vector<int> bodies;
    Grid grid;
  };
  void split(const std::vector<int>& by_size, const std::vector<double>& radius);

  std::vector<int> bodies_, class_of_;
  std::vector<Class> classes_;  // from small to large
};

// Where along x points lie that are behind the wall or closer to it than `within`, at these y.
Extent along_wall(const WallPart& wall, double within, Extent y);

// Where along x points lie that are closer than `within` to the segment, at these y.
Extent along_segment(Vec2 a, Vec2 b, double within, Extent y);

template <class Visit>
long SizeClasses::near_box(Extent x, Extent y, double reach, Visit&& visit) const {
  long rows = 0;
  for (const Class& c : classes_) {
    const double within = c.greatest + reach;
    rows += c.grid.in_box({x.from - within, x.to + within}, {y.from - within, y.to + within}, visit);
  }
  return rows;
}

template <class Visit>
long SizeClasses::near_wall(const WallPart& wall, double reach, Visit&& visit) const {
  long rows = 0;
  for (const Class& c : classes_) {
    rows += c.grid.in_rows(
        {-infinity, infinity}, [&](Extent y) { return along_wall(wall, c.greatest + reach, y); }, visit);
  }
  return rows;
}

template <class Visit>
long SizeClasses::near_segment(Vec2 a, Vec2 b, double reach, Visit&& visit) const {
  long rows = 0;
  for (const Class& c : classes_) {
    const double within = c.greatest + reach;
    rows += c.grid.in_rows(
        {std::min(a.y, b.y) - within, std::max(a.y, b.y) + within},
        [&](Extent y) { return along_segment(a, b, within, y); }, visit);
  }
  return rows;
}

}  // namespace furrow
