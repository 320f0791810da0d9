// The paper's scenes as ensembles: one run for each random packing of the bed, and what the runs say together.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "report/study.h"
#include "validation/studies/beds.h"

namespace furrow::validation {

// The named observables of one run of a made scene: those of the paper's statements about `scene` ("scenario_2"), and
// mean_force [N] and surface [m], the height of the settled bed. Numbers of six digits, or words where a run says no
// number. Of a run that diverges only what statements about stability ask, and "failed": why.
// With its curve also "force_by_way": the largest force in each stretch_of_way that the plate goes, N.
enum class Curve { left_out, kept };
inline constexpr double stretch_of_way = 5;  // mm
Json observed(const Scene& made, const std::string& scene, Curve curve = Curve::left_out);

// Those of the observables of a run, and why it failed if it did.
Json only(const std::vector<std::string>& ids, const Json& observed);

// One packing, by the paper's step if its discs are read as discs, else by step_for_spheres.
struct Member {
  std::string scene;
  Reading reading = Reading::disc;
  std::uint64_t seed = 1;
  std::string group() const { return scene + " " + to_string(reading); }
  std::string key() const { return group() + " " + std::to_string(seed); }
  Scene made() const;
  Task task() const;  // its observables
};

// Scene 1 has no packing and one member; `quick`: two packings of discs and none of spheres.
std::vector<Member> paper_members(bool quick);

// What the members say of one observable.
struct Sample {
  std::vector<double> numbers;     // sorted
  std::vector<std::string> words;  // of members that say it in words, or that it does not happen
  std::size_t failed = 0;          // members that diverged and so do not say
  std::size_t members() const { return numbers.size() + words.size(); }
  double quantile(double p) const;                    // NaN without numbers
  std::pair<double, double> median_interval() const;  // 95 %, by ranks; NaN for fewer than 6 numbers
  double share(const std::array<double, 2>& range) const;
  double mean() const;
  double deviation() const;  // standard deviation of one; NaN for fewer than 2
};

Sample sample_of(const std::string& observable, const std::vector<Json>& members);

// Rounded to three digits, for tables.
std::string three_digits(double value);

}  // namespace furrow::validation
