#include "page/run_record.h"

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
#include "scene/labels.h"
#include "scene/read.h"

namespace furrow {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<Fact> read_facts(const std::filesystem::path& file) {
  const auto text_of = [](const nlohmann::ordered_json& value) {
    if (value.is_number_float()) return number(value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  std::vector<Fact> facts;
  try {
    const auto json = nlohmann::ordered_json::parse(run_text(file));
    if (!json.is_object()) throw std::runtime_error(file.string() + ": is not a JSON object");
    for (const auto& [key, value] : json.items()) {
      facts.push_back({key, {}, value.is_number_float()});
      if (value.is_array()) {
        for (const auto& part : value) facts.back().texts.push_back(text_of(part));
      } else if (!value.is_null()) {
        facts.back().texts.push_back(text_of(value));
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
  return facts;
}

ForceCurve force_curve(const Table& table) {
  ForceCurve curve;
  const auto& plate = table.texts("plate");
  const auto mm = table.numbers("displacement [m]"), fx = table.numbers("Fx [N]"), fy = table.numbers("Fy [N]"),
             f = table.numbers("F [N]");
  for (std::size_t k = 0; k < plate.size(); ++k) {
    if (plate[k] != plate[0]) continue;
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

RunRecord read_run(const std::string& name, const std::filesystem::path& directory) {
  RunRecord run;
  run.name = name;
  const auto scene = directory / "scene.toml", frames = directory / "frames";
  run.facts = read_facts(directory / "run.json");
  run.scene = parse_scene(run_text(scene), scene.string());
  run.lattices = lattices_of(run.scene);
  if (!run.fact("steps")) return run;
  run.force = force_curve(Table(directory / "plate_force.csv"));
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
    for (std::size_t k = 0; entries && k < entries->size(); ++k) {
      const toml::node_view entry(*entries->get(k));
      Statement s;
      for (const auto& [key, field] : {std::pair{"id", &s.id},
                                       {"scene", &s.scene},
                                       {"quantity", &s.quantity},
                                       {"value", &s.words},
                                       {"unit", &s.unit},
                                       {"relation", &s.relation},
                                       {"where", &s.where},
                                       {"read", &s.read},
                                       {"observable", &s.observable},
                                       {"ours", &s.ours},
                                       {"expect", &s.expect},
                                       {"mark", &s.mark}}) {
        *field = entry[key].value_or(std::string());
      }
      if (s.words.empty()) s.value = entry["value"].value_or(nan);
      s.label = entry["label"].value_or(number(s.value) + " " + s.unit);
      const auto pair = [&](const char* key) -> std::optional<std::array<double, 2>> {
        if (!entry[key].is_array()) return std::nullopt;
        return std::array{entry[key][0].value_or(nan), entry[key][1].value_or(nan)};
      };
      s.window = pair("window");
      s.holds = pair("holds");
      if (s.id.empty() || (s.words.empty() && std::isnan(s.value))) {
        throw std::runtime_error("statements.toml: statement " + std::to_string(k + 1) + " has no id or no value");
      }
      publication.statements.push_back(std::move(s));
    }
    return publication;
  } catch (const toml::parse_error& error) {
    throw std::runtime_error("statements.toml: " + std::string(error.description()));
  }
}

}  // namespace furrow
