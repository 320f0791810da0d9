// The paper shows one run of each scene. How much of what it reports is the run's packing? Scenes 2 and 3 over many
// packings, and each statement of the paper judged by what the ensemble says. Scene 1 has no packing: one run.
#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "studies/beds.h"
#include "studies/catalogue.h"
#include "studies/observed_run.h"

namespace furrow::studies {
namespace {

struct Member {
  std::string scene;
  Reading reading;
  std::uint64_t seed;
  std::string key() const { return scene + " " + to_string(reading) + " " + std::to_string(seed); }
};

Json run_of(const Member& m) {
  Prepared prepared = prepare(paper_scene(m.scene, m.reading, m.seed));
  const Timing time = prepared.scene.time;
  const RunRecord run = observed_run(std::move(prepared), time);
  if (!run.finished()) throw Divergence(run.fact("reason")->texts.at(0));
  Json values = Json::object();
  for (const Reported& r : reported(run, the_paper(), m.scene)) {
    if (std::isfinite(r.ours.value)) {
      values[r.id] = r.ours.value;
    } else if (!r.ours.words.empty()) {
      values[r.id] = r.ours.words;
    }
  }
  return values;
}

// What the members say of one observable.
struct Sample {
  std::vector<double> numbers;     // sorted
  std::vector<std::string> words;  // of members that say it in words, or that it does not happen
  std::size_t failed = 0;          // members that diverged
  std::size_t members() const { return numbers.size() + words.size(); }

  double quantile(double p) const {
    if (numbers.empty()) return NAN;
    const double at = p * static_cast<double>(numbers.size() - 1);
    const auto low = static_cast<std::size_t>(at);
    const double high = numbers[std::min(low + 1, numbers.size() - 1)];
    return numbers[low] + (at - static_cast<double>(low)) * (high - numbers[low]);
  }

  // 95 % confidence interval of the median, from the binomial ranks in their normal approximation.
  std::pair<double, double> median_interval() const {
    const double n = static_cast<double>(numbers.size());
    if (n < 6) return {NAN, NAN};
    const double half = 0.98 * std::sqrt(n);
    const auto low = static_cast<std::size_t>(std::max(0.0, std::floor(n / 2 - half)));
    const auto high = static_cast<std::size_t>(std::min(n - 1, std::ceil(n / 2 + half) - 1));
    return {numbers[low], numbers[high]};
  }

  double share(const std::array<double, 2>& range) const {
    const auto inside =
        std::count_if(numbers.begin(), numbers.end(), [&](double v) { return v >= range[0] && v <= range[1]; });
    return members() == 0 ? NAN : static_cast<double>(inside) / static_cast<double>(members());
  }
};

Sample sample_of(const std::string& id, const std::vector<Json>& members) {
  Sample sample;
  for (const Json& m : members) {
    if (m.contains("failed")) {
      ++sample.failed;
    } else if (m.contains(id)) {
      if (m[id].is_number()) {
        sample.numbers.push_back(m[id]);
      } else {
        sample.words.push_back(m[id]);
      }
    }
  }
  std::sort(sample.numbers.begin(), sample.numbers.end());
  return sample;
}

// The range of a number that bears a statement out, if it is one of a limit or of words with a range.
std::optional<std::array<double, 2>> range_of(const Statement& s) {
  if (s.holds) return s.holds;
  if (s.relation == "below" || s.relation == "by") return std::array{-infinity, s.value};
  if (s.relation == "above") return std::array{s.value, infinity};
  return std::nullopt;
}

constexpr double near = 0.1, alike = 1.0 / 3;  // of the paper's number

// A limit is reproduced if at least half of the members keep it, in kind if one in twenty does. A number is reproduced
// if it lies between the 5 % and 95 % quantiles or within a tenth of the median, in kind within a third of it.
std::string verdict_of(const Statement& s, const Sample& sample) {
  if (const auto range = range_of(s)) {
    const double share = sample.share(*range);
    if (std::isnan(share)) return "not testable";
    return share >= 0.5 ? "reproduced" : share >= 0.05 ? "reproduced in kind" : "not reproduced";
  }
  if (!std::isfinite(s.value)) return "not testable";
  if (2 * sample.numbers.size() < sample.members() || sample.numbers.empty()) return "not reproduced";
  const double off = std::fabs(sample.quantile(0.5) - s.value);
  const bool between =
      sample.numbers.size() >= 20 && s.value >= sample.quantile(0.05) && s.value <= sample.quantile(0.95);
  if (between || off <= near * std::fabs(s.value)) return "reproduced";
  return off <= alike * std::fabs(s.value) ? "reproduced in kind" : "not reproduced";
}

Json number_or(double value, const std::string& otherwise) {
  return std::isfinite(value) ? Json(value) : Json(otherwise);
}

std::string said(const Statement& s) {
  if (!s.words.empty()) return s.words;
  return s.relation + (s.relation.empty() ? "" : " ") + number(s.value) + (s.unit.empty() ? "" : " " + s.unit);
}

class Judgement {
 public:
  void add(const std::string& scene, const std::string& members, const std::vector<Json>& got) {
    for (const Statement& s : the_paper().statements) {
      if (s.scene != scene) continue;
      const Sample sample = sample_of(s.id, got);
      const std::string verdict = verdict_of(s, sample);
      ++count_[verdict];
      const auto [low, high] = sample.median_interval();
      rows_.push_back(
          {scene.substr(9) + members, s.quantity, said(s), number_or(sample.quantile(0.5), common(sample.words)),
           std::isfinite(low) ? Json(number(rounded(low)) + " to " + number(rounded(high))) : Json("one run"),
           sample.numbers.size() < 6
               ? Json("one run")
               : Json(number(rounded(sample.quantile(0.05))) + " to " + number(rounded(sample.quantile(0.95)))),
           verdict});
    }
  }

