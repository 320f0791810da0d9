#include "verification/engines/case.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "report/embedded.h"
#include "scene/wording.h"
#include "verification/engines/transform.h"

namespace furrow::verification {
namespace {

constexpr std::string_view folder = "verification/cases/";

Json json_of(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    Json all = Json::object();
    for (const auto& [key, value] : *table) all[std::string(key.str())] = json_of(value);
    return all;
  }
  if (const auto* list = node.as_array()) {
    Json all = Json::array();
    for (const toml::node& value : *list) all.push_back(json_of(value));
    return all;
  }
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* truth = node.as_boolean()) return truth->get();
  if (const auto* whole = node.as_integer()) return whole->get();
  if (const auto* real = node.as_floating_point()) return real->get();
  throw std::invalid_argument("dates have no place in a case");
}

void complete_bodies(Json& c) {
  for (Json& body : c["body"]) {
    if (!body.contains("shape")) continue;
    const bool sphere = body["shape"] == "sphere";
    const double r = body["radius"];
    if (body.contains("density"))
      body["mass"] = body["density"].get<double>() * std::numbers::pi * r * r * (sphere ? 4 * r / 3 : 1);
    body["inertia"] = (sphere ? 0.4 : 0.5) * body["mass"].get<double>() * r * r;
  }
  for (Json& body : c["body"]) {
    for (const char* zero : {"radius", "inertia", "spin"}) body.emplace(zero, 0.0);
    body.emplace("velocity", Json::array({0.0, 0.0}));
    body.emplace("load", Json::array({0.0, 0.0}));
    body.emplace("fixed", false);
  }
}

std::string node_name(const Json& lattice, int row, int column) {
  return lattice["name"].get<std::string>() + "." + std::to_string(row) + "." + std::to_string(column);
}

Json body_of_node(const Json& lattice, int row, int column) {
  const auto has = [&](const char* key, int value) {
    const Json list = lattice.value(key, Json::array());
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  const double s = lattice["spacing"];
  double x = lattice["origin"][0].get<double>() + column * s;
  double y = lattice["origin"][1].get<double>() + row * s;
  Json body{{"name", node_name(lattice, row, column)},
            {"mass", lattice["node_mass"]},
            {"material", lattice["material"]},
            {"contact_radius", lattice.value("contact_radius", 0.01)},
            {"fixed", has("fixed_rows", row) || has("fixed_columns", column)}};
  for (const Json& node : lattice.value("node", Json::array())) {
    if (node.value("row", 0) != row || node.value("column", 0) != column) continue;
    const Json moved = node.value("displacement", Json::array({0.0, 0.0}));
    x += moved[0].get<double>();
    y += moved[1].get<double>();
    if (node.contains("velocity")) body["velocity"] = node["velocity"];
    if (node.contains("force")) body["load"] = node["force"];
  }
  body["position"] = {x, y};
  return body;
}

// Structural, shear and bending springs of one node, to neighbours above and to the right.
void add_springs(Json& c, const Json& lattice, int row, int column) {
  struct Neighbour {
    int up, right;
    const char* kind;
  };
  for (const auto& [up, right, kind] :
       {Neighbour{0, 1, "structural"}, Neighbour{1, 0, "structural"}, Neighbour{1, 1, "shear"},
        Neighbour{1, -1, "shear"}, Neighbour{0, 2, "bending"}, Neighbour{2, 0, "bending"}}) {
    const int r = row + up, k = column + right;
    if (!lattice.contains(kind) || k < 0 || r >= lattice["rows"] || k >= lattice["columns"]) continue;
    Json spring{{"a", node_name(lattice, row, column)},
                {"b", node_name(lattice, r, k)},
                {"kind", kind},
                {"length", lattice["spacing"].get<double>() * std::sqrt(up * up + right * right)}};
    spring.update(lattice[kind]);
    spring.emplace("damping", 0.0);
    c["spring"].push_back(spring);
  }
}

// The outline, which discs touch at one point, the nearest; of a single node only that node.
void add_edges(Json& c, const Json& lattice) {
  const int top = lattice["rows"].get<int>() - 1, right = lattice["columns"].get<int>() - 1;
  const auto add = [&](int r1, int c1, int r2, int c2) {
    c["edge"].push_back({{"outline", lattice["name"]},
                         {"a", node_name(lattice, r1, c1)},
                         {"b", node_name(lattice, r2, c2)},
                         {"auxiliary_points", lattice.value("auxiliary_points", 9)}});
  };
  if (top == 0 && right == 0) add(0, 0, 0, 0);
  for (int k = 0; k < right; ++k) {
    add(0, k, 0, k + 1);
    if (top > 0) add(top, k, top, k + 1);
  }
  for (int r = 0; r < top; ++r) {
    add(r, 0, r + 1, 0);
    if (right > 0) add(r, right, r + 1, right);
  }
}

bool has_discs(const Json& c) {
  return std::any_of(c["body"].begin(), c["body"].end(), [](const Json& body) { return body["radius"] > 0.0; });
}

void write_out_lattices(Json& c) {
  const bool discs = has_discs(c);
  for (const Json& lattice : c["lattice"]) {
    for (int row = 0; row < lattice["rows"]; ++row) {
      for (int column = 0; column < lattice["columns"]; ++column) {
        c["body"].push_back(body_of_node(lattice, row, column));
        add_springs(c, lattice, row, column);
      }
    }
    if (discs) add_edges(c, lattice);
  }
}

double softness(const Json& m) {
  const double nu = m.value("poisson", 0.0);
  return m.value("rigid", false) ? 0 : (1 - nu * nu) / m["young"].get<double>();
}
double shear_softness(const Json& m) {
  const double nu = m.value("poisson", 0.0);
  return m.value("rigid", false) ? 0 : 2 * (2 - nu) * (1 + nu) / m["young"].get<double>();
}

void add_pairs(Json& c) {
  c["pair"] = Json::array();
  const Json& all = c["material"];
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i; j < all.size(); ++j) {
      const double normal = softness(all[i]) + softness(all[j]);
      if (normal == 0) continue;
      c["pair"].push_back({{"materials", {all[i]["name"], all[j]["name"]}},
                           {"modulus", 1 / normal},
                           {"shear_modulus", 1 / (shear_softness(all[i]) + shear_softness(all[j]))}});
    }
  }
}

