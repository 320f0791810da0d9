#include "validation/page/run_record.h"

#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 0
#endif
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/files.h"
#include "output/schedule.h"
#include "physics/ramp.h"
#include "scene/labels.h"
#include "scene/read.h"

namespace furrow::validation {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Json = nlohmann::ordered_json;

std::string text_of(const Json& value) {
  if (value.is_number_float()) return number(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Fact fact_of(const std::string& key, const Json& value) {
  Fact fact{key, {}, value.is_number_float()};
  if (value.is_array()) {
    for (const Json& part : value) fact.texts.push_back(text_of(part));
  } else if (!value.is_null()) {
    fact.texts.push_back(text_of(value));
  }
  return fact;
}

double number_or(const Json& value, double otherwise) { return value.is_number() ? value.get<double>() : otherwise; }

WatchedFact watched_fact(const std::string& name, const Json& watch) {
  if (watch.is_string()) return {.name = name, .verdict = watch, .where = {}, .worst = nan, .time = nan};
  WatchedFact w{.name = name, .verdict = watch.at("verdict"), .where = watch.at("where")};
  w.worst = number_or(watch.at("worst"), infinity);  // JSON has no infinity
  w.time = watch.at("time");
  w.warns_above = watch.at("warns_above");
  w.ends_above = number_or(watch.at("ends_above"), infinity);
  const Json& allowed = watch.at("allowed");
  if (!allowed.is_null()) w.allowed = number_or(allowed, infinity);
  return w;
}

void read_facts(const std::filesystem::path& file, RunRecord& run) {
  try {
    const auto json = Json::parse(run_text(file));
    if (!json.is_object()) throw std::runtime_error(file.string() + ": is not a JSON object");
    for (const auto& [key, value] : json.items()) {
      if (key == "validity") {
        run.validity = value.at("verdict");
        for (const auto& [name, watch] : value.items())
          if (name != "verdict") run.watched.push_back(watched_fact(name, watch));
      } else if (key == "largest_force") {
        for (const Json& plate : value) run.largest_force.push_back({plate.at("F"), plate.at("time")});
      } else {
        run.facts.push_back(fact_of(key, value));
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

ForceCurve force_curve(const Table& table, const Scene& scene) {
  ForceCurve curve;
  curve.due = 0;
  Due due(make_method(scene.time.method)->info(), scene.time.step, scene.output.interval);
  const auto& plate = table.texts("plate");
  const auto t = table.numbers("t [s]"), mm = table.numbers("displacement [m]"), fx = table.numbers("Fx [N]"),
             fy = table.numbers("Fy [N]"), f = table.numbers("F [N]");
  for (std::size_t k = 0; k < plate.size(); ++k) {
    if (plate[k] != plate[0]) continue;
    if (due.at(t[k])) ++curve.due;
    due.take(t[k]);
    curve.mm.push_back(1e3 * mm[k]);
    curve.fx.push_back(0 - fx[k]);
    curve.fy.push_back(fy[k]);
    curve.f.push_back(f[k]);
  }
  return curve;
}

Parts lattices_of(Scene scene) {
  scene.disc.clear();
  scene.packing.clear();
  scene.plate.clear();
  return make_parts(scene);
}

std::vector<TornLink> torn_links(const Table& events, const Parts& parts) {
  const std::vector<std::string> lattices = labels(parts.lattice);
  std::map<std::vector<std::string>, int> index;
  for (int k = 0; k < parts.link.count(); ++k) {
    const int a = parts.link.a[k], b = parts.link.b[k], owner = parts.node.lattice[a];
    index[{to_string(parts.link.kind[k]), lattices[owner], std::to_string(parts.node.row[a]),
           std::to_string(parts.node.column[a]), std::to_string(parts.node.row[b]),
           std::to_string(parts.node.column[b])}] = k;
  }
  const auto mm = events.numbers("displacement [m]");
  std::vector<TornLink> torn;
  for (std::size_t k = 0; k < mm.size(); ++k) {
    std::vector<std::string> key;
    for (const char* column : {"kind", "lattice", "row a", "column a", "row b", "column b"})
      key.push_back(events.texts(column)[k]);
    const auto found = index.find(key);
    if (found == index.end())
      throw std::runtime_error(events.file() + ":" + std::to_string(k + 2) + ": no such link in the scene");
    torn.push_back({1e3 * mm[k], found->second});
  }
  return torn;
}

[[noreturn]] void wrong_publication(const std::string& what) { throw std::runtime_error("statements.toml: " + what); }

std::array<double, 2> pair_of(const toml::node& value, const std::string& which) {
  const toml::array* two = value.as_array();
  if (!two || two->size() != 2 || !two->get(0)->is_number() || !two->get(1)->is_number())
    wrong_publication(which + " must be two numbers");
  return {two->get(0)->value_or(nan), two->get(1)->value_or(nan)};
}

// A misspelt key is an error, or what it says would be left out without a word.
Statement statement_of(const toml::table& entry, const std::string& which) {
  Statement s;
  std::string label;
  const std::map<std::string_view, std::string*> texts{{"id", &s.id},
                                                       {"scene", &s.scene},
                                                       {"quantity", &s.quantity},
                                                       {"unit", &s.unit},
                                                       {"relation", &s.relation},
                                                       {"where", &s.where},
                                                       {"read", &s.read},
                                                       {"observable", &s.observable},
                                                       {"ours", &s.ours},
                                                       {"expect", &s.expect},
                                                       {"mark", &s.mark},
                                                       {"label", &label}};
  for (const auto& [key, value] : entry) {
    const std::string its = which + ": " + std::string(key.str());
    const auto text = texts.find(key.str());
    if (key == "window" || key == "holds") {
      (key == "window" ? s.window : s.holds) = pair_of(value, its);
    } else if (key == "value" && value.is_number()) {
      s.value = value.value_or(nan);
    } else if (!value.is_string() || (key != "value" && text == texts.end())) {
      wrong_publication(its +
                        (text == texts.end() && key != "value" ? " is no key of a statement" : " must be a text"));
    } else {
      *(key == "value" ? &s.words : text->second) = value.value_or(std::string());
    }
  }
  if (s.id.empty() || (s.words.empty() && std::isnan(s.value))) wrong_publication(which + " has no id or no value");
  s.label = label.empty() ? number(s.value) + " " + s.unit : label;
  return s;
}

}  // namespace

const Fact* RunRecord::fact(std::string_view key) const {
  const auto found = std::find_if(facts.begin(), facts.end(), [&](const Fact& f) { return f.key == key; });
  return found == facts.end() ? nullptr : &*found;
}

bool RunRecord::finished() const {
  const Fact* ended = fact("ended");
  return ended && ended->texts == std::vector<std::string>{"finished"};
}

double plate_speed(const RunRecord& run) {
  if (run.scene.plate.empty()) return 0;
  return 1e3 * std::hypot(run.scene.plate[0].velocity.x, run.scene.plate[0].velocity.y);
}

double plate_displacement(const RunRecord& run, double t) {
  return run.scene.plate.empty() ? 0 : plate_speed(run) * ramped(t, run.scene.plate[0].ramp).time;
}

RunRecord read_run(const std::string& name, const std::filesystem::path& directory) {
  RunRecord run;
  run.name = name;
  const auto scene = directory / "scene.toml", frames = directory / "frames";
  read_facts(directory / "run.json", run);
  run.scene = parse_scene(run_text(scene), scene.string());
  run.lattices = lattices_of(run.scene);
  if (!run.fact("steps")) return run;
  run.force = force_curve(Table(directory / "plate_force.csv"), run.scene);
  run.energy = Table(directory / "energy.csv");
  run.torn = torn_links(Table(directory / "events.csv"), run.lattices);
  if (const Fact* met = run.fact("plate_meets_lattice"))
    run.met = met->texts.empty() ? nan : plate_speed(run) * std::strtod(met->texts[0].c_str(), nullptr);
  const Table list(frames / "frames.csv");
  const auto displacement = list.numbers("displacement [m]");
  for (std::size_t k = 0; k < list.rows(); ++k) {
    const std::string& index = list.texts("index")[k];
    const std::string ending = "_" + std::string(index.size() < 3 ? 3 - index.size() : 0, '0') + index + ".csv";
    run.frames.push_back({1e3 * displacement[k], Table(frames / ("discs" + ending)), Table(frames / ("links" + ending)),
                          Table(frames / ("plates" + ending))});
  }
  return run;
}

Publication read_publication(std::string_view text) {
  try {
    const toml::table root = toml::parse(text);
    Publication publication{root["title"].value_or(std::string()), {}};
    const toml::array* entries = root["statement"].as_array();
    if (publication.title.empty()) wrong_publication("there is no title");
    if (!entries || entries->empty()) wrong_publication("there is no statement");
    for (std::size_t k = 0; k < entries->size(); ++k) {
      const toml::table* entry = entries->get(k)->as_table();
      const std::string which = "statement " + std::to_string(k + 1);
      if (!entry) wrong_publication(which + " is no table");
      publication.statements.push_back(statement_of(*entry, which));
    }
    return publication;
  } catch (const toml::parse_error& error) {
    wrong_publication(std::string(error.description()));
  }
}

}  // namespace furrow::validation