  void show(Report& report) const {
    report.table(
        "Every statement of the paper, judged. Numbers of an ensemble are its median, with the 95 % confidence "
        "interval of "
        "the median and the range from the 5 % to the 95 % quantile.",
        {"scene", "statement", "the paper", "ours", "of the median", "range", "verdict"}, rows_);
    std::string counts;
    for (const auto& [verdict, count] : count_)
      counts += (counts.empty() ? "" : ", ") + std::to_string(count) + " " + verdict;
    report.text("Of " + std::to_string(rows_.size()) + " judgements: " + counts + ".");
  }

 private:
  static double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return std::strtod(text, nullptr);
  }
  // The words that most members use.
  static std::string common(const std::vector<std::string>& words) {
    std::string best = "not said";
    std::ptrdiff_t most = 0;
    for (const std::string& w : words) {
      const auto count = std::count(words.begin(), words.end(), w);
      if (count > most) most = count, best = w;
    }
    return best;
  }

  std::vector<std::vector<Json>> rows_;
  std::map<std::string, int> count_;
};

std::vector<Member> members_of(const Settings& settings) {
  std::vector<Member> all{{"scenario_1", Reading::disc, 1}};
  const std::uint64_t discs = settings.quick ? 2 : 100;
  const std::uint64_t spheres = settings.quick ? 0 : 8;
  for (const char* scene : {"scenario_2", "scenario_3"}) {
    for (std::uint64_t seed = 1; seed <= discs; ++seed) all.push_back({scene, Reading::disc, seed});
    for (std::uint64_t seed = 1; seed <= spheres; ++seed) all.push_back({scene, Reading::sphere, seed});
  }
  return all;
}

// Numbers of one observable in steps, for a histogram drawn as a distribution function.
Json distribution(const Sample& sample) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < sample.numbers.size(); ++k)
    rows.push_back({sample.numbers[k], (static_cast<double>(k) + 0.5) / static_cast<double>(sample.numbers.size())});
  return rows;
}

}  // namespace

Json ensemble(const Settings& settings) {
  const std::vector<Member> members = members_of(settings);
  std::vector<Task> tasks;
  for (const Member& m : members) tasks.push_back({m.key(), [m] { return run_of(m); }});
  const std::vector<Json> got = run_tasks("ensemble", settings, tasks);
  const auto of = [&](const std::string& scene, Reading reading) {
    std::vector<Json> list;
    for (std::size_t k = 0; k < members.size(); ++k) {
      if (members[k].scene == scene && members[k].reading == reading) list.push_back(got[k]);
    }
    return list;
  };

  Report report("The paper, statement by statement",
                "Which of the paper's statements does its model bear out, if scenes 2 and 3 are run over many packings "
                "of the bed "
                "instead of one?");
  Judgement judgement;
  judgement.add("scenario_1", "", of("scenario_1", Reading::disc));
  Json blocks = Json::object();
  std::size_t failed = 0;
  for (const char* scene : {"scenario_2", "scenario_3"}) {
    const std::string id = std::string(scene) == "scenario_2" ? "largest_force_discs" : "largest_force_coupled";
    for (const Reading reading : {Reading::disc, Reading::sphere}) {
      const std::vector<Json> list = of(scene, reading);
      if (list.empty()) continue;
      judgement.add(scene, reading == Reading::disc ? ", discs" : ", spheres", list);
      const Sample sample = sample_of(id, list);
      failed += sample.failed;
      blocks[std::string(scene).substr(9) == "2" ? "two_" + to_string(reading) : "three_" + to_string(reading)] =
          distribution(sample);
    }
  }
  report.text(std::to_string(members.size()) + " runs at the paper's step, " + std::to_string(failed) +
              " of them diverged.");
  judgement.show(report);
  if (!settings.quick) {
    report.figure(
        {.name = "ensemble",
         .script = "ensemble.gp",
         .caption =
             "Largest force on the plate over the packings, as distribution functions; the upright lines are the "
             "paper's single runs.",
         .description = "Distribution functions of the largest force for scenes 2 and 3",
         .blocks = blocks});
  }
  report.claim("Every run of the ensemble came to its end.", failed == 0);
  return report.json();
}

}  // namespace furrow::studies
