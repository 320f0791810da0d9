// Reads the text files that a run leaves behind. Every error is a std::runtime_error that names the file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::validation {

// `file`, or `file`.partial, as an interrupted run leaves it.
std::filesystem::path run_path(const std::filesystem::path& file);
std::string run_text(const std::filesystem::path& file);

// Comma separated values with a heading line, by column.
class Table {
 public:
  Table() = default;
  explicit Table(const std::filesystem::path& file);
  Table(std::vector<std::string> heading, const std::vector<std::vector<double>>& columns);

  std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].size(); }
  const std::string& file() const { return file_; }
  const std::vector<std::string>& texts(std::string_view column) const;
  std::vector<double> numbers(std::string_view column) const;  // "nan" and "inf" are numbers; anything else is an error

 private:
  std::string file_;
  std::vector<std::string> heading_;
  std::vector<std::vector<std::string>> columns_;
};

}  // namespace furrow::validation
