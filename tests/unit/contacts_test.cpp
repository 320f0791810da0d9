// Every field of every contact of a busy scene, as observers see it, against the formulas of MODEL written out here;
// and that no contact is missing.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

constexpr double round_off = 1e-9;

// Discs of two materials among walls, a plate and a lattice of a third, after some time: springs are wound.
struct Busy {
  static Scene scene(MomentArm moment_arm) {
    Scene s = busy_scene(60);
    s.model.moment_arm = moment_arm;
    s.contact.restitution.reset();
    s.contact.damping_factor = 0.2;
    s.material.push_back(elastic_material("hard"));
    s.material.back().young = 2e7;
    s.material.back().density = 2500;
    s.contact.pair = {
        {.materials = {"hard", "soft"}, .damping_factor = 0.05, .friction = 0.3, .rolling_friction = 0.02},
        {.materials = {"hard", "hard"}, .friction = 0.1}};
    for (std::size_t k = 0; k < s.disc.size(); k += 3) s.disc[k].material = "hard";
    s.plate[0].material = "hard";
    s.lattice[0].structural.strength = s.lattice[0].shear.strength = infinity;
    return s;
  }
  explicit Busy(MomentArm moment_arm) : made(scene(moment_arm)), system(made), y(system.initial_state()) {
    const auto method = make_method("pece");
    const RunEnd end = run(system, *method, y, {.start = 0, .end = until, .step = 5e-5},
                           [](double, const State&, const JumpReport&) { return true; });
    EXPECT_EQ(end.ending, Ending::finished) << end.reason;
  }
  static constexpr double until = 0.05;  // s
  Scene made;
  System system;
  State y;
};

struct Side {  // one of the two parts of a contact
  std::string material;
  double inverse_mass = 0, radius = 0, spin = 0;  // 1/kg, m, rad/s; radius 0: flat
  Vec2 velocity{};
};

struct Want {
  double nx, ny, overlap;
};

const Material& named(const Scene& scene, const std::string& name) {
  for (const Material& m : scene.material) {
    if (m.name == name) return m;
  }
  throw std::runtime_error(name);
}

struct Constants {
  double modulus, shear_modulus, beta, friction, rolling;
};

Constants constants(const Scene& scene, const std::string& a, const std::string& b) {
  Constants c{0, 0, *scene.contact.damping_factor, scene.contact.friction, scene.contact.rolling_friction};
  for (const std::string& name : {a, b}) {
    const double young = *named(scene, name).young, poisson = *named(scene, name).poisson;
    c.modulus += (1 - poisson * poisson) / young;
    c.shear_modulus += (2 - poisson) * 2 * (1 + poisson) / young;
  }
  c.modulus = 1 / c.modulus;
  c.shear_modulus = 1 / c.shear_modulus;
  for (const ContactPair& p : scene.contact.pair) {
    if (!((p.materials[0] == a && p.materials[1] == b) || (p.materials[0] == b && p.materials[1] == a))) continue;
    c.beta = p.damping_factor.value_or(c.beta);
    c.friction = p.friction.value_or(c.friction);
    c.rolling = p.rolling_friction.value_or(c.rolling);
  }
  return c;
}

class Contacts : public testing::TestWithParam<MomentArm> {
 protected:
  Contacts() : busy(GetParam()), system(busy.system), parts(system.parts()), nodes(system.nodes(0, busy.y)) {}

  double at(int number) const { return busy.y[number]; }
  Side disc(int i) const {
    return {busy.made.disc[i].material,
            1 / parts.disc.mass[i],
            busy.made.disc[i].radius,
            at(system.spin_of(i)),
            {at(system.vx_of(i)), at(system.vy_of(i))}};
  }
  double node_inverse(int n) const { return parts.node.body[n] < 0 ? 0 : 1 / 0.1; }  // the lattice's node_mass
  Side node(int n) const { return {"soft", node_inverse(n), 0, 0, {nodes.vx[n], nodes.vy[n]}}; }
  Vec2 place(int i) const { return {at(system.x_of(i)), at(system.y_of(i))}; }

