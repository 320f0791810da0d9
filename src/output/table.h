// Reads the text files that a run leaves behind.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

// The text of `file`, or of `file`.partial, as an interrupted run leaves it. Throws std::runtime_error that names the file.
std::string run_file(const std::filesystem::path& file);

// Comma separated values with a heading line, by column. Every error is a std::runtime_error that names file and line.
class Table {
 public:
  Table() = default;
  explicit Table(const std::filesystem::path& file);

  std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].size(); }
  const std::vector<std::string>& texts(std::string_view column) const;
  std::vector<double> numbers(std::string_view column) const;  // "nan" and "inf" are numbers; anything else is an error
  std::vector<int> integers(std::string_view column) const;

 private:
  std::string file_;
  std::vector<std::string> heading_;
  std::vector<std::vector<std::string>> columns_;
};

}  // namespace furrow
