#include "validation/page/svg_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "scene/wording.h"

namespace furrow::validation {
namespace {

struct Point {
  double x = 0, y = 0;
};

constexpr double invisible = 0.15;     // px
constexpr std::size_t long_line = 40;  // points

double off_the_line(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
  return std::fabs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

void keep_between(const std::vector<Point>& line, std::size_t first, std::size_t last, std::vector<char>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double worst = invisible;
    std::size_t at = 0;
    for (std::size_t k = from + 1; k < to; ++k) {
      const double off = off_the_line(line[k], line[from], line[to]);
      if (off > worst) worst = off, at = k;
    }
    if (at == 0) continue;
    kept[at] = 1;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

std::vector<Point> simplified(const std::vector<Point>& line) {
  if (line.size() < long_line) return line;
  std::vector<char> kept(line.size());
  kept.front() = kept.back() = 1;
  keep_between(line, 0, line.size() - 1, kept);
  std::vector<Point> less;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (kept[k] != 0) less.push_back(line[k]);
  }
  return less;
}

// Numbers next to each other need a blank only where they would run together.
void append(std::string& text, const std::string& number) {
  const bool apart =
      !text.empty() && (std::isdigit(static_cast<unsigned char>(text.back())) != 0 || text.back() == '.');
  if (apart && number[0] != '-') text += ' ';
  text += number;
}

// Steps are those between rounded points, so that their errors do not add up.
std::string relative(const std::vector<Point>& line) {
  std::string text = "M";
  append(text, short_number(line[0].x));
  append(text, short_number(line[0].y));
  double x = std::round(10 * line[0].x), y = std::round(10 * line[0].y);
  if (line.size() > 1) text += 'l';
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double nx = std::round(10 * line[k].x), ny = std::round(10 * line[k].y);
    append(text, short_number((nx - x) / 10));
    append(text, short_number((ny - y) / 10));
    x = nx, y = ny;
  }
  return text;
}

}  // namespace

std::string short_number(double value, int digits) {
  std::string number = fixed(value, digits);
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
  }
  if (number == "-0") return "0";
  if (number.rfind("0.", 0) == 0) return number.substr(1);
  if (number.rfind("-0.", 0) == 0) return "-" + number.substr(2);
  return number;
}

std::string short_numbers(std::string_view text, int digits) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data() + at, text.data() + text.size(), value, std::chars_format::fixed);
    if (error == std::errc{}) {
      result += short_number(value, digits);
      at = static_cast<std::size_t>(end - text.data());
    } else {
      result += text[at++];
    }
  }
  return result;
}

std::string short_path(std::string_view d) {
  if (d.find_first_not_of("MLZz0123456789.,- \t\r\n") != std::string_view::npos) return short_numbers(d);
  std::string text;
  std::vector<Point> line;
  const auto end_line = [&] {
    if (line.size() > 1) text += relative(simplified(line));
    line.clear();
  };
  for (std::size_t at = d.find_first_of("MLZz"); at != std::string_view::npos; at = d.find_first_of("MLZz", at + 1)) {
    if (d[at] == 'Z' || d[at] == 'z') {
      end_line();
      text += 'z';
      continue;
    }
    if (d[at] == 'M') end_line();
    const std::string rest(d.substr(at + 1, 60));
    char* after = nullptr;
    const double x = std::strtod(rest.c_str(), &after);
    line.push_back({x, std::strtod(*after == ',' ? after + 1 : after, nullptr)});
  }
  end_line();
  return text;
}

std::string closed_path(std::string_view points) {
  constexpr std::string_view blanks = " \t\r\n";
  std::string d;
  for (std::size_t at = points.find_first_not_of(blanks); at < points.size();) {
    const std::size_t end = std::min(points.find_first_of(blanks, at), points.size());
    d += (d.empty() ? "M" : " L") + std::string(points.substr(at, end - at));
    at = points.find_first_not_of(blanks, end);
  }
  return short_path(d + " Z");
}

}  // namespace furrow::validation
