#include "validation/studies/sentences.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "report/embedded.h"
#include "report/seal.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/verdict.h"

namespace furrow::validation {
namespace {

using Range = std::array<double, 2>;

constexpr std::string_view file = "validation/sentences.toml";

std::string text_in(const toml::table& table, std::string_view key) { return table[key].value_or(std::string()); }

// The numbers that bear a row out, within a tenth where it is one number.
Range range_of(const Statement& s) {
  if (s.holds) return *s.holds;
  if (s.relation == "below" || s.relation == "by") return {-infinity, s.value};
  if (s.relation == "above") return {s.value, infinity};
  return {s.value - 0.1 * std::fabs(s.value), s.value + 0.1 * std::fabs(s.value)};
}

bool is_range(const Statement& s) {
  return s.holds || s.relation == "below" || s.relation == "by" || s.relation == "above";
}

// What one unit of a distance is; of 0 there is no tenth.
double scale_of(const Statement& s) {
  constexpr double of_zero = 0.1;
  const Range r = range_of(s);
  const double width = r[1] - r[0], end = std::isfinite(r[0]) ? r[0] : r[1];
  const double scale = !is_range(s)                        ? 0.1 * std::fabs(s.value)
                       : std::isfinite(width) && width > 0 ? 0.1 * width
                                                           : 0.1 * std::fabs(end);
  return scale > 0 ? scale : of_zero;
}

double distance_of(const Statement& s, double value) {
  if (!is_range(s)) return std::fabs(value - s.value);
  const Range r = range_of(s);
  return std::max({0.0, r[0] - value, value - r[1]});
}

std::size_t rank_of(const std::string& verdict) {
  static const std::vector<std::string> from_worst{"not testable", "not reproduced", "only at this step",
                                                   "reproduced in kind", "reproduced"};
  return static_cast<std::size_t>(std::find(from_worst.begin(), from_worst.end(), verdict) - from_worst.begin());
}

bool cannot_both_hold(const Statement& a, const Statement& b) {
  const Range p = range_of(a), q = range_of(b);
  return a.observable == b.observable && (p[1] < q[0] || q[1] < p[0]);
}

// As stated, of each sentence that is in the misfit: looked up once, for a search asks a hundred thousand times.
const std::vector<std::vector<Statement>>& counted_rows() {
  static const std::vector<std::vector<Statement>> all = [] {
    std::vector<std::vector<Statement>> sentences;
    for (const Sentence& sentence : the_sentences()) {
      if (sentence.judged_only) continue;
      sentences.emplace_back();
      for (const std::string& id : sentence.rows) {
        if (!is_judged_only(row_named(id))) sentences.back().push_back(as_stated(row_named(id)));
      }
    }
    return sentences;
  }();
  return all;
}

double misfit_as_stated(const Statement& row, const Json& said) {
  const auto found = said.find(row.id);
  if (found == said.end()) return 1;
  if (found->is_string()) return *found == row.expect ? 0 : 1;
  if (!row.expect.empty() || (!is_range(row) && !std::isfinite(row.value))) return 1;
  const double r = distance_of(row, *found) / scale_of(row);
  return r * r / (1 + r * r);
}

}  // namespace

std::vector<Sentence> read_sentences(std::string_view text, const std::vector<Statement>& rows) {
  std::vector<Sentence> sentences;
  const toml::table root = toml::parse(text);
  for (const toml::node& node : *root["sentence"].as_array()) {
    const toml::table& entry = *node.as_table();
    Sentence s{text_in(entry, "text"),
               text_in(entry, "where"),
               text_in(entry, "against"),
               text_in(entry, "untested"),
               {},
               entry["judged_only"].value_or(false)};
    for (const toml::node& row : *entry["rows"].as_array()) s.rows.push_back(row.value_or(std::string()));
    std::vector<std::string> named = s.rows;
    if (!s.against.empty()) named.push_back(s.against);
    for (const std::string& id : named) {
      if (std::none_of(rows.begin(), rows.end(), [&](const Statement& r) { return r.id == id; }))
        throw std::runtime_error(std::string(file) + ": no row has the id '" + id + "'");
    }
    if (s.text.empty() || s.rows.empty() == s.untested.empty())
      throw std::runtime_error(std::string(file) + ": '" + s.text + "' has neither rows nor a reason, or both");
    sentences.push_back(std::move(s));
  }
  return sentences;
}

const std::vector<Statement>& the_rows() {
  static const std::vector<Statement> all = [] {
    std::vector<Statement> rows = the_paper().statements;
    for (const Statement& s : read_publication(embedded(file)).statements) rows.push_back(s);
    return rows;
  }();
  return all;
}

const std::vector<Sentence>& the_sentences() {
  static const std::vector<Sentence> all = read_sentences(embedded(file), the_rows());
  return all;
}

const Statement& row_named(const std::string& id) {
  const auto found = std::find_if(the_rows().begin(), the_rows().end(), [&](const Statement& r) { return r.id == id; });
  if (found == the_rows().end()) throw std::out_of_range("no row '" + id + "'");
  return *found;
}

bool is_judged_only(const Statement& row) {
  static const std::set<std::string> ids = [] {
    std::set<std::string> all;
    const toml::table root = toml::parse(embedded(file));
    for (const toml::node& id : *root["judged_only"].as_array()) all.insert(id.value_or(std::string()));
    return all;
  }();
  return ids.contains(row.id);
}

const Statement& as_stated(const Statement& row) {
  static const std::map<std::string, Statement> stated = [] {
    std::map<std::string, Statement> all;
    const toml::table root = toml::parse(embedded(file));
    for (const auto& [id, range] : *root["stated"].as_table()) {
      Statement& one = all[std::string(id.str())] = row_named(std::string(id.str()));
      one.holds =
          Range{range.as_array()->at(0).value<double>().value(), range.as_array()->at(1).value<double>().value()};
    }
    return all;
  }();
  const auto found = stated.find(row.id);
  return found == stated.end() ? row : found->second;
}

Json observed_rows(const Scene& made, const std::string& scene) {
  Prepared prepared = prepare(made);
  const Timing time = prepared.scene.time;
  const RunRecord run = observed_run(std::move(prepared), time);
  Json values = Json::object();
  if (!run.finished()) values["failed"] = run.fact("reason")->texts.at(0);
  for (const Statement& s : the_rows()) {
    if (s.scene != scene || is_judged_only(s) || (!run.finished() && s.observable != "finished")) continue;
    const Measured ours = measure(run, s.observable, s.window);
    if (std::isfinite(ours.value)) {
      values[s.id] = to_digits(ours.value, 5);
    } else if (!ours.words.empty()) {
      values[s.id] = ours.words;
    }
  }
  return values;
}

std::string hash_of_observed_rows(const Scene& made, const std::string& scene) {
  std::string asked;
  for (const Statement& s : the_rows()) {
    if (s.scene != scene || is_judged_only(s)) continue;
    asked += s.id + " " + s.observable;
    if (s.window) asked += " " + std::to_string((*s.window)[0]) + " " + std::to_string((*s.window)[1]);
    asked += "\n";
  }
  return hash_of(hash_of_scene(made) + "\n" + asked);
}

double row_misfit(const Statement& row, const Json& said) { return misfit_as_stated(as_stated(row), said); }

double misfit_of(const std::map<std::string, Json>& said, const std::vector<std::string>& scenes) {
  double sum = 0, count = 0;
  for (const std::vector<Statement>& sentence : counted_rows()) {
    double rows = 0, misfit = 0;
    for (const Statement& row : sentence) {
      if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) continue;
      rows += 1;
      misfit += misfit_as_stated(row, said.at(row.scene));
    }
    if (rows > 0) sum += misfit / rows, count += 1;
  }
  return std::sqrt(sum / count);
}

