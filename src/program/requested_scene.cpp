// The scene that a command is asked for: the file, then the options, then one judgement of what they make together.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>
#include <stdexcept>

#include "methods/method.h"
#include "output/warnings.h"
#include "program/commands.h"
#include "program/method_name.h"
#include "program/resolved_moves.h"
#include "run/prepare.h"
#include "scene/packing.h"
#include "scene/read.h"
#include "scene/set_key.h"
#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow {
namespace {

struct Change {
  std::string option, path, text;
};

Change change_of(const std::string& set) {
  const std::size_t equals = std::min(set.find('='), set.size());
  const std::string path = set.substr(0, equals);
  if (path.empty() || equals == set.size())
    throw std::invalid_argument("--set: must be KEY=VALUE, as in time.step=1e-4, not " + in_quotes(visible(set)));
  return {"--set " + path, path, set.substr(equals + 1)};
}

// The path without zeros in front of an index and without a dot at its end: disc[00]. is disc[0].
std::string one_spelling(const std::string& path) {
  static const std::regex spare(R"((\[)0+(?=[0-9])|\.$)");
  return std::regex_replace(path, spare, "$1");
}

bool is_within(const std::string& part, const std::string& whole) {
  return part.starts_with(whole) &&
         (part.size() == whole.size() || part[whole.size()] == '.' || part[whole.size()] == '[');
}

// Of two that set one key, or a key and a part of it, one would be dropped without a word.
void refuse_twice(const std::vector<Change>& changes) {
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::string path = one_spelling(changes[k].path);
    for (std::size_t first = 0; first < k; ++first) {
      const std::string other = one_spelling(changes[first].path);
      if (!is_within(path, other) && !is_within(other, path)) continue;
      const bool same = changes[first].option == changes[k].option;
      throw std::invalid_argument(changes[k].option + ": " +
                                  (same ? "given twice" : changes[first].option + " sets it too") +
                                  "; give one of them");
    }
  }
}

std::vector<Change> changes_of(const RunOptions& o) {
  std::vector<Change> changes;
  const auto add = [&](const char* option, const char* path, const std::optional<std::string>& text) {
    if (text) changes.push_back({option, path, *text});
  };
  for (const std::string& set : o.set) changes.push_back(change_of(set));
  add("--method", "time.method", o.method);
  add("--dt", "time.step", o.step);
  add("--until", "time.end", o.until);
  add("--locate", "time.locate", o.locate);
  add("--threads", "search.threads", o.threads);
  add("--solver", "time.solver", o.solver);
  if (o.frames) changes.push_back({"--frames", "output.frames", *o.frames});
  refuse_twice(changes);
  if (o.frames) changes.pop_back();  // they depend on the end, so they are set last
  return changes;
}

// What the schedule of the file cannot be under another end or step follows it: a run to an earlier end has no pictures
// later than that, one with a longer step no rows between steps.
void adapt_schedule(const std::vector<Change>& changes, Scene& scene) {
  const auto changed = [&](const char* path) {
    return std::any_of(changes.begin(), changes.end(), [&](const Change& c) { return c.path == path; });
  };
  if (changed("time.end")) std::erase_if(scene.output.frames, [&](double t) { return t > scene.time.end; });
  if (changed("time.step") && std::isfinite(scene.time.step))
    scene.output.interval = std::max(scene.output.interval, scene.time.step);
}

// Pictures at equal times, from the start to the end.
void set_frames(const std::optional<std::string>& text, SceneFile& file) {
  if (!text) return;
  constexpr int most = 10'000;
  int count = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), count);
  if (error != std::errc{} || end != text->data() + text->size() || count < 2 || count > most)
    return file.option_fault("--frames", "must be a whole number from 2 to 10000, not " + in_quotes(visible(*text)));
  file.set_by_option("output.frames", "--frames");
  file.scene.output.frames.clear();
  for (int k = 0; k < count; ++k) file.scene.output.frames.push_back(file.scene.time.end * k / (count - 1));
}

void judge_method(SceneFile& file) {
  if (!file.known("time.method")) return;
  if (const std::string why = unknown_method(file.scene.time.method); !why.empty()) file.fault("time.method", why);
}

// A method whose steps are fixed shows the state of the nearest one.
void judge_frames(SceneFile& file) {
  const Scene& scene = file.scene;
  if (make_method(scene.time.method)->info().controlled) return;
  const std::vector<double>& frames = scene.output.frames;
  for (std::size_t k = 1; k < frames.size(); ++k) {
    if (frames[k] - frames[k - 1] >= (1 - 1e-9) * scene.time.step) continue;
    return file.fault("output.frames", item("frames", k) + " is less than a step of " + shortest(scene.time.step) +
                                           " s after the one before it: both would show the same");
  }
}

// A method that controls its step finds one that moves something.
void judge_moves(SceneFile& file) {
  if (make_method(file.scene.time.method)->info().controlled) return;
  if (const auto [key, why] = unresolved_move(file.scene); !key.empty()) file.fault(key, why);
}

// The others carry every scene.
void judge_fitness(SceneFile& file) {
  const MethodInfo method = make_method(file.scene.time.method)->info();
  if (!method.conservative && !method.dense_jacobian) return;
  if (const std::string why = refusal(method, unsettled(file.scene)); !why.empty()) file.fault("time.method", why);
  file.throw_if_wrong();
}

SceneFile changed_file(const RunOptions& options) {
  SceneFile file = SceneFile::read(options.scene);
  const std::vector<Change> changes = changes_of(options);
  for (const auto& [option, path, text] : changes) {
    const std::string fault = set_key(file.scene, path, text);
    if (!fault.empty()) file.option_fault(option, fault);
    file.set_by_option(path, option);
  }
  adapt_schedule(changes, file.scene);
  set_frames(options.frames, file);
  judge_method(file);
  file.judge();
  file.throw_if_wrong();
  judge_frames(file);
  judge_moves(file);
  file.throw_if_wrong();
  return file;
}

}  // namespace

Scene requested_scene(const RunOptions& options) {
  SceneFile file = changed_file(options);
  judge_fitness(file);
  return std::move(file.scene);
}

std::vector<std::string> checked_warnings(const std::string& scene) {
  SceneFile file = changed_file({.scene = scene});
  std::vector<std::string> warnings = warnings_before(file.scene);
  try {
    if (!place_packings(file.scene, most_attempts_of_a_check))
      warnings.emplace_back("packing: whether its discs find room was not tried to the end");
  } catch (const NoRoom& full) {
    file.fault(item("packing", full.packing()), full.why());
  }
  file.throw_if_wrong();
  judge_fitness(file);
  return warnings;
}

}  // namespace furrow
