#include "page/table.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "output/files.h"

namespace furrow {

std::filesystem::path run_path(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? file : std::filesystem::path(file.string() + ".partial");
}

std::string run_text(const std::filesystem::path& file) {
  std::ifstream stream(run_path(file), std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + ": no such file, or it cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Table::Table(const std::filesystem::path& file) : file_(run_path(file).string()) {
  std::istringstream stream(run_text(file));
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::vector<std::string> cells;
    std::istringstream row(line + ",");
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (number == 1) {
      heading_ = cells;
      columns_.resize(cells.size());
    } else if (cells.size() != heading_.size()) {
      throw std::runtime_error(file_ + ":" + std::to_string(number) + ": has " + std::to_string(cells.size()) +
                               " cells, the heading " + std::to_string(heading_.size()));
    } else {
      for (std::size_t k = 0; k < cells.size(); ++k) columns_[k].push_back(std::move(cells[k]));
    }
  }
}

Table::Table(std::vector<std::string> heading, const std::vector<std::vector<double>>& columns)
    : heading_(std::move(heading)) {
  for (const std::vector<double>& column : columns) {
    std::vector<std::string>& cells = columns_.emplace_back();
    for (const double value : column) cells.push_back(number(value));
  }
}

const std::vector<std::string>& Table::texts(std::string_view column) const {
  const auto found = std::find(heading_.begin(), heading_.end(), column);
  if (found == heading_.end()) throw std::runtime_error(file_ + ": has no column '" + std::string(column) + "'");
  return columns_[static_cast<std::size_t>(found - heading_.begin())];
}

std::vector<double> Table::numbers(std::string_view column) const {
  std::vector<double> values;
  for (const std::string& text : texts(column)) {
    const char* end = text.data() + text.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) {
      throw std::runtime_error(file_ + ":" + std::to_string(values.size() + 2) + ": '" + text + "' is not a number");
    }
    values.push_back(value);
  }
  return values;
}

}  // namespace furrow
