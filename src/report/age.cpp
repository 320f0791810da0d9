#include "report/age.h"

#include <algorithm>
#include <set>

namespace furrow {

Age age_of(const Numbers& numbers, const Today& today) {
  Age age;
  std::set<std::string> changed;
  std::vector<const Maker*> used;
  for (const Maker& maker : numbers.makers()) used.push_back(&maker);
  std::sort(used.begin(), used.end(), [](const Maker* a, const Maker* b) { return a->when < b->when; });
  std::map<std::pair<std::size_t, const Sources*>, std::vector<std::string>> since;
  for (const Result& result : numbers.results()) {
    const Maker& maker = numbers.makers().at(result.maker);
    const Sources& now = today.sources(result);
    const auto [files, fresh] = since.try_emplace({result.maker, &now});
    const bool unknown = maker.sources.empty();
    if (fresh && !unknown) files->second = changed_since(maker.sources, now);
    const auto input = today.inputs.find(result.key);
    const bool another = input != today.inputs.end() && input->second != result.input;
    const bool old = unknown || another || !files->second.empty();
    if (another && !unknown) age.inputs.push_back(result.key);
    ++age.results;
    age.old += old ? 1 : 0;
    age.unknown += unknown ? 1 : 0;
    age.timed += result.timed ? 1 : 0;
    if (old && result.timed) age.old_times.insert(result.key);
    changed.insert(files->second.begin(), files->second.end());
  }
  age.changed.assign(changed.begin(), changed.end());
  if (!used.empty()) {
    age.first = used.front()->when;
    age.last = used.back()->when;
  }
  for (const Maker* maker : used) {
    if (age.commits.empty() || age.commits.back() != maker->commit) age.commits.push_back(maker->commit);
  }
  return age;
}

Age age_of(const Numbers& numbers, const Sources& today) {
  return age_of(numbers, Today{[&today](const Result&) -> const Sources& { return today; }});
}

}  // namespace furrow
