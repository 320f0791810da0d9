// The laws of PROTOCOL.md, written down once more.
#include <algorithm>

#include "verification/engines/independent_world.h"

namespace furrow::verification::independent {

void World::rates(const Numbers& at, Numbers& dydt, double t) {
  std::fill(dydt.begin(), dydt.end(), 0);
  pushes_.assign(plates_.size(), Vec{0, 0});
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    push(dydt, i, bodies_[i].mass * gravity_ + bodies_[i].load, 0);
    if (bodies_[i].fixed) continue;
    dydt[5 * i] = at[5 * i + 2];
    dydt[5 * i + 1] = at[5 * i + 3];
  }
  for (const Spring& s : springs_) spring_rates(s, at, dydt);
  for (std::size_t k = 0; k < pairs_.size(); ++k) contact_rates(k, at, dydt, t);
}

void World::push(Numbers& dydt, std::size_t i, Vec force, double torque) const {
  const Body& body = bodies_[i];
  if (body.fixed) return;
  dydt[5 * i + 2] += force[0] / body.mass;
  dydt[5 * i + 3] += force[1] / body.mass;
  if (body.inertia > 0) dydt[5 * i + 4] += torque / body.inertia;
}

void World::spring_rates(const Spring& s, const Numbers& at, Numbers& dydt) const {
  if (s.torn) return;
  const Vec r = place(at, s.b) - place(at, s.a), v = speed(at, s.b) - speed(at, s.a);
  const Vec e = unit(r);
  const Vec force = (s.stiffness * (length(r) - s.length) + s.damping * dot(v, e)) * e;
  push(dydt, s.a, force, 0);
  push(dydt, s.b, -1 * force, 0);
}

Forces World::forces(const Touch& c, const Pair& pair, const Numbers& at, double xi) const {
  const double d = c.depth, damping = 2 * std::sqrt(5.0 / 6) * beta_;
  const double sn = linear_ ? number("kn") : 2 * pair.modulus * std::sqrt(c.radius * d);
  const double st = linear_ ? number("kt") : 8 * pair.shear * std::sqrt(c.radius * d);
  const double cn = linear_ ? number("cn") : damping * std::sqrt(sn / c.softness);
  const double ct = linear_ ? number("ct") : damps_slip_ ? damping * std::sqrt(st / c.softness) : 0;
  const Vec v = speed(at, pair.a) - c.velocity, tangent{-c.normal[1], c.normal[0]};
  const double turning = spin(at, pair.a) * c.arm + (pair.kind == with_body ? spin(at, pair.b) * c.arm_b : 0);
  const double slip = dot(v, tangent) + turning;
  const double push = (linear_ ? 1 : 2.0 / 3) * sn * d + cn * dot(v, c.normal);
  const double normal = pulls_ ? push : std::max(0.0, push), most = friction_ * std::max(0.0, normal);
  return {normal, std::clamp(-st * xi - ct * slip, -most, most), st, ct * slip, slip};
}

double World::relative_spin(const Pair& pair, const Numbers& at) const {
  return spin(at, pair.a) - (pair.kind == with_body ? spin(at, pair.b) : 0);
}

double World::rolling_moment(const Touch& c, std::size_t k, const Numbers& at, double normal) const {
  if (rolling_friction_ == 0) return 0;
  const double w = relative_spin(pairs_[k], at), most = rolling_friction_ * c.radius * std::max(0.0, normal);
  if (rolls_on_a_spring_)
    return std::clamp(-number("rolling_stiffness") * at[turn_of(k)] - number("rolling_damping") * w, -most, most);
  return -most * w / std::hypot(w, number("rolling_smoothing"));
}

void World::contact_rates(std::size_t k, const Numbers& at, Numbers& dydt, double t) {
  const Pair& pair = pairs_[k];
  const Touch c = touch(pair, at, t);
  if (c.depth <= 0) return;
  const Forces f = forces(c, pair, at, at[spring_of(k)]);
  const double moment = rolling_moment(c, k, at, f.normal);
  const Vec on_a = f.tangential * Vec{-c.normal[1], c.normal[0]} - f.normal * c.normal;
  push(dydt, pair.a, on_a, c.arm * f.tangential + moment);
  if (pair.kind == with_body) push(dydt, pair.b, -1 * on_a, c.arm_b * f.tangential - moment);
  if (pair.kind == with_plate) pushes_[pair.b] = pushes_[pair.b] - on_a;
  if (pair.kind == with_outline) {
    push(dydt, c.node[0], -(1 - c.share) * on_a, 0);
    push(dydt, c.node[1], -c.share * on_a, 0);
  }
  dydt[spring_of(k)] = f.slip;
  dydt[turn_of(k)] = relative_spin(pair, at);
}

void World::limit_spring(double& xi, const Forces& f) const {
  const double most = friction_ * std::max(0.0, f.normal), stick = f.shear_stiffness * xi + f.viscous;
  if (after_ == AfterSlip::returns) xi = std::clamp(xi, -most / f.shear_stiffness, most / f.shear_stiffness);
  if (after_ == AfterSlip::holds && std::fabs(stick) > most)
    xi = (std::copysign(most, stick) - f.viscous) / f.shear_stiffness;
}

void World::limit_turn(double& turn, const Touch& c, double normal) const {
  const double most = rolling_friction_ * c.radius * std::max(0.0, normal) / number("rolling_stiffness");
  turn = std::clamp(turn, -most, most);
}

// What a contact remembers ends with it, and is limited after each step.
void World::limit_memory(std::size_t k, double t) {
  double &xi = y[spring_of(k)], &turn = y[turn_of(k)];
  const Touch c = touch(pairs_[k], y, t);
  if (c.depth <= 0) {
    xi = turn = 0;
    return;
  }
  const Forces f = forces(c, pairs_[k], y, xi);
  if (friction_ > 0) limit_spring(xi, f);
  if (rolls_on_a_spring_) limit_turn(turn, c, f.normal);
}

void World::jump(double t) {
  for (Spring& s : springs_) {
    if (s.stiffness * (length(place(y, s.b) - place(y, s.a)) - s.length) > s.strength) s.torn = true;
  }
  if (friction_ == 0 && !rolls_on_a_spring_) return;
  for (std::size_t k = 0; k < pairs_.size(); ++k) limit_memory(k, t);
}

}  // namespace furrow::verification::independent
