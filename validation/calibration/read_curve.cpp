#include "validation/calibration/read_curve.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "scene/wording.h"
#include "validation/calibration/targets_file.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct Unit {
  const char* name;
  double size;  // in the unit that the curve is kept in
};

// What a column may be named, whatever the case of its letters, and the units it may have.
struct Column {
  std::vector<std::string> names;
  std::vector<Unit> units;
};

constexpr const char* any_force = "force";  // names no component

const Column displacement{{"displacement"}, {{"mm", 1}, {"m", 1e3}}};
const Column force{{any_force, "F", "Fx", "Fy"}, {{"N", 1}}};

std::string trimmed(const std::string& text, const char* around) {
  const std::size_t first = text.find_first_not_of(around);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(around) - first + 1);
}

// As many as commas and one.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (std::string& cell : cells) cell = trimmed(cell, " \t\"");
  return cells;
}

// Without what ends a line of the other systems.
bool next_line(std::istream& lines, std::string& line) {
  if (!std::getline(lines, line)) return false;
  if (line.ends_with('\r')) line.pop_back();
  return true;
}

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

struct Heading {
  std::string name;  // as the column has it
  double unit = 0;   // its size
};

// Of "NAME [UNIT]", if the cell is one of the headings that the column may have.
std::optional<Heading> heading_of(const std::string& cell, const Column& column) {
  const std::size_t open = cell.find('[');
  if (open == std::string::npos || cell.back() != ']') return {};
  const std::string name = lower(trimmed(cell.substr(0, open), " \t"));
  const std::string unit = trimmed(cell.substr(open + 1, cell.size() - open - 2), " \t");
  const auto named =
      std::find_if(column.names.begin(), column.names.end(), [&](const auto& known) { return lower(known) == name; });
  const auto found =
      std::find_if(column.units.begin(), column.units.end(), [&](const Unit& known) { return known.name == unit; });
  if (named == column.names.end() || found == column.units.end()) return {};
  return Heading{*named, found->size};
}

std::string allowed(const Column& column) {
  std::vector<std::string> units;
  for (const Unit& unit : column.units) units.push_back("[" + std::string(unit.name) + "]");
  return joined(column.names, " or ") + " in " + joined(units, " or ");
}

// Of displacement and force.
std::array<Heading, 2> headings_in(const std::string& heading, const fs::path& file) {
  const std::vector<std::string> cells = cells_of(heading);
  if (cells.size() == 2) {
    const auto first = heading_of(cells[0], displacement), second = heading_of(cells[1], force);
    if (first && second) return {*first, *second};
  }
  throw std::invalid_argument(file.string() + ":1: the heading must name two columns with one unit each, as in " +
                              in_quotes("displacement [mm],force [N]") + ", not " + in_quotes(heading) +
                              "; the first may be " + allowed(displacement) + ", the second " + allowed(force));
}

// In decimal digits alone, with a sign or none.
double cell_number(const std::string& cell, const std::string& where) {
  const bool plus = cell.size() > 1 && cell[0] == '+' && cell[1] != '-';
  const char *begin = cell.data() + (plus ? 1 : 0), *end = cell.data() + cell.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range && rest == end)
    throw std::invalid_argument(where + ": " + cell + " is too small or too large for a number of 64 bits");
  if (error == std::errc{} && rest == end && std::isfinite(value)) return value;
  throw std::invalid_argument(where + ": must be two numbers, displacement and force, not " + in_quotes(cell));
}

void add_point(MeasuredCurve& curve, const std::string& line, const std::array<Heading, 2>& headings,
               const std::string& where) {
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != 2)
    throw std::invalid_argument(where + ": must be two numbers, displacement and force, not " + in_quotes(line));
  curve.mm.push_back(headings[0].unit * cell_number(cells[0], where));
  curve.force.push_back(headings[1].unit * cell_number(cells[1], where));
  if (!std::isfinite(curve.mm.back()))
    throw std::invalid_argument(where + ": the displacement is too large for a number of 64 bits");
  if (curve.mm.back() < 0)
    throw std::invalid_argument(where + ": the displacement must not be below 0, where the plate starts");
  if (curve.mm.size() > 1 && !(curve.mm.back() > curve.mm[curve.mm.size() - 2]))
    throw std::invalid_argument(where + ": the displacement must rise from line to line");
}

}  // namespace

void read_curve(MeasuredCurve& curve, const fs::path& file) {
  std::istringstream lines(text_in(file));
  std::string line;
  next_line(lines, line);
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte order mark
  const std::array<Heading, 2> headings = headings_in(line, file);
  curve.heading = headings[1].name == any_force ? "" : headings[1].name;
  for (int k = 2; next_line(lines, line); ++k) {
    if (trimmed(line, " \t").empty()) continue;
    add_point(curve, line, headings, file.string() + ":" + std::to_string(k));
  }
  if (curve.mm.size() < 2) throw std::invalid_argument(file.string() + ": fewer than two points");
}

}  // namespace furrow::validation
