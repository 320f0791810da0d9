#include "validation/page/report.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>

#include "run_directory.h"
#include "tests/files.h"
#include "validation/page/gnuplot.h"
#include "validation/page/runs_table.h"

namespace furrow {
using namespace validation;
namespace {

using test::RunDirectory;
using test::text_of;

std::string page_of(const RunDirectory& run, const std::string& name = "scenario_1") {
  OwnedDirectory out(run.path() / "page", "report", page_files());
  write_report(out, {{name, run.path()}});
  return text_of(out.path() / "index.html");
}

bool has(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

TEST(Report, ShowsARunThatEndedWell) {
  RunDirectory run;
  run.force({{-3, 4}, {-30, 40}, {0, 0}});
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page, "Ran to its end, 1 s or 100 mm"));
  EXPECT_TRUE(has(page, "50 N, at 1 mm"));
  EXPECT_TRUE(has(page, "steps are &lt;large&gt;"));
  EXPECT_TRUE(has(page, "Of the 4.8 J of work") && has(page, "residual, what the ledger cannot place, is 0.075 J"));
  EXPECT_TRUE(has(page, "b) 50 mm"));
  EXPECT_FALSE(has(page, "class=\"failed\""));
  EXPECT_FALSE(has(page, "{{"));
  EXPECT_TRUE(std::filesystem::exists(run.path() / "page" / "scenario_1_force.svg"));
}

TEST(Report, NeverHidesThatARunFailed) {
  RunDirectory run;
  run.facts("diverged", "node 2 left the scene");
  run.force({{-3, 4}, {-30, 40}});
  run.write("frames/frames.csv", "index,t [s],displacement [m]\n0,0,0\n");
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page, "This run is not complete: diverged at 0.5 s of 1 s. Reason: node 2 left the scene"));
  EXPECT_TRUE(has(page, "50 mm: <span class=\"missing\">missing</span>")) << "the snapshot that was not reached";
}

TEST(Report, ShowsARunThatNeverStarted) {
  RunDirectory run;
  run.write("run.json", "{\"ended\": \"interrupted\", \"reason\": \"\", \"ended_at\": 0.0}");
  for (const char* file : {"plate_force.csv", "energy.csv", "events.csv", "frames/frames.csv"}) run.remove(file);
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page, "This run is not complete: interrupted"));
  EXPECT_TRUE(has(page, "Force on the plate: <span class=\"missing\">"));
}

// By hand: one watch of each verdict, a number that JSON cannot hold, one that was not watched.
TEST(Report, ShowsWhatTheRunDidToTheValidityOfItsLaws) {
  RunDirectory run;
  run.force({{-3, 4}, {-30, 40}, {0, 0}});
  EXPECT_TRUE(has(page_of(run), "Validity of the laws: <span class=\"missing\">missing</span>"));
  const auto watch = [](const std::string& name, const std::string& verdict, const std::string& worst,
                        const std::string& allowed) {
    return "\"" + name + "\": {\"verdict\": \"" + verdict + "\", \"worst\": " + worst +
           ", \"warns_above\": 0.01, \"ends_above\": null, \"allowed\": " + allowed +
           ", \"time\": 0.25, \"where\": \"disc 3 & <wall 0>\", \"times\": 7}";
  };
  run.write(
      "run.json",
      "{\"ended\": \"finished\", \"steps\": 10, \"warnings\": [], \"validity\": {\"verdict\": \"warned\", "
      "\"energy_made\": \"not watched\", " +
          watch("overlap", "allowed", "0.625", "0.75") + ", " + watch("through_plates", "allowed", "11.0", "true") +
          ", " + watch("step", "warned", "2.5", "null") + ", " + watch("impact", "kept", "0.0", "null") +
          "}, \"largest_force\": [{\"plate\": \"tool\", \"F\": 62.5, \"Fx\": 0.0, \"Fy\": 62.5, \"time\": 0.5}]}");
  std::string page = page_of(run);
  EXPECT_FALSE(has(page, "&quot;verdict&quot;")) << "raw JSON is for nobody";
  EXPECT_TRUE(has(page, "62.5 N of all steps, at 50 mm"));
  EXPECT_TRUE(has(page, "It goes beyond what its scene file allows, and warns."));
  page = std::regex_replace(page, std::regex("<span aria-hidden=\"true\">[^<]*</span> |</?span[^>]*>"), "");
  page = std::regex_replace(page, std::regex("\\s*</?(tr|td|small)[^>]*>\\s*"), "|");
  page = std::regex_replace(page, std::regex("\\|+"), "|");
  for (const char* row :
       {"|energy that the method or a law made, of all that the scene was given|not watched|",
        "|greatest overlap, of the smaller radius|allowed|0.625|0.01|–|0.75|0.25 s|disc 3 &amp; &lt;wall 0&gt;|",
        "|centres that crossed the middle of a plate|allowed|11|0.01|–|any|0.25 s|disc 3 &amp; &lt;wall 0&gt;|",
        "|step, of the largest stable one at the contacts that are there|warned|2.5|0.01|–|–|0.25 s|disc 3 &amp; "
        "&lt;wall 0&gt;|",
        "|energy of a contact, of what carries the one through the other|kept|0|0.01|–|–|"})
    EXPECT_TRUE(has(page, row)) << row;
  const std::string table = text_of(run.path() / "page/scenes.md");
  EXPECT_TRUE(has(table, "| scene 1 | 11 | <span class=\"missing\">missing</span> | ")) << table;
  EXPECT_TRUE(has(table, " | 0.625 | <span class=\"missing\">missing</span> | 2.5 | warned |")) << table;
}

