// What the paper leaves to further study, as far as two dimensions go: the speed of the plate, the size of the
// particles and the spread of their sizes, each with some packings of its second scene.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "validation/studies/members.h"
#include "validation/studies/studies.h"

namespace furrow::validation {
namespace {

constexpr double students_t = 2.2;  // 97.5 % quantile, 11 degrees of freedom
constexpr int packings = 12;

struct Variation {
  std::string what, block;
  std::string unit;
  std::vector<double> values;
  double paper;  // the value of the paper's scene
  void (*apply)(Scene&, double);
};

// As many particles as fill the bed of the paper's: their number goes with 1 / R^2.
void set_radius(Scene& scene, double radius) {
  Packing& p = scene.packing[0];
  const double ratio = p.radius_max / radius;
  p.count = static_cast<int>(std::lround(p.count * ratio * ratio));
  p.radius_min = p.radius_max = radius;
}

// Radii evenly spread by so many percent to both sides; as many particles as have the same area together.
void set_spread(Scene& scene, double percent) {
  Packing& p = scene.packing[0];
  const double radius = p.radius_max, spread = percent / 100;
  p.count = static_cast<int>(std::lround(p.count / (1 + spread * spread / 3)));
  p.radius_min = radius * (1 - spread);
  p.radius_max = radius * (1 + spread);
}

void set_speed(Scene& scene, double speed) {
  const double way = scene.plate[0].velocity.x * scene.time.end;
  scene.plate[0].velocity.x = speed;
  scene.output.interval *= way / speed / scene.time.end;
  for (double& t : scene.output.frames) t *= way / speed / scene.time.end;
  scene.time.end = way / speed;
}

const std::vector<Variation>& variations() {
  static const std::vector<Variation> all{
      {"Speed of the plate", "speed", "m/s", {0.05, 0.1, 0.2, 0.4, 0.8}, 0.1, set_speed},
      {"Radius of the particles",
       "radius",
       "mm",
       {8, 10, 12.5, 15},
       10,
       [](Scene& s, double mm) { set_radius(s, 1e-3 * mm); }},
      {"Spread of the radii", "spread", "%", {0, 10, 20, 30}, 0, set_spread},
  };
  return all;
}

// By rkc, which keeps an accuracy of a percent at any stiffness that these scenes come to; the paper's step is beyond
// the limit of its own method already.
Json run_of(const Variation& variation, double value, int packing) {
  Scene scene = paper_scene("scenario_2", Reading::disc, 301 + static_cast<std::uint64_t>(packing));
  scene.time.method = "rkc";
  scene.time.relative_tolerance = 1e-2;
  scene.time.absolute_tolerance = 1e-4;
  scene.time.max_step = 5e-3;
  scene.settle->limit = 60;
  if (value != variation.paper) variation.apply(scene, value);
  return observed(scene, "scenario_2");
}

struct Estimate {
  double mean = NAN, half = NAN;  // half the 95 % interval
  Estimate(const std::string& id, const std::vector<Json>& members) {
    const Sample sample = sample_of(id, members);
    if (sample.numbers.size() < 2) return;
    mean = sample.mean();
    half = students_t * sample.deviation() / std::sqrt(static_cast<double>(sample.numbers.size()));
  }
  // Both to the same decimal, the second of the half interval.
  std::string text() const {
    if (std::isnan(mean)) return "–";
    const int decimals = half > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(half)))) : 0;
    const auto to = [&](double value) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
      return std::string(digits);
    };
    return half > 0 ? to(mean) + " ± " + to(half) : to(mean);
  }
};

const std::vector<std::pair<const char*, const char*>> shown{{"mean_force", "mean force [N]"},
                                                             {"largest_force_discs", "largest force [N]"},
                                                             {"force_ratio", "Fx to Fy"},
                                                             {"growth_of_maxima", "growth of the maxima per 100 mm"},
                                                             {"force_free_share", "without force [%]"}};

