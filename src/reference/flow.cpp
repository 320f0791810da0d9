// y' = f(t, y): all contacts, all links, the sums of forces, the ledger. The order of the sums is that of
// system/order.h.
//
//   m x''    = sum of Fx                  N, of contacts, links and a node's load
//   m y''    = sum of Fy - m g            N, g > 0 points down; of a lattice only if its nodes have weight
//   I omega' = sum of (arm Ft + M)        N m, of discs, if some contact has friction; M with its sign for body a or b
//
// Signs of Ft, M and omega: physics/contact.h. Of the ledger: book() below.
#include <algorithm>
#include <utility>

#include "physics/link.h"
#include "reference/reference.h"
#include "system/order.h"
#include "system/surface.h"

namespace furrow::reference {
namespace {

struct Load {
  double fx = 0, fy = 0;  // N
  double torque = 0;      // N m
};

void add(Load& sum, double fx, double fy, double torque) {
  sum.fx += fx;          // N
  sum.fy += fy;          // N
  sum.torque += torque;  // N m
}

struct Sums {
  std::vector<Load> disc, node;
  ContactPowers powers;
  double plate_power = 0;  // W, supplied by what moves plates and driven nodes
  double link_power = 0;   // W, lost by the dampers of links
};

TouchPowers powers_of(const Instant& now, const Contact& c) {
  return contact_powers(now.parts.law[c.law], c.touch, c.force);
}

// Pairs of discs, block by block; what they do to a disc of a later block is added after all blocks.
void add_disc_pairs(const Instant& now, const std::vector<Contact>& contacts, Sums& sums) {
  std::vector<ContactPowers> block(static_cast<std::size_t>(blocks_of(now.parts.disc.count())));  // W, of each block
  std::vector<std::pair<int, Load>> boundary;                                                     // disc; N, N m
  for (const Contact& c : contacts) {
    if (c.id.kind != disc_disc) continue;
    add(sums.disc[c.id.a], c.fx, c.fy, c.torque_a);
    if (across_blocks(c.id.a, c.id.b)) {
      boundary.push_back({c.id.b, {-c.fx, -c.fy, c.torque_b}});
    } else {
      add(sums.disc[c.id.b], -c.fx, -c.fy, c.torque_b);
    }
    block[block_of(c.id.a)].add(powers_of(now, c), now.parts.friction);  // W
  }
  for (const auto& [disc, load] : boundary) add(sums.disc[disc], load.fx, load.fy, load.torque);
  join_blocks(block, [](ContactPowers& all, const ContactPowers& one) { all.add(one); });
  sums.powers = block[0];  // W
}

// What a plate or wall feels of them moves nothing: see forces_on_flats().
void add_other_contacts(const Instant& now, const std::vector<Contact>& contacts, Sums& sums) {
  for (const Contact& c : contacts) {
    if (c.id.kind == disc_disc) continue;
    add(of_disc(c.id.kind) ? sums.disc[c.id.a] : sums.node[c.id.a], c.fx, c.fy, c.torque_a);
    if (c.id.kind == disc_lattice) {
      const double i = 1 - c.share, j = c.share;  // -, of the force, to the two nodes
      add(sums.node[now.parts.border.a[c.segment]], -i * c.fx, -i * c.fy, 0);
      add(sums.node[now.parts.border.b[c.segment]], -j * c.fx, -j * c.fy, 0);
    }
    sums.powers.add(powers_of(now, c), now.parts.friction);
    if (of_plate(c.id.kind)) {
      const PlateAt at = plate_at(now.parts.plate[c.id.b], now.t, now.discrete.preparing);  // m/s, its velocity
      sums.plate_power += c.fx * at.vx + c.fy * at.vy;                                      // W, that drives the plate
    }
  }
}

void add_links(const Instant& now, Sums& sums) {
  const LinkArrays& link = now.parts.link;
  for (int k = 0; k < link.count(); ++k) {
    if (is_torn(now.discrete, k)) continue;
    const Body a = node_of(now, link.a[k]);  // m, m/s
    const Body b = node_of(now, link.b[k]);  // m, m/s
    const LinkForce f = link_force(a.at - b.at, a.velocity - b.velocity, link.rest[k], link.stiffness[k],
                                   link.damping[k], link.damper(k));
    add(sums.node[link.a[k]], f.fx, f.fy, 0);
    add(sums.node[link.b[k]], -f.fx, -f.fy, 0);
    sums.link_power += f.damping;  // W
  }
}

// The drive supplies -F.v (W) to its nodes; F (N) is the sum of forces on the node, its load included.
void drive(const Instant& now, Sums& sums) {
  for (const int n : now.parts.driven) {
    const Vec2 v = node_of(now, n).velocity;                            // m/s, as the scene says
    sums.plate_power -= sums.node[n].fx * v.x + sums.node[n].fy * v.y;  // W
  }
}

// Newton's law, body by body.
void accelerate(const Instant& now, const Sums& sums, State& rates) {
  const Parts& parts = now.parts;
  const Layout& at = now.layout;
  for (int i = 0; i < parts.disc.count(); ++i) {
    rates[at.vx_of(i)] = sums.disc[i].fx * (1 / parts.disc.mass[i]);                               // m/s^2
    rates[at.vy_of(i)] = sums.disc[i].fy * (1 / parts.disc.mass[i]) - parts.gravity;               // m/s^2
    if (parts.friction) rates[at.spin_of(i)] = sums.disc[i].torque * (1 / parts.disc.inertia[i]);  // rad/s^2
  }
  for (int n = 0; n < parts.node.count(); ++n) {
    const int body = parts.node.body[n];  // place in the state; -1: fixed or driven
    if (body < 0) continue;
    rates[at.vx_of(body)] = sums.node[n].fx * (1 / parts.node.mass[n]);                          // m/s^2
    rates[at.vy_of(body)] = sums.node[n].fy * (1 / parts.node.mass[n]) - parts.node.gravity[n];  // m/s^2
  }
  for (const int body : parts.held_x) rates[at.vx_of(body)] = 0;  // m/s^2: a roller takes the force
  for (const int body : parts.held_y) rates[at.vy_of(body)] = 0;  // m/s^2
}

// Rates of the entries of the ledger. Lost: contact_viscous, friction_work, rolling_work, link_damping. Supplied: stiffening,
// plate_work. Jumps book in friction_work, rolling_work and tear_energy. The balance of energy: system/layout.h.
void book(const Layout& at, const Sums& sums, State& rates) {
  rates[at.ledger_of(contact_viscous)] = sums.powers.viscous;  // W
  rates[at.ledger_of(friction_work)] = sums.powers.friction;   // W
  rates[at.ledger_of(rolling_work)] = sums.powers.rolling;     // W
  rates[at.ledger_of(stiffening)] = sums.powers.stiffening;    // W
  rates[at.ledger_of(link_damping)] = sums.link_power;         // W
  rates[at.ledger_of(plate_work)] = sums.plate_power;          // W
}

}  // namespace

void for_each_pair(const Parts& parts, const std::function<void(const ContactId&)>& for_pair) {
  const int discs = parts.disc.count();
  const auto with_each = [&](ContactKind kind, int a, std::size_t count) {
    for (int b = 0; b < static_cast<int>(count); ++b) for_pair({kind, a, b});
  };
  for (int a = 0; a < discs; ++a) {
    for (int b = a + 1; b < discs; ++b) for_pair({disc_disc, a, b});
  }
  for (int a = 0; a < discs; ++a) with_each(disc_wall, a, parts.wall.size());
  for (int a = 0; a < discs; ++a) with_each(disc_plate, a, parts.plate.size());
  for (int a = 0; a < discs; ++a) with_each(disc_lattice, a, parts.lattice.size());
  for (const ContactKind kind : {node_wall, node_plate}) {
    for (int a = 0; a < parts.node.count(); ++a) {
      if (parts.node.body[a] < 0) continue;  // neither a fixed node nor a wall or plate can give way
      with_each(kind, a, kind == node_wall ? parts.wall.size() : parts.plate.size());
    }
  }
}

std::vector<Contact> contacts(const Instant& now) {
  std::vector<Contact> touching;
  for_each_pair(now.parts, [&](const ContactId& pair) {
    const Proximity near = proximity(now, pair);  // m: where the two are
    if (near.touching) touching.push_back(contact_of(now, pair, near));
  });
  return touching;
}

// The opposite of what each contact does to the disc or node. run/observe.cpp sums the same for files and watches, from
// the contacts of either solver.
FlatForces forces_on_flats(const Instant& now) {
  FlatForces on{std::vector<Vec2>(now.parts.plate.size()), std::vector<Vec2>(now.parts.wall.size())};
  for (const Contact& c : contacts(now)) {
    if (!of_plate(c.id.kind) && !of_wall(c.id.kind)) continue;
    Vec2& sum = of_plate(c.id.kind) ? on.plate[c.id.b] : on.wall[c.id.b];
    sum.x -= c.fx;  // N
    sum.y -= c.fy;  // N
  }
  return on;
}

void flow(const Instant& now, State& rates) {
  const Layout& at = now.layout;
  const Parts& parts = now.parts;
  Sums sums;  // N, N m, W
  sums.disc.resize(static_cast<std::size_t>(parts.disc.count()));
  for (int n = 0; n < parts.node.count(); ++n) sums.node.push_back({parts.node.load_x[n], parts.node.load_y[n], 0});
  const std::vector<Contact> touching = contacts(now);  // with their forces
  add_disc_pairs(now, touching, sums);
  add_other_contacts(now, touching, sums);
  add_links(now, sums);
  drive(now, sums);

  std::fill(rates.begin(), rates.end(), 0.0);                              // entries without a rate
  std::copy_n(now.y.begin() + at.vx_of(0), 2 * at.bodies, rates.begin());  // x' = v, m/s
  accelerate(now, sums, rates);
  for (const Contact& c : touching) {
    if (c.slot < 0) continue;
    rates[at.spring_of(c.slot)] = spring_rate(parts.law[c.law], c.touch, c.force);    // xi' = vt, or as rescaled, m/s
    if (rolls_on_spring(parts.law[c.law])) rates[at.turn_of(c.slot)] = c.touch.spin;  // theta' = w, rad/s
  }
  for (const DiscreteState::Held& held : now.discrete.held) {
    const int leader = slot_followed(now, held);  // the slot whose spring this one follows
    if (leader >= 0) std::copy_n(&rates[at.spring_of(leader)], at.slot_width, &rates[at.spring_of(held.slot)]);
  }
  for (int i = 0; i < at.angles; ++i)
    rates[at.angle_of(i)] = parts.friction ? now.y[at.spin_of(i)] : parts.disc.spin[i];  // rad/s
  if (parts.keeps_ledger) book(at, sums, rates);
}

}  // namespace furrow::reference
