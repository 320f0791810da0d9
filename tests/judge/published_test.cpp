// What others have printed beside what furrow computes: verification/published.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "report/embedded.h"
#include "verification/engines/published_run.h"
#include "verification/studies/numbers_of_others.h"

namespace furrow::test {
namespace {

using verification::Json;
using verification::NumberOfOthers;
using verification::ProblemOfOthers;
using verification::problems_of_others;

std::map<std::string, int> count_by_suite(bool said) {
  std::map<std::string, int> count;
  for (const ProblemOfOthers& p : problems_of_others()) count[p.suite] += p.cannot.empty() == said ? 1 : 0;
  return count;
}

std::set<std::string> parts_of(const std::string& suite, bool said) {
  std::set<std::string> parts;
  for (const ProblemOfOthers& p : problems_of_others()) {
    if (p.suite == suite && p.cannot.empty() == said) parts.insert(p.of);
  }
  return parts;
}

// LAMMPS has 23 closed forms: what its file test_analytic_models.cpp tells apart by name, July 2026.
TEST(Published, EachClosedFormOfLammpsIsThere) {
  EXPECT_EQ(parts_of("LAMMPS", true).size(), 15U);
  EXPECT_EQ(parts_of("LAMMPS", false).size(), 8U);
  EXPECT_EQ(parts_of("Chung and Ooi", true).size(), 8U);
  EXPECT_EQ(parts_of("MFiX", true), (std::set<std::string>{"DEM01", "DEM02", "DEM03", "DEM04", "DEM05"}));
  EXPECT_EQ(count_by_suite(true)["Measured"], 7);
  EXPECT_EQ(parts_of("Springs", true), (std::set<std::string>{"elastica", "buckling", "lattice moduli"}));
}

TEST(Published, EachSaysWhereItStandsAndWhy) {
  std::set<std::string> names;
  for (const ProblemOfOthers& p : problems_of_others()) {
    EXPECT_TRUE(names.insert(p.suite + ": " + p.name).second) << p.name;
    EXPECT_FALSE(p.title.empty() || p.of.empty()) << p.name;
    EXPECT_EQ(p.numbers.empty(), !p.cannot.empty()) << p.name;
    EXPECT_TRUE(!p.source.empty() || !p.cannot.empty()) << p.name;
    for (const NumberOfOthers& n : p.numbers) {
      EXPECT_FALSE(n.unit.empty() || n.printed.empty() || n.reason.empty()) << p.name << ", " << n.name;
      EXPECT_TRUE(std::isfinite(n.number) && n.tolerance > 0 && n.scale > 0) << p.name << ", " << n.name;
      // What is as known must be known.
      EXPECT_TRUE(n.reason != "as known" || !n.known_off.empty()) << p.name << ", " << n.name;
    }
  }
}

TEST(Published, FurrowIsWithinTheTolerance) {
  for (const ProblemOfOthers& p : problems_of_others()) {
    for (const NumberOfOthers& n : p.numbers)
      EXPECT_LE(n.off(), n.tolerance) << p.name << ", " << n.name << ": " << n.got << " beside " << n.number;
  }
}

// Beyond round-off, and the sixth digit where a slip starts a step earlier with another compiler.
TEST(Published, NumbersOfTheFilesAreThoseOfTheSolver) {
  int compared = 0;
  for (const std::string_view file : embedded_files("verification/published/")) {
    const Json whole = verification::plain_case_from(embedded(file), std::string(file));
    for (const Json& problem : whole["problem"]) {
      if (!problem.contains("row") || problem.contains("page")) continue;
      const std::string name = problem["name"];
      const std::map<std::string, double> now = verification::furrows_numbers(problem);
      for (const Json& row : problem["row"]) {
        const NumberOfOthers& n = verification::number_of_others(name, row["name"]);
        EXPECT_NEAR(n.got, now.at(n.name), 1e-6 * std::fmax(std::fabs(n.got), n.scale)) << name << ", " << n.name;
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 100);
}

TEST(Published, NoNumberIsThereThatWasNotPrinted) {
  EXPECT_THROW(verification::number_of_others("test 9", "spin of ball"), std::invalid_argument);
  EXPECT_DOUBLE_EQ(verification::number_of_others("test 1, glass", "greatest overlap").number, 274e-6);
  EXPECT_DOUBLE_EQ(verification::number_of_others("lattice of isotropy", "Poisson's ratio").number, 1.0 / 3);
}

// A case that is one of those problems has the number as it is printed there, digit by digit.
TEST(Published, CasesHaveTheDigitsOfTheSource) {
  for (const auto& [name, problem] :
       std::map<std::string, std::string>{{"partial_slip_10", "test 4, 10 degrees"},
                                          {"partial_slip_10_undamped_tangent", "test 4, 10 degrees"},
                                          {"gross_slip_40", "test 4, 40 degrees"},
                                          {"gross_slip_70", "test 4, 70 degrees"},
                                          {"hertz_pair", "test 1, glass"},
                                          {"hertz_wall", "test 2, aluminium alloy"}}) {
    for (const Json& seen : verification::case_named(name)["observe"]) {
      if (!seen.contains("published")) continue;
      const double printed = verification::number_of_others(problem, seen["name"]).number;
      EXPECT_NEAR(seen["published"].get<double>() / printed, 1, 1e-15) << name << ", " << seen["name"] << ": a unit";
    }
  }
}

// A wrong law must be seen: the same impact with other friction, and of a disc.
TEST(Published, AnotherLawIsSeen) {
  const Json whole = verification::plain_case_from(embedded("verification/published/lammps.toml"), "lammps");
  for (const Json& problem : whole["problem"]) {
    if (problem["name"] != "dem04-mindlin-oblique-3d-si") continue;
    Json other = problem;
    other["contact"]["friction"] = 0.0921;
    const NumberOfOthers& n = verification::number_of_others("dem04-mindlin-oblique-3d-si", "spin of ball");
    EXPECT_GT(std::fabs(verification::furrows_numbers(other)[n.name] - n.number), n.tolerance * n.scale);
    other = problem;
    other["body"][0]["shape"] = "disc";
    EXPECT_GT(std::fabs(verification::furrows_numbers(other)[n.name] - n.number), n.tolerance * n.scale);
    return;
  }
  FAIL() << "the problem is gone";
}

}  // namespace
}  // namespace furrow::test
