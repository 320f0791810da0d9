#include "output/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "output/tell.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_in_memory = 1 << 16;  // bytes
constexpr mode_t permissions = 0666;             // less what umask takes

std::atomic<int> being_written = 0;

void plan(const fs::path& file) { tell(file, {.what = FileNews::What::planned}); }

constexpr std::size_t most_told = 50;  // bytes of a beginning

void tell_beginning(const fs::path& file, std::string_view text) {
  tell(file, {.what = FileNews::What::begins, .beginning = std::string(text.substr(0, most_told))});
}

[[noreturn]] void fail(const std::string& what, const fs::path& file, int error) {
  throw FileError(what + file.string() + ": " + std::strerror(error));
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw FileError("cannot write " + file.string() + ": " + why);
}

fs::path partial_of(const fs::path& file) { return file.string() + ".partial"; }

// O_EXCL: neither a file that is there nor a link is followed or overwritten.
int made(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  if (descriptor < 0 && errno == EEXIST)
    refuse(file, "it is there already; if no program is writing it, move it away or remove it");
  if (descriptor < 0) fail("cannot write ", file, errno);
  return descriptor;
}

fs::file_type type_of(const fs::path& file) {
  std::error_code failed;
  return fs::symlink_status(file, failed).type();
}

void refuse_to_replace(const fs::path& file) {
  if (type_of(file) != fs::file_type::not_found) refuse(file, "it is there already");
}

int made_for(const fs::path& file) {
  refuse_to_replace(file);
  plan(file);
  return made(partial_of(file));
}

// Asked once: to ask is to change it for a moment, also for the files that other threads make.
mode_t mask_of_process() {
  static const mode_t mask = [] {
    const mode_t now = umask(0);
    umask(now);
    return now;
  }();
  return mask;
}

int made_beside(std::string& pattern) {
  const int descriptor = mkostemp(pattern.data(), O_CLOEXEC);
  if (descriptor < 0) fail("cannot write ", pattern, errno);
  fchmod(descriptor, permissions & ~mask_of_process());
  return descriptor;
}

// Of the first bytes of a file.
Fnv1a hash_of_bytes(int descriptor, std::uint64_t bytes) {
  Fnv1a hash;
  std::string part(most_in_memory, '\0');
  while (bytes > 0) {
    const ssize_t n = read(descriptor, part.data(), std::min<std::uint64_t>(part.size(), bytes));
    if (n <= 0) break;
    hash.add(std::string_view(part).substr(0, static_cast<std::size_t>(n)));
    bytes -= static_cast<std::uint64_t>(n);
  }
  return hash;
}

// The file, positioned after the bytes of the mark, which are still what they were.
int opened_at(const fs::path& file, int flags, const FileMark& mark, Fnv1a& hash) {
  const std::string cannot = "cannot go on with " + file.string() + ": ";
  const int descriptor = open(file.c_str(), flags | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) throw FileError(cannot + std::strerror(errno));
  const auto refuse = [&](const std::string& why) {
    close(descriptor);
    throw FileError(cannot + why);
  };
  const off_t end = lseek(descriptor, 0, SEEK_END);
  const std::string bytes = std::to_string(mark.bytes) + " bytes";
  if (end < 0 || static_cast<std::uint64_t>(end) < mark.bytes)
    refuse("it has " + std::to_string(end) + " bytes, not " + bytes);
  lseek(descriptor, 0, SEEK_SET);
  hash = hash_of_bytes(descriptor, mark.bytes);
  if (hash.value() != mark.hash) refuse("its first " + bytes + " are not those that the run wrote");
  return descriptor;
}

// The file cut to the bytes of the mark, to go on at its end.
int reopened_at(const fs::path& file, const FileMark& mark, Fnv1a& hash) {
  const int descriptor = opened_at(file, O_RDWR, mark, hash);
  const auto length = static_cast<off_t>(mark.bytes);
  if (ftruncate(descriptor, length) == 0 && lseek(descriptor, 0, SEEK_END) == length) return descriptor;
  const int error = errno;
  close(descriptor);
  fail("cannot go on with ", file, error);
}

// Some file systems cannot rename without replacing.
bool renamed_to_free_name(const fs::path& from, const fs::path& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  std::error_code failed;
  const bool is_free = fs::symlink_status(to, failed).type() == fs::file_type::not_found;
  errno = EEXIST;
  return is_free && rename(from.c_str(), to.c_str()) == 0;
}

bool is_regular(const fs::path& file) { return type_of(file) == fs::file_type::regular; }

}  // namespace

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

int files_being_written() { return being_written; }

