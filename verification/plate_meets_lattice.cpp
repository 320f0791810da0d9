// A plate meets a lattice: the first impact force with the paper's Table 1, and the order of the coupling.
//
//   force on a node that is in the plate by d, d' = v - vx:
//     F = max(0, 4/3 E* sqrt(R*) d^(3/2) + 2 sqrt(5/6) beta sqrt(2 E* sqrt(R* d) m) d')
//   a node alone has a closed form (Antypov and Elliott 2011), with u = d^(5/4) and dtau = a u^(1/5) dt:
//     u = U/(2 r) (e^((r - beta) tau) - e^(-(r + beta) tau))
//     r = sqrt(beta^2 - 1),  U = 5 v / (4 a),  a = sqrt(5 K / (4 m))
//     F = K u^(1/5) (u + 2 beta u')
//   rows of linked nodes are integrated here in long double, on t = T s^4; the links are found by their length alone
//
// The plate is where its motion puts it at every stage, so a contact that stays closed has the order of the method.
//
// Source: the paper's sections on contact and on scene 1, MODEL.md sections 2, 6 and 7.
#include <cmath>
#include <string>
#include <vector>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double young = 2e5, shear = 2e5;      // Pa
constexpr double modulus = 133333.33333333333;  // Pa, E*: nu = -1/2 on both sides
constexpr double contact_radius = 0.01;         // m
constexpr double spacing = 0.01;                // m
constexpr double mass = 5;                      // kg
constexpr double stiffness = 1e4;               // N/m
constexpr double damping = 50;                  // N s/m
constexpr double speed = 0.1;                   // m/s
constexpr double beta = 20;                     // -

struct Meeting {
  int rows, columns, fixed_rows;
  double lower;            // m, edge of the plate; row r is at r * spacing
  double links = 1;        // of stiffness and damping
  double pressed = 0;      // m, overlap at t = 0
  bool back_held = false;  // the last column is fixed
  double beta = furrow::verification::beta;
};
constexpr Meeting one_node{1, 1, 0, -0.005};
constexpr Meeting one_row{1, 3, 0, -0.005};
constexpr Meeting two_rows{10, 3, 2, 0.075};
constexpr Meeting three_rows{10, 3, 2, 0.065};  // of the paper's ten
constexpr Meeting held{1, 2, 0, -0.005, 1, 2e-3, true, 0.1};

struct Impact {
  double force, peak;  // N on the plate at the end, and the greatest one
  double x;            // m, of the first node at the end
};

class Oracle {
 public:
  explicit Oracle(const Meeting& setup) : setup_(setup), count_(setup.rows * setup.columns) {
    for (int i = 0; i < count_; ++i) {
      const int row = i / setup.columns;
      place_.push_back({spacing * (i % setup.columns), spacing * row});
      const bool back = setup.back_held && i % setup.columns == setup.columns - 1;
      free_.push_back(row >= setup.fixed_rows && !back);
    }
    for (int i = 0; i < count_; ++i) {
      for (int j = 0; j < i; ++j) {
        const long double length = std::hypot(place_[i].x - place_[j].x, place_[i].y - place_[j].y);
        if (length < 2.1L * spacing) links_.push_back({i, j, length});  // 1, sqrt(2) and 2 spacings; next is sqrt(5)
      }
    }
  }

