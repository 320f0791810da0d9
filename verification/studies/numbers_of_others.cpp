#include "verification/studies/numbers_of_others.h"

#include <toml++/toml.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "report/embedded.h"

namespace furrow::verification {
namespace {

std::string text(const toml::table& t, const char* key) { return t[key].value_or(std::string()); }

// Where the printed text is a formula the number is `offset`, and `factor` 0.
double read(const std::string& printed, double factor) {
  if (factor == 0) return 0;
  char* end = nullptr;
  const double value = std::strtod(printed.c_str(), &end);
  if (end == printed.c_str() || *end != '\0') throw std::invalid_argument("no number: " + printed);
  return value;
}

NumberOfOthers number_of(const toml::table& row) {
  NumberOfOthers n{.name = text(row, "name"), .unit = text(row, "unit"), .printed = text(row, "printed")};
  const double factor = row["factor"].value_or(1.0);
  n.number = row["offset"].value_or(0.0) + factor * read(n.printed, factor);
  n.said = text(row, "said");
  n.got = row["got"].value_or(std::nan(""));
  n.tolerance = row["tolerance"].value_or(std::nan(""));
  n.scale = row["scale"].value_or(std::fabs(n.number));
  n.reason = text(row, "reason");
  n.known_off = text(row, "known_off");
  return n;
}

void add(std::vector<ProblemOfOthers>& all, std::string_view file) {
  const toml::table whole = toml::parse(embedded(file), file);
  const toml::array* problems = whole["problem"].as_array();
  if (problems == nullptr) throw std::invalid_argument(std::string(file) + ": no problem");
  for (const toml::node& node : *problems) {
    const toml::table& p = *node.as_table();
    ProblemOfOthers problem{.suite = text(whole, "suite"), .source = text(p, "source"), .name = text(p, "name")};
    if (problem.source.empty()) problem.source = text(whole, "source");
    problem.of = text(p, "of");
    problem.title = text(p, "title");
    problem.cannot = text(p, "cannot");
    problem.page = text(p, "page");
    if (const toml::array* rows = p["row"].as_array()) {
      for (const toml::node& row : *rows) problem.numbers.push_back(number_of(*row.as_table()));
    }
    all.push_back(problem);
  }
}

}  // namespace

double NumberOfOthers::off() const { return std::fabs(got - number) / scale; }

const std::vector<ProblemOfOthers>& problems_of_others() {
  static const std::vector<ProblemOfOthers> all = [] {
    std::vector<ProblemOfOthers> read;
    for (const std::string_view file : embedded_files("verification/published/")) {
      try {
        add(read, file);
      } catch (const toml::parse_error& fault) {
        throw std::invalid_argument(std::string(file) + ", line " + std::to_string(fault.source().begin.line) + ": " +
                                    std::string(fault.description()));
      }
    }
    return read;
  }();
  return all;
}

const NumberOfOthers& number_of_others(const std::string& problem, const std::string& name) {
  for (const ProblemOfOthers& p : problems_of_others()) {
    for (const NumberOfOthers& n : p.numbers) {
      if (p.name == problem && n.name == name) return n;
    }
  }
  throw std::invalid_argument("nothing is published of " + problem + ", " + name);
}

}  // namespace furrow::verification
