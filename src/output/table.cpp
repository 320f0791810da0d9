#include "output/table.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace furrow {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found;
  std::istringstream stream(line + ",");
  for (std::string cell; std::getline(stream, cell, ',');) found.push_back(cell);
  return found;
}

template <class Number>
std::vector<Number> parsed(const std::vector<std::string>& texts, const std::string& place) {
  std::vector<Number> values(texts.size());
  for (std::size_t row = 0; row < texts.size(); ++row) {
    const char* end = texts[row].data() + texts[row].size();
    const auto [stop, error] = std::from_chars(texts[row].data(), end, values[row]);
    if (error == std::errc() && stop == end) continue;
    throw std::runtime_error(place + ": line " + std::to_string(row + 2) + ": '" + texts[row] + "' is not a number");
  }
  return values;
}

}  // namespace

std::string run_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) stream = std::ifstream(file.string() + ".partial", std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + ": no such file, or it cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Table::Table(const std::filesystem::path& file) : file_(file.string()) {
  std::istringstream stream(run_file(file));
  std::string line;
  if (!std::getline(stream, line) || line.empty()) throw std::runtime_error(file_ + ": has no heading line");
  heading_ = cells(line);
  columns_.resize(heading_.size());
  for (int number = 2; std::getline(stream, line); ++number) {
    std::vector<std::string> row = cells(line);
    if (row.size() != heading_.size()) {
      throw std::runtime_error(file_ + ": line " + std::to_string(number) + " has " + std::to_string(row.size()) +
                               " cells, the heading " + std::to_string(heading_.size()));
    }
    for (std::size_t k = 0; k < row.size(); ++k) columns_[k].push_back(std::move(row[k]));
  }
}

const std::vector<std::string>& Table::texts(std::string_view column) const {
  const auto found = std::find(heading_.begin(), heading_.end(), column);
  if (found == heading_.end()) throw std::runtime_error(file_ + ": has no column '" + std::string(column) + "'");
  return columns_[static_cast<std::size_t>(found - heading_.begin())];
}

std::vector<double> Table::numbers(std::string_view column) const {
  return parsed<double>(texts(column), file_ + ": column '" + std::string(column) + "'");
}

std::vector<int> Table::integers(std::string_view column) const {
  return parsed<int>(texts(column), file_ + ": column '" + std::string(column) + "'");
}

}  // namespace furrow
