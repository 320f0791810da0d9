#include "validation/calibration/key_path.h"

#include <algorithm>
#include <charconv>
#include <regex>

#include "scene/wording.h"

namespace furrow::validation {
namespace {

// A key with its index, if it has one: both end up as steps.
void add_steps(std::vector<std::string>& steps, const std::string& part) {
  const std::size_t open = part.find('[');
  if (open == std::string::npos || part.back() != ']') return steps.push_back(part);
  const char *first = part.data() + open + 1, *end = part.data() + part.size() - 1;
  std::size_t index = 0;
  const auto [rest, error] = std::from_chars(first, end, index);
  if (error != std::errc{} || rest != end) return steps.push_back(part);
  steps.push_back(part.substr(0, open));
  steps.push_back(item("", index));
}

}  // namespace

std::vector<std::string> steps_of_path(const std::string& path) {
  std::vector<std::string> steps;
  for (std::size_t from = 0; from < path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    add_steps(steps, path.substr(from, dot - from));
    from = dot + 1;
  }
  return steps;
}

std::string text_of_steps(const std::vector<std::string>& steps) {
  std::string text;
  for (const std::string& step : steps) text += (text.empty() || step.starts_with('[') ? "" : ".") + step;
  return text;
}

bool overlap(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  const auto common = static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
  return std::equal(a.begin(), a.begin() + common, b.begin());
}

std::string canonical_value(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  std::string value = text.substr(first, text.find_last_not_of(' ') - first + 1);
  if (value.size() > 1 && value.front() == '\'' && value.back() == '\'') return value.substr(1, value.size() - 2);
  if (value.size() > 1 && value.front() == '"' && value.back() == '"')
    return std::regex_replace(value.substr(1, value.size() - 2), std::regex(R"(\\(["\\]))"), "$1");
  double number = 0;
  const char* end = value.data() + value.size();
  const auto [rest, error] = std::from_chars(value.data(), end, number);
  return error == std::errc{} && rest == end ? shortest(number + 0.0) : value;
}

}  // namespace furrow::validation
