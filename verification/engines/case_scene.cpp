// A case as a scene of furrow.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "scene/wording.h"
#include "verification/engines/case_fields.h"
#include "verification/engines/furrow_engine.h"

namespace furrow::verification {
namespace {

const std::set<std::string> abilities{"hertz",          "wall",       "pair",
                                      "plate",          "outline",    "point",
                                      "damping",        "pull",       "no_pull",
                                      "friction",       "rolling",    "gravity",
                                      "spring",         "tear",       "tangential_damping",
                                      "load",           "arm_radius", "arm_contact_point",
                                      "spring_damping", "linear",     "no_tangential_damping",
                                      "rolling_spring"};

Vec2 vec2(const Json& pair) { return {pair[0], pair[1]}; }

bool is_sphere(const Json& body) {
  return body["inertia"] < 0.45 * body["mass"].get<double>() * std::pow(body["radius"].get<double>(), 2);
}

// Each disc has a material of its own, for its density.
void add_discs(Scene& scene, const Json& c) {
  for (const Json& body : c["body"]) {
    if (body["radius"] == 0.0) continue;
    const double r = body["radius"];
    const bool sphere = is_sphere(body);
    scene.model.disc_mass = sphere ? DiscMass::sphere : DiscMass::disc;
    Material material = *std::find_if(scene.material.begin(), scene.material.end(),
                                      [&](const Material& m) { return m.name == body["material"]; });
    material.name = "of " + body["name"].get<std::string>();
    material.density = body["mass"].get<double>() / (std::numbers::pi * r * r * (sphere ? 4 * r / 3 : 1));
    scene.disc.push_back({vec2(body["position"]), r, vec2(body["velocity"]), body["spin"], material.name});
    scene.material.push_back(material);
  }
}

LinkKind link_kind(const Json& lattice, const char* kind) {
  const Json given = lattice.value(kind, Json::object());
  return {given.value("stiffness", 0.0), given.value("damping", 0.0), given.value("strength", infinity)};
}

void add_lattice(Scene& scene, const Json& l) {
  Lattice lattice{.name = l["name"],
                  .origin = vec2(l["origin"]),
                  .rows = l["rows"],
                  .columns = l["columns"],
                  .spacing = l["spacing"],
                  .node_mass = l["node_mass"],
                  .material = l["material"]};
  lattice.fixed_rows = l.value("fixed_rows", std::vector<int>{});
  lattice.fixed_columns = l.value("fixed_columns", std::vector<int>{});
  lattice.auxiliary_points = l.value("auxiliary_points", 9);
  lattice.contact_radius = l.value("contact_radius", 0.01);
  lattice.structural = link_kind(l, "structural");
  lattice.shear = link_kind(l, "shear");
  lattice.bending = link_kind(l, "bending");
  for (const Json& n : l.value("node", Json::array())) {
    const auto pair = [&](const char* key) { return n.contains(key) ? vec2(n[key]) : Vec2{}; };
    lattice.node.push_back(
        {n.value("row", 0), n.value("column", 0), pair("displacement"), pair("velocity"), pair("force")});
  }
  scene.lattice.push_back(lattice);
}

void set_contact(Scene& scene, const Json& c) {
  const Json& contact = c["contact"];
  scene.contact = {.friction = contact.value("friction", 0.0),
                   .rolling_friction = contact.value("rolling_friction", 0.0)};
  if (contact["law"] == "linear") {
    scene.model.law = ForceLaw::linear;
    scene.contact.normal_stiffness = contact["kn"];
    if (contact["kt"] > 0.0) scene.contact.tangential_stiffness = contact["kt"];
    scene.contact.damping = contact["cn"];
    scene.contact.tangential_damping = contact["ct"];
  } else {
    scene.contact.damping_factor = contact["beta"];
    scene.model.slip_damping = contact.value("tangential_damping", true);
  }
  scene.model.pull = contact["pull"];
  scene.model.moment_arm = contact["moment_arm"] == "radius" ? MomentArm::radius : MomentArm::contact_point;
  if (contact.contains("rolling_stiffness")) {
    const double k = contact["rolling_stiffness"];
    const Json& body = c["body"][0];
    const double inertia =  // about the contact
        body["inertia"].get<double>() + body["mass"].get<double>() * std::pow(body["radius"].get<double>(), 2);
    scene.model.rolling = Rolling::spring;
    scene.contact.rolling_stiffness = k;
    scene.contact.rolling_damping = contact["rolling_damping"].get<double>() / (2 * std::sqrt(inertia * k));
  }
  if (contact.contains("rolling_smoothing")) scene.model.rolling_smoothing = contact["rolling_smoothing"];
}

bool same(const Json& one, const Json& other) {
  if (!one.is_number() || !other.is_number()) return one == other;
  const double a = one, b = other;
  return std::fabs(a - b) <= 1e-12 * std::max(std::fabs(a), std::fabs(b));
}

// The first of `of` that is not said by `made`, or not so: a path; empty if there is none.
std::string differing(const Json& of, const Json& made, const std::string& path) {
  if (of.is_array() && made.is_array() && of.size() != made.size()) return path;
  if (of.is_array() && made.is_array()) {
    for (std::size_t k = 0; k < of.size(); ++k)
      if (const std::string found = differing(of[k], made[k], item(path, k)); !found.empty()) return found;
    return {};
  }
  if (!of.is_object() || !made.is_object()) return same(of, made) ? "" : path;
  for (const auto& [key, value] : of.items()) {
    const std::string here = path + "." + key;
    if (!made.contains(key)) return here;
    if (const std::string found = differing(value, made[key], here); !found.empty()) return found;
  }
  return {};
}

// A scene has point masses, springs and edges of lattices alone, and no force on a disc but its weight.
std::string beyond_a_scene(const Json& c) {
  for (const Json& body : c["body"]) {
    if (body["radius"] == 0.0) continue;
    if (body.value("fixed", false)) return "a disc that is held";
    if (body.contains("load") && (body["load"][0] != 0.0 || body["load"][1] != 0.0)) return "a load on a disc";
  }
  const Json made = made_of_lattices(c);
  for (const char* list : {"body", "spring", "edge", "pair"}) {
    const std::string path = differing(c.value(list, Json::array()), made[list], list);
    if (!path.empty()) return path + " other than its lattices and materials say";
  }
  return {};
}

// The damper against rolling is given in N m s, in a scene as a share of the critical one, which hangs on the partners.
bool rolls_on_springs_of_several(const Json& c) {
  return c["contact"].contains("rolling_stiffness") && (c["body"].size() != 1 || !(c["body"][0]["radius"] > 0.0));
}

bool mixed(const Json& c) {
  std::set<bool> shapes;
  for (const Json& body : c["body"]) {
    if (body["radius"] > 0.0) shapes.insert(is_sphere(body));
  }
  return shapes.size() > 1;
}

}  // namespace

std::string lacking(const Json& c) {
  require_needs(c);
  for (const std::string need : c["needs"]) {
    if (!abilities.contains(need)) return need;
  }
  require_fields(c);
  if (c["gravity"][0] != 0.0) return "gravity that is not along -y";
  if (std::string beyond = beyond_a_scene(c); !beyond.empty()) return beyond;
  if (rolls_on_springs_of_several(c)) return "springs against rolling of several bodies";
  return mixed(c) ? "discs and spheres together" : "";
}

Scene scene_of_case(const Json& c) {
  Scene scene;
  scene.title = c["title"];
  scene.model.gravity = -c["gravity"][1].get<double>();
  scene.output.energy = false;
  for (const Json& m : c["material"]) {
    Material material{.name = m["name"], .rigid = m.value("rigid", false)};
    if (!material.rigid) material.young = m["young"], material.poisson = m["poisson"];
    scene.material.push_back(material);
  }
  set_contact(scene, c);
  add_discs(scene, c);
  for (const Json& w : c["wall"]) scene.wall.push_back({w["name"], vec2(w["point"]), vec2(w["normal"]), w["material"]});
  for (const Json& p : c["plate"]) {
    const Vec2 low = vec2(p["lower_left"]), high = vec2(p["upper_right"]);
    scene.plate.push_back({.name = p["name"],
                           .left_edge = low.x,
                           .lower_edge = low.y,
                           .width = high.x - low.x,
                           .height = high.y - low.y,
                           .velocity = vec2(p["velocity"]),
                           .material = p["material"]});
  }
  for (const Json& l : c["lattice"]) add_lattice(scene, l);
  return scene;
}

}  // namespace furrow::verification
