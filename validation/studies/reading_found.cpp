// What a search of the readings has found, asked.
#include <algorithm>
#include <stdexcept>

#include "validation/studies/reading_search.h"

namespace furrow::validation {

int Finalist::valid_runs() const {
  std::ptrdiff_t count = 0;
  for (const auto& [scene, runs] : watched) count += std::count_if(runs.begin(), runs.end(), is_valid);
  return static_cast<int>(count);
}

double ReadPoint::misfit(const std::vector<std::string>& scenes) const {
  const auto [place, fresh] = misfits.try_emplace(scenes);
  if (fresh) place->second = misfit_of(said, scenes);
  return place->second;
}

const ReadPoint& ReadingsFound::at(const Interpretation& reading) const {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const ReadPoint& p) { return p.reading == reading; });
  if (found == points.end()) throw std::out_of_range("the search did not try " + words_of(reading));
  return *found;
}

std::vector<std::string> ReadingsFound::others(const std::string& out) const {
  std::vector<std::string> in;
  std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(in), [&](const std::string& s) { return s != out; });
  return in;
}

const ReadPoint& ReadingsFound::best(const std::vector<std::string>& of) const {
  return *std::min_element(points.begin(), points.end(),
                           [&](const ReadPoint& a, const ReadPoint& b) { return a.misfit(of) < b.misfit(of); });
}

}  // namespace furrow::validation
