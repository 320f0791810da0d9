// Files of targets, strictly: an unknown key, a wrong type or a value out of range is an error.
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "scene/wording.h"
#include "validation/calibration/judge_targets.h"
#include "validation/calibration/read_curve.h"
#include "validation/calibration/says.h"
#include "validation/calibration/targets.h"
#include "validation/calibration/targets_file.h"
#include "validation/page/observables.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

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

// That which the heading of the curve names, or the key, or neither: then the magnitude.
void read_component(MeasuredCurve& curve, Fields& fields) {
  curve.component = fields.choice("component", components, "F");
  if (curve.heading.empty() || curve.heading == curve.component) return;
  const std::string given = fields.text("component");
  if (components.contains(given))
    fields.fault("component is " + in_quotes(given) + ", but the heading of " + curve.file + " names " +
                 in_quotes(curve.heading) + ": correct one of them, or leave component out");
  curve.component = curve.heading;
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
    target.curve->norm = fields.choice("norm", norms, "rms");
    target.tolerance = fields.within("tolerance", NAN, least_tolerance, most_tolerance);
    read_curve(*target.curve, file.parent_path() / curve);
    read_component(*target.curve, fields);
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
  const Json root = json_in(file);
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
