#include "report/sources.h"

#include <algorithm>
#include <array>

namespace furrow {
namespace {

// The text of a scene is no part of it: a result depends on its scene by the scene's hash.
constexpr std::array state_path{"src/physics/",          "src/system/",       "src/reference/",     "src/kernel/",
                                "src/methods/",          "src/run/",          "src/scene/packing.", "src/scene/grid.",
                                "src/scene/border",      "src/scene/scene.h", "src/scene/lattice_", "src/scene/stem.",
                                "src/scene/unit_vector."};

}  // namespace

Sources that_decide(const Sources& all, const std::vector<std::string>& own) {
  Sources some;
  for (const auto& one : all) {
    const auto begins = [&one](const std::string& with) { return one.first.starts_with(with); };
    if (std::any_of(state_path.begin(), state_path.end(), begins) || std::any_of(own.begin(), own.end(), begins))
      some.insert(one);
  }
  return some;
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

}  // namespace furrow
