// Expected numbers are put into the files by hand.
#include "validation/page/observables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "output/first_touch.h"
#include "report/embedded.h"
#include "run_directory.h"

namespace furrow {
using namespace validation;
namespace {

using test::RunDirectory;

RunRecord read(const RunDirectory& directory) { return read_run("made_up", directory.path()); }

std::string error_of(const RunDirectory& directory) {
  try {
    read(directory);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// 3 mm without force, three of contact, three without, two of contact.
const std::vector<std::pair<double, double>> two_contacts{{0, 0}, {0, 0}, {0, 0}, {-30, 1}, {-10, 5}, {-3, 4},
                                                          {0, 0}, {0, 0}, {0, 0}, {-8, -6}, {-7, 2}};

TEST(Observables, ResistanceIsPositive) {
  RunDirectory directory;
  directory.force({{-3, 4}});
  const ForceCurve force = read(directory).force;
  EXPECT_EQ(force.fx, std::vector<double>{3});
  EXPECT_EQ(force.fy, std::vector<double>{4});
  EXPECT_EQ(force.f, std::vector<double>{5});
}

TEST(Observables, FirstContactEndsWhereNothingTouchesThePlate) {
  RunDirectory directory;
  directory.force(two_contacts);
  const RunRecord run = read(directory);
  EXPECT_EQ(measure(run, "first_impact").value, 30);
  EXPECT_NEAR(measure(run, "free_flight_begins").value, 6, 1e-9);
  EXPECT_NEAR(measure(run, "free_flight_ends").value, 9, 1e-9);
  EXPECT_EQ(measure(run, "second_contact_fx").value, 8);
  EXPECT_EQ(measure(run, "second_contact_fy").value, 6) << "in magnitude";
  EXPECT_NEAR(measure(run, "force_free_share").value, 100 * 6.0 / 11, 1e-9);
}

TEST(Observables, WithoutSecondContactItSaysSo) {
  RunDirectory directory;
  directory.force({{0, 0}, {-30, 0}, {0, 0}, {0, 0}, {0, 0}});
  const RunRecord run = read(directory);
  EXPECT_EQ(measure(run, "first_impact").value, 30);
  EXPECT_EQ(measure(run, "free_flight_ends").words, "not by the end");
  EXPECT_EQ(measure(run, "second_contact_fx").words, "no second contact");
}

TEST(Observables, WindowBoundsWhatIsSeen) {
  RunDirectory directory;
  directory.force(two_contacts);
  const RunRecord run = read(directory);
  EXPECT_NEAR(measure(run, "largest_force").value, std::sqrt(901.0), 1e-5);
  EXPECT_NEAR(measure(run, "largest_force", {{7, 10}}).value, 10, 1e-5);
  EXPECT_NEAR(measure(run, "largest_force_at", {{7, 10}}).value, 9, 1e-9);
  EXPECT_NEAR(measure(run, "force_ratio", {{0, 5}}).value, 4.3, 1e-9);
}

TEST(Observables, WindowBeyondTheEndOfTheRunIsMissing) {
  RunDirectory directory;
  directory.force(two_contacts);
  const Measured late = measure(read(directory), "largest_force", {{5, 100}});
  EXPECT_TRUE(std::isnan(late.value));
  EXPECT_EQ(late.words, "");
}

TEST(Observables, NotANumberIsNotSkipped) {
  RunDirectory directory;
  directory.force({{-5, 0}, {std::nan(""), 0}, {-3, 0}});
  const RunRecord run = read(directory);
  EXPECT_TRUE(std::isnan(measure(run, "largest_force").value));
  EXPECT_TRUE(std::isnan(measure(run, "force_ratio").value));
}

TEST(Observables, GrowthOfAnExponentialIsItsFactor) {
  RunDirectory directory;
  std::vector<std::pair<double, double>> rows;
  for (int mm = 0; mm <= 400; ++mm) rows.emplace_back(-100 * std::pow(2.0, mm / 100.0), 0);
  directory.force(rows);
  EXPECT_NEAR(measure(read(directory), "growth_of_maxima").value, 2, 1e-6) << "six digits are in the file";
  EXPECT_NEAR(measure(read(directory), "exponential_share").value, 1, 1e-6);
}

TEST(Observables, SplitComesWithTheLastChainOfLinks) {
  RunDirectory directory;
  directory.force(two_contacts);
  directory.events("0.07,0.007,structural,stem,1,0,2,0,0,41\n");
  const RunRecord run = read(directory);
  EXPECT_NEAR(measure(run, "split").value, 7, 1e-9);
  EXPECT_NEAR(measure(run, "first_tear").value, 7, 1e-9);
  EXPECT_NEAR(measure(run, "pieces").value, 2.0 / 3, 1e-15);
  EXPECT_EQ(measure(run, "first_structural_tear_place").words, "row 2, column 1 to row 3, column 1");
  EXPECT_EQ(measure(run, "fixed_links_torn").words, "not by the end");
  EXPECT_NEAR(measure(run, "largest_force_after_split").value, 10, 1e-5);
  EXPECT_EQ(measure(run, "smallest_force_after_split").value, 0);
}

TEST(Observables, LastLinkToAFixedNodeCounts) {
  RunDirectory directory;
  directory.force(two_contacts);
  directory.events("0.04,0.004,structural,stem,0,0,1,0,1,41\n");
  const RunRecord run = read(directory);
  EXPECT_NEAR(measure(run, "fixed_links_torn").value, 4, 1e-9);
  EXPECT_EQ(measure(run, "first_structural_tear_place").words, "row 1, column 1 (fixed) to row 2, column 1");
}

TEST(Observables, WholeLatticeIsNotSplit) {
  RunDirectory directory;
  directory.force(two_contacts);
  const RunRecord run = read(directory);
  EXPECT_EQ(measure(run, "split").words, "not by the end");
  EXPECT_EQ(measure(run, "largest_force_after_split").words, "no split");
}

TEST(Observables, PlateMeetsLatticeWhereTheRunSaysSo) {
  RunDirectory directory;
  directory.force(two_contacts);
  const auto met = [&](const std::string& json) {
    directory.write("run.json", json);
    return measure(read(directory), "plate_meets_lattice");
  };
  EXPECT_NEAR(met(R"({"steps": 1, "plate_meets_lattice": 0.25})").value, 25, 1e-12) << "at 100 mm/s";
  EXPECT_EQ(met(R"({"steps": 1, "plate_meets_lattice": null})").words, "not by the end");
  const Measured unknown = met(R"({"steps": 1})");
  EXPECT_TRUE(std::isnan(unknown.value) && unknown.words.empty()) << "a run of before it was recorded";
}

TEST(Observables, FirstTouchIsWhereANodeIsInThePlate) {
  Scene scene = test::three_node_scene();
  scene.plate[0].left_edge = -0.02;  // m: its right side comes to the nodes at 0 with 0.1 m/s
  const System system(scene);
  const State y = system.initial_state();
  const double gap = system.nodes(0, y).x[1] - (system.plate_at(0, 0).left + system.parts().plate[0].width);
  ASSERT_GT(gap, 0);
  FirstTouch touch;
  touch.see(system, 0.99 * gap / 0.1, y);
  EXPECT_TRUE(std::isinf(touch.time()));
  for (const double t : {1.01 * gap / 0.1, 1.02 * gap / 0.1}) touch.see(system, t, y);
  EXPECT_EQ(touch.time(), 1.01 * gap / 0.1);
}

TEST(Observables, InterruptedRunIsReadFromItsPartialFiles) {
  RunDirectory directory;
  directory.force(two_contacts);
  std::filesystem::rename(directory.path() / "plate_force.csv", directory.path() / "plate_force.csv.partial");
  EXPECT_EQ(read(directory).force.f.size(), two_contacts.size());
}

TEST(Observables, BadFilesAreNamedWithTheLine) {
  RunDirectory directory;
  directory.events("0.04,0.004,structural,stem,7,0,8,0,1,41\n");
  EXPECT_NE(error_of(directory).find("events.csv:2: no such link"), std::string::npos) << error_of(directory);
  directory.write("energy.csv", RunDirectory::energy_heading + "1,2,3\n");
  EXPECT_NE(error_of(directory).find("energy.csv:2: has 3 cells"), std::string::npos) << error_of(directory);
  directory.write("plate_force.csv", "t [s],plate,displacement [m],Fx [N],Fy [N],F [N]\n0,tool,0,?,0,0\n");
  EXPECT_NE(error_of(directory).find("plate_force.csv:2: '?' is not a number"), std::string::npos)
      << error_of(directory);
  // Cut within its last number, which is one still.
  directory.write("plate_force.csv", "t [s],plate,displacement [m],Fx [N],Fy [N],F [N]\n0,tool,0,0,0,12");
  EXPECT_NE(error_of(directory).find("plate_force.csv: is cut short"), std::string::npos) << error_of(directory);
  directory.write("plate_force.csv", "");
  EXPECT_NE(error_of(directory).find("plate_force.csv: is cut short"), std::string::npos) << error_of(directory);
  directory.write("plate_force.csv", "t [s],plate\n");
  EXPECT_NE(error_of(directory).find("has no column 'displacement [m]'"), std::string::npos) << error_of(directory);
  directory.remove("plate_force.csv");
  EXPECT_NE(error_of(directory).find("plate_force.csv: no such file"), std::string::npos) << error_of(directory);
  directory.write("run.json", "{");
  EXPECT_NE(error_of(directory).find("run.json: "), std::string::npos) << error_of(directory);
}

TEST(Publication, EveryStatementCanBeMeasured) {
  RunDirectory directory;
  directory.force(two_contacts);
  const RunRecord run = read(directory);
  const Publication paper = read_publication(embedded("validation/statements.toml"));
  std::set<std::string> ids;
  for (const Statement& s : paper.statements) {
    EXPECT_NO_THROW(measure(run, s.observable, s.window)) << s.id;
    EXPECT_TRUE(ids.insert(s.id).second) << s.id << " is there twice";
    for (const std::string& text : {s.scene, s.quantity, s.where, s.read, s.ours}) EXPECT_FALSE(text.empty()) << s.id;
    if (s.window) {
      EXPECT_LT((*s.window)[0], (*s.window)[1]) << s.id;
    }
  }
  EXPECT_GT(ids.size(), 0u);
  EXPECT_THROW(measure(run, "no_such_thing"), std::invalid_argument);
}

TEST(Publication, NumbersAndWordsAreToldApart) {
  const Publication paper = read_publication(
      "title = \"A paper\"\n[[statement]]\nid = \"a\"\nvalue = 238.0\nunit = \"N\"\nwindow = [1.0, 2.0]\n"
      "[[statement]]\nid = \"b\"\nvalue = \"in the middle\"\n");
  ASSERT_EQ(paper.statements.size(), 2u);
  EXPECT_EQ(paper.statements[0].value, 238);
  EXPECT_EQ(paper.statements[0].label, "238 N");
  EXPECT_EQ((*paper.statements[0].window)[1], 2);
  EXPECT_TRUE(std::isnan(paper.statements[1].value));
  EXPECT_EQ(paper.statements[1].words, "in the middle");
}

TEST(Publication, WhatIsMisspeltOrMissingIsAnError) {
  const std::string title = "title = \"A paper\"\n", sound = "[[statement]]\nid = \"a\"\nvalue = 1.0\n";
  EXPECT_NO_THROW(read_publication(title + sound));
  for (const auto& [text, why] : {std::pair<std::string, const char*>{sound, "no title"},
                                  {title, "no statement"},
                                  {title + "statement = [1]\n", "statement 1 is no table"},
                                  {title + "[[statement]]\nid = \"a\"\n", "no id or no value"},
                                  {title + "[[statement]]\nvalue = 1.0\n", "no id or no value"},
                                  {title + sound + "obsevable = \"x\"\n", "obsevable is no key"},
                                  {title + sound + "observable = 1\n", "observable must be a text"},
                                  {title + sound + "holds = [1.0]\n", "holds must be two numbers"},
                                  {title + sound + "window = [1.0, \"x\"]\n", "window must be two numbers"},
                                  {title + sound + "value = 1\n", "statements.toml: "},
                                  {"[[statement]", "statements.toml: "}}) {
    try {
      read_publication(text);
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace furrow
