// Reads CSV files, for tests that compare what was written with what it was written from. It shares nothing with what
// writes them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/files.h"

namespace furrow::test {

inline std::string text_of_file(const std::filesystem::path& file) {
  EXPECT_TRUE(std::filesystem::exists(file)) << file;
  return text_of(file);
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

}  // namespace furrow::test
