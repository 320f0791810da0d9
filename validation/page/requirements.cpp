#include "validation/page/requirements.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "validation/page/gnuplot.h"
#include "validation/page/html.h"

namespace furrow::validation {
namespace {

struct Requirement {
  std::size_t checks = 0, failed = 0;
  std::set<std::string> suites;
};

}  // namespace

std::string requirements_table(const nlohmann::ordered_json& checks, Page& page) {
  std::map<std::string, Requirement> all;
  for (const nlohmann::ordered_json& check : checks) {
    Requirement& one = all[check.at("requirement").get<std::string>()];
    const std::string test = check.at("test");
    ++one.checks;
    one.failed += check.at("good").get<bool>() ? 0 : 1;
    one.suites.insert(test.substr(0, test.find('.')));
  }
  std::string rows;
  for (const auto& [words, one] : all) {
    std::string pages;
    for (const std::string& suite : one.suites)
      pages += (pages.empty() ? "" : ", ") + ("<a href=\"#checks_" + suite + "\">" + suite + "</a>");
    rows += "<tr id=\"" + page.id("requirement " + words) + "\">" +
            element("td", "<code>" + escaped(words) + "</code>") + element("td", std::to_string(one.checks), "number") +
            element("td", std::to_string(one.failed), "number") + element("td", pages) + "</tr>\n";
  }
  return "<details class=\"unfold\"><summary>The " + std::to_string(all.size()) + " requirements</summary>" +
         framed({page.id("table requirements"), "What is required, and the checks that bear it out.", "Requirements",
                 "study",
                 head_cell("Requirement") + head_cell("Checks", true) + head_cell("Failed", true) +
                     head_cell("On the pages"),
                 rows}) +
         "</details>\n";
}

}  // namespace furrow::validation
