#include "validation/page/verification.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "report/numbers.h"
#include "report/seal.h"
#include "validation/page/faults.h"
#include "validation/page/html.h"
#include "validation/page/kept_files.h"
#include "validation/page/mutants.h"
#include "validation/page/packed.h"
#include "validation/page/requirements.h"
#include "validation/page/template.h"

namespace furrow::validation {
namespace {

using nlohmann::ordered_json;

// Records hold what is not finite as text.
double value_of(const ordered_json& value) { return value.is_number() ? value.get<double>() : NAN; }

std::string missing_part(const std::string& why, const std::string& otherwise) {
  return element("p", why.empty() ? otherwise : escaped(why), "missing");
}

std::string suite_of(const ordered_json& check) {
  const std::string test = check.at("test");
  return test.substr(0, test.find('.'));
}

// The checks of one page of verification/.
struct Suite {
  std::size_t checks = 0, failed = 0;
  double tightest = 0;  // error over tolerance
  std::string file, sentence;
};

std::map<std::string, Suite> suites_of(const ordered_json& checks) {
  std::map<std::string, Suite> suites;
  for (const ordered_json& check : checks) {
    Suite& suite = suites[suite_of(check)];
    ++suite.checks;
    suite.failed += check.at("good").get<bool>() ? 0 : 1;
    suite.tightest = std::fmax(suite.tightest, value_of(check.at("of_limit")));
    suite.file = check.at("file"), suite.sentence = check.at("sentence");
  }
  return suites;
}

const std::vector<std::string>& columns() {
  static const std::vector<std::string> all{"test",      "name",        "want",     "got",    "error",
                                            "tolerance", "kind",        "of_limit", "reason", "sentence",
                                            "file",      "requirement", "good"};
  return all;
}

// The tightest first, as the tests leave them. Words that many checks share stand once.
std::string data_of(const ordered_json& checks) {
  ordered_json words = ordered_json::array(), rows = ordered_json::array();
  std::map<std::string, std::size_t> known;
  for (const ordered_json& check : checks) {
    ordered_json row = ordered_json::array();
    for (const std::string& column : columns()) {
      const ordered_json value = check.contains(column) ? check.at(column) : ordered_json();
      if (!value.is_string()) {
        row.push_back(value.is_number_float() ? ordered_json(to_digits(value.get<double>(), 6)) : value);
        continue;
      }
      const auto [place, fresh] = known.try_emplace(value.get<std::string>(), words.size());
      if (fresh) words.push_back(value);
      row.push_back("$" + std::to_string(place->second));
    }
    rows.push_back(row);
  }
  return ordered_json{{"columns", columns()}, {"words", words}, {"rows", rows}}.dump();
}

std::string csv_of(const ordered_json& checks) {
  std::string text;
  for (const std::string& column : columns()) text += (text.empty() ? "" : ",") + column;
  text += "\n";
  for (const ordered_json& check : checks) {
    std::string line;
    for (const std::string& column : columns()) {
      std::string cell = !check.contains(column)     ? ""
                         : check[column].is_string() ? check[column].get<std::string>()
                                                     : check[column].dump();
      for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2) cell.insert(at, 1, '"');
      line += (column == columns().front() ? "" : ",") +
              (cell.find_first_of(",\"\n") == std::string::npos ? cell : '"' + cell + '"');
    }
    text += line + "\n";
  }
  return text;
}

// One row a page: without a script that is all; with one each opens to its checks.
std::string suite_rows(const std::map<std::string, Suite>& suites) {
  std::string html;
  for (const auto& [name, suite] : suites) {
    const std::string failed = suite.failed == 0
                                   ? "<span class=\"chip good\">✓ 0 failed</span>"
                                   : "<span class=\"chip bad\">✗ " + std::to_string(suite.failed) + " failed</span>";
    html += "<details class=\"suite\" id=\"checks_" + name + "\" data-suite=\"" + name + "\"><summary><b>" + name +
            "</b> <span>" + std::to_string(suite.checks) + (suite.checks == 1 ? " check" : " checks") + "</span> " +
            failed + " <span>tightest at " + shown(100 * suite.tightest) +
            " % of its limit</span></summary><p class=\"note\">" + typeset(escaped(suite.sentence)) + " <code>" +
            escaped(suite.file) + "</code></p></details>\n";
  }
  return html;
}

// One dot a check: error over tolerance, a row a page.
std::string dots(const ordered_json& checks, const std::map<std::string, Suite>& suites, Page& page) {
  std::vector<PlotInput::Row> rows, names;
  std::map<std::string, double> row_of;
  for (const auto& [name, suite] : suites) {
    const double row = static_cast<double>(row_of.size());
    row_of[name] = row;
    names.push_back({{row, suite.tightest}, name});
  }
  std::size_t exact = 0;
  for (const ordered_json& check : checks) {
    const double of_limit = value_of(check.at("of_limit"));
    exact += of_limit == 0 ? 1 : 0;
    rows.push_back({{std::isfinite(of_limit) ? std::fmax(of_limit, 1e-6) : 100, row_of.at(suite_of(check)),
                     check.at("good").get<bool>() ? 0.0 : 1.0},
                    ""});
  }
  PlotInput input;
  input.set("rows", static_cast<double>(suites.size())).block("checks", rows).block("names", names);
  const std::string svg =
      drawn(input, "checks.gp", page.files, "checks_dots",
            std::to_string(checks.size()) + " checks, error over tolerance: all that are good lie below 1");
  return "<details class=\"unfold\"><summary>All " + std::to_string(checks.size()) + " checks in one figure</summary>" +
         framed(page, {page.id("figure checks"), "<div class=\"plot\">" + svg + "</div>",
                       "One dot a check: its error over its tolerance, on a logarithmic scale, one row a page of "
                       "verification/. Right of the line a check "
                       "fails; " +
                           std::to_string(exact) +
                           " with no error at all, or less than a millionth of the tolerance, stand at the left edge.",
                       "checks_dots"}) +
         "</details>";
}

std::string checks_part(const Evidence& evidence, Page& page) {
  const auto& file = evidence.checks;
  const std::string why = file.empty() ? "" : unusable_checks(file);
  if (file.empty() || !why.empty())
    return missing_part(why, "No checks here: the page was made without those of the verification tests (--checks).");
  const ordered_json checks = read_sealed(file).at("checks");
  const Verdict verdict = verdict_of(evidence);
  const auto suites = suites_of(checks);
  page.files["checks.csv"] = csv_of(checks);
  return element("p", std::to_string(verdict.checks) + " checks of " + std::to_string(verdict.requirements) +
                          " requirements on " + std::to_string(suites.size()) + " pages; " +
                          std::to_string(verdict.failed) +
                          " failed. Expected values come from closed forms or independent computations. "
                          "<a href=\"checks.csv\">All of them as CSV</a>. A page opens to its checks, the ones closest "
                          "to their limits first.") +
         "<div id=\"checks_tools\" hidden></div><div id=\"checks_found\" aria-live=\"polite\"></div>\n<div "
         "id=\"checks\">" +
         suite_rows(suites) + "</div>\n" + requirements_table(checks, page) +
         packed_element("checks_data", data_of(checks)) + dots(checks, suites, page);
}

}  // namespace

