#include "validation/studies/reading_search.h"

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

#include "validation/studies/once.h"

namespace furrow::validation {
namespace {

class Search {
 public:
  Search(const RunTasks& run, bool quick, SearchForm form) : once_(run), quick_(quick), form_(form) {
    found_.form = form;
    found_.scenes = quick ? std::vector<std::string>{"scenario_1"}
                          : std::vector<std::string>{"scenario_1", "scenario_2", "scenario_3"};
  }

  ReadingsFound all() {
    const std::size_t choices = the_readings().choices.size();
    try_all({Interpretation(choices, 0)});
    try_all(changed(Interpretation(choices, 0)));
    if (form_ == SearchForm::second && !quick_) {
      for (const auto& [by, reading] : the_readings().named) try_all({reading});
    }
    found_.alone = found_.points.size() - 1;
    try_all(drawn());
    found_.random = found_.points.size() - 1 - found_.alone;
    Pool unled;  // points that no misfit led to
    for (const ReadPoint& point : found_.points) unled.insert(point.reading);
    const auto best = [&] { return found_.best(found_.scenes).reading; };
    for (int pass = 0; !quick_ && pass < the_readings().exchanges; ++pass) exchange(best);
    found_.exchanged = found_.points.size() - 1 - found_.alone - found_.random;
    exchange_valid([&] { return valid_ones(1).front(); });
    found_.joint = found_.points.size();
    for (const std::string& out : found_.scenes) {
      if (found_.scenes.size() == 1) break;
      if (form_ == SearchForm::first)
        found_.valid_without[out] = valid_ones(1, found_.others(out), found_.scenes).front();
      else
        fit_without(out, unled);
    }
    judge_finalists();
    found_.untorn = untorn();
    return std::move(found_);
  }

 private:
  void try_all(const std::vector<Interpretation>& readings) {
    std::vector<Wanted> runs;
    for (const Interpretation& reading : readings) {
      if (tried_.contains(reading)) continue;
      for (const std::string& scene : found_.scenes) runs.push_back(wanted(scene, reading, paper_step, 1));
    }
    once_.make(runs);
    for (const Interpretation& reading : readings) {
      if (!tried_.insert(reading).second) continue;
      ReadPoint point{reading, {}};
      for (const std::string& scene : found_.scenes)
        point.said[scene] = once_.of(key_of(scene, reading, paper_step, 1));
      found_.points.push_back(std::move(point));
    }
  }

  bool known(const Alternative& alternative) const { return alternative.since <= static_cast<int>(form_); }

  bool matters(std::size_t choice) const {
    return std::any_of(found_.scenes.begin(), found_.scenes.end(),
                       [&](const std::string& s) { return concerns(choice, s); });
  }

  std::vector<Interpretation> changed_in(const Interpretation& from, std::size_t k) const {
    std::vector<Interpretation> all;
    for (int a = 0; a < std::ssize(the_readings().choices[k].alternatives); ++a) {
      if (a == from[k] || !matters(k) || !known(the_readings().choices[k].alternatives[static_cast<std::size_t>(a)]))
        continue;
      all.push_back(from);
      all.back()[k] = a;
    }
    return all;
  }

  std::vector<Interpretation> changed(const Interpretation& from) const {
    std::vector<Interpretation> all;
    for (std::size_t k = 0; k < from.size(); ++k) {
      for (Interpretation& one : changed_in(from, k)) all.push_back(std::move(one));
    }
    return all;
  }

  // The literal alternative with an even chance. Own arithmetic: distributions of the library differ.
  std::vector<Interpretation> drawn() const {
    std::mt19937_64 random(the_readings().seed);
    std::vector<Interpretation> all(static_cast<std::size_t>(quick_ ? 8 : the_readings().random));
    for (Interpretation& one : all) {
      for (const Choice& choice : the_readings().choices) {
        if (choice.since() > static_cast<int>(form_)) {
          one.push_back(0);
          continue;
        }
        std::vector<int> others;
        for (int a = 1; a < std::ssize(choice.alternatives); ++a) {
          const Alternative& alternative = choice.alternatives[static_cast<std::size_t>(a)];
          if (alternative.drawn && known(alternative)) others.push_back(a);
        }
        const bool literal = (random() >> 63) != 0;
        const std::uint64_t which = random();
        one.push_back(literal || others.empty() ? 0 : others[which % others.size()]);
      }
    }
    return all;
  }

