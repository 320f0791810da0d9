#include "report/sources.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace furrow {
namespace {

// The text of a scene is no part of it: a result depends on its scene by the scene's hash.
constexpr std::array state_path{"src/physics/",          "src/system/",       "src/reference/",     "src/kernel/",
                                "src/methods/",          "src/run/",          "src/scene/packing.", "src/scene/grid.",
                                "src/scene/border",      "src/scene/scene.h", "src/scene/lattice_", "src/scene/stem.",
                                "src/scene/unit_vector."};

// The watches: they may end a run, and change no number of one that comes to its end. The check of each step is none,
// nor what it asks (step_check, meeting, path): a run that is not watched may diverge by it, and that is kept as a number.
// It also asks crossing.cpp where nodes are and whether a plate was crossed; the rest of that file is of watches.
constexpr std::array watches{"src/run/border_watch.", "src/run/crossing.",    "src/run/cut_lattices.",
                             "src/run/energy_floor.", "src/run/idle_discs.",  "src/run/inside_out.",
                             "src/run/validity.",     "src/run/watch_rules.", "src/run/watched."};

bool is_a_watch(const std::string& file) {
  return std::any_of(watches.begin(), watches.end(), [&](const char* watch) { return file.starts_with(watch); });
}

using Beginnings = std::vector<std::string>;

const Beginnings judge{"verification/engines/asked.",          "verification/engines/case.",
                       "verification/engines/convergence.",    "verification/engines/judge.",
                       "verification/engines/program_engine.", "verification/engines/transform."};

Beginnings and_judge(Beginnings own) {
  own.insert(own.end(), judge.begin(), judge.end());
  return own;
}

// Each page of verification is a fault's judge; of the studies those that pages call.
Beginnings of_faults() {
  Beginnings own{"tests/studies/work_precision_counts.",
                 "benchmarks/studies/measured_run.",
                 "benchmarks/studies/reference.",
                 "src/output/schedule.",
                 "src/report/cases.",
                 "src/report/linearise.",
                 "verification/fault_study/trial.",
                 "verification/fault_study/workshop."};
  for (const auto& [file, hash] : sources_of_this_program()) {
    const bool of_pages = file.starts_with("verification/") && file.find('/') == file.rfind('/');
    if (of_pages && file != "verification/commands.h") own.push_back(file);
  }
  for (const char* study :
       {"algebra.", "amplification.", "blow_up.", "growth.", "numbers_of_others.", "order_cure.", "order_hertz.",
        "order_observed.", "order_predicted.", "order_problems.", "order_reference.", "order_trends.",
        "published_problems.", "published_schemes.", "published_table.", "scene_stability."})
    own.push_back(std::string("verification/studies/") + study);
  return own;
}

struct Kept {
  const char* what;
  bool of_solver;
  Beginnings (*own)();
  bool watched = false;
};
const std::array<Kept, 5> kept{
    {{"faults", true, of_faults, true},
     {"judged_furrow", true,
      [] {
        return and_judge({"verification/engines/furrow_engine.", "verification/engines/observer."});
      }},
     {"judged_independent", false,
      [] {
        return and_judge({"verification/engines/independent", "verification/engines/observer."});
      }},
     {"judged_others", false, [] { return and_judge({"verification/engines/adapters/"}); }},
     {"times", true, [] { return Beginnings{}; }, true}}};

Sources beginning(const Sources& all, const Beginnings& with) {
  Sources some;
  for (const auto& one : all) {
    if (std::any_of(with.begin(), with.end(), [&](const std::string& b) { return one.first.starts_with(b); }))
      some.insert(one);
  }
  return some;
}

}  // namespace

Sources that_decide(const Sources& all, const std::vector<std::string>& own, bool watched) {
  Sources some = beginning(all, {state_path.begin(), state_path.end()});
  if (!watched) std::erase_if(some, [](const auto& one) { return is_a_watch(one.first); });
  some.merge(beginning(all, own));
  return some;
}

Sources that_decide(const std::string& what) {
  std::string known;
  for (const Kept& one : kept) {
    const Sources& all = sources_of_this_program();
    if (what == one.what) return one.of_solver ? that_decide(all, one.own(), one.watched) : beginning(all, one.own());
    known += (known.empty() ? "" : ", ") + std::string(one.what);
  }
  throw std::invalid_argument("nothing that is kept is called '" + what + "'; there are " + known);
}

std::vector<std::string> differing(const Sources& a, const Sources& b) {
  std::vector<std::string> files;
  for (const auto& [file, hash] : a) {
    const auto other = b.find(file);
    if (other == b.end() || other->second != hash) files.push_back(file);
  }
  for (const auto& [file, hash] : b) {
    if (!a.contains(file)) files.push_back(file);
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> changed_since(const Sources& then, const Sources& now) {
  Sources decided;
  for (const auto& one : then) {
    if (now.contains(one.first) || !is_a_watch(one.first)) decided.insert(one);
  }
  return differing(decided, now);
}

}  // namespace furrow
