// A plate meets the nodes of a lattice, without the solver: rows of linked nodes, integrated in long double on
// t = T s^4, and one node in closed form. Equations: plate_meets_lattice.cpp.
#pragma once

#include <cmath>
#include <vector>

namespace furrow::verification::plate_meets_lattice {

inline constexpr double young = 2e5, shear = 2e5;      // Pa
inline constexpr double modulus = 133333.33333333333;  // Pa, E*: nu = -1/2 on both sides
inline constexpr double contact_radius = 0.01;         // m
inline constexpr double spacing = 0.01;                // m
inline constexpr double mass = 5;                      // kg
inline constexpr double stiffness = 1e4;               // N/m
inline constexpr double damping = 50;                  // N s/m
inline constexpr double speed = 0.1;                   // m/s
inline constexpr double beta = 20;                     // -

struct Meeting {
  int rows, columns, fixed_rows;
  double lower;            // m, edge of the plate; row r is at r * spacing
  double links = 1;        // of stiffness and damping
  double pressed = 0;      // m, overlap at t = 0
  bool back_held = false;  // the last column is fixed
  double beta = plate_meets_lattice::beta;
};
inline constexpr Meeting one_node{1, 1, 0, -0.005};
inline constexpr Meeting one_row{1, 3, 0, -0.005};
inline constexpr Meeting two_rows{10, 3, 2, 0.075};
inline constexpr Meeting three_rows{10, 3, 2, 0.065};  // of the paper's ten
inline constexpr Meeting held{1, 2, 0, -0.005, 1, 2e-3, true, 0.1};

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
inline Impact closed_form(double end) {
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

}  // namespace furrow::verification::plate_meets_lattice
