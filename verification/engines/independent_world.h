// The world of a case for the independent engine: its parts, the laws between them, and what is seen of it.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "verification/engines/independent.h"
#include "verification/engines/observer.h"

namespace furrow::verification::independent {

using Vec = std::array<double, 2>;

inline Vec operator+(Vec a, Vec b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Vec operator-(Vec a, Vec b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Vec operator*(double k, Vec a) { return {k * a[0], k * a[1]}; }
inline double dot(Vec a, Vec b) { return a[0] * b[0] + a[1] * b[1]; }
inline double length(Vec a) { return std::hypot(a[0], a[1]); }
inline Vec unit(Vec a) { return 1 / length(a) * a; }

struct Body {
  std::string name, material;
  double radius, contact_radius, mass, inertia;  // m, m, kg, kg m^2
  Vec load;                                      // N
  bool fixed;
  double softness() const { return fixed ? 0 : 1 / mass; }  // 1/kg
};
struct Spring {
  std::size_t a, b;
  double stiffness, damping, length, strength;  // N/m, N s/m, m, N
  bool torn;
};
struct Edge {
  std::size_t a, b;
  int points;
};
struct Outline {
  std::string name;
  std::vector<Edge> edges;
};
struct Wall {
  std::string name, material;
  Vec point, normal;
};
struct Plate {
  std::string name, material;
  Vec lower, upper, velocity;
};
enum Kind { with_body, with_wall, with_plate, with_outline };
struct Pair {  // that may touch
  std::size_t a;
  Kind kind;
  std::size_t b;
  double modulus, shear;  // Pa
};

// Body a against something at this moment.
struct Touch {
  double depth = -HUGE_VAL;   // m
  Vec normal{};               // from a to the other
  Vec velocity{};             // m/s, of the other's surface without its spin
  double radius = 0;          // m, R*
  double softness = 0;        // 1/kg, 1/m*
  double arm = 0, arm_b = 0;  // m
  std::size_t node[2] = {};
  double share = 0;
};
struct Forces {
  double normal, tangential, shear_stiffness, viscous, slip;  // N, N, N/m, N, m/s
};

class World {
 public:
  World(const Json& c, AfterSlip after);

  Numbers y;  // [x y vx vy spin] of each body, then the tangential spring of each pair, then its spring against rolling

  void rates(const Numbers& at, Numbers& dydt, double t);
  void jump(double t);  // what happens at once after a step
  Moment moment(double t);

 private:
  void spring_rates(const Spring& s, const Numbers& at, Numbers& dydt) const;
  void contact_rates(std::size_t k, const Numbers& at, Numbers& dydt, double t);
  Forces forces(const Touch& c, const Pair& pair, const Numbers& at, double xi) const;
  double rolling_moment(const Touch& c, std::size_t k, const Numbers& at, double normal) const;
  double relative_spin(const Pair& pair, const Numbers& at) const;
  void limit_spring(double& xi, const Forces& f) const;
  void limit_turn(double& turn, const Touch& c, double normal) const;
  void limit_memory(std::size_t k, double t);
  void push(Numbers& dydt, std::size_t i, Vec force, double torque) const;

  Touch touch(const Pair& pair, const Numbers& at, double t) const;
  Touch touch_body(const Pair& pair, const Numbers& at) const;
  Touch touch_outline(const Outline& outline, const Numbers& at, std::size_t body) const;

  void add_body(const Json& b);
  void add_edge(const Json& e);
  void add_pair(const Json& c, std::size_t a, Kind kind, std::size_t b, const std::string& material);
  void add_pairs(const Json& c);
  const Pair& pair_of(const std::string& a, const std::string& b) const;
  double normal_force(const Pair& pair, double t) const;
  Vec push_on(const std::string& plate, double t);
  bool is_torn(std::size_t a, std::size_t b) const;

  static Vec place(const Numbers& at, std::size_t i) { return {at[5 * i], at[5 * i + 1]}; }
  static Vec speed(const Numbers& at, std::size_t i) { return {at[5 * i + 2], at[5 * i + 3]}; }
  static double spin(const Numbers& at, std::size_t i) { return at[5 * i + 4]; }
  std::size_t spring_of(std::size_t k) const { return 5 * bodies_.size() + k; }
  std::size_t turn_of(std::size_t k) const { return spring_of(pairs_.size() + k); }
  double number(const char* key) const { return contact_[key]; }

  Json contact_;
  Vec gravity_;
  AfterSlip after_;
  bool linear_;
  double beta_, friction_;
  bool pulls_, damps_slip_, whole_radius_, rolls_on_a_spring_;
  double rolling_friction_;
  std::map<std::string, std::size_t> index_;
  std::vector<Body> bodies_;
  std::vector<Spring> springs_;
  std::vector<Outline> outlines_;
  std::vector<Wall> walls_;
  std::vector<Plate> plates_;
  std::vector<Pair> pairs_;
  std::vector<Vec> pushes_;  // N, on each plate
};

}  // namespace furrow::verification::independent