OutputFile::OutputFile(fs::path file, fs::path partial, int descriptor, Ending ending, std::uint64_t bytes, Fnv1a hash)
    : file_(std::move(file)),
      partial_(std::move(partial)),
      written_(bytes),
      hash_(hash),
      descriptor_(descriptor),
      ending_(ending) {
  ++being_written;
}

void begin_appending(const fs::path& file, std::string_view beginning) {
  tell(file, {.what = FileNews::What::grows, .beginning = std::string(beginning.substr(0, most_told))});
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, permissions);
  if (descriptor < 0) fail("cannot write ", file, errno);
  ::close(descriptor);
}

OutputFile::OutputFile(const fs::path& file, std::string_view headings)
    : OutputFile(file, partial_of(file), made_for(file), Ending::is_new) {
  if (!headings.empty()) *this << headings << "\n";
}

OutputFile OutputFile::at_once(const fs::path& file) {
  refuse_to_replace(file);
  plan(file);
  std::string partial = file.string() + ".partial-XXXXXX";
  const int descriptor = made_beside(partial);
  return {file, partial, descriptor, Ending::is_new_or_nothing};
}

OutputFile OutputFile::replacing(const fs::path& file) {
  const fs::file_type there = type_of(file);
  if (there != fs::file_type::not_found && there != fs::file_type::regular)
    refuse(file, there == fs::file_type::directory ? "it is a directory" : "it is no regular file");
  plan(file);
  std::string partial = file.string() + ".partial-XXXXXX";
  const int descriptor = made_beside(partial);
  return {file, partial, descriptor, Ending::replaces};
}

OutputFile OutputFile::rewriting(const fs::path& file) {
  const fs::path partial = partial_of(file);
  if (is_regular(partial)) unlink(partial.c_str());
  plan(file);
  return {file, partial, made(partial), Ending::replaces};
}

void OutputFile::require(const fs::path& file, const FileMark& mark) {
  const fs::path partial = partial_of(file);
  Fnv1a hash;
  ::close(opened_at(is_regular(partial) ? partial : file, O_RDONLY, mark, hash));
}

void OutputFile::require_whole(const fs::path& file, const FileMark& mark) {
  Fnv1a hash;
  ::close(opened_at(file, O_RDONLY, mark, hash));
  if (const std::uintmax_t bytes = fs::file_size(file); bytes != mark.bytes)
    throw FileError("cannot go on with " + file.string() + ": it has " + std::to_string(bytes) + " bytes, not the " +
                    std::to_string(mark.bytes) + " that the run wrote");
}

OutputFile OutputFile::reopened(const fs::path& file, const FileMark& mark) {
  const fs::path partial = partial_of(file);
  if (!is_regular(partial) && is_regular(file)) fs::rename(file, partial);
  Fnv1a hash;
  if (mark.bytes > 0) {
    std::string beginning(most_told, '\0');
    std::ifstream stream = regular_file(partial);
    stream.read(beginning.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(most_told, mark.bytes)));
    tell_beginning(file, std::string_view(beginning).substr(0, static_cast<std::size_t>(stream.gcount())));
  }
  const int descriptor = reopened_at(partial, mark, hash);
  return {file, partial, descriptor, Ending::is_new, mark.bytes, hash};
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  --being_written;
  drop();
}

// What has failed, unless it is a series, whose beginning is worth something.
void OutputFile::drop() {
  if (ending_ != Ending::is_new) unlink(partial_.c_str());
}

OutputFile& OutputFile::operator<<(std::string_view text) {
  buffer_ += text;
  hash_.add(text);
  if (buffer_.size() >= most_in_memory) flush();
  return *this;
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  if (written_ == 0 && !rest.empty()) tell_beginning(file_, rest);
  while (!rest.empty()) {
    const ssize_t n = write(descriptor_, rest.data(), rest.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("could not write all of ", partial_, errno);
    rest.remove_prefix(static_cast<std::size_t>(n));
    written_ += static_cast<std::uint64_t>(n);
  }
  buffer_.clear();
}

void OutputFile::close() {
  flush();
  const int result = ::close(std::exchange(descriptor_, -1));
  const int error = errno;
  --being_written;
  if (result == 0) return;
  drop();
  fail("could not write all of ", partial_, error);
}

void OutputFile::finish() {
  const FileMark whole = mark();
  tell(file_, {.what = FileNews::What::finished, .mark = whole});
  close();
  const bool renamed = ending_ == Ending::replaces ? rename(partial_.c_str(), file_.c_str()) == 0
                                                   : renamed_to_free_name(partial_, file_);
  if (renamed) return;
  const int error = errno;
  drop();
  fail("cannot rename " + partial_.string() + " to ", file_, error);
}

void replace_file(const fs::path& file, std::string_view text) {
  OutputFile out = OutputFile::replacing(file);
  out << text;
  out.finish();
}

}  // namespace furrow
