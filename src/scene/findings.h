// What is found in a scene: faults, and what may be meant but is worth a warning.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace furrow {

// Paths of keys that could not be read. Nothing that depends on them is judged, for it would be judged by a default.
class Unread {
 public:
  void add(const std::string& path) { paths_.insert(path); }
  bool empty() const { return paths_.empty(); }

  // Whether the path, a part of it, or the table that holds it was not read. The scene itself has the path "".
  bool touches(std::string path) const {
    const auto begins = [&](const std::string& with) {
      const auto next = paths_.lower_bound(with);
      return next != paths_.end() && next->starts_with(with);
    };
    if (path.empty()) return !paths_.empty();
    if (begins(path + '.') || begins(path + '[')) return true;
    for (std::size_t end; !path.empty(); path.resize(end == std::string::npos ? 0 : end)) {
      if (paths_.contains(path)) return true;
      end = path.find_last_of(".[");
    }
    return false;
  }

 private:
  std::set<std::string> paths_;
};

struct Finding {
  std::string path;                   // as in "lattice[0].node[2].row"
  std::string message;                // what is wrong, and what to do
  std::vector<std::string> others{};  // further paths that it depends on
  bool warning = false;
};

class Findings {
 public:
  explicit Findings(Unread unread = {}) : unread_(std::move(unread)) {}

  void error(const std::string& path, const std::string& message, const std::vector<std::string>& others = {}) {
    add({path, message, others, false});
  }
  void warning(const std::string& path, const std::string& message, const std::vector<std::string>& others = {}) {
    add({path, message, others, true});
  }

  // The values of these paths are wrong: nothing else is reported about them.
  void refuse(const std::string& path, const std::string& message, const std::vector<std::string>& others = {}) {
    error(path, message, others);
    unread_.add(path);
    for (const std::string& other : others) unread_.add(other);
  }

  bool known(const std::string& path) const { return !unread_.touches(path); }
  bool all_known() const { return unread_.empty(); }
  bool any_error() const {
    return std::any_of(list_.begin(), list_.end(), [](const Finding& f) { return !f.warning; });
  }
  // Every key could be read and nothing is wrong so far. A key that could not be read is no finding: its reader has said it.
  bool sound() const { return all_known() && !any_error(); }
  // The same of this path and all below it.
  bool sound(const std::string& path) const {
    return known(path) && !unlisted_.touches(path) && std::none_of(list_.begin(), list_.end(), [&](const Finding& f) {
             return !f.warning && (f.path == path || f.path.starts_with(path + '.') || f.path.starts_with(path + '['));
           });
  }
  // And how many more there are.
  std::vector<Finding> list() const {
    std::vector<Finding> all = list_;
    for (const bool warning : {false, true})
      if (more_[warning] > 0)
        all.push_back({"",
                       std::to_string(more_[warning]) + (warning ? " warnings" : " errors") + " more than the " +
                           std::to_string(most) + " that are listed; mend these first",
                       {},
                       warning});
    return all;
  }

 private:
  // A mistake that is made for each of many parts is listed often enough; what is not listed is known to be wrong all the same.
  static constexpr long most = 200;

  void add(Finding f) {
    const auto& others = f.others;
    if (!std::all_of(others.begin(), others.end(), [&](const std::string& other) { return known(other); })) return;
    if (!known(f.path)) return;
    if (listed_[f.warning] < most) {
      ++listed_[f.warning];
      list_.push_back(std::move(f));
    } else {
      ++more_[f.warning];
      if (!f.warning) unlisted_.add(f.path);
    }
  }

  Unread unread_, unlisted_;
  std::vector<Finding> list_;
  long listed_[2] = {0, 0}, more_[2] = {0, 0};  // by warning
};

// Each of these judges one aspect of a scene.
void judge_ranges(const Scene& scene, Findings& found);    // every number within the range of its key, every text clean
void judge_whole(const Scene& scene, Findings& found);     // keys that contradict each other, names of nothing
void judge_lattices(const Scene& scene, Findings& found);  // the same of lattices: rows, nodes, links, drives, stems
void judge_damping(const Scene& scene, Findings& found);   // given in one way, and what the linear law needs
void judge_sizes(const Scene& scene, Findings& found);     // counts and bytes within their limits
void judge_numbers(const Scene& scene, Findings& found);   // what is derived from the numbers is finite and positive
void judge_start(const Scene& scene, Findings& found);     // where the parts stand at t = 0
void judge_effects(const Scene& scene, Findings& found);   // what is given and changes nothing
void judge_idle(const Scene& scene, Findings& found);      // the same of keys for parts that the scene has not
void judge_gaps(const Scene& scene, Findings& found);      // what passes between the points of a lattice's border
void judge_cells(const Scene& scene, Findings& found);     // lattices that reach through themselves

bool may_tear(const Lattice& l);  // a link of it has a strength, or is torn from the start

// All of them, one after the other.
std::vector<Finding> findings_of(const Scene& scene, const Unread& unread = {});

}  // namespace furrow
