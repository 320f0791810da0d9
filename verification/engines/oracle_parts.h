// Two bodies that meet, as the closed forms see them, read from a case.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include "verification/engines/case.h"
#include "verification/engines/oracles.h"

namespace furrow::verification {

using Expected = std::map<std::string, double>;
using Oracle = std::function<Expected(const Json& whole)>;

// Tables of oracles, one a file.
const std::map<std::string, Oracle>& contact_oracles();
const std::map<std::string, Oracle>& assembly_oracles();
const std::map<std::string, Oracle>& spring_oracles();
const std::map<std::string, Oracle>& bed_oracles();

using Vec = std::array<double, 2>;
inline Vec vec(const Json& pair) { return {pair[0], pair[1]}; }
inline double dot(Vec a, Vec b) { return a[0] * b[0] + a[1] * b[1]; }

inline const Json& pair_of_materials(const Json& c, const std::string& a, const std::string& b) {
  for (const Json& p : c["pair"]) {
    const Json& m = p["materials"];
    if ((m[0] == a && m[1] == b) || (m[0] == b && m[1] == a)) return p;
  }
  throw std::invalid_argument("no pair of materials " + a + " and " + b);
}

// The first body and what it runs into: the wall, the second body, or the nodes of the outline.
struct Meeting {
  double mass, radius, modulus, shear;  // kg, m, Pa, Pa: m*, R*, E*, G*
  Vec normal;                           // from the first body to the other
  double closing;                       // m/s
  double beta, friction;
  double stiffness() const { return 4.0 / 3 * modulus * std::sqrt(radius); }  // N/m^(3/2)
};

inline Meeting meeting_of(const Json& c) {
  const Json& a = c["body"][0];
  const bool wall = !c["wall"].empty(), nodes = !c["edge"].empty();
  const Json& b = wall ? c["wall"][0] : c["body"][1];
  const Json& pair = pair_of_materials(c, a["material"], b["material"]);
  Meeting m{a["mass"], a["radius"], pair["modulus"],      pair["shear_modulus"],
            {},        0,           c["contact"]["beta"], c["contact"]["friction"]};
  const Vec va = vec(a["velocity"]);
  if (wall) {
    const Vec n = vec(b["normal"]);
    m.normal = {-n[0], -n[1]};
    m.closing = dot(va, m.normal);
    return m;
  }
  const bool shared = nodes && c["body"].size() > 2 && c["lattice"][0]["columns"] == 2;  // the middle of an edge
  const Vec pa = vec(a["position"]), pb = shared ? Vec{0, 0} : vec(b["position"]), vb = vec(b["velocity"]);
  const double distance = std::hypot(pb[0] - pa[0], pb[1] - pa[1]);
  m.normal = {(pb[0] - pa[0]) / distance, (pb[1] - pa[1]) / distance};
  m.closing = dot(va, m.normal) - dot(vb, m.normal);
  m.mass = 1 / (1 / m.mass + (shared ? 0.5 : 1) / b["mass"].get<double>());
  if (!nodes) m.radius = 1 / (1 / m.radius + 1 / b["radius"].get<double>());
  return m;
}

// Puts `value` of (what, body, direction) under the name that the case has for it.
inline void fill(Expected& all, const Json& c, const std::function<double(const Json& seen)>& value) {
  for (const Json& seen : c["observe"]) all[seen["name"]] = value(seen);
}

}  // namespace furrow::verification
