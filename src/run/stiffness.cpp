#include "run/stiffness.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "physics/impact.h"
#include "run/observe.h"
#include "scene/wording.h"

namespace furrow {
namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

// Of one body, in the mass-weighted coordinates (x sqrt(m), y sqrt(m), angle sqrt(I)).
struct Body {
  Matrix stiffness = Matrix::Zero();  // 1/s^2
  Matrix damping = Matrix::Zero();    // 1/s
  int contacts = 0;
};

double greatest_eigenvalue(const Matrix& m) { return Eigen::SelfAdjointEigenSolver<Matrix>(m).eigenvalues()[2]; }

Oscillator oscillator_of(const Body& body) {
  const double omega2 = greatest_eigenvalue(body.stiffness);
  const double rate = greatest_eigenvalue(body.damping);
  const double omega = std::sqrt(std::max(omega2, 1e-12 * rate * rate));
  return {omega, omega > 0 ? rate / (2 * omega) : 0};
}

void add_contacts(const System& system, double t, const State& y, std::vector<Body>& bodies) {
  const Parts& parts = system.parts();
  system.for_each_contact(t, y, [&](const Contact& c) {
    const ContactLaw& law = parts.law[c.law];
    const double viscosity = normal_viscosity(law, c.touch, c.force);
    const double shear = law.friction > 0 ? 1 : 0;
    const auto add = [&](int body, double mass, double inertia, double arm) {
      const double root = std::sqrt(mass);
      const Vector normal(c.nx / root, c.ny / root, 0);
      const Vector tangent(-c.ny / root, c.nx / root, inertia > 0 ? arm / std::sqrt(inertia) : 0);
      Body& b = bodies[body];
      b.stiffness += c.force.stiffness * normal * normal.transpose() +
                     shear * c.force.shear_stiffness * tangent * tangent.transpose();
      b.damping +=
          viscosity * normal * normal.transpose() + shear * c.force.shear_viscosity * tangent * tangent.transpose();
      if (inertia > 0 && rolls_on_spring(law)) {
        const double kr = rolling_stiffness(law, c.touch, c.force);
        b.stiffness(2, 2) += kr / inertia;
        b.damping(2, 2) += rolling_spring_viscosity(law, c.touch, kr) / inertia;
      } else if (inertia > 0) {
        b.damping(2, 2) += law.rolling * c.touch.reduced_radius * std::max(c.force.normal, 0.0) /
                           (system.rolling_smoothing() * inertia);
      }
      ++b.contacts;
    };
    const auto disc = [&](int i, double arm) { add(i, parts.disc.mass[i], parts.disc.inertia[i], arm); };
    const auto node = [&](int n, double share) {
      if (parts.node.body[n] >= 0 && share > 0) add(parts.node.body[n], parts.node.mass[n] / (share * share), 0, 0);
    };
    if (of_disc(c.id.kind)) {
      disc(c.id.a, c.arm_a);
    } else {
      node(c.id.a, 1);
    }
    if (c.id.kind == disc_disc) disc(c.id.b, -c.arm_b);  // its surface moves against the tangent when it spins
    if (c.id.kind == disc_lattice) {
      node(parts.border.a[c.segment], 1 - c.share);
      node(parts.border.b[c.segment], c.share);
    }
  });
}

void add_links(const System& system, double t, const State& y, std::vector<Body>& bodies) {
  const Parts& parts = system.parts();
  const NodeMotion nodes = system.nodes(t, y);
  for (int k = 0; k < parts.link.count(); ++k) {
    if (system.torn(k)) continue;
    const int a = parts.link.a[k];
    const int b = parts.link.b[k];
    const double rx = nodes.x[a] - nodes.x[b];
    const double ry = nodes.y[a] - nodes.y[b];
    const double length = std::sqrt(rx * rx + ry * ry);
    const Vector along(rx / length, ry / length, 0);
    for (const int n : {a, b}) {
      if (parts.node.body[n] < 0) continue;
      Body& body = bodies[parts.node.body[n]];
      const Matrix direction = along * along.transpose() / parts.node.mass[n];
      body.stiffness += parts.link.stiffness[k] * direction;
      const Matrix whole = Vector(1, 1, 0).asDiagonal();
      body.damping += parts.link.damping[k] * (parts.link.axial[k] != 0 ? direction : whole / parts.node.mass[n]);
    }
  }
}

}  // namespace

void StiffPart::history(HistoryVisitor& visit) {
  visit("omega", oscillator.omega);
  visit("zeta", oscillator.zeta);
  visit("name", name);
  visit("contacts", contacts);
  visit("spins", spins);
}

StiffPart stiffest_part(const System& system, double t, const State& y) {
  std::vector<Body> bodies(static_cast<std::size_t>(system.parts().bodies()));
  add_contacts(system, t, y, bodies);
  add_links(system, t, y, bodies);
  StiffPart stiffest;
  stiffest.oscillator = {0, 0};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Oscillator o = oscillator_of(bodies[i]);
    if (!(fastest_rate(o) > fastest_rate(stiffest.oscillator))) continue;
    stiffest = {o, system.parts().body_name(static_cast<int>(i)), bodies[i].contacts, false};
    Eigen::SelfAdjointEigenSolver<Matrix> modes(bodies[i].damping);
    stiffest.spins = std::fabs(modes.eigenvectors()(2, 2)) > 0.7;
  }
  return stiffest;
}

