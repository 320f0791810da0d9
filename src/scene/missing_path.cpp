#include "scene/missing_path.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "scene/wording.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

// Of a file those with the same ending; of one without an ending, which may be left out, all.
std::vector<std::string> names_beside(const fs::path& path, PathKind kind) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder_of(path), unreadable)) {
    const fs::path name = entry.path().filename();
    const bool alike = kind == PathKind::directory || !path.has_extension() || name.extension() == path.extension();
    if (alike && entry.is_directory(unreadable) == (kind == PathKind::directory)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The one that is this but for its ending; else the nearest.
std::string nearest_beside(const fs::path& path, PathKind kind) {
  const std::vector<std::string> names = names_beside(path, kind);
  for (const std::string& name : names)
    if (!path.has_extension() && fs::path(name).stem() == path.filename()) return name;
  return nearest_name(path.filename().string(), names);
}

// Each folder on the way may be misspelt, too.
std::optional<fs::path> nearest_path(const fs::path& missing, PathKind kind) {
  fs::path path = missing;
  std::error_code unreadable;
  if (!fs::is_directory(folder_of(missing), unreadable)) {
    const auto folder = nearest_path(missing.parent_path(), PathKind::directory);
    if (!folder) return {};
    path = *folder / missing.filename();
    if (fs::exists(path, unreadable)) return path;
  }
  const std::string name = nearest_beside(path, kind);
  if (name.empty()) return {};
  return path.has_parent_path() ? path.parent_path() / name : fs::path(name);
}

// The first folder on the way that is not there.
fs::path first_missing(const fs::path& folder) {
  std::error_code unreadable;
  const bool on = folder.has_parent_path() && folder != folder.parent_path();
  return on && !fs::is_directory(folder.parent_path(), unreadable) ? first_missing(folder.parent_path()) : folder;
}

std::string seen_from(const fs::path& path) {
  std::error_code gone;
  return path.is_absolute() ? "" : ", seen from " + in_quotes(fs::current_path(gone).string());
}

}  // namespace

std::string instead_of(const fs::path& missing, PathKind kind) {
  constexpr std::size_t most = 8;  // names
  const fs::path wanted = missing.has_filename() ? missing : missing.parent_path(), folder = folder_of(wanted);
  if (const auto nearest = nearest_path(wanted, kind)) return "; did you mean " + in_quotes(nearest->string()) + "?";
  std::error_code unreadable;
  if (!fs::is_directory(folder, unreadable))
    return "; there is no directory " + in_quotes(first_missing(folder).string()) + seen_from(folder);
  std::vector<std::string> names = names_beside(wanted, kind);
  const std::string any = kind == PathKind::directory ? "directory" : "file";
  const bool by_ending = kind == PathKind::file && wanted.has_extension();
  const std::string what = by_ending ? in_quotes(wanted.extension().string()) + " file" : any;
  if (names.empty()) return "; there is no " + what + " in " + in_quotes(folder.string()) + seen_from(folder);
  if (names.size() > most) names.resize(most), names.emplace_back("...");
  return "; in " + in_quotes(folder.string()) + seen_from(folder) + " there are " + joined(names);
}

}  // namespace furrow