// Over the values at which the scene runs; the others are named.
std::string conclusion(const Variation& v, const std::vector<Estimate>& force) {
  std::vector<std::size_t> ran;
  std::string failed;
  for (std::size_t k = 0; k < force.size(); ++k) {
    if (std::isnan(force[k].mean)) {
      failed += (failed.empty() ? "" : ", ") + three_digits(v.values[k]);
    } else {
      ran.push_back(k);
    }
  }
  const auto at = [&](std::size_t k) { return force[k].text() + " N at " + three_digits(v.values[k]) + " " + v.unit; };
  std::string text = v.what + ": ";
  if (ran.size() > 1) {
    const Estimate &first = force[ran.front()], &last = force[ran.back()];
    const bool differs = std::fabs(first.mean - last.mean) > std::hypot(first.half, last.half);
    text += std::string("the mean force ") +
            (differs ? "goes from " : "does not change by more than the packings do: ") + at(ran.front()) +
            (differs ? " to " : ", ") + at(ran.back()) + ".";
  }
  return text + (failed.empty() ? "" : " No packing runs to its end at " + failed + " " + v.unit + ".");
}

}  // namespace

Json outlook(const Settings& settings) {
  const int members = settings.quick ? 2 : packings;
  struct Place {
    std::size_t variation, value;
  };
  std::vector<Place> places;
  std::vector<Task> tasks;
  for (std::size_t v = 0; v < variations().size(); ++v) {
    for (std::size_t k = 0; k < variations()[v].values.size(); ++k) {
      for (int packing = 0; packing < members; ++packing) {
        const Variation& variation = variations()[v];
        const double value = variation.values[k];
        places.push_back({v, k});
        tasks.push_back({variation.block + " " + three_digits(value) + " " + std::to_string(packing),
                         [&variation, value, packing] { return run_of(variation, value, packing); }});
      }
    }
  }
  const std::vector<Json> got = run_tasks("outlook", settings, tasks);
  Report report("Speed of the plate, size of the particles",
                "The paper leaves the effect of speed and of sizes of particles to later. What do they do to the force "
                "in its second scene?");
  Json blocks = Json::object();
  std::size_t failed = 0;
  std::string why;
  for (std::size_t v = 0; v < variations().size(); ++v) {
    const Variation& variation = variations()[v];
    std::vector<std::string> head{variation.what + " [" + variation.unit + "]"};
    for (const auto& [id, title] : shown) head.emplace_back(title);
    std::vector<std::vector<Json>> rows;
    std::vector<Estimate> force;
    for (std::size_t k = 0; k < variation.values.size(); ++k) {
      std::vector<Json> list;
      for (std::size_t i = 0; i < got.size(); ++i) {
        if (places[i].variation == v && places[i].value == k) list.push_back(got[i]);
      }
      for (const Json& one : list) {
        if (!one.contains("failed")) continue;
        if (++failed == 1) why = one["failed"].get<std::string>();
      }
      std::vector<Json> row{variation.values[k]};
      for (const auto& [id, title] : shown) row.emplace_back(Estimate(id, list).text());
      rows.push_back(row);
      force.emplace_back("mean_force", list);
      if (!std::isnan(force.back().mean))
        blocks[variation.block].push_back({variation.values[k], force.back().mean, force.back().half,
                                           Estimate("largest_force_discs", list).mean,
                                           Estimate("largest_force_discs", list).half});
    }
    report.text(conclusion(variation, force));
    report.table(variation.what + ", " + std::to_string(members) +
                     " packings each; mean and half its 95 % interval. –: no packing runs to its end.",
                 head, rows);
  }
  if (!settings.quick) {
    report.figure({.name = "outlook",
                   .script = "outlook.gp",
                   .caption = "Mean and largest force on the plate over its way of 450 mm, mean over " +
                              std::to_string(members) + " packings with its 95 % interval.",
                   .description = "Force on the plate against its speed, the radius of particles and their spread",
                   .blocks = blocks});
  }
  report.claim("Every run came to its end." +
                   (failed == 0 ? "" : " " + std::to_string(failed) + " did not; the first: " + why + "."),
               failed == 0);
  return report.json();
}

}  // namespace furrow::validation
