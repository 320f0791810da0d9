#include "validation/page/html.h"

#include <regex>
#include <utility>
#include <vector>

namespace furrow::validation {

std::string in_groups(std::string digits) {
  if (digits.size() < 5) return digits;
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

std::string typeset(std::string html) {
  static const std::vector<std::pair<std::regex, const char*>> rules{
      {std::regex(R"((^|[\s(\[])-(?=\.?\d))"), "$1−"},
      {std::regex(R"((\d)e[+-]00\b)"), "$1"},
      {std::regex(R"((^|[^\w.])1e([+-])0*(\d+)\b)"), "$0110<sup>$2$3</sup>"},
      {std::regex(R"((\d)e([+-])0*(\d+)\b)"), "$1 × 10<sup>$2$3</sup>"},
      {std::regex(R"((^|[^\w.])1e0*(\d{1,2})\b)"), "$0110<sup>$2</sup>"},
      {std::regex(R"((^|[^\w.])(\d(?:\.\d+)?)e0*(\d{1,2})\b)"), "$1$2 × 10<sup>$3</sup>"},
      {std::regex(R"((^|[^\d,.])(\d),(\d{3})(?![\d,]))"), "$1$2$3"},
      {std::regex(R"((^|[\s(\[])(\d{2,3})(\d{3})(?=[\s;:)\],]|$|\.$|\.\s))"), "$1$2,$3"},
      {std::regex(R"(<sup>-)"), "<sup>−"},
      {std::regex(R"(<sup>\+)"), "<sup>"},
      {std::regex(R"(\b(\d+)\.0{6}\b)"), "$1"},
      {std::regex(R"(\b(\d+\.(?=\d{6}\b)\d*[1-9])0+\b)"), "$1"},
      {std::regex(R"( ± )"), "\u00a0±\u00a0"},
      {std::regex(R"((\d) %)"), "$1\u00a0%"}};
  for (const auto& [what, by] : rules) html = std::regex_replace(html, what, by);
  return html;
}

}  // namespace furrow::validation
