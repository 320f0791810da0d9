// From a case to the world, and what is seen of it.
#include "verification/engines/independent_world.h"

#include <algorithm>
#include <stdexcept>

namespace furrow::verification::independent {
namespace {

Vec vec(const Json& pair) { return {pair[0], pair[1]}; }

}  // namespace

World::World(const Json& c, AfterSlip after)
    : contact_(c["contact"]),
      gravity_(vec(c["gravity"])),
      after_(after),
      linear_(contact_["law"] == "linear"),
      beta_(contact_["beta"]),
      friction_(contact_["friction"]),
      pulls_(contact_["pull"]),
      damps_slip_(contact_["tangential_damping"]),
      whole_radius_(contact_["moment_arm"] == "radius"),
      rolls_on_a_spring_(contact_.contains("rolling_stiffness")),
      rolling_friction_(contact_["rolling_friction"]) {
  for (const Json& b : c["body"]) add_body(b);
  for (const Json& s : c["spring"])
    springs_.push_back({index_.at(s["a"]), index_.at(s["b"]), s["stiffness"], s["damping"], s["length"],
                        s.value("strength", HUGE_VAL), false});
  for (const Json& e : c["edge"]) add_edge(e);
  for (const Json& w : c["wall"]) walls_.push_back({w["name"], w["material"], vec(w["point"]), unit(vec(w["normal"]))});
  for (const Json& p : c["plate"])
    plates_.push_back({p["name"], p["material"], vec(p["lower_left"]), vec(p["upper_right"]), vec(p["velocity"])});
  add_pairs(c);
  y.resize(5 * bodies_.size() + 2 * pairs_.size());
}

void World::add_body(const Json& b) {
  index_[b["name"]] = bodies_.size();
  bodies_.push_back({b["name"], b.value("material", ""), b["radius"], b.value("contact_radius", 0.0), b["mass"],
                     b["inertia"], vec(b["load"]), b["fixed"]});
  const Vec p = vec(b["position"]), v = vec(b["velocity"]);
  y.insert(y.end(), {p[0], p[1], v[0], v[1], b["spin"].get<double>()});
}

void World::add_edge(const Json& e) {
  if (outlines_.empty() || outlines_.back().name != e["outline"]) outlines_.push_back({e["outline"], {}});
  outlines_.back().edges.push_back({index_.at(e["a"]), index_.at(e["b"]), e["auxiliary_points"]});
}

void World::add_pair(const Json& c, std::size_t a, Kind kind, std::size_t b, const std::string& material) {
  for (const Json& p : c["pair"]) {
    const Json& m = p["materials"];
    const std::string& own = bodies_[a].material;
    if ((m[0] != own || m[1] != material) && (m[1] != own || m[0] != material)) continue;
    return pairs_.push_back({a, kind, b, p["modulus"], p["shear_modulus"]});
  }
}

void World::add_pairs(const Json& c) {
  for (std::size_t a = 0; a < bodies_.size(); ++a) {
    for (std::size_t b = 0; b < walls_.size(); ++b) add_pair(c, a, with_wall, b, walls_[b].material);
    for (std::size_t b = 0; b < plates_.size(); ++b) add_pair(c, a, with_plate, b, plates_[b].material);
    if (bodies_[a].radius == 0) continue;
    for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
      if (bodies_[b].radius > 0) add_pair(c, a, with_body, b, bodies_[b].material);
    }
    for (std::size_t b = 0; b < outlines_.size(); ++b)
      add_pair(c, a, with_outline, b, bodies_[outlines_[b].edges[0].a].material);
  }
}

const Pair& World::pair_of(const std::string& a, const std::string& b) const {
  const auto other = [this](const Pair& p) {
    return p.kind == with_body    ? bodies_[p.b].name
           : p.kind == with_wall  ? walls_[p.b].name
           : p.kind == with_plate ? plates_[p.b].name
                                  : outlines_[p.b].name;
  };
  for (const Pair& pair : pairs_) {
    if (bodies_[pair.a].name == a && other(pair) == b) return pair;
  }
  throw std::invalid_argument("no contact of " + a + " and " + b);
}

double World::normal_force(const Pair& pair, double t) const {
  const Touch c = touch(pair, y, t);
  return c.depth > 0 ? forces(c, pair, y, 0).normal : 0;
}

Vec World::push_on(const std::string& plate, double t) {
  Numbers rate(y.size());
  rates(y, rate, t);
  for (std::size_t k = 0; k < plates_.size(); ++k) {
    if (plates_[k].name == plate) return pushes_[k];
  }
  throw std::invalid_argument("no plate " + plate);
}

bool World::is_torn(std::size_t a, std::size_t b) const {
  return std::any_of(springs_.begin(), springs_.end(),
                     [&](const Spring& s) { return s.torn && ((s.a == a && s.b == b) || (s.a == b && s.b == a)); });
}

Moment World::moment(double t) {
  const auto at = [this](const std::string& name) { return index_.at(name); };
  return {.time = t,
          .position = [=, this](const std::string& b) { return place(y, at(b)); },
          .velocity = [=, this](const std::string& b) { return speed(y, at(b)); },
          .spin = [=, this](const std::string& b) { return spin(y, at(b)); },
          .overlap = [=, this](const std::string& a, const std::string& b) { return touch(pair_of(a, b), y, t).depth; },
          .force = [=, this](const std::string& a, const std::string& b) { return normal_force(pair_of(a, b), t); },
          .push = [=, this](const std::string& plate) { return push_on(plate, t); },
          .torn = [=, this](const std::string& a, const std::string& b) { return is_torn(at(a), at(b)); }};
}

}  // namespace furrow::verification::independent
