#include "validation/page/faults.h"

#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "report/embedded.h"
#include "validation/page/age_words.h"
#include "validation/page/gnuplot.h"
#include "validation/page/html.h"
#include "validation/page/kept_files.h"

namespace furrow::validation {
namespace {

using nlohmann::ordered_json;
using Suites = std::set<std::string>;

std::string text(const ordered_json& entry, const char* key) { return escaped(entry.at(key).get<std::string>()); }

std::string suite_of(const std::string& test) { return test.substr(0, test.find('.')); }

std::vector<ordered_json> of_kind(const ordered_json& study, const char* kind) {
  std::vector<ordered_json> entries;
  for (const ordered_json& entry : study.at("results")) {
    if (entry.at("kind") == kind) entries.push_back(entry);
  }
  return entries;
}

std::ptrdiff_t noticed_by_property(const std::vector<ordered_json>& faults) {
  return std::count_if(faults.begin(), faults.end(),
                       [](const ordered_json& f) { return f.contains("by_property") && !f["by_property"].empty(); });
}

Suites suites_of(const ordered_json& tests) {
  Suites suites;
  for (const auto& test : tests) suites.insert(suite_of(test.get<std::string>()));
  return suites;
}

// Of the kernel's faults: whether the test that holds the kernel against the reference notices it, alone.
std::string property_cell(const ordered_json& fault) {
  if (!fault.contains("by_property")) return element("td", "");
  const std::size_t count = fault["by_property"].size();
  return count == 0 ? element("td", "none", "number missing") : element("td", std::to_string(count), "hit");
}

std::string matrix_row(const ordered_json& fault, const Suites& suites, const Suites& methods) {
  std::map<std::string, int> by;
  for (const auto& test : fault.at("failed")) ++by[suite_of(test.get<std::string>())];
  const auto& left_out = fault.at("left_out");
  const bool methods_left_out = std::find(left_out.begin(), left_out.end(), "methods") != left_out.end();
  std::string cells = element("td", text(fault, "says")) +
                      (by.empty() ? element("td", "none", "number missing")
                                  : element("td", std::to_string(fault.at("failed").size()), "number")) +
                      property_cell(fault);
  for (const std::string& suite : suites) {
    if (by.count(suite) != 0) {
      cells += element("td", std::to_string(by[suite]), "hit");
    } else {
      // An empty cell needs no end; there are thousands.
      cells += methods_left_out && methods.count(suite) != 0 ? element("td", "&#8211;", "left_out") : "<td>";
    }
  }
  return element("tr", cells);
}

// Faults, file by file, against test suites: how many tests of a suite notice a fault.
std::string matrix(const std::vector<ordered_json>& faults, const ordered_json& study, Page& page) {
  std::map<std::string, int> noticed_by;  // suite: faults
  std::map<std::string, std::vector<ordered_json>> files;
  Suites suites;
  for (const ordered_json& fault : faults) {
    for (const std::string& suite : suites_of(fault.at("failed"))) ++noticed_by[suite];
    files[fault.at("file")].push_back(fault);
  }
  for (const auto& [suite, count] : noticed_by) suites.insert(suite);
  const Suites methods = suites_of(study.at("groups").value("methods", ordered_json::array()));

  const auto upright = [](const std::string& words) {
    return "<th scope=\"col\" class=\"upright\"><span>" + words + "</span></th>";
  };
  std::string head = head_cell("Fault") + upright("tests that notice it") + upright("kernel against reference, alone");
  std::string foot = "<th scope=\"row\">Faults that the page notices</th>" + element("td", "") +
                     element("td", std::to_string(noticed_by_property(faults)), "number");
  for (const std::string& suite : suites) {
    head += upright(escaped(suite));
    foot += element("td", std::to_string(noticed_by[suite]), "number");
  }
  std::string rows;
  for (const auto& [file, those] : files) {
    rows += element("tr", "<th scope=\"rowgroup\" class=\"file\" colspan=\"" + std::to_string(suites.size() + 3) +
                              "\">" + escaped(file) + "</th>");
    for (const ordered_json& fault : those) rows += matrix_row(fault, suites, methods);
  }
  rows += element("tr", foot, "foot");
  return framed({page.id("table faults"),
                 "Faults by file, and how many tests of each page of verification/ notice them.", "Faults",
                 "matrix plain", head, rows});
}

std::string constants_table(const std::vector<ordered_json>& constants, Page& page) {
  std::string rows;
  for (const ordered_json& entry : constants) {
    std::string by;
    for (const auto& test : entry.value("by", ordered_json::array()))
      by += (by.empty() ? "" : ", ") + escaped(test.get<std::string>());
    const bool found = entry.contains("smallest_noticed");
    rows +=
        element("tr", element("td", text(entry, "name") + "<small>" + text(entry, "says") + "</small>") +
                          element("td", found ? shown(entry["smallest_noticed"].get<double>()) : missing, "number") +
                          element("td", "<small>" + by + "</small>"));
  }
  return framed({page.id("table smallest change noticed"),
                 "The smallest relative change, to a power of ten, that some test notices, and the tests of the first "
                 "page that does.",
                 "Smallest change noticed", "study",
                 head_cell("Constant") + head_cell("Relative change", true) + head_cell("Noticed by"), rows});
}

std::string silent_table(const ordered_json& tests, Page& page) {
  std::string rows;
  for (const auto& [test, why] : tests.items()) {
    const std::string reason = why.get<std::string>();
    rows += element("tr", element("td", escaped(test)) + (reason.empty() ? element("td", "no reason known", "missing")
                                                                         : element("td", escaped(reason))));
  }
  return "<details><summary>The " + std::to_string(tests.size()) +
         " tests that noticed none of them, and why they are kept</summary>" +
         framed({page.id("table noticed nothing"), "", "Tests that noticed none of the faults", "study",
                 head_cell("Test") + head_cell("Why it is kept"), rows}) +
         "</details>";
}

// Of the faults in the kernel; empty if the property was not asked.
std::string property_sentence(const std::vector<ordered_json>& faults) {
  const auto asked =
      std::count_if(faults.begin(), faults.end(), [](const ordered_json& f) { return f.contains("by_property"); });
  if (asked == 0) return {};
  return std::to_string(asked) +
         " of them are in the fast kernel. These were also given to the test that holds the kernel against the "
         "reference, to the bit, and to nothing else: it noticed " +
         std::to_string(noticed_by_property(faults)) + ".";
}

std::string untried_sentence(const ordered_json& study) {
  std::string names;
  const std::vector<std::string> untried = untried_faults(study);
  for (const std::string& name : untried) names += (names.empty() ? "" : ", ") + escaped(name);
  return untried.empty()
             ? ""
             : std::to_string(untried.size()) + " more were added since and are not tried yet: " + names + ".";
}

}  // namespace

std::vector<std::string> untried_faults(const ordered_json& study) {
  std::set<std::string> tried;
  for (const ordered_json& entry : study.at("results")) tried.insert(entry.at("name"));
  std::vector<std::string> untried;
  const toml::table listed = toml::parse(embedded("verification/faults.toml"));
  for (const char* kind : {"fault", "constant"}) {
    for (const toml::node& entry : *listed[kind].as_array()) {
      const std::string name = entry.as_table()->at("name").value_or(std::string());
      if (!tried.contains(name)) untried.push_back(name);
    }
  }
  return untried;
}

std::string faults_part(const ordered_json& study, Page& page) {
  const std::vector<ordered_json> faults = of_kind(study, "fault");
  const std::vector<ordered_json> constants = of_kind(study, "constant");
  const auto noticed =
      std::count_if(faults.begin(), faults.end(), [](const ordered_json& f) { return !f.at("failed").empty(); });
  std::string html = element(
      "p", std::to_string(faults.size()) +
               " faults were put into the source, one at a time; the verification tests noticed " +
               std::to_string(noticed) +
               ". A number says how many tests of a page fail. A dash: the page was not run, because it measures "
               "methods, the fault is not in one, and other pages noticed it.");
  if (const std::string words = untried_sentence(study); !words.empty()) html += element("p", words);
  if (const std::string words = property_sentence(faults); !words.empty()) html += element("p", words);
  html += element("p", escaped(words_of(numbers_of_faults(study), age_of_faults(study))), "note");
  html += "<details class=\"unfold\"><summary>Each fault and who notices it</summary>" + matrix(faults, study, page) +
          "</details>";
  if (!constants.empty()) html += constants_table(constants, page);
  if (!study.at("noticed_nothing").empty()) html += silent_table(study.at("noticed_nothing"), page);
  return html;
}

}  // namespace furrow::validation