  Impact run(long double end, int steps) {
    std::vector<Node> y = place_;
    Impact out{};
    const long double h = 1.0L / steps;
    for (int n = 0; n < steps; ++n) {
      const long double s[3] = {n * h, (n + 0.5L) * h, (n + 1) * h};
      const auto k = [&](const std::vector<Node>& at, long double x) {
        return rates(at, end * x * x * x * x, end * 4 * x * x * x);
      };
      const auto k1 = k(y, s[0]);
      const auto k2 = k(moved(y, k1, h / 2), s[1]);
      const auto k3 = k(moved(y, k2, h / 2), s[1]);
      const auto k4 = k(moved(y, k3, h), s[2]);
      y = moved(moved(moved(moved(y, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
      out.force = 0;
      const long double t = end * s[2] * s[2] * s[2] * s[2];
      for (int i = 0; i < count_; i += setup_.columns) out.force += static_cast<double>(push(i, y[i], t));
      out.peak = std::fmax(out.peak, out.force);
    }
    out.x = static_cast<double>(y[0].x);
    return out;
  }

 private:
  struct Node {
    long double x, y, vx = 0, vy = 0;
  };
  struct Link {
    int i, j;
    long double rest;
  };

  long double push(int i, const Node& n, long double t) const {
    const long double d = setup_.pressed + speed * t - n.x;
    if (!free_[i] || n.y < setup_.lower || d <= 0) return 0;
    const long double root = std::sqrt(contact_radius * d);
    const long double viscous = 2 * std::sqrt(5.0L / 6) * setup_.beta * std::sqrt(2 * modulus * root * mass);
    return std::fmax(0.0L, 4 * modulus * root * d / 3 + viscous * (speed - n.vx));
  }

  std::vector<Node> rates(const std::vector<Node>& y, long double t, long double scale) const {
    std::vector<Node> r(y.size(), Node{0, 0});
    for (const Link& l : links_) {
      const long double dx = y[l.i].x - y[l.j].x;
      const long double dy = y[l.i].y - y[l.j].y;
      const long double length = std::hypot(dx, dy);
      const long double rate = ((y[l.i].vx - y[l.j].vx) * dx + (y[l.i].vy - y[l.j].vy) * dy) / length;
      const long double force = setup_.links * (stiffness * (length - l.rest) + damping * rate) / length;
      r[l.i].vx -= force * dx;
      r[l.i].vy -= force * dy;
      r[l.j].vx += force * dx;
      r[l.j].vy += force * dy;
    }
    for (int i = 0; i < count_; ++i) {
      if (i % setup_.columns == 0) r[i].vx += push(i, y[i], t);
      const long double share = free_[i] ? scale / mass : 0;
      r[i] = {free_[i] ? y[i].vx * scale : 0, free_[i] ? y[i].vy * scale : 0, r[i].vx * share, r[i].vy * share};
    }
    return r;
  }

  static std::vector<Node> moved(std::vector<Node> y, const std::vector<Node>& k, long double h) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i].x += h * k[i].x;
      y[i].y += h * k[i].y;
      y[i].vx += h * k[i].vx;
      y[i].vy += h * k[i].vy;
    }
    return y;
  }

  Meeting setup_;
  int count_;
  std::vector<Node> place_;
  std::vector<bool> free_;
  std::vector<Link> links_;
};

// N, on a plate that has met one free node at t = 0; `peak` over all times until t.
Impact closed_form(double end) {
  const double k = 4.0 / 3 * modulus * std::sqrt(contact_radius);
  const double a = std::sqrt(5 * k / (4 * mass));
  const double r = std::sqrt(beta * beta - 1);
  const double slow = -1 / (r + beta);  // r - beta without cancellation
  const auto u = [&](double tau) { return -5 * speed / (8 * a * r) * std::exp(slow * tau) * std::expm1(-2 * r * tau); };
  const auto rate = [&](double tau) { return 5 * speed / (4 * a) * std::exp(-(r + beta) * tau) + slow * u(tau); };
  Impact out{};
  double t = 0;
  for (double x = 0; t < end;) {  // tau = x^5, dt = dtau / (a u^(1/5)); by the midpoint rule
    const double dx = 1e-5;
    const double middle = std::pow(x + dx / 2, 5);
    const double dt = 5 * std::pow(x + dx / 2, 4) * dx / (a * std::pow(u(middle), 0.2));
    x += dx * std::fmin(1, (end - t) / dt);
    t += dt;
    const double tau = std::pow(x, 5);
    out.force = k * std::pow(u(tau), 0.2) * (u(tau) + 2 * beta * rate(tau));
    out.peak = std::fmax(out.peak, out.force);
  }
  return out;
}

Scene meeting(const Meeting& setup) {
  Scene scene;
  scene.model.gravity = 0;
  scene.contact.damping_factor = setup.beta;
  scene.material.push_back({.name = "soil", .young = young, .shear = shear});
  Lattice lattice{
      .rows = setup.rows, .columns = setup.columns, .spacing = spacing, .node_mass = mass, .material = "soil"};
  for (int r = 0; r < setup.fixed_rows; ++r) lattice.fixed_rows.push_back(r);
  if (setup.back_held) lattice.fixed_columns = {setup.columns - 1};
  lattice.contact_radius = contact_radius;
  lattice.structural = lattice.shear =
      lattice.bending = {.stiffness = setup.links * stiffness, .damping = setup.links * damping};
  scene.lattice.push_back(lattice);
  scene.plate.push_back({.left_edge = setup.pressed - 0.01,
                         .lower_edge = setup.lower,
                         .height = 0.1,
                         .velocity = {speed, 0},
                         .material = "soil"});
  return scene;
}

Impact run_meeting(const Meeting& setup, const char* method, double step, double end) {
  const Scene scene = meeting(setup);
  const System system(scene);
  Impact out{};
  run_scene(scene, method, step, end, [&](double t, const State& y, const JumpReport&) {
    out.force = -observe(system, t, y).plate[0].x;
    out.peak = std::fmax(out.peak, out.force);
    out.x = y[system.x_of(0)];
    return true;
  });
  return out;
}

constexpr double end = 0.01;  // s

TEST(PlateMeetsLattice, OracleAgreesWithTheClosedFormOfOneNode) {
  requirement("coupling.plate_impact");
  const Impact got = Oracle(one_node).run(end, 4000);
  const Impact want = closed_form(end);
  expect("one node, force at 10 ms [N]", got.force, want.force,
         relative(2e-9, "truncation of the closed form's time integral, order 2: 1e-9 measured, doubled"));
  expect("one node, greatest force [N]", got.peak, want.peak,
         relative(2e-7, "the greatest of 4000 samples: 1e-7 measured, doubled"));
  const Impact half = Oracle(three_rows).run(end, 1000);
  const Impact full = Oracle(three_rows).run(end, 2000);
  expect("three rows, force at 10 ms, steps halved [N]", half.force, full.force,
         relative(2e-10, "truncation of order 4: 7e-11 measured, doubled"));
  expect("three rows, greatest force, steps halved [N]", half.peak, full.peak,
         relative(1.7e-7, "the greatest of 1000 samples: 8.3e-8 measured, doubled"));
}

TEST(PlateMeetsLattice, FirstImpactForceIsThatOfTheRowsHit) {
  requirement("coupling.plate_impact");
  struct Row {
    std::string name;
    Meeting meeting;
  };
  const Tolerance at_end = relative(8e-6, "order 5/4 at touch: 4e-6 measured at h = 2e-6 s, doubled");
  const Tolerance at_peak = relative(2.2e-5, "order 5/4 at touch: 1.1e-5 measured at h = 2e-6 s, doubled");
  for (const Row& row : {Row{"one node", one_node}, Row{"one row", one_row}, Row{"two rows of ten", two_rows},
                         Row{"three rows of ten", three_rows}}) {
    const Impact want = Oracle(row.meeting).run(end, 2000);
    const Impact got = run_meeting(row.meeting, "rk4", 2e-6, end);
    expect("force at 10 ms [N], " + row.name, got.force, want.force, at_end);
    expect("greatest force [N], " + row.name, got.peak, want.peak, at_peak);
  }
}

TEST(PlateMeetsLattice, CouplingHasTheOrderOfTheMethod) {
  requirement("coupling.order");
  const Impact want = Oracle(held).run(end, 4000);
  struct Row {
    std::string method;
    double order, width;  // -
    double error;         // m, at the shortest step
  };
  for (const Row& row :
       {Row{"pece", 2, 0.05, 2.7e-12}, Row{"verlet", 2, 0.002, 1.1e-11}, Row{"rk4", 4, 0.1, 1.5e-19}}) {
    std::vector<double> steps;
    std::vector<double> errors;
    double got = 0;
    for (const int n : {80, 160, 320, 640}) {
      got = run_meeting(held, row.method.c_str(), end / n, end).x;
      steps.push_back(end / n);
      errors.push_back(std::fabs(got - want.x));
    }
    expect("observed order, " + row.method, fitted_slope(steps, errors), row.order,
           absolute(row.width, "the next order of the error at these steps and round-off: half of it measured"));
    expect("position of the node, 640 steps [m], " + row.method, got, want.x,
           absolute(row.error, "truncation: half of it measured"));
  }
}

}  // namespace
}  // namespace furrow::verification
