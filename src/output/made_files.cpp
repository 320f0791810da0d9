#include "output/made_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include "output/file_list.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view about_to_be_made = "-";
constexpr std::string_view partial = ".partial";

// An inode's number comes again after a file is removed, with another time of birth.
std::string identity_of(const struct statx& s) {
  const bool born = (s.stx_mask & STATX_BTIME) != 0;
  return std::to_string(s.stx_ino) +
         (born ? "." + std::to_string(s.stx_btime.tv_sec) + "." + std::to_string(s.stx_btime.tv_nsec) : "");
}

bool look_at(const fs::path& file, struct statx& s) {
  return statx(AT_FDCWD, file.c_str(), AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS | STATX_BTIME, &s) == 0;
}

std::string name_of(const std::string& file) {
  return file.ends_with(partial) ? file.substr(0, file.size() - partial.size()) : file;
}

// The directory in which a marker is that is nearest to the file.
bool is_nearer(const fs::path& place, const fs::path& directory) {
  for (fs::path at = place; at != directory && at.has_relative_path(); at = at.parent_path())
    if (fs::exists(at / ".furrow.json")) return true;
  return false;
}

}  // namespace

void MadeFiles::open(const fs::path& directory) {
  directory_ = directory;
  canonical_ = fs::canonical(directory);
  read_journal();
}

MadeFiles::~MadeFiles() {
  if (journal_ >= 0) close(journal_);
}

void MadeFiles::read_journal() {
  std::ifstream stream(directory_ / journal_name);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t space = line.find(' ');
    if (space == std::string::npos || stream.eof()) continue;  // cut where its writer was killed
    std::set<std::string>& known = identity_[line.substr(space + 1)];
    if (const std::string identity = line.substr(0, space); identity != about_to_be_made) known.insert(identity);
  }
}

std::set<std::string> MadeFiles::names() const {
  std::set<std::string> names;
  for (const auto& [file, content] : content_) names.insert(name_of(file));
  for (const auto& [name, identities] : identity_) names.insert(name);
  return names;
}

bool MadeFiles::is_own(const std::string& file) const {
  struct statx s {};
  if (!look_at(directory_ / file, s) || !S_ISREG(s.stx_mode)) return false;
  if (const auto known = identity_.find(name_of(file)); known != identity_.end()) {
    if (known->second.contains(identity_of(s)) || s.stx_size == 0) return true;
  }
  const auto ended = content_.find(file);
  return ended != content_.end() && (ended->second.empty() || ended->second == length_and_crc(directory_ / file));
}

void MadeFiles::forget() {
  content_.clear();
  identity_.clear();
  if (journal_ >= 0) close(journal_);
  journal_ = -1;
  unlink((directory_ / journal_name).c_str());
}

std::map<std::string, std::string> MadeFiles::contents() const {
  std::map<std::string, std::string> contents;
  for (const std::string& name : names()) {
    for (const char* ending : file_endings)
      if (is_own(name + ending)) contents[name + ending] = length_and_crc(directory_ / (name + ending));
  }
  return contents;
}

void MadeFiles::made(const fs::path& file, int descriptor) {
  if (canonical_.empty()) return;
  std::error_code failed;
  const fs::path place = fs::canonical(file.has_parent_path() ? file.parent_path() : fs::path("."), failed);
  if (failed) return;
  const std::string name = (place / file.filename()).lexically_relative(canonical_).string();
  if (name.empty() || name.starts_with("..") || name == ".furrow.json" || is_nearer(place, canonical_)) return;
  if (descriptor < 0) {
    if (!identity_.contains(name)) note(std::string(about_to_be_made), name);
    identity_[name];
    return;
  }
  struct statx s {};
  if (statx(descriptor, "", AT_EMPTY_PATH, STATX_BASIC_STATS | STATX_BTIME, &s) != 0) return;
  if (!identity_[name].contains(identity_of(s))) note(identity_of(s), name);
  identity_[name].insert(identity_of(s));
}

void MadeFiles::note(const std::string& identity, const std::string& name) {
  const fs::path file = directory_ / journal_name;
  if (journal_ < 0) journal_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
  const std::string line = identity + " " + name + "\n";
  if (journal_ >= 0 && write(journal_, line.data(), line.size()) == static_cast<ssize_t>(line.size())) return;
  throw FileError("could not write all of " + file.string() + ": " + std::strerror(errno));
}

}  // namespace furrow
