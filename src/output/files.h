// Files that are never half-written: they carry the ending .partial until they are complete.
#pragma once

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "scene/wording.h"

namespace furrow {

class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline std::string number(double value) { return shortest(value); }

class OutputFile {
 public:
  // Opens `file`.partial, to begin with a line of headings if there are any. This, close and finish throw FileError,
  // for example on a full disk.
  explicit OutputFile(std::filesystem::path file, std::string_view headings = {})
      : file_(std::move(file)), partial_(file_.string() + ".partial"), stream_(partial_) {
    if (!stream_) throw FileError("cannot write " + partial_.string() + ": " + std::strerror(errno));
    if (!headings.empty()) stream_ << headings << '\n';
  }

  OutputFile& operator<<(std::string_view text) { return stream_ << text, *this; }
  OutputFile& operator<<(double value) { return *this << std::string_view(number(value)); }
  OutputFile& operator<<(int value) { return *this << std::string_view(std::to_string(value)); }

  // One line of comma separated values.
  template <class First, class... Rest>
  void row(const First& first, const Rest&... rest) {
    *this << first;
    ((*this << "," << rest), ...);
    *this << "\n";
  }

  // Closes the file as it is and keeps the ending .partial.
  void close() {
    stream_.close();
    if (!stream_) throw FileError("could not write all of " + partial_.string() + ": " + std::strerror(errno));
  }

  // Closes the file and takes the ending away.
  void finish() {
    close();
    std::error_code failed;
    std::filesystem::rename(partial_, file_, failed);
    if (failed) throw FileError("cannot rename " + partial_.string() + ": " + failed.message());
  }

 private:
  std::filesystem::path file_, partial_;
  std::ofstream stream_;
};

}  // namespace furrow
