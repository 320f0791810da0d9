#include "validation/studies/reading_search.h"

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

namespace furrow::validation {
namespace {

// Each run once, whoever asks for it.
class Once {
 public:
  explicit Once(const RunTasks& run) : run_(run) {}
  void make(const std::vector<Task>& tasks) {
    std::vector<Task> wanted;
    std::set<std::string> keys;
    for (const Task& task : tasks) {
      if (!known_.contains(task.key) && keys.insert(task.key).second) wanted.push_back(task);
    }
    const std::vector<Json> results = run_(wanted);
    for (std::size_t k = 0; k < wanted.size(); ++k) known_[wanted[k].key] = results[k];
  }
  bool knows(const std::string& key) const { return known_.contains(key); }
  const Json& of(const std::string& key) const { return known_.at(key); }

 private:
  const RunTasks& run_;
  std::map<std::string, Json> known_{};
};

class Search {
 public:
  Search(const RunTasks& run, bool quick) : once_(run), quick_(quick) {
    found_.scenes = quick ? std::vector<std::string>{"scenario_1"}
                          : std::vector<std::string>{"scenario_1", "scenario_2", "scenario_3"};
  }

  ReadingsFound all() {
    const std::size_t choices = the_readings().choices.size();
    try_all({Interpretation(choices, 0)});
    try_all(changed(Interpretation(choices, 0)));
    found_.alone = found_.points.size() - 1;
    try_all(drawn());
    found_.random = found_.points.size() - 1 - found_.alone;
    const auto best = [&] { return found_.best(found_.scenes).reading; };
    for (int pass = 0; !quick_ && pass < the_readings().exchanges; ++pass) exchange(best);
    found_.exchanged = found_.points.size() - 1 - found_.alone - found_.random;
    const auto best_valid = [&] { return valid_ones(1).front(); };
    for (int pass = 0; !quick_ && pass < the_readings().valid_exchanges; ++pass) {
      const Interpretation before = best_valid();
      exchange(best_valid);
      if (best_valid() == before) break;
    }
    for (const std::string& out : found_.scenes) {
      if (found_.scenes.size() > 1) found_.valid_without[out] = valid_ones(1, found_.others(out)).front();
    }
    judge_finalists();
    found_.untorn = untorn();
    return std::move(found_);
  }

 private:
  void try_all(const std::vector<Interpretation>& readings) {
    std::vector<Task> tasks;
    for (const Interpretation& reading : readings) {
      if (tried_.contains(reading)) continue;
      for (const std::string& scene : found_.scenes) {
        if (!once_.knows(key_of(scene, reading, paper_step, 1)))
          tasks.push_back(task_of(scene, reading, paper_step, 1));
      }
    }
    once_.make(tasks);
    for (const Interpretation& reading : readings) {
      if (!tried_.insert(reading).second) continue;
      ReadPoint point{reading, {}};
      for (const std::string& scene : found_.scenes)
        point.said[scene] = once_.of(key_of(scene, reading, paper_step, 1));
      found_.points.push_back(std::move(point));
    }
  }

  bool matters(std::size_t choice) const {
    return std::any_of(found_.scenes.begin(), found_.scenes.end(),
                       [&](const std::string& s) { return concerns(the_readings().choices[choice], s); });
  }

  std::vector<Interpretation> changed_in(const Interpretation& from, std::size_t k) const {
    std::vector<Interpretation> all;
    for (int a = 0; a < std::ssize(the_readings().choices[k].alternatives); ++a) {
      if (a == from[k] || !matters(k)) continue;
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
        std::vector<int> others;
        for (int a = 1; a < std::ssize(choice.alternatives); ++a) {
          if (choice.alternatives[static_cast<std::size_t>(a)].drawn) others.push_back(a);
        }
        const bool literal = (random() >> 63) != 0;
        const std::uint64_t which = random();
        one.push_back(literal || others.empty() ? 0 : others[which % others.size()]);
      }
    }
    return all;
  }

  void exchange(const std::function<Interpretation()>& from) {
    for (std::size_t k = 0; k < the_readings().choices.size(); ++k) try_all(changed_in(from(), k));
  }

