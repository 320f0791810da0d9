#include "verification/engines/case_fields.h"

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "scene/wording.h"

namespace furrow::verification {
namespace {

using Names = std::set<std::string>;

constexpr double most_lines = 100'000, most_points = 1000;  // of a lattice, as of a scene's

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::invalid_argument("the request does not follow the protocol: " + path + " " + why +
                              "; see furrow cases --protocol");
}

std::string shown(const Json& value) {
  constexpr std::size_t most = 40;
  const std::string text = value.dump();
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

std::string digits(double whole) { return std::to_string(static_cast<long>(whole)); }

bool is_finite(const Json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

bool is_whole(const Json& value, double most) {
  return is_finite(value) && value.get<double>() >= 0 && value.get<double>() <= most &&
         value.get<double>() == std::floor(value.get<double>());
}

// One object of a case.
class Fields {
 public:
  Fields(const Json& object, std::string path) : object_(object), path_(std::move(path)) {
    if (!object.is_object()) refuse(path_, "must be an object, not " + shown(object));
  }
  bool has(const char* key) const { return object_.contains(key); }
  std::string at(const std::string& key) const { return path_ + "." + key; }

  const Json& given(const char* key) const {
    if (!has(key)) refuse(at(key), "is missing");
    return object_.at(key);
  }
  double number(const char* key, double least = -HUGE_VAL) const {
    const Json& value = given(key);
    if (!is_finite(value)) refuse(at(key), "must be a number, not " + shown(value));
    if (value.get<double>() < least) refuse(at(key), "must be at least 0, not " + shown(value));
    return value;
  }
  void pair(const char* key) const {
    const Json& value = given(key);
    if (!value.is_array() || value.size() != 2 || !is_finite(value[0]) || !is_finite(value[1]))
      refuse(at(key), "must be two numbers, not " + shown(value));
  }
  std::string text(const char* key) const {
    const Json& value = given(key);
    if (!value.is_string()) refuse(at(key), "must be a text, not " + shown(value));
    return value;
  }
  std::string name(const char* key, const Names& known) const { return one_of(at(key), text(key), known); }
  void flag(const char* key) const {
    if (!given(key).is_boolean()) refuse(at(key), "must be true or false, not " + shown(given(key)));
  }
  double whole(const char* key, double least, double most) const {
    const Json& value = given(key);
    if (!is_whole(value, most) || value.get<double>() < least)
      refuse(at(key), "must be an integer from " + digits(least) + " to " + digits(most) + ", not " + shown(value));
    return value;
  }
  void wholes(const char* key, double most) const {
    for (std::size_t k = 0; k < list(key).size(); ++k)
      if (!is_whole(list(key)[k], most))
        refuse(item(at(key), k), "must be an integer from 0 to " + digits(most) + ", not " + shown(list(key)[k]));
  }
  const Json& list(const char* key) const {
    if (!given(key).is_array()) refuse(at(key), "must be a list, not " + shown(given(key)));
    return given(key);
  }
  template <class Check>
  void each(const char* key, const Check& check) const {
    for (std::size_t k = 0; k < list(key).size(); ++k) check(Fields(list(key)[k], item(at(key), k)));
  }

  static std::string one_of(const std::string& path, const std::string& name, const Names& known) {
    if (!known.contains(name))
      refuse(path, "names " + in_quotes(name) + ", which is none of " +
                       (known.empty() ? "what the case has" : joined({known.begin(), known.end()})));
    return name;
  }

 private:
  const Json& object_;
  std::string path_;
};

// Names of the parts of a case, by what they are.
struct Parts {
  Names material{}, disc{}, point{}, body{}, wall{}, plate{}, lattice{}, pressed{};  // pressed: what a body may touch
  double nodes = 0;
};

void check_body(const Fields& body, Parts& parts) {
  const std::string name = body.text("name");
  const bool disc = body.number("radius", 0) > 0;
  for (const char* key : {"mass", "inertia", "spin"}) body.number(key);
  for (const char* key : {"position", "velocity"}) body.pair(key);
  if (body.has("load")) body.pair("load");
  if (body.has("fixed")) body.flag("fixed");
  if (disc) body.name("material", parts.material);
  if (!disc && body.number("inertia") > 0) refuse(body.at("inertia"), "must be 0: a point mass does not turn");
  if (!parts.body.insert(name).second) refuse(body.at("name"), "is given twice: " + in_quotes(name));
  (disc ? parts.disc : parts.point).insert(name);
}

void check_lattice(const Fields& l, Parts& parts) {
  parts.lattice.insert(l.text("name"));
  l.name("material", parts.material);
  l.pair("origin");
  for (const char* key : {"spacing", "node_mass"}) l.number(key, 0);
  const double rows = l.whole("rows", 1, most_lines), columns = l.whole("columns", 1, most_lines);
  parts.nodes += rows * columns;
  if (l.has("fixed_rows")) l.wholes("fixed_rows", rows - 1);
  if (l.has("fixed_columns")) l.wholes("fixed_columns", columns - 1);
  if (l.has("auxiliary_points")) l.whole("auxiliary_points", 0, most_points);
  if (l.has("contact_radius")) l.number("contact_radius", 0);
  for (const char* kind : {"structural", "shear", "bending"}) {
    if (!l.has(kind)) continue;
    const Fields links(l.given(kind), l.at(kind));
    for (const char* key : {"stiffness", "damping", "strength"})
      if (links.has(key)) links.number(key, 0);
  }
  if (!l.has("node")) return;
  l.each("node", [&](const Fields& node) {
    if (node.has("row")) node.whole("row", 0, rows - 1);
    if (node.has("column")) node.whole("column", 0, columns - 1);
    for (const char* key : {"displacement", "velocity", "force"})
      if (node.has(key)) node.pair(key);
  });
}

void check_contact(const Fields& contact) {
  const bool linear = contact.name("law", {"hertz", "linear"}) == "linear";
  contact.name("moment_arm", {"radius", "contact_point"});
  contact.flag("pull");
  for (const char* key : {"friction", "rolling_friction", "rolling_smoothing"})
    if (contact.has(key)) contact.number(key, 0);
  if (contact.has("rolling_stiffness")) {
    if (!(contact.number("rolling_stiffness", 0) > 0)) refuse(contact.at("rolling_stiffness"), "must be above 0");
    contact.number("rolling_damping", 0);
  }
  if (linear) {
    for (const char* key : {"kn", "kt", "cn", "ct"}) contact.number(key, 0);
  } else {
    contact.number("beta", 0);
    if (contact.has("tangential_damping")) contact.flag("tangential_damping");
  }
}

void check_seen(const Fields& seen, const Parts& parts) {
  // What each of `of` is, in order.
  const std::vector<const Names*> pressed{&parts.body, &parts.pressed}, plate{&parts.plate}, body{&parts.body};
  static const Names along{"velocity", "displacement", "momentum", "push", "greatest push", "mean push"};
  const std::map<std::string, std::vector<const Names*>> known{
      {"velocity", body},        {"displacement", body},        {"spin", {&parts.disc}},
      {"overlap", pressed},      {"greatest overlap", pressed}, {"greatest force", pressed},
      {"contact time", pressed}, {"torn springs", {}},          {"time of tear", {&parts.point, &parts.point}},
      {"momentum", {}},          {"angular momentum", {}},      {"push", plate},
      {"greatest push", plate},  {"mean push", plate},          {"mean height", {}}};
  Names what;
  for (const auto& [name, of] : known) what.insert(name);
  seen.text("name");
  const std::string asked = seen.name("what", what);
  const std::vector<const Names*>& needed = known.at(asked);
  if (along.contains(asked)) seen.pair("direction");
  if (asked == "mean push") seen.number("from");
  if (needed.empty()) return;
  const Json& of = seen.list("of");
  if (of.size() < needed.size()) refuse(seen.at("of"), "must name " + std::to_string(needed.size()) + " of the parts");
  for (std::size_t k = 0; k < needed.size(); ++k) {
    const std::string path = item(seen.at("of"), k);
    if (!of[k].is_string()) refuse(path, "must be a text, not " + shown(of[k]));
    Fields::one_of(path, of[k], *needed[k]);
  }
}

void check_plate(const Fields& plate, Parts& parts) {
  parts.plate.insert(plate.text("name"));
  for (const char* key : {"lower_left", "upper_right", "velocity"}) plate.pair(key);
  plate.name("material", parts.material);
}

void check_wall(const Fields& wall, Parts& parts) {
  parts.wall.insert(wall.text("name"));
  for (const char* key : {"point", "normal"}) wall.pair(key);
  wall.name("material", parts.material);
}

void check_material(const Fields& material, Parts& parts) {
  parts.material.insert(material.text("name"));
  if (material.has("rigid")) material.flag("rigid");
  if (material.has("rigid") && material.given("rigid").get<bool>()) return;
  for (const char* key : {"young", "poisson"}) material.number(key);
}

}  // namespace

void require_needs(const Json& c) {
  const Fields whole(c, "case");
  const Json& needs = whole.list("needs");
  for (std::size_t k = 0; k < needs.size(); ++k)
    if (!needs[k].is_string()) refuse(item("case.needs", k), "must be a text, not " + shown(needs[k]));
}

void require_fields(const Json& c) {
  const Fields whole(c, "case");
  Parts parts;
  whole.text("title");
  whole.pair("gravity");
  whole.each("material", [&](const Fields& f) { check_material(f, parts); });
  check_contact(Fields(whole.given("contact"), "case.contact"));
  whole.each("body", [&](const Fields& f) { check_body(f, parts); });
  whole.each("wall", [&](const Fields& f) { check_wall(f, parts); });
  whole.each("plate", [&](const Fields& f) { check_plate(f, parts); });
  whole.each("lattice", [&](const Fields& f) { check_lattice(f, parts); });
  if (parts.nodes != static_cast<double>(parts.point.size()))
    refuse("case.lattice", "has " + digits(parts.nodes) + " nodes, but case.body has " +
                               std::to_string(parts.point.size()) + " point masses");
  whole.each("spring", [&](const Fields& f) {
    for (const char* end : {"a", "b"}) f.name(end, parts.point);
    for (const char* key : {"stiffness", "damping", "length"}) f.number(key, 0);
    if (f.has("strength")) f.number("strength", 0);
  });
  whole.each("edge", [&](const Fields& f) {
    for (const char* end : {"a", "b"}) f.name(end, parts.point);
  });
  whole.each("pair", [&](const Fields& f) {
    for (const char* key : {"modulus", "shear_modulus"}) f.number(key, 0);
  });
  for (const Names* some : {&parts.disc, &parts.wall, &parts.plate, &parts.lattice})
    parts.pressed.insert(some->begin(), some->end());
  whole.each("observe", [&](const Fields& f) { check_seen(f, parts); });
}

}  // namespace furrow::verification