StiffPart stiffest_bond(const System& system, double t, const State& y, int body) {
  const Parts& parts = system.parts();
  StiffPart best;
  best.oscillator = {0, 0};
  bool on_body = false;
  const auto take = [&](double stiffness, double viscosity, double mass, bool own, const auto& name) {
    const double omega = std::sqrt(stiffness / mass);
    const Oscillator o{omega, omega > 0 ? viscosity / (2 * mass * omega) : 0};
    if (own < on_body || (own == on_body && !(fastest_rate(o) > fastest_rate(best.oscillator)))) return;
    on_body = own;
    best = {o, name()};
  };
  system.for_each_contact(t, y, [&](const Contact& c) {
    const int a = of_disc(c.id.kind) ? c.id.a : parts.node.body[c.id.a];
    const double viscosity = normal_viscosity(parts.law[c.law], c.touch, c.force);
    take(c.force.stiffness, viscosity, c.touch.reduced_mass, a == body || (c.id.kind == disc_disc && c.id.b == body),
         [&] { return "the contact of " + contact_name(system.parts(), c.id); });
  });
  const auto inverse_mass = [&](int n) { return parts.node.body[n] < 0 ? 0 : 1 / parts.node.mass[n]; };
  for (int k = 0; k < parts.link.count(); ++k) {
    const int a = parts.link.a[k];
    const int b = parts.link.b[k];
    if (system.torn(k) || inverse_mass(a) + inverse_mass(b) == 0) continue;
    take(parts.link.stiffness[k], parts.link.damping[k], 1 / (inverse_mass(a) + inverse_mass(b)),
         body >= 0 && (parts.node.body[a] == body || parts.node.body[b] == body),
         [&] { return "the " + parts.link_name(k); });
  }
  return best;
}

namespace {

struct Striker {
  double radius, mass;
  int material;
  bool alone = true;  // the only one of its material
};

// Of those of one material the one that goes least deep: d^(5/2) goes with m / sqrt(R).
void keep_lightest(std::vector<Striker>& kept, const Striker& one) {
  const auto depth = [](const Striker& s) { return s.mass / std::sqrt(s.radius); };
  for (Striker& other : kept) {
    if (other.material != one.material) continue;
    if (depth(one) < depth(other)) other = one;
    other.alone = false;
    return;
  }
  kept.push_back(one);
}

}  // namespace

Oscillator stiffest_impact(const Parts& parts, double speed) {
  std::vector<Striker> discs, nodes;
  for (int i = 0; i < parts.disc.count(); ++i)
    keep_lightest(discs, {parts.disc.radius[i], parts.disc.mass[i], parts.disc.material[i]});
  for (int n = 0; n < parts.node.count(); ++n) {
    const double mass = parts.node.body[n] < 0 ? infinity : parts.node.mass[n];  // held: nothing moves it
    keep_lightest(nodes, {parts.node.contact_radius[n], mass, parts.node.material[n]});
  }
  Oscillator stiffest{0, 0};
  const auto meet = [&](int a, int b, double radius, double mass) {
    const ContactLaw& law = parts.law[parts.law_of(a, b)];
    const double overlap = impact_overlap(law, radius, mass, speed);
    const double omega = impact_frequency(law, overlap, speed);
    const Oscillator o{omega, law.viscosity / 2 + law.options.dashpot / (2 * mass * omega)};
    if (std::isfinite(o.omega) && fastest_rate(o) > fastest_rate(stiffest)) stiffest = o;
  };
  const auto meet_flat = [&](const Striker& s) {
    for (const WallPart& w : parts.wall) meet(s.material, w.material, s.radius, s.mass);
    for (const PlatePart& p : parts.plate) meet(s.material, p.material, s.radius, s.mass);
  };
  for (const Striker& a : discs) {
    for (const Striker& b : discs) {
      if (&a == &b && a.alone) continue;
      meet(a.material, b.material, a.radius * b.radius / (a.radius + b.radius), a.mass * b.mass / (a.mass + b.mass));
    }
    for (const Striker& n : nodes) meet(a.material, n.material, a.radius, 1 / (1 / a.mass + 1 / n.mass));
    meet_flat(a);
  }
  for (const Striker& n : nodes)
    if (std::isfinite(n.mass)) meet_flat(n);
  return stiffest;
}

std::vector<std::string> step_warnings(const System& system, double t, const State& y, const std::string& method,
                                       double step) {
  const StiffPart part = stiffest_part(system, t, y);
  const double limit = largest_stable_step(method, part.oscillator);
  if (part.name.empty() || step <= 0.5 * limit) return {};
  Sentence text;
  text.precision(3);
  text << "the step of " << step << " s is " << (step > limit ? "beyond" : "near") << " the stability limit of "
       << method << ": " << part.name << " (" << part.contacts << " contacts, damping ratio " << part.oscillator.zeta
       << ") allows " << limit
       << " s with its neighbours held, and down to half of that when they move against it; forces may chatter, and "
          "the energy "
          "residual shows how much";
  return {text.str()};
}

}  // namespace furrow
