#include "validation/calibration/varied_key.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>

#include "methods/method.h"
#include "run/prepare.h"
#include "scene/read.h"
#include "scene/set_key.h"
#include "scene/wording.h"
#include "validation/calibration/key_path.h"

namespace furrow::validation {
namespace {

constexpr std::size_t most_combinations = 10000;

[[noreturn]] void wrong(const std::string& what, const std::string& why) {
  throw std::invalid_argument("--vary " + what + ": " + why);
}

// At each `mark` outside of brackets and of TOML's texts: "..." with escapes, '...' without.
std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts{""};
  int depth = 0;
  char quote = 0;
  bool escaped = false;
  for (const char c : text) {
    const bool within = quote != 0;
    if (!within && (c == '"' || c == '\'')) quote = c;
    if (within && c == quote && !escaped) quote = 0;
    escaped = within && quote == '"' && c == '\\' && !escaped;
    if (!within) depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == mark && depth == 0 && !within) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (quote != 0) wrong(text, "a quote is opened and not closed; write it at both ends of a text");
  return parts;
}

double number_in(const std::string& text, const std::string& key) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || rest != end || !std::isfinite(number))
    wrong(key, "the end of a range must be a number, not " + in_quotes(text));
  return number;
}

void read_range(VariedKey& key, const std::string& text, const std::string& values) {
  const std::vector<std::string> ends = split(values, ':');
  key.logarithmic = ends.size() == 3 && ends[2] == "log";
  if (ends.size() != 2 && !key.logarithmic) wrong(text, "a range is low:high, or low:high:log");
  key.low = number_in(ends[0], text);
  key.high = number_in(ends[1], text);
  if (!(key.low < key.high)) wrong(text, "the range must begin below its end");
  if (key.logarithmic && !(key.low > 0)) wrong(text, "a logarithmic range must lie above 0");
  if (!std::isfinite(key.logarithmic ? key.high / key.low : key.high - key.low)) wrong(text, "the range is too wide");
  if (key.at(0) == key.at(1)) wrong(text, "the ends of the range are the same to eight digits");
}

// What keeps a scene from having that value; empty if nothing does.
std::string fault_of(const Case& of, const VariedKey::Path& path, const std::string& value) {
  Scene scene = of.scene;
  return set_key(scene, path.path, value);
}

bool belongs(const VariedKey::Path& path, const Case& of, const std::string& value) {
  return (path.scene.empty() || path.scene == of.name) && fault_of(of, path, value).empty();
}

void judge_path(const VariedKey& key, const VariedKey::Path& path, const std::string& value,
                const std::vector<Case>& cases) {
  std::string fault;
  std::vector<std::string> names;
  for (const Case& of : cases) {
    if (belongs(path, of, value)) return;
    names.push_back(of.name);
    if (path.scene.empty() || path.scene == of.name) fault = fault_of(of, path, value);
  }
  if (fault.empty()) fault = "there is no scene " + in_quotes(path.scene) + nearest_or_all(path.scene, names);
  wrong(key.name + "=" + value, fault);
}

void judge_value(const std::vector<VariedKey>& keys, const std::vector<Case>& cases, Setting setting, std::size_t k,
                 const std::string& value) {
  setting[k] = value;
  for (const VariedKey::Path& path : keys[k].paths) judge_path(keys[k], path, value, cases);
  for (const Case& of : cases) {
    const Scene scene = scene_with(of, keys, setting, 0);
    for (const Problem& problem : problems_of(scene))
      wrong(keys[k].name + "=" + value, of.name + ": " + problem.path + ": " + problem.message);
    try {
      make_method(scene.time.method);
    } catch (const std::invalid_argument& unknown) {
      wrong(keys[k].name + "=" + value, unknown.what());
    }
  }
}

void find_whole(VariedKey& key, const std::vector<Case>& cases) {
  const std::string first = key.at(0), between = shortest(std::floor(key.low) + 0.5);
  for (const Case& of : cases) {
    for (const VariedKey::Path& path : key.paths)
      key.whole = key.whole || (belongs(path, of, first) && !belongs(path, of, between));
  }
}

void judge_alone(const VariedKey& key) {
  if (key.values.size() == 1)
    wrong(key.name + "=" + key.values[0], "one value varies nothing: list two or more, or write it into the scene");
  for (const VariedKey::Path& path : key.paths) {
    const std::vector<std::string> steps = steps_of_path(path.path);
    if (steps.size() > 1 && steps.front() == "packing" && steps.back() == "seed")
      wrong(key.name, "a seed only draws another packing: leave it out, --packings and --fresh draw several");
  }
}

