#include "output/made_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string_view>

#include "output/file_list.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "furrow, files made in this directory, until the run has ended\n";
constexpr std::string_view planned = "planned", begins = "begins:", grows = "grows:", finished = "finished:";
constexpr std::string_view partial = ".partial";

bool is_partial(const std::string& file) { return file.ends_with(partial); }

std::string name_of(const std::string& file) {
  return is_partial(file) ? file.substr(0, file.size() - partial.size()) : file;
}

std::string in_digits(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    char pair[3];
    std::snprintf(pair, sizeof pair, "%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
    text += pair;
  }
  return text;
}

std::string in_words(const FileNews& news) {
  switch (news.what) {
    case FileNews::What::begins:
      return std::string(begins) + in_digits(news.beginning);
    case FileNews::What::grows:
      return std::string(grows) + in_digits(news.beginning);
    case FileNews::What::finished:
      return std::string(finished) + std::to_string(news.mark.bytes) + ":" + hexadecimal(news.mark.hash);
    case FileNews::What::planned:
      break;
  }
  return std::string(planned);
}

// As much of it as is asked for, or as there is.
std::string beginning_of(const fs::path& file, std::size_t bytes) {
  std::ifstream stream = regular_file(file);
  std::string text(bytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(bytes));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

bool begins_with(const fs::path& file, std::string_view digits) {
  return digits.starts_with(in_digits(beginning_of(file, digits.size() / 2)));
}

// Whether what is known of a name lets this file of that name be own. `finished` looks at every byte.
bool fits(const fs::path& file, const std::string& known) {
  const std::string_view what = known;
  if (what.starts_with(finished)) return in_words({.what = FileNews::What::finished, .mark = mark_of(file)}) == known;
  if (what.starts_with(grows)) return begins_with(file, what.substr(grows.size()));
  return what.starts_with(begins) && is_partial(file.string()) && begins_with(file, what.substr(begins.size()));
}

// The directory in which a marker is that is nearest to the file.
bool is_nearer(const fs::path& place, const fs::path& directory) {
  for (fs::path at = place; at != directory && at.has_relative_path(); at = at.parent_path())
    if (fs::exists(at / ".furrow.json")) return true;
  return false;
}

}  // namespace

bool is_journal(const fs::path& file) {
  return file.filename() == journal_name && fs::symlink_status(file).type() == fs::file_type::regular &&
         first_line.starts_with(beginning_of(file, first_line.size()));
}

MadeFiles::~MadeFiles() {
  watch_.reset();
  if (journal_ >= 0) close(journal_);
}

void MadeFiles::open(const fs::path& directory) {
  directory_ = directory;
  canonical_ = fs::canonical(directory);
  const fs::path file = directory / journal_name;
  if (fs::symlink_status(file).type() == fs::file_type::not_found) return;
  if (!is_journal(file))
    throw FileError(file.string() +
                    " is in the way: it is not a file of furrow's; move it away, or choose another --out");
  std::ifstream stream = regular_file(file);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    const std::size_t space = line.find(' ');
    if (space == std::string::npos || stream.eof()) continue;  // cut where its writer was killed
    known_[line.substr(space + 1)].insert(line.substr(0, space));
  }
}

std::set<std::string> MadeFiles::names() const {
  std::set<std::string> names;
  for (const auto& [file, content] : content_) names.insert(name_of(file));
  for (const auto& [name, known] : known_) names.insert(name);
  return names;
}

bool MadeFiles::is_own(const std::string& file) const {
  const fs::path path = directory_ / file;
  if (fs::symlink_status(path).type() != fs::file_type::regular) return false;
  if (const auto found = known_.find(name_of(file)); found != known_.end()) {
    const std::set<std::string>& all = found->second;
    if (fs::file_size(path) == 0 ||
        std::any_of(all.begin(), all.end(), [&](const std::string& known) { return fits(path, known); }))
      return true;
  }
  const auto ended = content_.find(file);
  return ended != content_.end() && (ended->second.empty() || ended->second == length_and_crc(path));
}

void MadeFiles::begin() {
  const fs::path file = directory_ / journal_name;
  journal_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (journal_ < 0) throw FileError("cannot write " + file.string() + ": " + std::strerror(errno));
  if (fs::file_size(file) < first_line.size()) begin_anew();
  watch_.emplace([this](const fs::path& made, const FileNews& news) { hear(made, news); });
}

void MadeFiles::forget() {
  content_.clear();
  known_.clear();
  begin_anew();
}

void MadeFiles::begin_anew() const {
  if (ftruncate(journal_, 0) != 0)
    throw FileError("cannot write " + (directory_ / journal_name).string() + ": " + std::strerror(errno));
  write(std::string(first_line));
}

void MadeFiles::end() {
  watch_.reset();
  close(journal_);
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

void MadeFiles::hear(const fs::path& file, const FileNews& news) {
  std::error_code failed;
  const fs::path place = fs::canonical(file.has_parent_path() ? file.parent_path() : fs::path("."), failed);
  if (failed) return;
  const std::string name = (place / file.filename()).lexically_relative(canonical_).string();
  // Markers, also those of owners below, are nobody's to replace.
  if (name.empty() || name.starts_with("..") || file.filename() == ".furrow.json" || is_nearer(place, canonical_))
    return;
  note(in_words(news), name);
}

void MadeFiles::note(const std::string& known, const std::string& name) {
  if (known_[name].contains(known)) return;
  write(known + " " + name + "\n");
  known_[name].insert(known);
}

void MadeFiles::write(const std::string& line) const {
  if (::write(journal_, line.data(), line.size()) == static_cast<ssize_t>(line.size())) return;
  throw FileError("could not write all of " + (directory_ / journal_name).string() + ": " + std::strerror(errno));
}

}  // namespace furrow
