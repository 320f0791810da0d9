// Reads CSV files, for tests that compare what was written with what it was written from. It shares nothing with what
// writes them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace furrow::test {

inline std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream) << file;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

struct Csv {
  explicit Csv(const std::filesystem::path& file) : file_(file) {
    std::istringstream lines(text_of_file(file));
    std::string line;
    std::getline(lines, line);
    headings = cells_of(line);
    while (std::getline(lines, line)) {
      rows.push_back(cells_of(line));
      EXPECT_EQ(rows.back().size(), headings.size()) << file << ": " << line;
    }
  }

  // By RFC 4180: a cell in quotes may hold commas, and quotes that are doubled.
  static std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (line[k] == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') {
        cells.back() += line[++k];
      } else if (line[k] == '"') {
        quoted = !quoted;
      } else if (line[k] == ',' && !quoted) {
        cells.emplace_back();
      } else {
        cells.back() += line[k];
      }
    }
    return cells;
  }

  const std::string& text(std::size_t row, const std::string& heading) const {
    static const std::string none;
    for (std::size_t k = 0; k < headings.size(); ++k) {
      if (headings[k] == heading && row < rows.size()) return rows[row][k];
    }
    ADD_FAILURE() << file_ << " has no row " << row << " or no column " << heading;
    return none;
  }

  double number(std::size_t row, const std::string& heading) const {
    const std::string& cell = text(row, heading);
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    EXPECT_TRUE(!cell.empty() && *end == '\0') << file_ << ", row " << row << ", " << heading << ": '" << cell << "'";
    return value;
  }

  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;

 private:
  std::filesystem::path file_;
};

// A directory of its own, removed at the end of the test.
class OwnDirectory {
 public:
  OwnDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "furrow_test_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = pattern;
  }
  ~OwnDirectory() { std::filesystem::remove_all(path_); }
  OwnDirectory(const OwnDirectory&) = delete;
  OwnDirectory& operator=(const OwnDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace furrow::test
