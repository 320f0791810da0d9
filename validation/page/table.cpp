#include "validation/page/table.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "output/files.h"

namespace furrow::validation {
namespace {

// A file that was cut within its last line could hold half a number.
void require_whole(const std::string& text, const std::string& file) {
  if (text.empty() || text.back() != '\n' || std::count(text.begin(), text.end(), '"') % 2 != 0)
    throw std::runtime_error(file + ": is cut short: its last line has no end");
}

// RFC 4180: between quotes, commas and ends of lines are text, and "" is one quote.
std::vector<std::vector<std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  bool in_row = false, in_quotes = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (!in_row) rows.push_back({""});
    in_row = true;
    if (c == '"' && in_quotes && k + 1 < text.size() && text[k + 1] == '"') {
      rows.back().back() += text[++k];
    } else if (c == '"') {
      in_quotes = !in_quotes;
    } else if (c == ',' && !in_quotes) {
      rows.back().emplace_back();
    } else if (c == '\n' && !in_quotes) {
      in_row = false;
    } else {
      rows.back().back() += c;
    }
  }
  return rows;
}

}  // namespace

std::filesystem::path run_path(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? file : std::filesystem::path(file.string() + ".partial");
}

std::string run_text(const std::filesystem::path& file) {
  std::ifstream stream = regular_file(run_path(file));
  if (!stream) throw std::runtime_error(file.string() + ": no such file, or it cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Table::Table(const std::filesystem::path& file) : file_(run_path(file).string()) {
  const std::string text = run_text(file);
  require_whole(text, file_);
  const std::vector<std::vector<std::string>> rows = csv_rows(text);
  heading_ = rows[0];
  columns_.resize(heading_.size());
  for (std::size_t row = 1; row < rows.size(); ++row) {
    if (rows[row].size() != heading_.size()) {
      throw std::runtime_error(file_ + ":" + std::to_string(row + 1) + ": has " + std::to_string(rows[row].size()) +
                               " cells, the heading " + std::to_string(heading_.size()));
    }
    for (std::size_t k = 0; k < heading_.size(); ++k) columns_[k].push_back(rows[row][k]);
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

}  // namespace furrow::validation