  // From the least misfit of those scenes on.
  std::vector<Interpretation> in_order(const std::vector<std::string>& scenes) const {
    std::vector<std::pair<double, const ReadPoint*>> order;
    for (const ReadPoint& point : found_.points) order.emplace_back(point.misfit(scenes), &point);
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Interpretation> all;
    for (const auto& [misfit, point] : order) all.push_back(point->reading);
    return all;
  }

  // Those of the least misfit that are valid in all scenes. The literal one is, so there is one at least.
  std::vector<Interpretation> valid_ones(std::size_t count) { return valid_ones(count, found_.scenes); }
  std::vector<Interpretation> valid_ones(std::size_t count, const std::vector<std::string>& scenes) {
    constexpr std::size_t at_a_time = 8;
    std::vector<Interpretation> valid;
    const std::vector<Interpretation> order = in_order(scenes);
    for (std::size_t begin = 0; begin < order.size() && valid.size() < count; begin += at_a_time) {
      const auto first = order.begin() + static_cast<std::ptrdiff_t>(begin);
      const std::vector<Interpretation> some(first, first + std::min<std::ptrdiff_t>(at_a_time, order.end() - first));
      std::vector<Task> tasks;
      for (const Interpretation& reading : some) {
        for (const std::string& scene : found_.scenes) {
          if (!once_.knows(watched_key(scene, reading, 1))) tasks.push_back(watched_task(scene, reading, 1));
        }
      }
      once_.make(tasks);
      for (const Interpretation& reading : some) {
        const bool all = std::all_of(found_.scenes.begin(), found_.scenes.end(), [&](const std::string& scene) {
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
    const std::uint64_t packings = quick_ ? 1 : static_cast<std::uint64_t>(the_readings().packings);
    const auto step = [](bool fine) { return fine ? the_readings().fine_step : paper_step; };
    std::vector<Task> tasks;
    const std::vector<Interpretation> best = finalists();
    const auto each = [&](const auto& what) {
      for (const Interpretation& reading : best) {
        for (const std::string& scene : found_.scenes) {
          for (const bool fine : {false, true}) {
            for (std::uint64_t p = 0; p < (scene == "scenario_1" ? 1 : packings); ++p) what(reading, scene, fine, p);
          }
        }
      }
    };
    each([&](const Interpretation& r, const std::string& s, bool fine, std::uint64_t p) {
      tasks.push_back(task_of(s, r, step(fine), 2 + p));
      if (!fine) tasks.push_back(watched_task(s, r, 2 + p));
    });
    once_.make(tasks);
    each([&](const Interpretation& r, const std::string& s, bool fine, std::uint64_t p) {
      if (found_.finalists.empty() || found_.finalists.back().reading != r) found_.finalists.push_back({r, {}, {}, {}});
      Finalist& finalist = found_.finalists.back();
      (fine ? finalist.finer : finalist.said)[s].push_back(once_.of(key_of(s, r, step(fine), 2 + p)));
      if (!fine) finalist.watched[s].push_back(once_.of(watched_key(s, r, 2 + p)));
    });
  }

  std::vector<Json> untorn() {
    std::vector<Task> tasks;
    for (const Untorn& u : untorn_runs()) tasks.push_back(task_of(u));
    once_.make(tasks);
    std::vector<Json> results;
    for (const Task& task : tasks) results.push_back(once_.of(task.key));
    return results;
  }

  Once once_;
  bool quick_;
  ReadingsFound found_{};
  std::set<Interpretation> tried_{};
};

}  // namespace

int Finalist::valid_runs() const {
  std::ptrdiff_t count = 0;
  for (const auto& [scene, runs] : watched) count += std::count_if(runs.begin(), runs.end(), is_valid);
  return static_cast<int>(count);
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

ReadingsFound search_readings(const RunTasks& run, bool quick) { return Search(run, quick).all(); }

void measure_readings(Measurement& measurement) {
  search_readings([&](const std::vector<Task>& tasks) { return measurement.run(tasks); }, measurement.quick());
}

}  // namespace furrow::validation