  using Pool = std::set<Interpretation>;
  using From = std::function<Interpretation()>;

  void exchange_valid(const From& best_valid, Pool* pool = nullptr) {
    for (int pass = 0; !quick_ && pass < the_readings().valid_exchanges; ++pass) {
      const Interpretation before = best_valid();
      exchange(best_valid, pool);
      if (best_valid() == before) break;
    }
  }

  // Fitted as the winner is, on two scenes alone: from the points that no misfit led to, by exchanges of its own, and
  // valid where the two are. Then judged by packings that did not choose it.
  void fit_without(const std::string& out, Pool pool) {
    const std::vector<std::string> in = found_.others(out);
    const From best_valid = [&] { return valid_ones(1, in, in, &pool).front(); };
    exchange_valid(best_valid, &pool);
    Finalist& fitted = found_.fitted_without[out];
    found_.valid_without[out] = fitted.reading = best_valid();
    std::vector<Wanted> runs;
    const auto each = [&](const auto& what) {
      for (const std::string& scene : found_.scenes) {
        for (std::uint64_t p = 0; p < packings_of(scene); ++p) what(scene, p);
      }
    };
    each([&](const std::string& s, std::uint64_t p) { runs.push_back(wanted(s, fitted.reading, paper_step, 2 + p)); });
    once_.make(runs);
    each([&](const std::string& s, std::uint64_t p) {
      fitted.said[s].push_back(once_.of(key_of(s, fitted.reading, paper_step, 2 + p)));
    });
  }

  std::uint64_t packings_of(const std::string& scene) const {
    return quick_ || scene == "scenario_1" ? 1 : static_cast<std::uint64_t>(the_readings().packings);
  }

  void exchange(const From& from, Pool* pool = nullptr) {
    for (std::size_t k = 0; k < the_readings().choices.size(); ++k) {
      const std::vector<Interpretation> changed = changed_in(from(), k);
      try_all(changed);
      if (pool != nullptr) pool->insert(changed.begin(), changed.end());
    }
  }

  // From the least misfit of those scenes on, of a pool or of all.
  std::vector<Interpretation> in_order(const std::vector<std::string>& scenes, const Pool* pool = nullptr) const {
    std::vector<std::pair<double, const ReadPoint*>> order;
    for (const ReadPoint& point : found_.points) {
      if (pool == nullptr || pool->contains(point.reading)) order.emplace_back(point.misfit(scenes), &point);
    }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Interpretation> all;
    for (const auto& [misfit, point] : order) all.push_back(point->reading);
    return all;
  }

  // Those of the least misfit that are valid in all scenes. The literal one is, so there is one at least.
  std::vector<Interpretation> valid_ones(std::size_t count) { return valid_ones(count, found_.scenes, found_.scenes); }
  // By the misfit of some scenes, and valid in those that are asked.
  std::vector<Interpretation> valid_ones(std::size_t count, const std::vector<std::string>& scenes,
                                         const std::vector<std::string>& asked, const Pool* pool = nullptr) {
    constexpr std::size_t at_a_time = 8;
    std::vector<Interpretation> valid;
    const std::vector<Interpretation> order = in_order(scenes, pool);
    for (std::size_t begin = 0; begin < order.size() && valid.size() < count; begin += at_a_time) {
      const auto first = order.begin() + static_cast<std::ptrdiff_t>(begin);
      const std::vector<Interpretation> some(first, first + std::min<std::ptrdiff_t>(at_a_time, order.end() - first));
      std::vector<Wanted> runs;
      for (const Interpretation& reading : some) {
        for (const std::string& scene : asked) runs.push_back(wanted_watched(scene, reading, 1));
      }
      once_.make(runs);
      for (const Interpretation& reading : some) {
        const bool all = std::all_of(asked.begin(), asked.end(), [&](const std::string& scene) {
          return is_valid(once_.of(watched_key(scene, reading, 1)));
        });
        if (all && valid.size() < count) valid.push_back(reading);
      }
    }
    if (valid.empty()) throw std::runtime_error("no reading is valid, the literal one neither");
    return valid;
  }

