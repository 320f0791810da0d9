// Scripts of validation/figures, texts of validation/page.
#pragma once

#include <map>
#include <string>

#include "report/embedded.h"
#include "validation/page/gnuplot.h"

namespace furrow::validation {

inline std::string figure_file(const std::string& name) { return std::string(embedded("validation/figures/" + name)); }
inline std::string page_file(const std::string& name) { return std::string(embedded("validation/page/" + name)); }

// The figure of a script of validation/figures, see draw().
inline std::string drawn(const PlotInput& input, const std::string& script, Drawings& drawings, const std::string& name,
                         const std::string& what) {
  return draw(input, figure_file(script), drawings, name, what);
}

// Replaces every {{key}}.
inline std::string filled(const std::string& page, const std::map<std::string, std::string>& values) {
  std::string result;
  for (std::size_t at = 0;;) {
    const std::size_t open = page.find("{{", at), close = page.find("}}", at);
    result += page.substr(at, open - at);
    if (open == std::string::npos) return result;
    result += values.at(page.substr(open + 2, close - open - 2));
    at = close + 2;
  }
}

}  // namespace furrow::validation
