// What the paper leaves to later: speed of the plate, size of the particles, spread of their sizes.
#include "validation/studies/outlook.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/outlook_parts.h"

namespace furrow::validation {
namespace {

const std::vector<std::pair<const char*, const char*>> shown{{"mean_force", "mean force [N]"},
                                                             {"largest_force_discs", "largest force [N]"},
                                                             {"force_ratio", "Fx to Fy"},
                                                             {"growth_of_maxima", "growth of the maxima per 100 mm"},
                                                             {"force_free_share", "without force [%]"}};

// ", by way of 182 N at 1.5e6 Pa", of the least or the greatest, where it is neither at the first value nor at the last and differs
// from both by more than the packings do.
std::string turning_point(const OutlookVariation& v, const std::vector<Estimate>& force,
                          const std::vector<std::size_t>& ran) {
  const Estimate &first = force[ran.front()], &last = force[ran.back()];
  const auto beyond = [&](std::size_t k, double sign) {
    return sign * (force[k].mean - first.mean) > std::hypot(force[k].half, first.half) &&
           sign * (force[k].mean - last.mean) > std::hypot(force[k].half, last.half);
  };
  for (const double sign : {-1.0, 1.0}) {
    const std::size_t k = *std::max_element(ran.begin(), ran.end(), [&](std::size_t a, std::size_t b) {
      return sign * force[a].mean < sign * force[b].mean;
    });
    if (beyond(k, sign))
      return ", by way of " + force[k].text() + " N at " + three_digits(v.values[k]) +
             (v.unit == std::string("-") ? "" : " " + std::string(v.unit));
  }
  return {};
}

// Over the values at which the scene runs; the others are named.
std::string conclusion(const OutlookVariation& v, const std::vector<Estimate>& force) {
  std::vector<std::size_t> ran;
  std::string failed;
  for (std::size_t k = 0; k < force.size(); ++k) {
    if (std::isnan(force[k].mean)) {
      failed += (failed.empty() ? "" : ", ") + three_digits(v.values[k]);
    } else {
      ran.push_back(k);
    }
  }
  const std::string unit = v.unit == std::string("-") ? "" : " " + std::string(v.unit);
  const auto at = [&](std::size_t k) { return force[k].text() + " N at " + three_digits(v.values[k]) + unit; };
  std::string text = v.what + ": ";
  if (ran.size() > 1) {
    const Estimate &first = force[ran.front()], &last = force[ran.back()];
    const bool differs = std::fabs(first.mean - last.mean) > std::hypot(first.half, last.half);
    text += std::string("the mean force ") +
            (differs ? "goes from " : "does not change by more than the packings do: ") + at(ran.front()) +
            (differs ? " to " : ", ") + at(ran.back()) + turning_point(v, force, ran) + ".";
  }
  return text + (failed.empty() ? "" : " No packing runs to its end at " + failed + unit + ".");
}

}  // namespace

Report outlook(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("outlook");
  const int members = outlook_packings(numbers.quick());
  Report report("Speed of the plate, size of the particles",
                "The paper leaves the effect of speed and of sizes of particles to later, and its parameters to "
                "calibration. What do they do to the force in scene 2, and what does a tool that bends?");
  Json blocks = Json::object();
  report.text(
      "By rkc, with steps of its own to a relative tolerance of 1 %, for the paper's step is beyond its own method's "
      "limit: these are "
      "numbers of the model, as those at the finest step under the finding, and not those of the paper's step, which "
      "the "
      "ensemble of packings has.");
  std::size_t runs = 0, failed = 0;
  bool paper_counted = false;
  std::string why;
  std::string missing;
  for (const OutlookVariation& variation : outlook_variations()) {
    if (!measured(numbers, variation)) {
      missing += (missing.empty() ? "" : ", ") + variation.what;
      continue;
    }
    std::vector<std::string> head{variation.what + " [" + variation.unit + "]"};
    for (const auto& [id, title] : shown) head.emplace_back(title);
    std::vector<std::vector<Json>> rows;
    std::vector<Estimate> force;
    for (const double value : variation.values) {
      std::vector<Json> list;
      for (int packing = 0; packing < members; ++packing)
        list.push_back(numbers.at(outlook_key(variation, value, packing)));
      const bool counted = value == variation.paper && std::exchange(paper_counted, true);  // the same runs in each
      runs += counted ? 0 : list.size();
      for (const Json& one : list) {
        if (counted || !one.contains("failed")) continue;
        if (++failed == 1) why = one["failed"].get<std::string>();
      }
      std::vector<Json> row{value};
      for (const auto& [id, title] : shown) row.emplace_back(Estimate(id, list).text());
      rows.push_back(row);
      force.emplace_back("mean_force", list);
      if (!std::isnan(force.back().mean))
        blocks[variation.name].push_back({value, force.back().mean, force.back().half,
                                          Estimate("largest_force_discs", list).mean,
                                          Estimate("largest_force_discs", list).half});
    }
    report.text(conclusion(variation, force));
    report.table(variation.what + ", " + std::to_string(members) +
                     " packings each; mean and half its 95 % interval. –: no packing runs to its end.",
                 head, rows);
  }
  if (!numbers.quick()) {
    report.figure({.name = "outlook",
                   .script = "outlook.gp",
                   .caption = "Mean and largest force on the plate over its way of 450 mm, mean over " +
                              std::to_string(members) + " packings with its 95 % interval.",
                   .description = "Force on the plate against its speed, the radius of particles and their spread",
                   .blocks = blocks});
  }
  if (!missing.empty())
    report.text("Not in the kept numbers, which are of an earlier form of this study: " + missing + ".");
  add_sensitivity(report, numbers);
  add_tools(report, numbers);
  report.claim({.text = "Runs of scene 2, each setting once, that came to their end." +
                        (failed == 0 ? "" : " The first that did not: " + why + "."),
                .value = std::to_string(runs - failed) + " of " + std::to_string(runs),
                .aim = "all",
                .holds = failed == 0});
  return report;
}

}  // namespace furrow::validation