std::string row_verdict(const Statement& row, const std::vector<Json>& said, const std::vector<Json>& finer) {
  const Sample sample = sample_of(row.id, said);
  // A run that failed bears out nothing.
  if (sample.members() == 0) return sample.failed > 0 ? "not reproduced" : "not testable";
  const std::string here = verdict_of(row, sample);
  if (finer.empty()) return here;
  const Sample fine = sample_of(row.id, finer);
  const std::string there = fine.members() == 0 ? "not reproduced" : verdict_of(row, fine);
  const std::size_t least = rank_of("reproduced in kind");
  return rank_of(here) >= least && rank_of(there) < least ? "only at this step" : here;
}

std::string rows_verdict(const Sentence& sentence, const std::map<std::string, std::string>& verdicts) {
  if (sentence.rows.empty()) return "not testable";
  std::string worst = "reproduced";
  for (const std::string& id : sentence.rows) {
    if (rank_of(verdicts.at(id)) < rank_of(worst)) worst = verdicts.at(id);
  }
  return worst;
}

std::string sentence_verdict(const Sentence& sentence, const std::map<std::string, std::string>& verdicts) {
  if (!sentence.against.empty()) {
    for (const std::string& id : sentence.rows) {
      if (cannot_both_hold(row_named(id), row_named(sentence.against))) return "contradicted by the paper itself";
    }
  }
  return rows_verdict(sentence, verdicts);
}

}  // namespace furrow::validation