  // The literal one, the best half of all, the best half of the valid ones.
  std::vector<Interpretation> finalists() {
    const std::size_t half = quick_ ? 1 : static_cast<std::size_t>(the_readings().finalists) / 2;
    std::vector<Interpretation> best{found_.points.front().reading};
    const auto add = [&](const std::vector<Interpretation>& some) {
      const std::size_t full = best.size() + half;
      for (const Interpretation& reading : some) {
        if (best.size() < full && std::find(best.begin(), best.end(), reading) == best.end()) best.push_back(reading);
      }
    };
    add(in_order(found_.scenes));
    add(valid_ones(2 * half + 1));
    return best;
  }

  void judge_finalists() {
    const auto step = [](bool fine) { return fine ? the_readings().fine_step : paper_step; };
    std::vector<Wanted> runs;
    const std::vector<Interpretation> best = finalists();
    const auto each = [&](const auto& what) {
      for (const Interpretation& reading : best) {
        for (const std::string& scene : found_.scenes) {
          for (const bool fine : {false, true}) {
            for (std::uint64_t p = 0; p < packings_of(scene); ++p) what(reading, scene, fine, p);
          }
        }
      }
    };
    each([&](const Interpretation& r, const std::string& s, bool fine, std::uint64_t p) {
      runs.push_back(wanted(s, r, step(fine), 2 + p));
      if (!fine) runs.push_back(wanted_watched(s, r, 2 + p));
    });
    once_.make(runs);
    each([&](const Interpretation& r, const std::string& s, bool fine, std::uint64_t p) {
      if (found_.finalists.empty() || found_.finalists.back().reading != r) found_.finalists.push_back({r, {}, {}, {}});
      Finalist& finalist = found_.finalists.back();
      (fine ? finalist.finer : finalist.said)[s].push_back(once_.of(key_of(s, r, step(fine), 2 + p)));
      if (!fine) finalist.watched[s].push_back(once_.of(watched_key(s, r, 2 + p)));
    });
  }

  std::vector<Json> untorn() {
    std::vector<Wanted> runs;
    for (const Untorn& u : untorn_runs()) runs.push_back(wanted(u));
    once_.make(runs);
    std::vector<Json> results;
    for (const Wanted& run : runs) results.push_back(once_.of(run.key));
    return results;
  }

  Once once_;
  bool quick_;
  SearchForm form_;
  ReadingsFound found_{};
  std::set<Interpretation> tried_{};
};

}  // namespace

ReadingsFound search_readings(const RunTasks& run, bool quick, SearchForm form) {
  return Search(run, quick, form).all();
}

ReadingsFound kept_search(const Numbers& numbers) {
  const auto kept = [&](const std::vector<Wanted>& runs) {
    std::vector<Json> values;
    for (const Wanted& run : runs) values.push_back(numbers.at(run.key));
    return values;
  };
  try {
    return search_readings(kept, numbers.quick(), SearchForm::second);
  } catch (const std::out_of_range&) {
    return search_readings(kept, numbers.quick(), SearchForm::first);
  }
}

void measure_readings(Measurement& measurement) {
  // A check asks for what is kept, in the form in which it was made.
  const Numbers* kept = measurement.compared_with();
  const SearchForm form = kept ? kept_search(*kept).form : SearchForm::second;
  const auto make = [&](const std::vector<Wanted>& runs) {
    std::vector<Task> tasks;
    for (const Wanted& run : runs) tasks.push_back(run.task());
    return measurement.run(tasks);
  };
  search_readings(make, measurement.quick(), form);
}

}  // namespace furrow::validation
