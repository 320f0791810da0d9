// Files of targets, strictly: an unknown key, a wrong type or a value out of range is an error.
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "output/files.h"
#include "scene/wording.h"
#include "validation/calibration/judge_targets.h"
#include "validation/calibration/says.h"
#include "validation/calibration/targets.h"
#include "validation/page/observables.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

std::string text_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError("cannot read " + file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

Json json_of(const toml::node& node) {
  Json json;
  node.visit([&](const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (toml::is_table<T>) {
      json = Json::object();
      for (const auto& [key, item] : value) json[std::string(key.str())] = json_of(item);
    } else if constexpr (toml::is_array<T>) {
      json = Json::array();
      for (const auto& item : value) json.push_back(json_of(item));
    } else if constexpr (toml::is_string<T> || toml::is_integer<T> || toml::is_floating_point<T> ||
                         toml::is_boolean<T>) {
      json = value.get();
    } else {
      json = "a date";
    }
  });
  return json;
}

Json parsed(const fs::path& file) {
  const std::string text = text_in(file);
  if (file.extension() == ".json") {
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw std::invalid_argument(file.string() + ": is no JSON");
    return json;
  }
  try {
    return json_of(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(file.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                                std::string(error.description()));
  }
}

// A table of the file, read key by key; what is left over at the end is unknown.
class Fields {
 public:
  Fields(const Json& table, std::string where, std::vector<std::string>& faults)
      : table_(table), where_(std::move(where)), faults_(faults) {
    if (!table.is_object()) fault("must be a table");
  }
  const Json* find(const std::string& key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
    return table_.is_object() && table_.contains(key) ? &table_.at(key) : nullptr;
  }
  std::string text(const std::string& key, const std::string& otherwise = "") {
    const Json* found = find(key);
    if (found && !found->is_string()) fault(key + " must be a text, not " + found->dump());
    return found && found->is_string() ? found->get<std::string>() : otherwise;
  }
  double number(const std::string& key, double otherwise) {
    const Json* found = find(key);
    if (found && !found->is_number()) fault(key + " must be a number, not " + found->dump());
    return found && found->is_number() ? found->get<double>() : otherwise;
  }
  double positive(const std::string& key, double otherwise) {
    const double value = number(key, otherwise);
    if (std::isnan(otherwise) && table_.is_object() && !table_.contains(key))
      fault(key + " is missing");
    else if (!(value > 0) || !std::isfinite(value))
      fault(key + " must be above 0, not " + shortest(value));
    return value;
  }
  double within(const std::string& key, double otherwise, double least, double most) {
    const std::size_t known = faults_.size();
    const double value = positive(key, otherwise);
    if (faults_.size() == known && !(value >= least && value <= most))
      fault(key + " must be from " + shortest(least) + " to " + shortest(most) + ", not " + shortest(value));
    return value;
  }
  std::optional<std::array<double, 2>> pair(const std::string& key) {
    const Json* found = find(key);
    if (!found) return {};
    const auto is_number = [&](std::size_t k) {
      return found->at(k).is_number() && std::isfinite(found->at(k).get<double>());
    };
    const bool good = found->is_array() && found->size() == 2 && is_number(0) && is_number(1);
    if (good && found->at(0).get<double>() < found->at(1).get<double>())
      return std::array{found->at(0).get<double>(), found->at(1).get<double>()};
    fault(key + " must be two rising numbers, [from, to], not " + found->dump());
    return {};
  }
  template <class Word>
  Word choice(const std::string& key, const std::map<std::string, Word>& words, const std::string& otherwise) {
    const std::string word = text(key, otherwise);
    if (words.contains(word)) return words.at(word);
    std::vector<std::string> names;
    for (const auto& [name, value] : words) names.push_back(name);
    fault(key + " must be one of " + joined(names) + ", not " + in_quotes(word) + did_you_mean(word, names));
    return words.at(otherwise);
  }
  void fault(const std::string& what) { faults_.push_back(where_ + ": " + what); }
  void no_others() {
    if (!table_.is_object()) return;
    for (const auto& [key, value] : table_.items()) {
      if (std::find(known_.begin(), known_.end(), key) == known_.end())
        fault("unknown key " + in_quotes(key) + nearest_or_all(key, known_));
    }
  }

 private:
  const Json& table_;
  std::string where_;
  std::vector<std::string>& faults_;
  std::vector<std::string> known_{};
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    const std::size_t first = cell.find_first_not_of(" \t\""), last = cell.find_last_not_of(" \t\r\"");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

double cell_number(const std::string& cell, const std::string& where) {
  try {
    std::size_t used = 0;
    const double value = std::stod(cell, &used);
    if (used == cell.size() && std::isfinite(value)) return value;
  } catch (const std::logic_error&) {
  }
  throw std::invalid_argument(where + ": must be two numbers, displacement and force, not " + in_quotes(cell));
}

// A heading says the units: displacement in "[mm]" or "[m]", force in "[N]".
double millimetres_in(const std::string& heading, const fs::path& file) {
  const std::vector<std::string> cells = cells_of(heading);
  const auto has = [&](std::size_t k, const char* unit) { return cells.at(k).find(unit) != std::string::npos; };
  if (cells.size() == 2 && has(1, "[N]") && (has(0, "[mm]") || has(0, "[m]"))) return has(0, "[mm]") ? 1 : 1e3;
  throw std::invalid_argument(file.string() + ":1: the heading must name two columns with their units, as in " +
                              in_quotes("displacement [mm],force [N]") + ", not " + in_quotes(heading));
}

void read_curve(MeasuredCurve& curve, const fs::path& file) {
  std::istringstream lines(text_in(file));
  std::string line;
  std::getline(lines, line);
  const double millimetres = millimetres_in(line, file);
  for (int k = 2; std::getline(lines, line); ++k) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.empty()) continue;
    const std::string where = file.string() + ":" + std::to_string(k);
    if (cells.size() != 2)
      throw std::invalid_argument(where + ": must be two numbers, displacement and force, not " + in_quotes(line));
    curve.mm.push_back(millimetres * cell_number(cells[0], where));
    curve.force.push_back(cell_number(cells[1], where));
    if (curve.mm.back() < 0)
      throw std::invalid_argument(where + ": the displacement must not be below 0, where the plate starts");
    if (curve.mm.size() > 1 && !(curve.mm.back() > curve.mm[curve.mm.size() - 2]))
      throw std::invalid_argument(where + ": the displacement must rise from line to line");
  }
  if (curve.mm.size() < 2) throw std::invalid_argument(file.string() + ": fewer than two points");
}

const std::map<std::string, Relation> relations{{"equals", Relation::equals},
                                                {"below", Relation::below},
                                                {"above", Relation::above},
                                                {"between", Relation::between},
                                                {"says", Relation::says}};
const std::map<std::string, CurveNorm> norms{
    {"rms", CurveNorm::rms}, {"mean", CurveNorm::mean}, {"max", CurveNorm::max}};
const std::map<std::string, std::string> components{{"F", "F"}, {"Fx", "Fx"}, {"Fy", "Fy"}};

void read_value(CalibrationTarget& target, Fields& fields) {
  target.relation = fields.choice("relation", relations, "equals");
  if (target.relation == Relation::says) {
    target.words = fields.text("value");
    if (target.words.empty()) fields.fault("value must be the words that are expected");
    return;
  }
  target.tolerance = fields.within("tolerance", NAN, least_tolerance, most_tolerance);
  if (target.relation == Relation::between) {
    const auto ends = fields.pair("value");
    if (!ends) fields.fault("value must be [from, to]");
    target.value = ends.value_or(target.value);
    return;
  }
  target.value[0] = fields.number("value", NAN);
  if (!fields.find("value"))
    fields.fault("value is missing");
  else if (fields.find("value")->is_number() && !std::isfinite(target.value[0]))
    fields.fault("value must be finite, not " + shortest(target.value[0]));
}

// What the observable can say, against what the target wants of it.
void judge_observable(const CalibrationTarget& target, Fields& fields) {
  const Says says = says_of(target.observable);
  if (target.relation == Relation::says && !target.words.empty()) {
    if (const std::string fault = fault_of_words(target.observable, target.words); !fault.empty()) fields.fault(fault);
  }
  if (target.relation != Relation::says && !says.number)
    fields.fault(target.observable + " says words, no number: give relation = \"says\" and the words as value");
  if (!target.window) return;
  if (!says.window) fields.fault("window has no effect on " + target.observable + ": leave it out");
  if ((*target.window)[0] < 0) fields.fault("window must not begin below 0, where the plate starts");
}

void read_observable(CalibrationTarget& target, Fields& fields) {
  target.observable = fields.text("observable");
  target.window = fields.pair("window");
  const std::vector<std::string>& known = observable_names();
  if (target.observable.empty()) {
    fields.fault("says neither observable nor curve");
  } else if (std::find(known.begin(), known.end(), target.observable) == known.end()) {
    fields.fault("there is no observable " + in_quotes(target.observable) + nearest_or_all(target.observable, known));
  }
  const bool is_known = std::find(known.begin(), known.end(), target.observable) != known.end();
  read_value(target, fields);
  if (is_known) judge_observable(target, fields);
}

CalibrationTarget target_of(const Json& table, std::size_t number, const fs::path& file,
                            const std::vector<std::string>& scenes, std::vector<std::string>& faults) {
  Fields fields(table, file.string() + ": target " + std::to_string(number), faults);
  CalibrationTarget target;
  target.scene = fields.text("scene", scenes.size() == 1 ? scenes[0] : "");
  if (std::find(scenes.begin(), scenes.end(), target.scene) == scenes.end())
    fields.fault("scene must be one of " + joined(scenes) + ", not " + in_quotes(target.scene));
  if (const std::string curve = fields.text("curve"); !curve.empty()) {
    target.curve.emplace();
    target.curve->file = curve;
    target.curve->component = fields.choice("component", components, "F");
    target.curve->norm = fields.choice("norm", norms, "rms");
    target.tolerance = fields.within("tolerance", NAN, least_tolerance, most_tolerance);
    read_curve(*target.curve, file.parent_path() / curve);
  } else {
    read_observable(target, fields);
  }
  if (const std::string fault = fault_of_tolerance(target); !fault.empty()) fields.fault(fault);
  target.weight = fields.within("weight", 1, least_weight, most_weight);
  target.named = fields.find("name") != nullptr;
  target.name = fields.text("name", target.curve ? target.curve->file : target.observable);
  fields.no_others();
  return target;
}

}  // namespace

Targets read_targets(const fs::path& file, const std::vector<std::string>& scenes) {
  const Json root = parsed(file);
  std::vector<std::string> faults;
  Fields fields(root, file.string(), faults);
  Targets targets;
  targets.title = fields.text("title", file.stem().string());
  targets.missing = fields.within("missing", 10, least_missing, most_missing);
  targets.bounded =
      fields.choice("loss", std::map<std::string, bool>{{"squares", false}, {"bounded", true}}, "squares");
  const Json* list = fields.find("target");
  if (!list || !list->is_array() || list->empty()) fields.fault("there is no [[target]]");
  for (std::size_t k = 0; list && list->is_array() && k < list->size(); ++k)
    targets.all.push_back(target_of(list->at(k), k + 1, file, scenes, faults));
  fields.no_others();
  if (faults.empty()) {
    for (const std::string& fault : faults_between(targets.all, scenes)) fields.fault(fault);
  }
  if (!faults.empty()) throw std::invalid_argument(joined(faults, "\n"));
  return targets;
}

}  // namespace furrow::validation