std::size_t failed_checks(const Evidence& evidence) { return verdict_of(evidence).failed; }

Verdict verdict_of(const Evidence& evidence) {
  Verdict verdict;
  if (!evidence.checks.empty()) verdict.trouble = unusable_checks(evidence.checks);
  if (!evidence.checks.empty() && verdict.trouble.empty()) {
    std::set<std::string> requirements;
    const ordered_json all = read_sealed(evidence.checks);
    for (const ordered_json& check : all.at("checks")) {
      requirements.insert(check.at("requirement").get<std::string>());
      verdict.failed += check.at("good").get<bool>() ? 0 : 1;
      ++verdict.checks;
    }
    verdict.requirements = requirements.size();
  }
  if (!evidence.faults.empty() && unusable_faults(evidence.faults).empty()) {
    const ordered_json study = read_sealed(evidence.faults);
    for (const ordered_json& fault : study.at("results")) {
      if (fault.at("kind") != "fault") continue;
      ++verdict.faults;
      verdict.noticed += fault.at("failed").empty() ? 0 : 1;
    }
    verdict.old = std::min(verdict.faults, age_of_faults(study).old);
    verdict.untried = untried_faults(study).size();
  }
  return verdict;
}

std::string verification_section(const Evidence& evidence, const std::string& number, Page& page) {
  const std::string why = evidence.faults.empty() ? "" : unusable_faults(evidence.faults);
  const bool none = evidence.faults.empty() || !why.empty();
  return "<section id=\"verification\">" +
         heading(3, page.id("checks against closed forms"), element("span", number + ".1", "section") + "Checks") +
         checks_part(evidence, page) + "</section>\n<section>" +
         heading(3, page.id("faults"), element("span", number + ".2", "section") + "Faults that they notice") +
         (none ? missing_part(why, "No fault study here: the page was made without one (--faults).")
               : faults_part(read_sealed(evidence.faults), page)) +
         mutants_part(evidence.mutants, page) + "</section>\n";
}

}  // namespace furrow::validation
