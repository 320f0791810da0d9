// One contact: where two parts touch, how they move there, and what the law answers. Two centres in one place have no
// direction: the forces are then NaN, and the run ends as diverged.
#include <cmath>

#include "physics/geometry.h"
#include "reference/reference.h"
#include "system/surface.h"

namespace furrow::reference {

Body disc_of(const Instant& now, int disc) {
  const Layout& at = now.layout;
  const double spin = now.parts.friction ? now.y[at.spin_of(disc)] : 0;  // rad/s
  return {{now.y[at.x_of(disc)], now.y[at.y_of(disc)]}, {now.y[at.vx_of(disc)], now.y[at.vy_of(disc)]}, spin};
}

Body node_of(const Instant& now, int node) {
  const Layout& at = now.layout;
  const int body = now.parts.node.body[node];  // its place in the state; -1: it has none
  if (body < 0) {                              // fixed or driven
    const NodeAt held = held_node_at(now.parts, node, now.t, now.discrete.preparing);  // m, m/s, as the scene says
    return {{held.x, held.y}, {held.vx, held.vy}, 0};
  }
  return {{now.y[at.x_of(body)], now.y[at.y_of(body)]}, {now.y[at.vx_of(body)], now.y[at.vy_of(body)]}, 0};
}

namespace {

Body body_a(const Instant& now, const ContactId& pair) {
  return of_disc(pair.kind) ? disc_of(now, pair.a) : node_of(now, pair.a);
}

// ---- geometry ----

Proximity between_discs(const Instant& now, const ContactId& pair) {
  const Vec2 d = disc_of(now, pair.b).at - disc_of(now, pair.a).at;                     // m, from centre to centre
  const double within = now.parts.disc.radius[pair.a] + now.parts.disc.radius[pair.b];  // m, distance at touch
  const double reach = within + now.parts.margin;  // m, distance at which the two are near
  const double distance2 = dot(d, d);              // m^2
  if (!(distance2 < reach * reach)) return {};
  const double distance = std::sqrt(distance2);  // m
  Proximity found;
  found.near = true;                             // distance2 is below reach^2
  found.touching = distance2 < within * within;  // the surfaces cross
  found.overlap = within - distance;             // m, d
  found.nx = d.x / distance;                     // -, n from a to b
  found.ny = d.y / distance;                     // -
  return found;
}

Proximity across(const Instant& now, const Gap& gap) {
  Proximity found;
  found.near = gap.gap < now.parts.margin;  // gap: m, between the surfaces
  found.touching = gap.gap < 0;             // the surfaces cross
  found.overlap = -gap.gap;                 // m, d
  found.nx = gap.nx;                        // -, n from a to b
  found.ny = gap.ny;                        // -
  return found;
}

Proximity to_wall_or_plate(const Instant& now, const ContactId& pair) {
  const double t = now.discrete.preparing ? 0 : now.t;  // s
  // m and direction, to the wall or to the face that is kept
  return across(now, held_gap(now.parts, now.discrete.faces, pair, body_a(now, pair).at, t));
}

// The nearest point of the border; of two equally near the one on the first segment.
Proximity to_lattice(const Instant& now, const ContactId& pair) {
  const BorderArrays& border = now.parts.border;
  const Vec2 a = disc_of(now, pair.a).at;                            // m, the centre
  const int auxiliary = now.parts.lattice[pair.b].auxiliary_points;  // of each segment; 0: all of its points
  NearestOnSegment nearest{infinity, 0, 0, 0};                       // m^2, m, m, -: no point yet
  int segment = -1;                                                  // of that point; none yet
  for (const int s : now.discrete.border) {
    if (border.lattice[s] != pair.b) continue;
    const Vec2 i = node_of(now, border.a[s]).at;                                     // m, the ends of the segment
    const Vec2 j = node_of(now, border.b[s]).at;                                     // m
    const bool torn = border.link[s] >= 0 && is_torn(now.discrete, border.link[s]);  // only its ends are left
    const NearestOnSegment n = torn ? nearest_end(a, i, j) : nearest_on_segment(a, i, j, auxiliary);  // m^2, m, m, -
    if (!(n.distance2 < nearest.distance2)) continue;
    nearest = n;  // m^2, m, m, -
    segment = s;  // index into Parts::border
  }
  Proximity found = across(now, border_gap(nearest, now.parts.disc.radius[pair.a]));  // m and direction
  found.segment = segment;                                                            // index into Parts::border
  found.share = nearest.share;  // -, 0 at the first node, 1 at the second
  return found;
}

// ---- R* and m*: see the table in system/contact.h ----

double radius_of(const Parts& parts, const ContactId& pair) {
  const double a = of_disc(pair.kind) ? parts.disc.radius[pair.a] : parts.node.contact_radius[pair.a];  // m, Ra
  if (pair.kind != disc_disc) return a;
  const double b = parts.disc.radius[pair.b];  // m, Rb
  return a * b / (a + b);
}

// 1/kg: what a node that takes this share of the force adds to 1/m*.
double yielding(const Parts& parts, int node, double share) {
  return parts.node.body[node] < 0 ? 0 : share * share / parts.node.mass[node];
}

double mass_of(const Parts& parts, const ContactId& pair, const Proximity& near) {
  const double a = of_disc(pair.kind) ? parts.disc.mass[pair.a] : parts.node.mass[pair.a];  // kg, ma
  if (pair.kind == disc_disc) {
    const double b = parts.disc.mass[pair.b];  // kg, mb
    return a * b / (a + b);
  }
  if (pair.kind != disc_lattice) return a;
  const double i = yielding(parts, parts.border.a[near.segment], 1 - near.share);  // 1/kg, of the first node
  const double j = yielding(parts, parts.border.b[near.segment], near.share);      // 1/kg, of the second
  return 1 / (1 / a + i + j);
}

int law_of(const Parts& parts, const ContactId& pair) {
  const int a = of_disc(pair.kind) ? parts.disc.material[pair.a] : parts.node.material[pair.a];  // index of a material
  const int b = pair.kind == disc_disc      ? parts.disc.material[pair.b]
                : pair.kind == disc_lattice ? parts.lattice[pair.b].material
                : of_wall(pair.kind)        ? parts.wall[pair.b].material
                                            : parts.plate[pair.b].material;
  return parts.law_of(a, b);
}

// ---- kinematics ----

// The translational velocity of b at the contact (m/s) and its angular velocity (rad/s; only discs have one). It is not the
// velocity of the surface: contact_of() adds what the spin contributes.
Body surface_b(const Instant& now, const ContactId& pair, const Proximity& near) {
  if (pair.kind == disc_disc) return disc_of(now, pair.b);
  if (of_plate(pair.kind)) {
    const PlateAt at = plate_at(now.parts.plate[pair.b], now.t, now.discrete.preparing);  // m/s, its velocity
    return {{}, {at.vx, at.vy}, 0};
  }
  if (of_wall(pair.kind)) return {};
  const Vec2 i = node_of(now, now.parts.border.a[near.segment]).velocity;  // m/s, of the first node
  const Vec2 j = node_of(now, now.parts.border.b[near.segment]).velocity;  // m/s, of the second
  return {{}, {(1 - near.share) * i.x + near.share * j.x, (1 - near.share) * i.y + near.share * j.y}, 0};
}

// m: from the centre to the contact point. The three choices of model.moment_arm: system/contact.h. By default two discs
// share the overlap, so that their arms add up to the distance of the centres, and angular momentum is kept; with "radius"
// it is not. On flats R - d is negative where d > R.
double moment_arm(const Instant& now, const ContactId& pair, int disc, double overlap) {
  const double share =
      pair.kind == disc_disc ? now.parts.pair_arm_shortening : now.parts.flat_arm_shortening;  // -, of d
  return now.parts.disc.radius[disc] - share * overlap;
}

}  // namespace

Proximity proximity(const Instant& now, const ContactId& pair) {
  switch (pair.kind) {
    case disc_disc:
      return between_discs(now, pair);
    case disc_lattice:
      return to_lattice(now, pair);
    default:
      return to_wall_or_plate(now, pair);
  }
}

int slot_followed(const Instant& now, const DiscreteState::Held& held) {
  const ContactId pair{static_cast<ContactKind>(held.kind), held.a, held.b};
  if (!now.parts.flush_plates || !of_plate(pair.kind)) return -1;
  const double t = now.discrete.preparing ? 0 : now.t;                                           // s
  const int other = felt_instead(now.parts, now.discrete.faces, pair, body_a(now, pair).at, t);  // the plate; -1: none
  return other < 0 ? -1 : slot_of(now.discrete, {pair.kind, pair.a, other});
}

Contact contact_of(const Instant& now, const ContactId& pair, const Proximity& near) {
  const Parts& parts = now.parts;
  Contact c;
  c.id = pair;                           // kind, a, b
  c.law = law_of(parts, pair);           // index into Parts::law
  c.slot = slot_of(now.discrete, pair);  // place of xi in the state; -1: none
  c.segment = near.segment;              // index into Parts::border
  c.share = near.share;                  // -, s
  c.nx = near.nx;                        // -, n
  c.ny = near.ny;                        // -

  const Body a = body_a(now, pair);           // m, m/s, rad/s
  const Body b = surface_b(now, pair, near);  // m/s, rad/s
  c.vx = -(b.velocity.x - a.velocity.x);      // m/s, of a against b; -(vb - va), so that a zero has the kernel's sign
  c.vy = -(b.velocity.y - a.velocity.y);      // m/s
  c.spin_a = a.spin;                          // rad/s
  c.spin_b = b.spin;                          // rad/s
  c.arm_a = of_disc(pair.kind) ? moment_arm(now, pair, pair.a, near.overlap) : 0;      // m
  c.arm_b = pair.kind == disc_disc ? moment_arm(now, pair, pair.b, near.overlap) : 0;  // m

  c.touch.overlap = near.overlap;                                                        // m, d
  c.touch.approach = c.vx * c.nx + c.vy * c.ny;                                          // m/s, d'
  c.touch.slip = c.vy * c.nx - c.vx * c.ny + (c.spin_a * c.arm_a + c.spin_b * c.arm_b);  // m/s, vt
  c.touch.spring = c.slot < 0 ? 0 : now.y[now.layout.spring_of(c.slot)];                 // m, xi; 0 without a slot
  c.touch.spin = c.spin_a - c.spin_b;                                                    // rad/s, w
  c.touch.reduced_radius = radius_of(parts, pair);                                       // m, R*
  c.touch.reduced_mass = mass_of(parts, pair, near);                                     // kg, m*
  if (parts.rolling_spring) {
    c.touch.turn = c.slot < 0 ? 0 : now.y[now.layout.turn_of(c.slot)];  // rad, theta
    c.touch.rolling_inertia = rolling_inertia(parts, pair);             // kg m^2, Ir
  }

  c.force = contact_force(parts.law[c.law], c.touch, parts.rolling_smoothing);  // N, N m, N/m, N s/m
  c.fx = -c.force.normal * c.nx - c.force.tangential * c.ny;                    // N, on a; the tangent is (-ny, nx)
  c.fy = -c.force.normal * c.ny + c.force.tangential * c.nx;                    // N
  c.torque_a = c.arm_a * c.force.tangential + c.force.moment;                   // N m
  if (pair.kind == disc_disc) c.torque_b = c.arm_b * c.force.tangential - c.force.moment;  // N m
  return c;
}

SpringEnergies energy_at_opening(const Instant& now, const ContactId& pair, double spring, double turn) {
  return furrow::energy_at_opening(now.parts.law[law_of(now.parts, pair)], radius_of(now.parts, pair), spring, turn);
}

}  // namespace furrow::reference
