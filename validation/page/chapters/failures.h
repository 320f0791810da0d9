// What a chapter says of results that are failures.
#pragma once

#include <algorithm>
#include <string>

#include "report/study.h"

namespace furrow::validation {

// What happened, without what to do about it and where it began.
inline std::string in_short(const std::string& reason) {
  return reason.substr(0, std::min(reason.find(". "), reason.find("; ")));
}

// A sentence for each, as a part of its own.
inline void add_failures(Report& report, const Numbers& numbers) {
  std::string text;
  for (const Result& result : numbers.results()) {
    if (result.failed())
      text += (text.empty() ? "" : " ") + result.key + " has no numbers: " + result.value["failed"].get<std::string>() +
              ".";
  }
  if (!text.empty()) report.text(text);
}

}  // namespace furrow::validation
