// Files that are never half-written: they carry the ending .partial until they are complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "scene/hash.h"
#include "scene/wording.h"
#include "system/history.h"

namespace furrow {

class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline std::string number(double value) { return shortest(value); }

// A cell of comma separated values: in quotes where it must be (RFC 4180).
std::string csv_cell(std::string_view text);

// How far a file has come: what was written so far, to be known again.
struct FileMark {
  std::uint64_t bytes = 0;
  std::uint64_t hash = Fnv1a().value();  // of these bytes
  bool operator==(const FileMark&) const = default;
  void history(HistoryVisitor& visit, const std::string& name) {
    visit("bytes of " + name, bytes);
    visit("hash of " + name, hash);
  }
};

// Every member that writes throws FileError at the write that fails, for example on a full disk.
class OutputFile {
 public:
  // Makes `file`.partial, to begin with a line of headings if there are any. Nothing may stand there, and nothing may
  // stand where finish() puts the file: neither now nor then.
  explicit OutputFile(const std::filesystem::path& file, std::string_view headings = {});

  // Has a name of its own until it is finished, so that nothing of an earlier one is in its way; nothing is left of one
  // that fails. Nothing may stand where finish() puts it: neither now nor then.
  static OutputFile at_once(const std::filesystem::path& file);

  // Takes the place of a regular file when it is finished; until then it has a name of its own. Nothing else is replaced.
  static OutputFile replacing(const std::filesystem::path& file);

  // Takes the place of the owner's own file, in a directory that is its own: what a killed owner left of `file`.partial
  // is removed.
  static OutputFile rewriting(const std::filesystem::path& file);

  // Goes on with `file`.partial, or with the finished file, as it was at the mark. Its bytes must still be those.
  static OutputFile reopened(const std::filesystem::path& file, const FileMark& mark);

  // Throws FileError unless it could be reopened at the mark; changes nothing.
  static void require(const std::filesystem::path& file, const FileMark& mark);

  // Throws FileError unless the file is finished and of just these bytes.
  static void require_whole(const std::filesystem::path& file, const FileMark& mark);

  // A new one with its headings, or reopened as it was at the mark.
  static OutputFile begun(const std::filesystem::path& file, std::string_view headings, const FileMark* mark) {
    if (mark) return reopened(file, *mark);
    return OutputFile(file, headings);
  }

  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();  // of a file that was not closed: what is still in memory is lost

  OutputFile& operator<<(std::string_view text);
  OutputFile& operator<<(double value) { return *this << std::string_view(number(value)); }
  OutputFile& operator<<(int value) { return *this << std::string_view(std::to_string(value)); }

  // One line of comma separated values.
  template <class First, class... Rest>
  void row(const First& first, const Rest&... rest) {
    cell(first);
    ((*this << ",", cell(rest)), ...);
    *this << "\n";
  }

  // Hands to the operating system what is still in memory.
  void flush();

  // Of the file so far, all of it handed over: a run that is killed after it leaves no less.
  FileMark mark() {
    flush();
    return {written_, hash_.value()};
  }

  // Closes the file as it is and keeps the ending .partial.
  void close();

  // Closes the file and takes the ending away.
  void finish();

 private:
  enum class Ending { replaces, is_new, is_new_or_nothing };
  OutputFile(std::filesystem::path file, std::filesystem::path partial, int descriptor, Ending ending,
             std::uint64_t bytes = 0, Fnv1a hash = {});
  void cell(std::string_view text) { *this << csv_cell(text); }
  void cell(double value) { *this << value; }
  void cell(int value) { *this << value; }
  void drop();

  std::filesystem::path file_, partial_;
  std::string buffer_;
  std::uint64_t written_ = 0;
  Fnv1a hash_;
  int descriptor_;
  Ending ending_;
};

// The whole text at once, in place of what stood there.
void replace_file(const std::filesystem::path& file, std::string_view text);

// What an OutputFile says of the file that it will be when finished, each before it is so.
struct FileNews {
  enum class What {
    planned,   // about to be made
    begins,    // with these bytes, while it has the ending .partial
    grows,     // with these bytes; it has no ending, and others will add to it
    finished,  // with these bytes in all; the ending goes
  } what;
  std::string beginning{};  // its first bytes, fifty at most
  FileMark mark{};          // of one that is finished
};

// Hears of every file while it lives. What the function throws keeps the file from going on. Called by any thread, by one at a
// time.
class FileWatch {
 public:
  using Hear = std::function<void(const std::filesystem::path& file, const FileNews& news)>;
  explicit FileWatch(Hear hear);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

 private:
  Hear hear_;
};

// Makes the file if it is not there: for one that lines are added to without an OutputFile. Tells with which bytes it begins.
// Throws FileError.
void begin_appending(const std::filesystem::path& file, std::string_view beginning);

// The file, opened to be read, if it is a regular one: any other might let its reader wait for ever. Else a stream that has
// failed, as of one that cannot be opened.
std::ifstream regular_file(const std::filesystem::path& file);

// All that a file or stream gives, up to 2^28 bytes. Throws FileError, which begins with `name`, if there is more, it is a
// directory or cannot be read.
std::string bounded_text(const std::filesystem::path& file);
std::string bounded_text(std::istream& stream, const std::string& name);

// Length and hash of what is in it.
FileMark mark_of(const std::filesystem::path& file);

// Number of files being written now, in all threads; may be asked in a signal handler.
int files_being_written();

}  // namespace furrow
