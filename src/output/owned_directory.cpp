#include "output/owned_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "output/build_info.h"
#include "output/process.h"
#include "output/strict_json.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* marker_name = ".furrow.json";
constexpr std::string_view marker_begins = "{\n  \"program\": \"furrow\",";
constexpr const char* running = "running";  // how an owner stands that has not said how it ended

fs::file_type type_of(const fs::path& path) {
  std::error_code failed;
  const fs::file_type type = fs::symlink_status(path, failed).type();
  if (type == fs::file_type::none) throw FileError("cannot look at " + path.string() + ": " + failed.message());
  return type;
}

bool is_there(const fs::path& path) { return type_of(path) != fs::file_type::not_found; }
bool is_file(const fs::path& path) { return type_of(path) == fs::file_type::regular; }

void remove_file(const fs::path& path) {
  std::error_code failed;
  fs::remove(path, failed);
  if (failed) throw FileError("cannot replace " + path.string() + ": " + failed.message());
}

std::string beginning_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(marker_begins.size(), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

// What a process that was killed while it wrote the marker leaves.
bool is_unfinished_marker(const fs::path& path) {
  return path.filename().string().starts_with(std::string(marker_name) + ".partial-") && is_file(path) &&
         marker_begins.starts_with(beginning_of(path));
}

// A name that a marker may list: below the directory, no way out of it.
bool is_proper(const std::string& name) {
  const fs::path path(name);
  return !path.empty() && path.is_relative() && path == path.lexically_normal() && path.has_filename() &&
         *path.begin() != ".." && path.filename() != marker_name && path.filename() != journal_name;
}

struct Marker {
  std::string kind, began, standing;
  ProcessIdentity process;
  std::map<std::string, std::string> files;  // with their endings: length and CRC-32
};

// In a marker of an earlier version, which listed names alone, both endings of each, and no more.
std::map<std::string, std::string> files_of(const Json& list) {
  if (list.is_object()) return list.get<std::map<std::string, std::string>>();
  std::map<std::string, std::string> files;
  for (const std::string& name : list.get<std::vector<std::string>>())
    for (const char* ending : file_endings) files[name + ending] = "";
  return files;
}

// Throws Json::exception.
Marker marker_of(const Json& json) {
  return {.kind = json.at("kind"),
          .began = json.at("began"),
          .standing = json.at("standing"),
          .process = {json.at("pid"), json.at("process_start"), json.at("host")},
          .files = files_of(json.at("files"))};
}

// None if there is none.
std::optional<Marker> marker_in(const fs::path& directory) {
  const fs::path file = directory / marker_name;
  if (!is_there(file)) return {};
  try {
    std::ifstream stream(file);
    const Json json = is_file(file) ? json_or_discarded(stream) : Json();
    Marker marker = marker_of(json);
    if (json.at("program") == "furrow" &&
        std::all_of(marker.files.begin(), marker.files.end(), [](const auto& f) { return is_proper(f.first); }))
      return marker;
  } catch (const Json::exception&) {
    // as any other that is not a marker
  }
  throw FileError(file.string() + " is not a marker that furrow can read; remove it, or choose another --out");
}

[[noreturn]] void refuse_used_directory(const fs::path& directory, const std::optional<Marker>& marker) {
  std::string who = "another process";
  if (marker) {
    who = "process " + std::to_string(marker->process.pid) + " on " + marker->process.host + ", which began at " +
          marker->began;
  }
  throw FileError(directory.string() + " is in use by " + who + "; wait for it, or choose another --out");
}

void remove_unfinished_markers(const fs::path& directory) {
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (is_unfinished_marker(entry.path())) remove_file(entry.path());
  }
}

void refuse_foreign_directory(const fs::path& directory) {
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(directory, failed)) {
    if (is_unfinished_marker(entry.path()) || is_journal(entry.path())) continue;
    if (type_of(entry.path()) == fs::file_type::directory && marker_in(entry.path())) continue;
    const bool is_run = is_there(directory / "run.json") || is_there(directory / "run.json.partial");
    throw FileError(directory.string() + " is not empty and has no marker (" + marker_name + ") of furrow's" +
                    (is_run ? ", though it has a run.json: it was written by an earlier version, or by hand" : "") +
                    "; move it away, or choose another --out");
  }
  if (failed) throw FileError("cannot look into " + directory.string() + ": " + failed.message());
}

// All directories between `directory` and the file, the outermost first.
std::vector<fs::path> directories_of(const fs::path& directory, const std::string& file) {
  std::vector<fs::path> between;
  fs::path reached = directory;
  for (const fs::path& part : fs::path(file).parent_path()) between.push_back(reached /= part);
  return between;
}

