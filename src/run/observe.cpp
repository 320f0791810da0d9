#include "run/observe.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "physics/link.h"

namespace furrow {
namespace {

void add_motion(const System& system, const State& y, Observation& seen) {
  const Parts& parts = system.parts();
  const NodeArrays& node = parts.node;
  const auto add_body = [&](int body, double mass, double gravity) {
    const double vx = y[system.vx_of(body)];
    const double vy = y[system.vy_of(body)];
    seen.energy.kinetic += 0.5 * mass * (vx * vx + vy * vy);
    seen.energy.gravity += mass * gravity * y[system.y_of(body)];
    seen.momentum.x += mass * vx;
    seen.momentum.y += mass * vy;
    seen.momentum.angular += mass * (y[system.x_of(body)] * vy - y[system.y_of(body)] * vx);
  };
  for (int i = 0; i < parts.disc.count(); ++i) {
    add_body(i, parts.disc.mass[i], system.gravity());
    const double spin = system.spin(y, i);
    seen.energy.kinetic += 0.5 * parts.disc.inertia[i] * spin * spin;
    seen.momentum.angular += parts.disc.inertia[i] * spin;
  }
  for (int n = 0; n < node.count(); ++n) {
    if (node.body[n] < 0) continue;
    add_body(node.body[n], node.mass[n], node.gravity[n]);
    seen.energy.load -= node.load_x[n] * (y[system.x_of(node.body[n])] - node.x[n]) +
                        node.load_y[n] * (y[system.y_of(node.body[n])] - node.y[n]);
  }
}

// Adds up what acts on the driven nodes.
class DriveForces {
 public:
  DriveForces(const Parts& parts, std::vector<Force>& sums) : parts_(parts), sums_(sums) {
    sums_.resize(parts.drive.size());
  }
  void add(int node, double fx, double fy) {
    const int drive = parts_.node.drive[node];
    if (drive < 0) return;
    sums_[drive].x += fx;
    sums_[drive].y += fy;
  }
  void add(const Contact& c) {
    if (c.id.kind != disc_lattice) return;
    add(parts_.border.a[c.segment], (c.share - 1) * c.fx, (c.share - 1) * c.fy);
    add(parts_.border.b[c.segment], -c.share * c.fx, -c.share * c.fy);
  }
  void add_links(const System& system, double t, const State& y) {
    const NodeMotion n = system.nodes(t, y);
    const LinkArrays& link = parts_.link;
    for (int k = 0; k < link.count(); ++k) {
      const int a = link.a[k], b = link.b[k];
      if (system.torn(k) || (parts_.node.drive[a] < 0 && parts_.node.drive[b] < 0)) continue;
      const LinkForce f = link_force({n.x[a] - n.x[b], n.y[a] - n.y[b]}, {n.vx[a] - n.vx[b], n.vy[a] - n.vy[b]},
                                     link.rest[k], link.stiffness[k], link.damping[k], link.damper(k));
      add(a, f.fx, f.fy);
      add(b, -f.fx, -f.fy);
    }
  }

