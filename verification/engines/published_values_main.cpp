// Writes furrow's own numbers beside those that others have published: for a new problem, and after a law has changed.
//
// usage: published_values FILE...
#include <cstdio>
#include <regex>

#include "verification/engines/published_run.h"
#include "verification/engines/rewritten_files.h"

namespace furrow::verification {
namespace {

std::string with_got(const std::string& text, const Json& problems) {
  std::istringstream lines(text);
  std::string all, line, name;
  std::map<std::string, double> numbers;
  std::size_t problem = 0;
  const std::regex naming("name = \"(.*)\"");
  std::smatch found;
  for (bool of_row = false; std::getline(lines, line);) {
    if (line == "[[problem]]") {
      const Json& p = problems[problem++];
      numbers = p.contains("row") && !p.contains("page") ? furrows_numbers(p) : std::map<std::string, double>{};
      of_row = false;
    }
    if (line == "[[problem.row]]") of_row = true;
    if (of_row && std::regex_match(line, found, naming)) name = found[1];
    if (of_row && line.starts_with("got = ") && numbers.contains(name)) {
      char value[40];
      std::snprintf(value, sizeof value, "got = %.14g", numbers[name]);
      line = value;
    }
    all += line + "\n";
  }
  return all;
}

}  // namespace
}  // namespace furrow::verification

int main(int argc, char** argv) {
  using namespace furrow::verification;
  return rewrite_files("published_values", argc, argv, [](const std::string& text, const std::filesystem::path& file) {
    return with_got(text, plain_case_from(text, file.stem())["problem"]);
  });
}