  Want against_wall(Vec2 p, double radius, int w) const {
    const Wall& wall = busy.made.wall[w];
    const double length = std::hypot(wall.normal.x, wall.normal.y);
    const double nx = wall.normal.x / length, ny = wall.normal.y / length;
    return {-nx, -ny, radius - ((p.x - wall.point.x) * nx + (p.y - wall.point.y) * ny)};
  }
  Want against_plate(Vec2 p, double radius) const {
    const Plate& plate = busy.made.plate[0];
    const double left = plate.left_edge + plate.velocity.x * Busy::until, right = left + plate.width;
    const double lower = *plate.lower_edge + plate.velocity.y * Busy::until, upper = lower + plate.height;
    const double dx = std::fmin(std::fmax(p.x, left), right) - p.x, dy = std::fmin(std::fmax(p.y, lower), upper) - p.y;
    const double distance = std::hypot(dx, dy);
    if (distance > 0) return {dx / distance, dy / distance, radius - distance};
    const double out[] = {p.x - left, right - p.x, p.y - lower, upper - p.y};  // inside: out through the nearest face
    const int face = static_cast<int>(std::min_element(out, out + 4) - out);
    return {face == 0 ? 1.0 : face == 1 ? -1.0 : 0, face == 2 ? 1.0 : face == 3 ? -1.0 : 0, radius + out[face]};
  }

  // Contact k of the block between these two sides, number by number.
  void expect(const Contact& c, const Side& a, const Side& b, const Want& want, double reduced_radius,
              double reduced_mass) {
    const bool pair = b.radius > 0;
    const double shortening = GetParam() == MomentArm::contact_point ? 1 : 0;
    const Constants law = constants(busy.made, a.material, b.material);
    expect_near("nx", c.nx, want.nx, 1);
    expect_near("ny", c.ny, want.ny, 1);
    expect_near("overlap", c.touch.overlap, want.overlap, 1e-4);
    const double overlap = c.touch.overlap;  // a difference: from here on its own digits
    const double arm_a = a.radius > 0 ? a.radius - shortening * overlap * (pair ? 0.5 : 1) : 0;
    const double arm_b = pair ? b.radius - shortening * overlap * 0.5 : 0;
    expect_near("arm a", c.arm_a, arm_a, 1);
    expect_near("arm b", c.arm_b, arm_b, 1);
    expect_near("spin a", c.spin_a, a.spin, 1);
    expect_near("spin b", c.spin_b, b.spin, 1);
    const double vx = a.velocity.x - b.velocity.x, vy = a.velocity.y - b.velocity.y;
    expect_near("vx", c.vx, vx, 1);
    expect_near("vy", c.vy, vy, 1);
    expect_near("R*", c.touch.reduced_radius, reduced_radius, reduced_radius);
    expect_near("m*", c.touch.reduced_mass, reduced_mass, reduced_mass);
    const double approach = vx * c.nx + vy * c.ny;
    const double slip = -vx * c.ny + vy * c.nx + arm_a * a.spin + arm_b * b.spin;
    expect_near("approach", c.touch.approach, approach, 1);
    expect_near("slip", c.touch.slip, slip, 1);
    const double root = std::sqrt(reduced_radius * overlap);
    const double stiffness = 2 * law.modulus * root, shear = 8 * law.shear_modulus * root;
    const double elastic = 4.0 / 3 * law.modulus * root * overlap;
    const double viscosity = 2 * std::sqrt(5.0 / 6) * law.beta;
    const double normal = std::fmax(0, elastic + viscosity * std::sqrt(stiffness * reduced_mass) * approach);
    const double brake = viscosity * std::sqrt(shear * reduced_mass);
    const double scale = elastic + 1;  // N
    expect_near("elastic", c.force.elastic, elastic, scale);
    expect_near("normal", c.force.normal, normal, scale);
    expect_near("Sn", c.force.stiffness, stiffness, stiffness);
    expect_near("St", c.force.shear_stiffness, shear, shear);
    expect_near("shear viscosity", c.force.shear_viscosity, brake, brake + 1e-3);
    const double spring = c.slot >= 0 ? at(system.first_spring() + c.slot) : 0;
    EXPECT_EQ(c.touch.spring, spring);
    if (spring != 0) ++wound;
    const double limit = law.friction * normal;
    const double tangential = std::fmin(std::fmax(-shear * spring - brake * slip, -limit), limit);
    expect_near("tangential", c.force.tangential, tangential, scale);
    const double spin = a.spin - b.spin;
    const double moment =
        -law.rolling * reduced_radius * normal * spin / std::hypot(spin, busy.made.model.rolling_smoothing);
    expect_near("moment", c.force.moment, moment, scale);
    expect_near("fx", c.fx, -normal * c.nx - tangential * c.ny, scale);
    expect_near("fy", c.fy, -normal * c.ny + tangential * c.nx, scale);
    if (a.radius > 0) {
      expect_near("torque a", c.torque_a, arm_a * tangential + moment, scale);
    }
    if (pair) {
      expect_near("torque b", c.torque_b, arm_b * tangential - moment, scale);
    }
  }

