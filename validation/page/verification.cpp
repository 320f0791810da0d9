#include "validation/page/verification.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "report/seal.h"
#include "validation/page/faults.h"
#include "validation/page/gnuplot.h"
#include "validation/page/html.h"

namespace furrow::validation {
namespace {

using nlohmann::ordered_json;

// Records hold what is not finite as text.
double number(const ordered_json& value) { return value.is_number() ? value.get<double>() : NAN; }

std::string text(const ordered_json& entry, const char* key) { return escaped(entry.at(key).get<std::string>()); }

// A test's name may break where a word of it begins.
std::string breakable(const std::string& name) {
  std::string html;
  for (std::size_t k = 0; k < name.size(); ++k) {
    const bool begins = k > 0 && std::isupper(static_cast<unsigned char>(name[k])) != 0;
    html += (begins ? "<wbr>" : "") + std::string(1, name[k]);
  }
  return html;
}

std::string check_row(const ordered_json& check) {
  return element(
      "tr",
      element("td", typeset(text(check, "name")) + "<small>" + breakable(text(check, "test")) + "</small>") +
          element("td", shown(number(check["want"])), "number") + element("td", shown(number(check["got"])), "number") +
          element("td", shown(number(check["error"])), "number") +
          element("td", shown(number(check["tolerance"])) + "<small>" + text(check, "kind") + "</small>", "number") +
          element("td", check["good"] ? shown(100 * number(check["of_limit"])) + " %" : "<strong>FAILED</strong>",
                  "number") +
          element("td", typeset(text(check, "reason")) + "<small>" + text(check, "sentence") + " (" +
                            text(check, "file") + ")</small>"));
}

std::string check_table(const std::vector<ordered_json>& checks) {
  std::string rows;
  for (const ordered_json& check : checks) rows += check_row(check);
  return "<div class=\"scroll\"><table class=\"checks\"><thead><tr><th>Check</th><th class=\"number\">Expected</th>"
         "<th class=\"number\">Got</th><th class=\"number\">Error</th><th class=\"number\">Tolerance</th>"
         "<th class=\"number\">Of limit</th><th>Why this tolerance, and what for</th></tr></thead>" +
         element("tbody", rows) + "</table></div>";
}

std::string missing_part(const std::string& why, const std::string& otherwise) {
  return element("p", why.empty() ? otherwise : escaped(why), "missing");
}

std::string checks_part(const std::filesystem::path& file) {
  const std::string why = file.empty() ? "" : unusable_checks(file);
  if (file.empty() || !why.empty())
    return missing_part(why, "No checks here: the page was made without those of the verification tests (--checks).");
  const ordered_json all = read_sealed(file).at("checks");
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

}  // namespace

std::size_t failed_checks(const Evidence& evidence) {
  if (evidence.checks.empty() || !unusable_checks(evidence.checks).empty()) return 0;
  const ordered_json all = read_sealed(evidence.checks).at("checks");
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const ordered_json& check) { return !check.at("good").get<bool>(); }));
}

std::string verification_section(const Evidence& evidence) {
  const std::string why = evidence.faults.empty() ? "" : unusable_faults(evidence.faults);
  const bool none = evidence.faults.empty() || !why.empty();
  return element("h3", "Checks") + checks_part(evidence.checks) + element("h3", "Faults that they notice") +
         (none ? missing_part(why, "No fault study here: the page was made without one (--faults).")
               : faults_part(read_sealed(evidence.faults)));
}

}  // namespace furrow::validation