void complete_contact(Json& c) {
  Json& contact = c["contact"];
  if (contact.is_null()) contact = Json::object();
  contact.emplace("law", "hertz");
  if (contact.contains("restitution")) {
    const double log_e = std::log(contact["restitution"].get<double>());
    contact["beta"] = -log_e / std::hypot(log_e, std::numbers::pi);
  }
  for (const char* zero : {"beta", "friction", "rolling_friction"}) contact.emplace(zero, 0.0);
  contact.emplace("pull", false);
  contact.emplace("tangential_damping", true);
  contact.emplace("moment_arm", "radius");
}

void write_out(Json& c) {
  for (const char* list : {"material", "body", "wall", "plate", "spring", "edge", "lattice"})
    c.emplace(list, Json::array());
  c.emplace("gravity", Json::array({0.0, 0.0}));
  complete_bodies(c);
  write_out_lattices(c);
  complete_bodies(c);
  complete_contact(c);
  add_pairs(c);
}

bool fits(const Json& c, const std::string& pattern) {
  const auto& names = case_names();
  if (std::find(names.begin(), names.end(), pattern) != names.end()) return c["name"] == pattern;
  if (c["name"].get<std::string>().find(pattern) != std::string::npos) return true;
  return std::find(c["needs"].begin(), c["needs"].end(), pattern) != c["needs"].end();
}

}  // namespace

Json plain_case_from(std::string_view text, const std::string& name) {
  try {
    Json c = json_of(toml::parse(text, name));
    Json whole{{"name", name}};
    whole.update(c);
    return whole;
  } catch (const toml::parse_error& fault) {
    throw std::invalid_argument("case " + name + ", line " + std::to_string(fault.source().begin.line) + ": " +
                                std::string(fault.description()));
  }
}

Json case_from(std::string_view text, const std::string& name) {
  try {
    Json c = plain_case_from(text, name);
    if (c.contains("view")) return seen_from(case_named(c["view"]["of"]), c);
    write_out(c);
    return c;
  } catch (const Json::exception& fault) {
    throw std::invalid_argument("case " + name + ": " + fault.what());
  }
}

Json made_of_lattices(Json c) {
  Json discs = Json::array();
  for (const Json& body : c["body"]) {
    if (body["radius"] > 0.0) discs.push_back(body);
  }
  c["body"] = discs;
  for (const char* list : {"spring", "edge", "pair"}) c[list] = Json::array();
  write_out(c);
  return c;
}

const std::vector<std::string>& case_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const std::string_view file : embedded_files(folder))
      all.emplace_back(file.substr(folder.size(), file.size() - folder.size() - std::string_view(".toml").size()));
    std::sort(all.begin(), all.end());
    return all;
  }();
  return names;
}

Json case_named(const std::string& name) {
  const auto& names = case_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw std::invalid_argument("there is no case " + in_quotes(name) + nearest_or_all(name, names) +
                                "; see furrow cases");
  return case_from(embedded(std::string(folder) + name + ".toml"), name);
}

std::vector<Json> cases_like(const std::vector<std::string>& patterns) {
  std::vector<Json> all;
  for (const std::string& name : case_names()) all.push_back(case_named(name));
  if (patterns.empty()) return all;
  std::set<std::string> known(case_names().begin(), case_names().end());
  for (const Json& c : all) known.insert(c["needs"].begin(), c["needs"].end());
  for (const std::string& pattern : patterns) {
    if (std::none_of(all.begin(), all.end(), [&](const Json& c) { return fits(c, pattern); }))
      throw std::invalid_argument("no case has " + in_quotes(pattern) + " in its name or among its needs" +
                                  nearest_or_all(pattern, {known.begin(), known.end()}) + "; see furrow cases");
  }
  std::erase_if(all, [&](const Json& c) {
    return std::none_of(patterns.begin(), patterns.end(), [&](const std::string& p) { return fits(c, p); });
  });
  return all;
}

Json request_of(const Json& whole, int steps) {
  Json c = whole;
  for (const char* verdict : {"source", "oracle", "members", "moved", "steps", "view", "floor", "limit", "reason"})
    c.erase(verdict);
  for (Json& seen : c["observe"]) {
    for (const char* answer :
         {"value", "interval", "published", "published_by", "floor", "limit", "kind", "scale", "reason", "made_by"})
      seen.erase(answer);
  }
  const double step = whole["unit"].get<double>() / steps;
  const double count = std::round(whole["end"].get<double>() / step);
  return {{"protocol", 1}, {"steps", steps}, {"step", step}, {"count", static_cast<long>(count)}, {"case", c}};
}

const Json& named(const Json& whole, const char* list, const std::string& name) {
  for (const Json& one : whole[list]) {
    if (one["name"] == name) return one;
  }
  throw std::invalid_argument("case " + whole["name"].get<std::string>() + ": no " + list + " is called " +
                              in_quotes(name));
}

}  // namespace furrow::verification
