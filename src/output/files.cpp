#include "output/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace furrow {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_in_memory = 1 << 16;  // bytes
constexpr mode_t permissions = 0666;             // less what umask takes

std::atomic<int> being_written = 0;

[[noreturn]] void fail(const std::string& what, const fs::path& file, int error) {
  throw FileError(what + file.string() + ": " + std::strerror(error));
}

fs::path partial_of(const fs::path& file) { return file.string() + ".partial"; }

// O_EXCL: neither a file that is there nor a link is followed or overwritten.
int made(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  if (descriptor < 0) fail("cannot write ", file, errno);
  return descriptor;
}

int made_beside(std::string& pattern) {
  const int descriptor = mkostemp(pattern.data(), O_CLOEXEC);
  if (descriptor < 0) fail("cannot write ", pattern, errno);
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, permissions & ~mask);
  return descriptor;
}

// The file cut to so many bytes, to go on at its end.
int reopened_at(const fs::path& file, std::uint64_t bytes) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) fail("cannot go on with ", file, errno);
  const off_t end = lseek(descriptor, 0, SEEK_END);
  const bool is_long_enough = end >= 0 && static_cast<std::uint64_t>(end) >= bytes;
  const auto length = static_cast<off_t>(bytes);
  if (is_long_enough && ftruncate(descriptor, length) == 0 && lseek(descriptor, 0, SEEK_END) == length)
    return descriptor;
  const int error = errno;
  close(descriptor);
  if (is_long_enough) fail("cannot go on with ", file, error);
  throw FileError("cannot go on with " + file.string() + ": it has " + std::to_string(end) + " bytes, not " +
                  std::to_string(bytes));
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

bool is_regular(const fs::path& file) {
  std::error_code failed;
  return fs::is_regular_file(fs::symlink_status(file, failed));
}

}  // namespace

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

int files_being_written() { return being_written; }

OutputFile::OutputFile(fs::path file, fs::path partial, int descriptor, bool replaces, std::uint64_t bytes)
    : file_(std::move(file)),
      partial_(std::move(partial)),
      written_(bytes),
      descriptor_(descriptor),
      replaces_(replaces) {
  ++being_written;
}

OutputFile::OutputFile(const fs::path& file, std::string_view headings)
    : OutputFile(file, partial_of(file), made(partial_of(file)), false) {
  if (!headings.empty()) *this << headings << "\n";
}

OutputFile OutputFile::replacing(const fs::path& file) {
  std::string partial = file.string() + ".partial-XXXXXX";
  const int descriptor = made_beside(partial);
  return {file, partial, descriptor, true};
}

OutputFile OutputFile::rewriting(const fs::path& file) {
  const fs::path partial = partial_of(file);
  if (is_regular(partial)) unlink(partial.c_str());
  return {file, partial, made(partial), true};
}

OutputFile OutputFile::reopened(const fs::path& file, std::uint64_t bytes) {
  const fs::path partial = partial_of(file);
  if (!is_regular(partial) && is_regular(file)) fs::rename(file, partial);
  return {file, partial, reopened_at(partial, bytes), false, bytes};
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  --being_written;
  if (replaces_) unlink(partial_.c_str());
}

OutputFile& OutputFile::operator<<(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= most_in_memory) flush();
  return *this;
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
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
  if (replaces_) unlink(partial_.c_str());
  fail("could not write all of ", partial_, error);
}

void OutputFile::finish() {
  close();
  const bool renamed = replaces_ ? rename(partial_.c_str(), file_.c_str()) == 0 : renamed_to_free_name(partial_, file_);
  if (renamed) return;
  const int error = errno;
  if (replaces_) unlink(partial_.c_str());
  fail("cannot rename " + partial_.string() + " to ", file_, error);
}

void replace_file(const fs::path& file, std::string_view text) {
  OutputFile out = OutputFile::replacing(file);
  out << text;
  out.finish();
}

}  // namespace furrow