// The watch has the most of all times of the run, the ledger's last row what is left at its end.
TEST(Report, HasOneNumberForTheEnergyThatARunMade) {
  RunDirectory run;
  run.force({{-3, 4}, {-30, 40}, {0, 0}});
  run.write("run.json",
            "{\"ended\": \"finished\", \"steps\": 10, \"warnings\": [], \"validity\": {\"verdict\": \"allowed\", "
            "\"energy_made\": {\"verdict\": \"allowed\", \"worst\": 0.21875, \"warns_above\": 0.01, "
            "\"ends_above\": 0.1, \"allowed\": 0.35, \"time\": 0.25, \"where\": \"\", \"times\": 7}}}");
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page,
                  "is 0.075 J: the method or a law made 21.9 % of all the energy that the scene was given, out of "
                  "nothing"));
  EXPECT_TRUE(has(page,
                  "<td class=\"number\">21.9 %</td>\n<td class=\"number\">1 %</td>\n<td class=\"number\">10 "
                  "%</td>\n<td class=\"number\">35 %</td>"));
  EXPECT_FALSE(has(page, "of the work)")) << "0.075 J of 4.8 J would be another number";
  EXPECT_TRUE(has(text_of(run.path() / "page/scenes.md"), " | 21.9 % | "));
}

TEST(Report, NamesASceneOfThePaperByItsNumber) {
  RunDirectory run;
  run.force({{-3, 4}, {-30, 40}, {0, 0}});
  Scene scene = test::three_node_scene();
  scene.title = "First scene of the paper: three nodes";
  run.write("scene.toml", canonical_text(scene));
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page, "</span>\nScene 1: three nodes <a"));
  EXPECT_TRUE(has(page, "aria-label=\"Scene 1: three nodes: the force on the plate"));
  EXPECT_TRUE(has(page, "<th scope=\"col\">scene 1</th>")) << "of the table of runs";
  EXPECT_FALSE(has(page, "First scene of the paper"));
}

TEST(Report, ShowsNotANumberAsMissing) {
  RunDirectory run;
  run.force({{-3, 4}, {std::nan(""), 0}, {-1, 0}});
  EXPECT_TRUE(has(page_of(run), "the sum is largest, <span class=\"missing\">missing</span>"));
}

TEST(Report, DrawsDiscsOfWhichOneHasNoStress) {
  RunDirectory run;
  run.force({{-3, 4}});
  run.write("frames/discs_000.csv",
            RunDirectory::discs_heading + "0.05,0.01,0.01,0,0,0,1500\n0.08,0.01,0.01,0,0,0,nan\n");
  EXPECT_TRUE(has(page_of(run), "the largest value is 1.5 kPa"));
}

TEST(Report, IdsOfFiguresDoNotClash) {
  RunDirectory run;
  run.force({{-3, 4}});
  const std::string page = page_of(run);
  std::map<std::string, int> count;
  const std::regex id(" id=[\"']([^\"']*)");
  for (auto at = std::sregex_iterator(page.begin(), page.end(), id); at != std::sregex_iterator(); ++at)
    ++count[(*at)[1]];
  EXPECT_GT(count.size(), 50u);
  for (const auto& [name, times] : count) EXPECT_EQ(times, 1) << name;
}

TEST(Report, SameFilesGiveTheSamePage) {
  RunDirectory run;
  run.force({{-3, 4}, {-30, 40}});
  EXPECT_EQ(page_of(run), page_of(run));
}

TEST(Report, ListsOfFilesStayInRunJsonWhichIsLinked) {
  RunDirectory run;
  std::string facts = text_of(run.path() / "run.json");
  facts.insert(facts.rfind('}'), ", \"files\": {\"motion.csv\": \"4711 c0ffee\"}, \"seal\": \"0badcafe\"");
  run.write("run.json", facts);
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page, "table_runs"));
  EXPECT_FALSE(has(page, "c0ffee") || has(page, "0badcafe"));
  EXPECT_EQ(link_to_record(run.path().parent_path(), run.path()), run.path().filename().string() + "/run.json");
  EXPECT_EQ(link_to_record(run.path() / "page", run.path()), "") << "outside of what is published";
}

TEST(Report, NamesAMissingFile) {
  RunDirectory run;
  run.remove("events.csv");
  try {
    page_of(run);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(has(error.what(), "events.csv: no such file")) << error.what();
  }
}

TEST(Report, SaysThatGnuplotIsMissing) {
  RunDirectory run;
  const std::string path = std::getenv("PATH");
  setenv("PATH", run.path().c_str(), 1);
  std::string said;
  Drawings drawings;
  try {
    draw({}, "plot x", drawings, "x", "x");
  } catch (const std::runtime_error& error) {
    said = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(has(said, "gnuplot is not installed")) << said;
}

TEST(Report, TellsWhatGnuplotComplainsOf) {
  Drawings drawings;
  try {
    draw({}, "plot nonsense_variable\n", drawings, "it's", "x");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(has(error.what(), "undefined variable: nonsense_variable")) << error.what();
  }
}

}  // namespace
}  // namespace furrow
