#include "report/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

#include "output/build_info.h"
#include "output/files.h"
#include "output/machine.h"
#include "output/strict_json.h"
#include "report/seal.h"
#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr std::size_t schema = 2;  // of the file; 1 had no lists of names

double load_of_the_machine() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

Json json_of(const Result& r) {
  Json json{{"key", r.key}};
  if (!r.input.empty()) json["input"] = r.input;
  if (r.timed) json["timed"] = true;
  json["cpu"] = r.cpu;
  if (r.maker != 0) json["maker"] = r.maker;
  json["value"] = r.value;
  return json;
}

// Values that are objects with the same names, in the same order, share a list of these.
using Names = std::vector<std::string>;

Names names_in(const Json& value) {
  Names names;
  if (value.is_object()) {
    for (const auto& one : value.items()) names.push_back(one.key());
  }
  return names;
}

std::vector<Names> shared_names(const std::vector<Result>& results) {
  std::map<Names, int> counts;
  std::vector<Names> shared;
  for (const Result& r : results) {
    const Names names = names_in(r.value);
    if (!names.empty() && ++counts[names] == 2) shared.push_back(names);
  }
  return shared;
}

void share_names(Json& result, const std::vector<Names>& shared) {
  const auto found = std::find(shared.begin(), shared.end(), names_in(result["value"]));
  if (found == shared.end()) return;
  Json numbers = Json::array();
  for (Json& one : result["value"]) numbers.push_back(std::move(one));
  result["names"] = found - shared.begin();
  result["value"] = std::move(numbers);
}

// A place in a list, or a schema: 0.7 of it would be read as 0.
std::size_t whole(const Json& json, const char* what) {
  if (!json.is_number_unsigned())
    throw std::out_of_range(std::string(what) + " is no whole number from 0 but " + json.dump());
  return json;
}

const Names& at_place(const std::vector<Names>& shared, std::size_t place) {
  if (place >= shared.size()) throw std::out_of_range("a result has names that are not there");
  return shared[place];
}

Json value_of(const Json& result, const std::vector<Names>& shared) {
  if (!result.contains("names")) return result.at("value");
  const Names& names = at_place(shared, whole(result.at("names"), "a result's names"));
  const Json& numbers = result.at("value");
  Json value = Json::object();
  if (numbers.is_array() && numbers.size() == names.size()) {
    for (std::size_t k = 0; k < names.size(); ++k) value[names[k]] = numbers[k];
  }
  if (value.size() != names.size()) throw std::out_of_range("a result has other names than values");
  return value;
}

Result result_of(const Json& json, const std::vector<Names>& shared) {
  return {json.at("key"),
          json.value("input", ""),
          json.value("timed", false),
          json.at("cpu"),
          json.contains("maker") ? whole(json.at("maker"), "a result's maker") : 0,
          value_of(json, shared)};
}

std::string text_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

