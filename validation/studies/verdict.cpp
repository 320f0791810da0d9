#include "validation/studies/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace furrow::validation {
namespace {

// The range of a number that bears a statement out, if it is one of a limit or of words with a range.
std::optional<std::array<double, 2>> range_of(const Statement& s) {
  if (s.holds) return s.holds;
  if (s.relation == "below" || s.relation == "by") return std::array{-infinity, s.value};
  if (s.relation == "above") return std::array{s.value, infinity};
  return std::nullopt;
}

// Of words in place of a number: that the thing does not happen. Any others leave open what the number is.
bool says_never(const std::string& words) { return words == "not by the end" || words.starts_with("no "); }

constexpr double near = 0.1, alike = 1.0 / 3;  // of the paper's number

std::string by_share(double share) {
  if (std::isnan(share)) return "not testable";
  return share >= 0.5 ? "reproduced" : share >= 0.05 ? "reproduced in kind" : "not reproduced";
}

}  // namespace

std::string verdict_of(const Statement& s, const Sample& sample) {
  if (const auto range = range_of(s)) return by_share(sample.share(*range));
  if (!s.expect.empty()) {
    const auto same = static_cast<double>(std::count(sample.words.begin(), sample.words.end(), s.expect));
    return by_share(same / static_cast<double>(sample.members()));
  }
  if (!std::isfinite(s.value)) return "not testable";
  if (sample.numbers.empty() && std::none_of(sample.words.begin(), sample.words.end(), says_never))
    return "not testable";
  if (2 * sample.numbers.size() < sample.members() || sample.numbers.empty()) return "not reproduced";
  const double off = std::fabs(sample.quantile(0.5) - s.value);
  const bool between =
      sample.numbers.size() >= 20 && s.value >= sample.quantile(0.05) && s.value <= sample.quantile(0.95);
  if (between || off <= near * std::fabs(s.value)) return "reproduced";
  return off <= alike * std::fabs(s.value) ? "reproduced in kind" : "not reproduced";
}

}  // namespace furrow::validation
