#include "validation/page/chapters/outlook_parts.h"

#include <algorithm>

#include "scene/wording.h"

namespace furrow::validation {
namespace {

// 97.5 % quantiles of Student's distribution, by number of packings: 6 and 12 are those that the study has.
double students_t(std::size_t members) { return members >= 12 ? 2.2 : members >= 6 ? 2.57 : 12.7; }

// Least squares of ln force over ln value, in one packing; NaN where fewer than two values have a force.
double exponent_of(const Numbers& numbers, const OutlookVariation& v, int packing, const std::string& id) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const double value : v.values) {
    const Json& said = numbers.at(outlook_key(v, value, packing));
    if (!(value > 0) || !said.contains(id) || !said[id].is_number() || !(said[id].get<double>() > 0)) continue;
    const double a = std::log(value), b = std::log(said[id].get<double>());
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return n < 2 ? NAN : (n * xy - x * y) / (n * xx - x * x);
}

// "1 to 20 Pa": the values at which packings ran to their end.
std::string ran_over(const Numbers& numbers, const OutlookVariation& v) {
  std::vector<double> ran;
  for (const double value : v.values) {
    for (int packing = 0; packing < outlook_packings(numbers.quick()); ++packing) {
      if (numbers.at(outlook_key(v, value, packing)).contains("failed")) continue;
      ran.push_back(value);
      break;
    }
  }
  if (ran.empty()) return "no packing runs to its end";
  return three_digits(ran.front()) + " to " + three_digits(ran.back()) + (v.unit == "-" ? "" : " " + v.unit);
}

}  // namespace

Estimate::Estimate(const std::string& id, const std::vector<Json>& members) {
  const Sample sample = sample_of(id, members);
  if (sample.numbers.size() < 2) return;
  mean = sample.mean();
  half = students_t(sample.numbers.size()) * sample.deviation() / std::sqrt(static_cast<double>(sample.numbers.size()));
}

std::string Estimate::text() const {
  if (std::isnan(mean)) return "–";
  const int decimals = half > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(half)))) : 0;
  return fixed(mean, decimals) + (half > 0 ? " ± " + fixed(half, decimals) : "");
}

bool measured(const Numbers& numbers, const OutlookVariation& variation) {
  for (const double value : variation.values) {
    for (int packing = 0; packing < outlook_packings(numbers.quick()); ++packing) {
      if (numbers.find(outlook_key(variation, value, packing)) == nullptr) return false;
    }
  }
  return true;
}

void add_sensitivity(Report& report, const Numbers& numbers) {
  static const std::vector<std::pair<const char*, const char*>> asked{
      {"mean_force", "mean force"}, {"largest_force_discs", "largest force"}, {"force_ratio", "Fx to Fy"}};
  std::vector<std::vector<Json>> rows;
  for (const OutlookVariation& v : outlook_variations()) {
    if (!measured(numbers, v) || v.values.front() <= 0) continue;
    std::vector<Json> row{v.what, ran_over(numbers, v)};
    for (const auto& [id, title] : asked) {
      std::vector<Json> exponents;
      for (int packing = 0; packing < outlook_packings(numbers.quick()); ++packing) {
        const double n = exponent_of(numbers, v, packing, id);
        if (std::isfinite(n)) exponents.push_back({{"n", n}});
      }
      row.emplace_back(Estimate("n", exponents).text());
    }
    rows.push_back(std::move(row));
  }
  report.heading("Which parameter moves what");
  report.table(
      "Exponent n of number ~ parameter^n, fitted in each packing; mean and half its 95 % interval over packings.",
      {"parameter", "from", "mean force", "largest force", "Fx to Fy"}, rows);
}

void add_tools(Report& report, const Numbers& numbers) {
  report.heading("A tool that bends");
  if (numbers.find(tool_key(true, 0)) == nullptr || numbers.find(tool_key(false, 0)) == nullptr) {
    report.text("The kept numbers are of an earlier form of this study, which did not run it.");
    return;
  }
  std::vector<std::vector<Json>> rows;
  for (const bool rigid : {true, false}) {
    std::vector<Json> runs;
    for (int packing = 0; packing < tool_packings(numbers.quick()); ++packing)
      runs.push_back(numbers.at(tool_key(rigid, packing)));
    rows.push_back({rigid ? "rigid plate" : "lattice", Estimate("mean_force", runs).text(),
                    Estimate("largest_force", runs).text(), Estimate("fluctuation", runs).text(),
                    Estimate("torn", runs).text()});
  }
  report.table(
      "The scene deformable_tool, a lattice as a tool, and a plate of its size in its place, in the same beds, after "
      "0.4 s; " +
          std::to_string(tool_packings(numbers.quick())) + " packings, mean and half its 95 % interval.",
      {"tool", "mean force [N]", "largest force [N]", "deviation over mean", "links torn"}, rows);
}

}  // namespace furrow::validation