double to_digits(double value, int digits) {
  if (!std::isfinite(value)) return value;
  const std::string text = rounded(value, digits);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string now_in_utc() {
  const std::time_t seconds = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

Json json_of(const Maker& m) {
  return {{"commit", m.commit},   {"when", m.when}, {"compiler", m.compiler}, {"flags", m.flags},
          {"machine", m.machine}, {"load", m.load}, {"sources", m.sources}};
}

Maker maker_of(const Json& json) {
  Maker m;
  json.at("commit").get_to(m.commit);
  json.at("when").get_to(m.when);
  json.at("compiler").get_to(m.compiler);
  json.at("flags").get_to(m.flags);
  json.at("machine").get_to(m.machine);
  json.at("load").get_to(m.load);
  json.at("sources").get_to(m.sources);
  for (const std::string& text : {m.commit, m.when, m.compiler, m.flags, m.machine}) {
    if (visible(text) != text) throw std::out_of_range("a maker has characters that cannot be shown: " + visible(text));
  }
  return m;
}

Maker this_maker(const Sources& sources) {
  const BuildInfo& build = build_info();
  return {.commit = std::string(build.commit),
          .when = now_in_utc(),
          .compiler = std::string(build.compiler),
          .flags = std::string(build.flags),
          .machine = processor_name(),
          .load = load_of_the_machine(),
          .sources = sources};
}

std::size_t place_in(std::vector<Maker>& makers, const Maker& maker) {
  const auto known = std::find(makers.begin(), makers.end(), maker);
  const auto place = static_cast<std::size_t>(known - makers.begin());
  if (known == makers.end()) makers.push_back(maker);
  return place;
}

Maker maker_in(const Json& kept, const Json& result, const char* key) {
  if (kept.contains("makers")) return maker_of(kept.at("makers").at(whole(result.at(key), "a result's maker")));
  const std::string own = text_in(result, "commit");
  return {.commit = own.empty() ? text_in(kept, "commit") : own,
          .when = text_in(kept, "when"),
          .compiler = {},
          .flags = {},
          .machine = text_in(kept, "machine"),
          .sources = {}};
}

const Result* Numbers::find(const std::string& key) const {
  const auto found = places_.find(key);
  return found == places_.end() ? nullptr : &results_[found->second];
}

const Json& Numbers::at(const std::string& key) const {
  const Result* result = find(key);
  if (!result) throw std::out_of_range("study " + study_ + " has no result '" + key + "'");
  return result->value;
}

void Numbers::add(Result result, const Maker& maker) {
  result.maker = place_in(makers_, maker);
  const auto [place, isnew] = places_.emplace(result.key, results_.size());
  if (isnew) {
    results_.push_back(std::move(result));
  } else {
    results_[place->second] = std::move(result);
  }
}

Numbers Numbers::read(const std::filesystem::path& file) { return of(read_sealed(file), file); }

Numbers Numbers::of(const Json& kept, const std::filesystem::path& file) {
  try {
    if (const std::size_t its = whole(kept.at("schema"), "schema"); its < 1 || its > schema)
      throw FileError(file.string() + ": is of schema " + std::to_string(its) + ", not " + std::to_string(schema));
    Numbers numbers(kept.at("study"), kept.at("form"));
    std::vector<Maker> makers;
    for (const Json& maker : kept.at("makers")) makers.push_back(maker_of(maker));
    const auto shared = kept.value("names", std::vector<Names>{});
    for (const Json& result : kept.at("results")) {
      Result one = result_of(result, shared);
      if (numbers.find(one.key)) throw FileError(file.string() + ": two results of the key '" + one.key + "'");
      if (one.maker >= makers.size())
        throw FileError(file.string() + ": '" + one.key + "' names a maker that is not there");
      const Maker& maker = makers[one.maker];
      numbers.add(std::move(one), maker);
    }
    return numbers;
  } catch (const nlohmann::json::exception& error) {
    throw FileError(file.string() + ": is not the numbers of a study: " + error.what());
  } catch (const std::out_of_range& error) {
    throw FileError(file.string() + ": is not the numbers of a study: " + error.what());
  }
}

bool Numbers::is_one(const std::string& study, const std::string& text) {
  const Json json = json_or_discarded(text);
  return json.is_object() && json.contains("schema") && json.contains("results") && json.value("study", "") == study;
}

Json Numbers::json() const {
  Json all{{"study", study_}, {"form", form_}, {"schema", schema}, {"makers", Json::array()}};
  for (const Maker& maker : makers_) all["makers"].push_back(json_of(maker));
  const std::vector<Names> shared = shared_names(results_);
  if (!shared.empty()) all["names"] = shared;
  all["results"] = Json::array();
  for (const Result& result : results_) {
    all["results"].push_back(json_of(result));
    share_names(all["results"].back(), shared);
  }
  seal(all);
  return all;
}

std::string Numbers::line() const { return json().dump(); }

// One result a line, so that a change of one is a change of one line.
void Numbers::write(const std::filesystem::path& file) const {
  const Json all = json();
  std::string text = "{";
  for (const auto& [key, value] : all.items()) {
    text += (key == "study" ? "" : ",\n") + Json(key).dump() + ": ";
    if (!value.is_array()) {
      text += value.dump();
      continue;
    }
    std::string lines;
    for (const Json& one : value) lines += (lines.empty() ? "\n" : ",\n") + one.dump();
    text += "[" + lines + "]";
  }
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  replace_file(file, text + "}\n");
}

}  // namespace furrow
