// Who touches whom, how deep, and in which direction.
#include <algorithm>

#include "verification/engines/independent_world.h"

namespace furrow::verification::independent {
namespace {

Touch touch_wall(const Wall& wall, Vec p, double radius) {
  Touch c;
  c.depth = radius - dot(p - wall.point, wall.normal);
  c.normal = -1 * wall.normal;
  return c;
}

Touch touch_plate(const Plate& plate, Vec p, double radius, double t) {
  const Vec low = plate.lower + t * plate.velocity, high = plate.upper + t * plate.velocity;
  const Vec r = Vec{std::clamp(p[0], low[0], high[0]), std::clamp(p[1], low[1], high[1])} - p;
  Touch c;
  c.velocity = plate.velocity;
  if (length(r) > 0) {
    c.depth = radius - length(r);
    c.normal = unit(r);
    return c;
  }
  const double inside[4] = {p[0] - low[0], high[0] - p[0], p[1] - low[1], high[1] - p[1]};
  const Vec inwards[4] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  const auto face = std::min_element(inside, inside + 4) - inside;
  c.depth = radius + inside[face];
  c.normal = inwards[face];
  return c;
}

}  // namespace

Touch World::touch_body(const Pair& pair, const Numbers& at) const {
  const Body &a = bodies_[pair.a], &b = bodies_[pair.b];
  const Vec r = place(at, pair.b) - place(at, pair.a);
  Touch c;
  c.depth = a.radius + b.radius - length(r);
  c.normal = unit(r);
  c.velocity = speed(at, pair.b);
  c.radius = 1 / (1 / a.radius + 1 / b.radius);
  c.softness = b.softness();
  return c;
}

// The nearest of the ends and auxiliary points of all edges, or, where there are no such points, of the edges.
Touch World::touch_outline(const Outline& outline, const Numbers& at, std::size_t body) const {
  const Vec p = place(at, body);
  Touch best;
  for (const Edge& edge : outline.edges) {
    const Vec a = place(at, edge.a), b = place(at, edge.b);
    for (int k = 0; k <= edge.points + 1; ++k) {
      double s = static_cast<double>(k) / (edge.points + 1);
      if (edge.points == 0 && edge.a != edge.b) s = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      const Vec r = a + s * (b - a) - p;
      const double depth = bodies_[body].radius - length(r);
      if (depth <= best.depth) continue;
      best.depth = depth;
      best.normal = unit(r);
      best.velocity = (1 - s) * speed(at, edge.a) + s * speed(at, edge.b);
      best.softness = (1 - s) * (1 - s) * bodies_[edge.a].softness() + s * s * bodies_[edge.b].softness();
      best.node[0] = edge.a, best.node[1] = edge.b;
      best.share = s;
    }
  }
  return best;
}

Touch World::touch(const Pair& pair, const Numbers& at, double t) const {
  const Body& a = bodies_[pair.a];
  const Vec p = place(at, pair.a);
  Touch c = pair.kind == with_body    ? touch_body(pair, at)
            : pair.kind == with_wall  ? touch_wall(walls_[pair.b], p, a.radius)
            : pair.kind == with_plate ? touch_plate(plates_[pair.b], p, a.radius, t)
                                      : touch_outline(outlines_[pair.b], at, pair.a);
  if (pair.kind != with_body) c.radius = a.radius > 0 ? a.radius : a.contact_radius;
  c.softness += a.softness();
  if (a.radius == 0) return c;
  const double cut = whole_radius_ ? 0 : pair.kind == with_body ? c.depth / 2 : c.depth;
  c.arm = a.radius - cut;
  c.arm_b = pair.kind == with_body ? bodies_[pair.b].radius - cut : 0;
  return c;
}

}  // namespace furrow::verification::independent
