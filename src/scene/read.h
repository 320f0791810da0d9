// Scenes from TOML files, strictly: an unknown key, a wrong type or a value out of range is an error, never a default.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/findings.h"
#include "scene/scene.h"

namespace furrow {

// All that is wrong with a scene file. Each message reads  file:line:column: error: what, and what to do.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(std::vector<std::string> messages);
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

// A fault in what a scene says. `path` names the place as in "lattice[0].node[2].row".
struct Problem {
  std::string path;
  std::string message;
};

// All that is wrong with a scene. Empty if it can be run. Used by the reader, and by whoever builds a scene in code.
std::vector<Problem> problems_of(const Scene& scene);

// Only what is wrong with the places of its parts: plates whose height was found by settling are judged by this.
std::vector<Problem> start_problems(const Scene& scene);

// What may be meant but is worth a look, one line each: parts that overlap at the start, keys without effect.
std::vector<std::string> scene_warnings(const Scene& scene);

// A scene file read as far as it can be, with the place of each value, so that later findings can name it.
class SceneFile {
 public:
  // Throws std::runtime_error if the file cannot be read, SceneError if it is not TOML.
  static SceneFile read(const std::filesystem::path& file);
  // The same from text; `name` stands for the file in messages.
  static SceneFile parse(std::string_view text, const std::string& name);

  Scene scene{};  // may be changed before it is judged

  // The value of this path came from an option of the command line, by which messages name it.
  void set_by_option(const std::string& path, const std::string& option) { options_[path] = option; }

  // Looks at the scene as it is now. What depends on values that could not be read is not judged.
  void judge();

  // Something else that is wrong: with a value, or with an option.
  void fault(const std::string& path, const std::string& message);
  void option_fault(const std::string& option, const std::string& message);

  // Throws SceneError with all faults at once, those of options last.
  void throw_if_wrong() const;
  bool known(const std::string& path) const { return !unread_.touches(path); }

 private:
  struct Line {
    std::uint32_t line, column;
    std::string text;
  };
  friend class FileReader;
  void add(std::uint32_t line, std::uint32_t column, const std::string& text) {
    faults_.push_back({line, column, text});
  }
  std::string option_of(const Finding& finding) const;

  std::string name_;
  std::vector<Line> faults_{};
  std::vector<std::string> option_faults_{};
  std::map<std::string, std::string> options_{};  // by path
  Unread unread_{};
  std::function<std::pair<std::uint32_t, std::uint32_t>(const std::string& path)> place_{};  // line and column
};

// Throws SceneError with all faults at once; std::runtime_error if the file cannot be read.
Scene read_scene(const std::filesystem::path& file);

// The same from text; `name` stands for the file in messages.
Scene parse_scene(std::string_view text, const std::string& name);

// The scene as TOML, every key with its value (the shortest digits that read back the same), in the order of the
// schema, without comments. Reading it gives the same scene.
std::string canonical_text(const Scene& scene);

// 64-bit FNV-1a of the canonical text: equal for scenes that say the same, however they are written.
std::uint64_t scene_hash(const Scene& scene);

}  // namespace furrow
