#include "verification/fault_study/trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>
#include <set>

#include "verification/fault_study/verdicts.h"

namespace furrow::verification {

using nlohmann::ordered_json;

void try_fault(Workshop& workshop, const std::vector<Page>& pages, Turn last, const Change& change,
               ordered_json& result) {
  std::set<std::string> failed;
  std::set<std::string> left_out;
  workshop.put(change);
  for (const Page& page : pages) {
    if (page.turn > last && !failed.empty()) {
      left_out.insert(turn_names[page.turn]);
      continue;
    }
    last = std::max(last, page.turn);
    failed.merge(workshop.failing_tests(page));
  }
  result["failed"] = failed;
  result["left_out"] = left_out;
}

void smallest_noticed(Workshop& workshop, std::vector<Page>& pages, const Change& constant, ordered_json& result) {
  int seen = 0;
  int unseen = 16;
  while (unseen - seen > 1) {
    const int middle = (seen + unseen) / 2;
    Change change = constant;
    change.new_text = std::regex_replace(change.new_text, std::regex("CHANGE"), "1e-" + std::to_string(middle));
    workshop.put(change);
    std::set<std::string> failed;
    const auto notices = [&](const Page& page) {
      return page.turn == Turn::always && !(failed = workshop.failing_tests(page)).empty();
    };
    const auto noticing = std::find_if(pages.begin(), pages.end(), notices);
    const bool noticed = noticing != pages.end();
    (noticed ? seen : unseen) = middle;
    if (!noticed) continue;
    result["by"] = failed;
    std::rotate(pages.begin(), noticing, noticing + 1);
  }
  if (seen == 0) throw std::runtime_error("a change by a tenth is not noticed");
  result["smallest_noticed"] = std::pow(10.0, -seen);
}

bool failed(const ordered_json& result) {
  const auto nothing_in = [&](const char* key) { return result.contains(key) && result[key].empty(); };
  return result.contains("trouble") || nothing_in("failed") || nothing_in("by_property");
}

std::string in_words(const ordered_json& result) {
  if (result.contains("trouble")) return "TROUBLE: " + result["trouble"].get<std::string>();
  const auto noticed_by = [&](const char* key) {
    return result[key].empty() ? std::string("NOT NOTICED")
                               : "noticed by " + std::to_string(result[key].size()) + " tests";
  };
  std::string words = result.contains("failed") ? noticed_by("failed") : "";
  if (result.contains("by_property"))
    words += (words.empty() ? "" : "; ") + ("by the kernel's property alone: " + noticed_by("by_property"));
  if (!words.empty()) return words;
  char text[64];
  std::snprintf(text, sizeof text, "noticed from a relative change of %g", result["smallest_noticed"].get<double>());
  return text;
}

}  // namespace furrow::verification
