#include "page/verification.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "page/gnuplot.h"
#include "page/html.h"

namespace furrow {
namespace {

using nlohmann::ordered_json;

// Null if there is no such file.
ordered_json json_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return nullptr;
  try {
    return ordered_json::parse(stream);
  } catch (const ordered_json::parse_error& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

// Records hold what is not finite as text.
double number(const ordered_json& value) { return value.is_number() ? value.get<double>() : NAN; }

std::string text(const ordered_json& entry, const char* key) { return escaped(entry.at(key).get<std::string>()); }

std::string check_row(const ordered_json& check) {
  return element(
      "tr",
      element("td", text(check, "name") + "<small>" + text(check, "test") + "</small>") +
          element("td", shown(number(check["want"])), "number") + element("td", shown(number(check["got"])), "number") +
          element("td", shown(number(check["error"])), "number") +
          element("td", shown(number(check["tolerance"])) + "<small>" + text(check, "kind") + "</small>", "number") +
          element("td", check["good"] ? shown(100 * number(check["of_limit"])) + " %" : "<strong>FAILED</strong>",
                  "number") +
          element("td", text(check, "reason") + "<small>" + text(check, "sentence") + " (" + text(check, "file") +
                            ")</small>"));
}

std::string check_table(const std::vector<ordered_json>& checks) {
  std::string rows;
  for (const ordered_json& check : checks) rows += check_row(check);
  return "<div class=\"scroll\"><table class=\"checks\"><thead><tr><th>Check</th><th class=\"number\">Expected</th>"
         "<th class=\"number\">Got</th><th class=\"number\">Error</th><th class=\"number\">Tolerance</th>"
         "<th class=\"number\">Of limit</th><th>Why this tolerance, and what for</th></tr></thead>" +
         element("tbody", rows) + "</table></div>";
}

std::string checks_part(const std::filesystem::path& file) {
  const ordered_json all = json_of(file);
  if (all.is_null())
    return element("p", "No checks here: the verification tests were not run before this page was made.", "missing");
  const std::vector<ordered_json> checks(all.begin(), all.end());
  std::set<std::string> requirements;
  std::size_t failed = 0;
  for (const ordered_json& check : checks) {
    requirements.insert(check.at("requirement").get<std::string>());
    failed += check.at("good").get<bool>() ? 0 : 1;
  }
  constexpr std::size_t first = 12;
  const auto cut = checks.begin() + static_cast<std::ptrdiff_t>(std::min(first, checks.size()));
  std::string html = element("p", std::to_string(checks.size()) + " checks of " + std::to_string(requirements.size()) +
                                      " requirements; " + std::to_string(failed) +
                                      " failed. Expected values come from closed forms or independent computations. "
                                      "The checks closest to their limits come first.");
  html += check_table({checks.begin(), cut});
  if (cut != checks.end()) {
    html += "<details><summary>The other " + std::to_string(checks.end() - cut) + " checks</summary>" +
            check_table({cut, checks.end()}) + "</details>";
  }
  return html;
}

std::string suite_of(const std::string& test) { return test.substr(0, test.find('.')); }

// Faults by test suites: how many tests of a suite notice a fault.
std::string fault_matrix(const std::vector<ordered_json>& faults) {
  std::set<std::string> suites;
  for (const ordered_json& fault : faults) {
    for (const auto& test : fault.at("failed")) suites.insert(suite_of(test.get<std::string>()));
  }
  std::string head = "<th>Fault</th>";
  for (const std::string& suite : suites) head += "<th class=\"upright\"><span>" + escaped(suite) + "</span></th>";
  std::string rows;
  for (const ordered_json& fault : faults) {
    std::map<std::string, int> by;
    for (const auto& test : fault["failed"]) ++by[suite_of(test.get<std::string>())];
    std::string cells = "<td>" + escaped(fault["says"].get<std::string>()) + "<small>" + text(fault, "file") +
                        "</small>" + (by.empty() ? "<strong class=\"missing\">not noticed</strong>" : "") + "</td>";
    for (const std::string& suite : suites) {
      cells += by.count(suite) != 0 ? "<td class=\"hit\">" + std::to_string(by[suite]) + "</td>" : "<td></td>";
    }
    rows += element("tr", cells);
  }
  return "<div class=\"scroll\"><table class=\"matrix\"><thead><tr>" + head + "</tr></thead>" + element("tbody", rows) +
         "</table></div>";
}

std::string faults_part(const std::filesystem::path& file) {
  const ordered_json all = json_of(file);
  if (all.is_null()) return element("p", "No fault study here: <code>scripts/faults</code> was not run.", "missing");
  std::vector<ordered_json> faults;
  std::string constants;
  std::size_t noticed = 0;
  for (const ordered_json& entry : all.at("results")) {
    if (entry.at("kind") == "fault") {
      faults.push_back(entry);
      noticed += entry.at("failed").empty() ? 0 : 1;
    } else {
      constants += element(
          "tr",
          element("td", text(entry, "name") + "<small>" + text(entry, "says") + "</small>") +
              element("td",
                      entry.contains("smallest_noticed") ? shown(entry["smallest_noticed"].get<double>()) : missing,
                      "number"));
    }
  }
  return element("p", std::to_string(faults.size()) +
                          " faults were put into the source, one at a time; the verification tests noticed " +
                          std::to_string(noticed) + ". Made from commit " + text(all, "commit") +
                          ". The numbers say how many tests of a page fail.") +
         fault_matrix(faults) +
         (constants.empty() ? ""
                            : "<table class=\"torn\"><caption>The smallest relative change, to a power of ten, that "
                              "some test notices.</caption>"
                              "<thead><tr><th>Constant</th><th class=\"number\">Change</th></tr></thead>" +
                                  element("tbody", constants) + "</table>");
}

}  // namespace

std::size_t failed_checks(const Evidence& evidence) {
  const ordered_json all = json_of(evidence.checks);
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const ordered_json& check) { return !check.at("good").get<bool>(); }));
}

std::string verification_section(const Evidence& evidence) {
  return element("h3", "Checks") + checks_part(evidence.checks) + element("h3", "Faults that they notice") +
         faults_part(evidence.faults);
}

}  // namespace furrow
