// What is wrong with a scene file, with the places of its values or the options that have set them.
#include <algorithm>
#include <utility>

#include "scene/read.h"
#include "scene/stem.h"
#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow {

SceneError::SceneError(std::vector<std::string> messages)
    : std::runtime_error(joined(messages, "\n")), messages_(std::move(messages)) {}

// The option that set the value or one that the finding depends on; empty if all of them stand in the file.
std::string SceneFile::option_of(const Finding& finding) const {
  for (std::string path = finding.path; !path.empty();) {  // an option may have set the list that it is in
    const auto own = options_.find(path);
    if (own != options_.end()) return own->second;
    const std::size_t end = path.find_last_of(".[");
    path.resize(end == std::string::npos ? 0 : end);
  }
  for (const std::string& other : finding.others) {
    const auto set = options_.find(other);
    if (set != options_.end()) return set->second + ": " + finding.path;
  }
  return {};
}

void SceneFile::judge() {
  fill_stems(scene);
  for (const Finding& f : findings_of(scene, unread_)) {
    if (f.warning) continue;
    const std::string option = option_of(f);
    if (option.empty())
      fault(f.path, f.message);
    else
      option_fault(option, f.message);
  }
}

void SceneFile::fault(const std::string& path, const std::string& message) {
  const auto option = options_.find(path);
  if (option != options_.end()) return option_fault(option->second, message);
  const auto [line, column] = place_(path);
  add(line, column, path + (path.empty() ? "" : ": ") + message);
}

void SceneFile::option_fault(const std::string& option, const std::string& message) {
  option_faults_.push_back("furrow: error: " + visible(option + ": " + message));
}

void SceneFile::throw_if_wrong() const {
  std::vector<Line> sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Line& a, const Line& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  std::vector<std::string> messages;
  for (const Line& f : sorted)
    messages.push_back(visible(name_) + ':' + std::to_string(f.line) + ':' + std::to_string(f.column) +
                       ": error: " + visible(f.text));
  messages.insert(messages.end(), option_faults_.begin(), option_faults_.end());
  if (!messages.empty()) throw SceneError(std::move(messages));
}

Scene parse_scene(std::string_view text, const std::string& name) {
  SceneFile file = SceneFile::parse(text, name);
  file.judge();
  file.throw_if_wrong();
  return std::move(file.scene);
}

Scene read_scene(const std::filesystem::path& name) {
  SceneFile file = SceneFile::read(name);
  file.judge();
  file.throw_if_wrong();
  return std::move(file.scene);
}

}  // namespace furrow
