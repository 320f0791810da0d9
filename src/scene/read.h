// Scenes from TOML files, strictly: an unknown key, a wrong type or a value out of range is an error, never a default.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

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

// A fault in what a scene says as a whole (an unknown material, a node outside its lattice, ...). `path` names the
// place as in "lattice[0].node[2].row".
struct Problem {
  std::string path;
  std::string message;
};

// Faults that no single key shows. Empty if the scene can be run. Used by the reader, and by whoever builds a scene in
// code.
std::vector<Problem> problems_of(const Scene& scene);

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