// What stands where the owner's file is or will be must be that file or nothing.
void refuse_what_is_in_the_way(const fs::path& directory, const std::string& file, const MadeFiles& made) {
  if (!is_proper(file)) throw FileError(file + " is not a name of a file in " + directory.string());
  for (const fs::path& between : directories_of(directory, file)) {
    if (is_there(between) && type_of(between) != fs::file_type::directory)
      throw FileError(between.string() +
                      " is in the way: it is not a directory; move it away, or choose another --out");
  }
  for (const char* ending : file_endings) {
    const fs::path path = directory / (file + ending);
    if (!is_there(path) || made.is_own(file + ending)) continue;
    const bool named = made.names().contains(file) && is_file(path);
    throw FileError(path.string() + " is in the way: it is not " +
                    (named ? "the file that furrow wrote" : "a file of furrow's") +
                    "; move it away, or choose another --out");
  }
}

}  // namespace

OwnedDirectory::OwnedDirectory(fs::path directory, std::string kind, const std::vector<std::string>& files,
                               Earlier earlier)
    : directory_(std::move(directory)), kind_(std::move(kind)), began_(utc_time()) {
  try {
    lock();
    take(files, earlier);
  } catch (...) {
    if (lock_ >= 0) close(lock_);
    throw;
  }
}

OwnedDirectory::~OwnedDirectory() {
  try {
    if (!concluded_) conclude("failed");
  } catch (...) {  // the disk is full, perhaps: the marker says "running", and nobody holds the lock
  }
  close(lock_);
}

// The lock is on the directory itself, so that the marker can be replaced; it goes with the process.
void OwnedDirectory::lock() {
  std::error_code failed;
  if (fs::exists(directory_, failed) && !fs::is_directory(directory_, failed))
    throw FileError(directory_.string() + " is not a directory");
  fs::create_directories(directory_, failed);
  if (failed) throw FileError("cannot make " + directory_.string() + ": " + failed.message());
  lock_ = open(directory_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw FileError("cannot open " + directory_.string() + ": " + std::strerror(errno));
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  const bool held = errno == EWOULDBLOCK;  // else the file system has no locks, and the marker must do
  const std::optional<Marker> other = marker_in(directory_);
  if (held || (other && other->standing == running && is_alive(other->process)))
    refuse_used_directory(directory_, other);
}

void OwnedDirectory::take(const std::vector<std::string>& files, Earlier earlier) {
  const std::optional<Marker> marker = marker_in(directory_);
  if (!marker) refuse_foreign_directory(directory_);
  if (marker && marker->kind != kind_) {
    throw FileError(directory_.string() + " belongs to a " + marker->kind + " of furrow's, not to a " + kind_ +
                    "; choose another --out");
  }
  made_.open(directory_);
  if (marker)
    for (const auto& [file, content] : marker->files) made_.know(file, content);
  const std::set<std::string> before = made_.names();
  std::set<std::string> all = before;
  all.insert(files.begin(), files.end());
  for (const std::string& file : all) refuse_what_is_in_the_way(directory_, file, made_);
  made_.begin();  // before anything is removed: it may fail
  // The marker of before still says whose the files are while they are removed.
  if (earlier == Earlier::replaced) {
    for (const std::string& file : before) discard(file);
  }
  remove_unfinished_markers(directory_);
  write_marker(running);
  if (earlier == Earlier::replaced) made_.forget();
  make_directories(files);
}

void OwnedDirectory::make_directories(const std::vector<std::string>& files) const {
  for (const std::string& file : files) {
    std::error_code failed;
    const fs::path place = (directory_ / file).parent_path();
    fs::create_directories(place, failed);
    if (failed) throw FileError("cannot make " + place.string() + ": " + failed.message());
  }
}

void OwnedDirectory::add(const std::vector<std::string>& files) {
  for (const std::string& file : files) refuse_what_is_in_the_way(directory_, file, made_);
  make_directories(files);
}

void OwnedDirectory::discard(const std::string& file) {
  for (const char* ending : file_endings) {
    if (made_.is_own(file + ending)) remove_file(directory_ / (file + ending));
  }
  // A directory goes with its last file; one that holds more stays.
  std::vector<fs::path> between = directories_of(directory_, file);
  for (; !between.empty(); between.pop_back()) rmdir(between.back().c_str());
}

void OwnedDirectory::keep_only(const std::vector<std::string>& files) {
  for (const std::string& file : made_.names()) {
    if (std::find(files.begin(), files.end(), file) == files.end()) discard(file);
  }
  make_directories(files);
}

void OwnedDirectory::conclude(const std::string& standing) {
  write_marker(standing);
  made_.end();
  concluded_ = true;
}

void OwnedDirectory::write_marker(const std::string& standing) const {
  const ProcessIdentity self = this_process();
  const Json json{{"program", "furrow"},
                  {"kind", kind_},
                  {"version", build_info().version},
                  {"commit", build_info().commit},
                  {"pid", self.pid},
                  {"process_start", self.start},
                  {"host", self.host},
                  {"began", began_},
                  {"standing", standing},
                  {"files", Json(made_.contents())}};
  replace_file(directory_ / marker_name, json.dump(2) + "\n");
}

}  // namespace furrow