  static void expect_near(const char* what, double got, double want, double scale) {
    EXPECT_NEAR(got, want, round_off * scale) << what;
  }

  Busy busy;
  const System& system;
  const Parts& parts;
  NodeMotion nodes;
  int wound = 0;
};
INSTANTIATE_TEST_SUITE_P(MomentArms, Contacts, testing::Values(MomentArm::contact_point, MomentArm::radius),
                         [](const auto& of) { return of.param == MomentArm::radius ? "radius" : "contact_point"; });

TEST_P(Contacts, AreWhatTheModelSaysAndNoneIsMissing) {
  std::map<ContactKind, int> seen;
  system.for_each_contact(Busy::until, busy.y, [&](const Contact& c) {
    SCOPED_TRACE(std::string(contact_kind_names[c.id.kind]) + " " + std::to_string(c.id.a) + " " +
                 std::to_string(c.id.b));
    ++seen[c.id.kind];
    const Side a = of_disc(c.id.kind) ? disc(c.id.a) : node(c.id.a);
    const Vec2 p = of_disc(c.id.kind) ? place(c.id.a) : Vec2{nodes.x[c.id.a], nodes.y[c.id.a]};
    const double reduced_radius = of_disc(c.id.kind) ? a.radius : 0.01;  // a node's contact_radius
    if (c.id.kind == disc_disc) {
      const Side b = disc(c.id.b);
      const double dx = place(c.id.b).x - p.x, dy = place(c.id.b).y - p.y, d = std::hypot(dx, dy);
      expect(c, a, b, {dx / d, dy / d, a.radius + b.radius - d}, a.radius * b.radius / (a.radius + b.radius),
             1 / (a.inverse_mass + b.inverse_mass));
    } else if (c.id.kind == disc_wall || c.id.kind == node_wall) {
      expect(c, a, {"soft"}, against_wall(p, a.radius, c.id.b), reduced_radius, 1 / a.inverse_mass);
    } else if (c.id.kind == disc_plate || c.id.kind == node_plate) {
      expect(c, a, {"hard", 0, 0, 0, {0.8, 0}}, against_plate(p, a.radius), reduced_radius, 1 / a.inverse_mass);
    } else {
      // The nearest of the eleven points of each border segment.
      double nearest = 1e9, share = 0, dx = 0, dy = 0;
      int i = 0, j = 0;
      for (int s = 0; s < parts.border.count(); ++s) {
        for (int point = 0; point <= 10; ++point) {
          const double along = point / 10.0;
          const int from = parts.border.a[s], to = parts.border.b[s];
          const double x = nodes.x[from] + along * (nodes.x[to] - nodes.x[from]) - p.x;
          const double y = nodes.y[from] + along * (nodes.y[to] - nodes.y[from]) - p.y;
          if (std::hypot(x, y) >= nearest - 1e-15) return;
          nearest = std::hypot(x, y);
          share = along, i = from, j = to, dx = x, dy = y;
        }
      }
      Side b{"soft"};
      b.velocity = {(1 - share) * nodes.vx[i] + share * nodes.vx[j], (1 - share) * nodes.vy[i] + share * nodes.vy[j]};
      b.inverse_mass = (1 - share) * (1 - share) * node_inverse(i) + share * share * node_inverse(j);
      expect(c, a, b, {dx / nearest, dy / nearest, a.radius - nearest}, a.radius,
             1 / (a.inverse_mass + b.inverse_mass));
    }
  });
  std::map<ContactKind, int> there;
  const auto count = [&](ContactKind kind, double overlap) { there[kind] += overlap > 0 ? 1 : 0; };
  for (int i = 0; i < parts.disc.count(); ++i) {
    const double radius = busy.made.disc[i].radius;
    for (int j = 0; j < i; ++j)
      count(disc_disc,
            radius + busy.made.disc[j].radius - std::hypot(place(i).x - place(j).x, place(i).y - place(j).y));
    for (int w = 0; w < 3; ++w) count(disc_wall, against_wall(place(i), radius, w).overlap);
    count(disc_plate, against_plate(place(i), radius).overlap);
  }
  for (const ContactKind kind : {disc_disc, disc_wall, disc_plate}) {
    EXPECT_EQ(seen[kind], there[kind]) << contact_kind_names[kind];
    EXPECT_GT(seen[kind], 0) << contact_kind_names[kind];
  }
  EXPECT_GT(seen[disc_lattice], 0);
  EXPECT_GT(wound, 10);
}

}  // namespace
}  // namespace furrow
