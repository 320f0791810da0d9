// Files that are never half-written: they carry the ending .partial until they are complete.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace furrow {

class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Shortest text that reads back as the same double.
std::string number(double value);

class OutputFile {
 public:
  // Opens `file`.partial; throws FileError.
  explicit OutputFile(std::filesystem::path file);

  OutputFile& operator<<(std::string_view text) {
    stream_ << text;
    return *this;
  }
  OutputFile& operator<<(double value) { return *this << std::string_view(number(value)); }
  OutputFile& operator<<(int value) { return *this << std::string_view(std::to_string(value)); }

  // One line of comma separated values.
  template <class First, class... Rest>
  void row(const First& first, const Rest&... rest) {
    *this << first;
    ((*this << "," << rest), ...);
    *this << "\n";
  }

  // Closes the file as it is and keeps the ending .partial; finish() takes it away. Both throw FileError, for example
  // on a full disk.
  void close();
  void finish();

 private:
  std::filesystem::path file_, partial_;
  std::ofstream stream_;
};

}  // namespace furrow