// Every key of the scene by one path alone.
void refuse_twice(const std::vector<VariedKey>& keys, const Case& of) {
  std::vector<std::pair<std::vector<std::string>, std::string>> taken;  // with the name of the key
  for (const VariedKey& key : keys) {
    for (const VariedKey::Path& path : key.paths) {
      if (!belongs(path, of, key.ends().front())) continue;
      const std::vector<std::string> steps = steps_of_path(path.path);
      for (const auto& [other, name] : taken) {
        if (overlap(other, steps))
          wrong(key.name, text_of_steps(steps) + " of " + of.name + " is varied twice" +
                              (name == key.name ? "" : ", by " + in_quotes(name) + " too") + "; leave one out");
      }
      taken.emplace_back(steps, key.name);
    }
  }
}

}  // namespace

VariedKey VariedKey::of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
    wrong(text, "must be KEY=low:high, KEY=low:high:log or KEY=a,b,c");
  VariedKey key{text.substr(0, equals), {}};
  for (const std::string& part : split(key.name, ',')) {
    const std::size_t colon = part.find(':');
    key.paths.push_back(colon == std::string::npos ? Path{"", part}
                                                   : Path{part.substr(0, colon), part.substr(colon + 1)});
  }
  const std::string values = text.substr(equals + 1);
  if (split(values, ':').size() > 1) {
    read_range(key, text, values);
    return key;
  }
  key.values = split(values, ',');
  std::set<std::string> different;
  for (const std::string& value : key.values) {
    if (value.empty()) wrong(text, "a value is empty: there is a comma too many, or a text is missing its quotes");
    if (!different.insert(canonical_value(value)).second) wrong(text, "names a value twice");
  }
  return key;
}

std::vector<std::string> VariedKey::ends() const { return listed() ? values : std::vector<std::string>{at(0), at(1)}; }

// Eight digits: settings stay readable, and no key of a scene is known better.
std::string VariedKey::at(double share) const {
  const double between = logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
  return rounded(std::clamp(whole ? std::round(between) : between, low, high), 8);
}

std::string VariedKey::below(const std::string& value, double share) const {
  const double off = share_of(value) - share;
  if (!whole || off <= 0) return at(std::max(0.0, off));
  return rounded(std::max(low, std::min(number_in(value, name) - 1, number_in(at(off), name))), 8);
}

std::string VariedKey::above(const std::string& value, double share) const {
  const double off = share_of(value) + share;
  if (!whole || off >= 1) return at(std::min(1.0, off));
  return rounded(std::min(high, std::max(number_in(value, name) + 1, number_in(at(off), name))), 8);
}

double VariedKey::share_of(const std::string& value) const {
  const double number = number_in(value, name);
  return logarithmic ? std::log(number / low) / std::log(high / low) : (number - low) / (high - low);
}

Scene scene_with(const Case& of, const std::vector<VariedKey>& keys, const Setting& setting, int packing) {
  Scene scene = of.scene;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    for (const VariedKey::Path& path : keys[k].paths) {
      if (!belongs(path, of, keys[k].ends().front())) continue;  // it is of other scenes
      if (const std::string fault = set_key(scene, path.path, setting[k]); !fault.empty())
        wrong(keys[k].name + "=" + setting[k], of.name + ": " + fault);
    }
  }
  for (Packing& p : scene.packing) p.seed += static_cast<std::uint64_t>(packing);
  return scene;
}

void judge_keys(std::vector<VariedKey>& keys, const std::vector<Case>& cases) {
  if (keys.empty()) throw std::invalid_argument("--vary: name at least one key, as in --vary contact.friction=0.1:0.9");
  for (const VariedKey& key : keys) judge_alone(key);
  for (const Case& of : cases) refuse_twice(keys, of);
  for (VariedKey& key : keys) {
    if (!key.listed()) find_whole(key, cases);
  }
  const Setting middle = combinations(keys).front();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    for (const std::string& value : keys[k].ends()) judge_value(keys, cases, middle, k, value);
  }
}

std::vector<Setting> combinations(const std::vector<VariedKey>& keys) {
  std::vector<Setting> all{{}};
  for (const VariedKey& key : keys) {
    std::vector<Setting> longer;
    for (const Setting& some : all) {
      for (const std::string& value : key.listed() ? key.values : std::vector<std::string>{key.at(0.5)}) {
        longer.push_back(some);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
    if (all.size() > most_combinations)
      wrong(key.name, "more than " + std::to_string(most_combinations) + " combinations of listed values");
  }
  return all;
}

std::string text_of(const std::vector<VariedKey>& keys, const Setting& setting) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < keys.size(); ++k) parts.push_back(keys[k].name + "=" + setting[k]);
  return joined(parts);
}

}  // namespace furrow::validation