 private:
  const Parts& parts_;
  std::vector<Force>& sums_;
};

}  // namespace

void Energies::history(HistoryVisitor& visit) {
  visit("kinetic", kinetic);
  visit("gravity", gravity);
  visit("load", load);
  visit("springs", springs);
  visit("contact elastic", contact_elastic);
  visit("link damping", link_damping);
  visit("contact viscous", contact_viscous);
  visit("friction", friction);
  visit("rolling", rolling);
  visit("tear", tear);
  visit("plate work", plate_work);
  visit("stiffening", stiffening);
}

double Energies::residual(const Energies& start) const {
  return (stored() - start.stored()) + (lost() - start.lost()) - (plate_work - start.plate_work) -
         (stiffening - start.stiffening);
}

double Energies::supplied(const Energies& start) const {
  return start.live() + std::fabs(plate_work - start.plate_work) + std::max(0.0, start.gravity - gravity) +
         std::max(0.0, start.load - load);
}

Observation observe(const System& system, double t, const State& y) {
  Observation seen;
  const Parts& parts = system.parts();
  seen.plate.resize(parts.plate.size());
  DriveForces drives(parts, seen.drive);
  seen.wall.resize(parts.wall.size());
  ContactId deepest;
  system.for_each_contact(t, y, [&](const Contact& c) {
    ++seen.contacts;
    seen.energy.contact_elastic += stored_energy(parts, c);
    const double size = of_disc(c.id.kind) ? parts.disc.radius[c.id.a] : parts.node.contact_radius[c.id.a];
    if (c.touch.overlap / size > seen.overlap.relative) {
      seen.overlap = {c.touch.overlap, c.touch.overlap / size, {}};
      deepest = c.id;
    }
    if (!seen.drive.empty()) drives.add(c);
    if (!of_plate(c.id.kind) && !of_wall(c.id.kind)) return;
    Force& on = of_wall(c.id.kind) ? seen.wall[c.id.b] : seen.plate[c.id.b];
    on.x -= c.fx;
    on.y -= c.fy;
  });
  seen.overlap.between = contact_name(parts, deepest);
  add_motion(system, y, seen);
  if (!seen.drive.empty()) drives.add_links(system, t, y);
  const std::vector<double> tension = link_forces(system, t, y);
  for (int k = 0; k < parts.link.count(); ++k) {
    if (parts.link.stiffness[k] > 0) seen.energy.springs += 0.5 * tension[k] * tension[k] / parts.link.stiffness[k];
  }
  if (system.keeps_ledger()) {
    const auto entry = [&](Ledger which) { return y[system.ledger_of(which)]; };
    seen.energy.link_damping = entry(link_damping);
    seen.energy.contact_viscous = entry(contact_viscous);
    seen.energy.friction = entry(friction_work);
    seen.energy.rolling = entry(rolling_work);
    seen.energy.tear = entry(tear_energy);
    seen.energy.plate_work = entry(plate_work);
    seen.energy.stiffening = entry(stiffening);
  }
  return seen;
}

std::vector<Stress> disc_stresses(const System& system, double t, const State& y) {
  const DiscArrays& disc = system.parts().disc;
  std::vector<Stress> stress(disc.radius.size(), Stress::Zero());
  system.for_each_contact(t, y, [&](const Contact& c) {
    if (!of_disc(c.id.kind)) return;
    Eigen::Vector2d normal(c.nx, c.ny);
    if (system.parts().tight_plates) normal.normalize();  // shorter in a corner, see physics/held_face.h
    const Eigen::Vector2d force(c.fx, c.fy);
    stress[c.id.a] += stress_moment(c.arm_a * normal, force) / disc.volume[c.id.a];
    if (c.id.kind == disc_disc) stress[c.id.b] += stress_moment(-c.arm_b * normal, -force) / disc.volume[c.id.b];
  });
  return stress;
}

std::vector<double> link_forces(const System& system, double t, const State& y) {
  const LinkArrays& link = system.parts().link;
  const NodeMotion nodes = system.nodes(t, y);
  std::vector<double> force(link.a.size(), 0.0);
  for (int k = 0; k < link.count(); ++k) {
    if (system.torn(k)) continue;
    const double rx = nodes.x[link.a[k]] - nodes.x[link.b[k]];
    const double ry = nodes.y[link.a[k]] - nodes.y[link.b[k]];
    force[k] = link.stiffness[k] * (std::sqrt(rx * rx + ry * ry) - link.rest[k]);
  }
  return force;
}

double greatest_speed(const System& system, const State& y, double left_out) {
  std::vector<double> squares;
  for (int i = 0; i < system.parts().bodies(); ++i) {
    const double vx = y[system.vx_of(i)];
    const double vy = y[system.vy_of(i)];
    squares.push_back(vx * vx + vy * vy);
  }
  if (squares.empty()) return 0;
  const auto from_top = squares.begin() + static_cast<std::ptrdiff_t>(left_out * static_cast<double>(squares.size()));
  std::nth_element(squares.begin(), from_top, squares.end(), std::greater<>());
  return std::sqrt(*from_top);
}

double surface_height(const System& system, const State& y) {
  const std::vector<double>& radius = system.parts().disc.radius;
  if (radius.empty()) return 0;
  double left = infinity;
  double right = -infinity;
  double width = 0;
  for (int i = 0; i < system.parts().disc.count(); ++i) {
    left = std::min(left, y[system.x_of(i)] - radius[i]);
    right = std::max(right, y[system.x_of(i)] + radius[i]);
    width += 2 * radius[i] / static_cast<double>(radius.size());
  }
  const int strips = std::max(1, static_cast<int>((right - left) / width));
  std::vector<double> top(static_cast<std::size_t>(strips), -infinity);
  for (int i = 0; i < system.parts().disc.count(); ++i) {
    const int strip = std::min(strips - 1, static_cast<int>((y[system.x_of(i)] - left) / (right - left) * strips));
    top[strip] = std::max(top[strip], y[system.y_of(i)] + radius[i]);
  }
  double sum = 0;
  int filled = 0;
  for (const double height : top) {
    if (!std::isfinite(height)) continue;
    sum += height;
    ++filled;
  }
  return sum / filled;
}

}  // namespace furrow
