#include "export/engine_file.h"

#include <charconv>
#include <cmath>

#include "output/files.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double most_count = 1e15;  // whole numbers up to it are exact

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

EngineFile::EngineFile(const std::filesystem::path& file, int refine) : file_(file), refine_(refine) {
  std::error_code unreachable;
  if (!std::filesystem::exists(file, unreachable)) fail_whole("is missing");
  if (!std::filesystem::is_regular_file(file, unreachable)) fail_whole("is no regular file");
  stream_.open(file);
  if (!stream_) fail_whole("cannot be read");
}

bool EngineFile::next() {
  if (!std::getline(stream_, line_)) return false;
  ++number_;
  if (stream_.eof()) fail("does not end: the file was cut");  // without the end of its line
  return true;
}

void EngineFile::need_next() {
  if (!next()) fail_whole("ends too early, after line " + std::to_string(number_));
}

void EngineFile::fail(const std::string& what) const { fail_whole("line " + std::to_string(number_) + " " + what); }

void EngineFile::fail_whole(const std::string& what) const {
  const std::string refined = refine_ > 1 ? " -var refine " + std::to_string(refine_) : "";
  throw FileError(file_.string() + ": " + what + "; run the engine again: lmp -in in.lammps" + refined);
}

std::vector<double> EngineFile::row(std::size_t columns) const {
  std::vector<double> numbers;
  const char* at = line_.data();
  const char* const end = at + line_.size();
  for (;;) {
    while (at != end && is_blank(*at)) ++at;
    if (at == end) break;
    double value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc() || (rest != end && !is_blank(*rest))) fail("is not a row of numbers");
    if (!std::isfinite(value)) fail("has a number that is not finite");
    numbers.push_back(value);
    at = rest;
  }
  if (numbers.size() != columns)
    fail("has " + std::to_string(numbers.size()) + " numbers, not " + std::to_string(columns));
  return numbers;
}

void EngineFile::expect(std::string_view beginning) {
  need_next();
  if (!line_.starts_with(beginning)) fail("is not " + in_quotes(beginning));
}

long EngineFile::count() {
  need_next();
  const double value = row(1).front();
  if (!(value >= 0 && value <= most_count && value == std::floor(value))) fail("is not a whole number");
  return static_cast<long>(value);
}

void EngineFile::expect_number(long value, const std::string& what) {
  if (const long found = count(); found != value)
    fail("has " + std::to_string(found) + " as " + what + ", not " + std::to_string(value));
}

}  // namespace furrow
