// Sentences of the paper: their rows, how far a number is from them, and the verdict.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "validation/page/chapters/readings_parts.h"
#include "validation/page/chapters/readings_rows.h"
#include "validation/page/sentence_observables.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/reading_search.h"

namespace furrow::validation {
namespace {

const std::vector<std::string> scenes{"scenario_1", "scenario_2", "scenario_3"};

TEST(Sentences, EveryRowOfTheirOwnIsUsedAndNoIdStandsTwice) {
  std::set<std::string> ids, used;
  for (const Statement& row : the_rows()) EXPECT_TRUE(ids.insert(row.id).second) << row.id;
  for (const Sentence& sentence : the_sentences()) used.insert(sentence.rows.begin(), sentence.rows.end());
  for (std::size_t k = the_paper().statements.size(); k < the_rows().size(); ++k)
    EXPECT_TRUE(used.contains(the_rows()[k].id)) << the_rows()[k].id;
}

TEST(Sentences, WithoutRowsNeedAReason) {
  EXPECT_THROW(read_sentences("[[sentence]]\ntext = \"a\"\nrows = []", {}), std::runtime_error);
  EXPECT_THROW(read_sentences("[[sentence]]\ntext = \"a\"\nrows = [\"none\"]", {}), std::runtime_error);
  EXPECT_EQ(read_sentences("[[sentence]]\ntext = \"a\"\nrows = []\nuntested = \"b\"", {}).size(), 1U);
}

Statement row(const std::string& id) {
  Statement s;
  s.id = id;
  return s;
}

TEST(RowMisfit, IsAHalfAtATenthOfTheNumber) {
  Statement s = row("a");
  s.value = 200;
  EXPECT_EQ(row_misfit(s, {{"a", 200.0}}), 0);
  EXPECT_EQ(row_misfit(s, {{"a", 220.0}}), 0.5);
  EXPECT_EQ(row_misfit(s, {{"a", 180.0}}), 0.5);
  EXPECT_EQ(row_misfit(s, {{"a", "not by the end"}}), 1);
  EXPECT_EQ(row_misfit(s, Json::object()), 1);
}

TEST(RowMisfit, IsNothingWithinARange) {
  Statement s = row("a");
  s.words = "high";
  s.holds = {{2.0, 4.0}};
  EXPECT_EQ(row_misfit(s, {{"a", 2.0}}), 0);
  EXPECT_NEAR(row_misfit(s, {{"a", 4.2}}), 0.5, 1e-12) << "a tenth of its width";
  s.holds = {{2.0, infinity}};
  EXPECT_NEAR(row_misfit(s, {{"a", 1.8}}), 0.5, 1e-12) << "a tenth of its end";
}

Json runs_of(double value) { return {{"a", value}}; }

TEST(RowVerdict, IsOnlyAtThisStepWhereTheFinerOneTakesItAway) {
  Statement s = row("a");
  s.value = 100;
  const std::vector<Json> near{runs_of(101), runs_of(99)}, far{runs_of(10), runs_of(11)};
  EXPECT_EQ(row_verdict(s, near, {}), "reproduced");
  EXPECT_EQ(row_verdict(s, near, near), "reproduced");
  EXPECT_EQ(row_verdict(s, near, far), "only at this step");
  EXPECT_EQ(row_verdict(s, far, near), "not reproduced");
  EXPECT_EQ(row_verdict(s, near, {Json{{"failed", "diverged"}}}), "only at this step");
  EXPECT_EQ(row_verdict(s, {Json{{"failed", "diverged"}}}, {}), "not reproduced");
}

TEST(SentenceVerdict, IsTheWorstOfItsRows) {
  const Sentence two{"", "", "", "", {"stable_lattice", "stable_discs"}};
  EXPECT_EQ(sentence_verdict(two, {{"stable_lattice", "reproduced"}, {"stable_discs", "reproduced in kind"}}),
            "reproduced in kind");
  EXPECT_EQ(sentence_verdict({"", "", "", "", {}}, {}), "not testable");
}

// The text puts the split after 357 mm, figure 8 d shows it at 333 mm.
TEST(SentenceVerdict, SaysWhereThePaperContradictsItself) {
  const std::map<std::string, std::string> verdicts{{"split", "reproduced"}, {"early_maxima", "reproduced"}};
  EXPECT_EQ(sentence_verdict({"", "", "split_in_figure_8d", "", {"split"}}, verdicts),
            "contradicted by the paper itself");
  EXPECT_EQ(sentence_verdict({"", "", "split_in_figure_8d", "", {"early_maxima"}}, verdicts), "reproduced");
}

TEST(SentenceVerdict, HidesNoFailureBehindAContradiction) {
  const Sentence sentence{"", "", "split_in_figure_8d", "", {"split"}};
  EXPECT_EQ(rows_verdict(sentence, {{"split", "not reproduced"}}), "not reproduced");
  EXPECT_EQ(sentence_verdict(sentence, {{"split", "not reproduced"}}), "contradicted by the paper itself");
}

TEST(SentenceVerdict, FindsThatFigure8cAndTheTextOnTheContactCannotBothHold) {
  const auto sentence = std::find_if(the_sentences().begin(), the_sentences().end(), [](const Sentence& s) {
    return s.text.find("undergoes even larger deformation") != std::string::npos;
  });
  std::map<std::string, std::string> verdicts;
  for (const std::string& id : sentence->rows) verdicts[id] = "reproduced";
  EXPECT_EQ(sentence_verdict(*sentence, verdicts), "contradicted by the paper itself");
}

TEST(RowVerdict, OfRightSideFirstIsNotThatOfAtOnce) {
  const Statement& order = row_named("right_side_first");
  EXPECT_EQ(row_verdict(order, {Json{{order.id, 0.0}}}, {}), "not reproduced");
  EXPECT_EQ(row_verdict(order, {Json{{order.id, 3.0}}}, {}), "reproduced");
}

TEST(RowMisfit, IsThatOfTheRangesAsStatedBeforeTheSearch) {
  EXPECT_EQ(row_misfit(row_named("right_side_first"), {{"right_side_first", 0.0}}), 0);
  EXPECT_EQ(row_misfit(row_named("quasi_periodic"), {{"quasi_periodic", 40.0}}), 0);
}

TEST(RowVerdict, OfAHeapOfAMetreIsNotThatOfAHeap) {
  const Statement& heap = row_named("pile_up");
  EXPECT_EQ(row_verdict(heap, {Json{{heap.id, 1010.0}}}, {}), "not reproduced");
  EXPECT_EQ(row_verdict(heap, {Json{{heap.id, 60.0}}}, {}), "reproduced");
  EXPECT_EQ(row_misfit(heap, {{heap.id, 1010.0}}), 0) << "by the range as stated before the search";
}

TEST(Misfit, KnowsNothingOfRowsThatCameAfterTheSearch) {
  std::map<std::string, Json> said{{"scenario_3", Json::object()}};
  const double without = misfit_of(said, {"scenario_3"});
  said["scenario_3"]["meets_in_figure_8c"] = 250.0;
  EXPECT_EQ(misfit_of(said, {"scenario_3"}), without);
}

// Of a search with one finalist, whose untorn runs are all as given.
ReadingsFound found_with(const Json& untorn) {
  ReadingsFound found{};
  found.scenes = scenes;
  found.untorn.assign(untorn_runs().size(), untorn);
  return found;
}

TEST(RowVerdict, OfRunsWithoutTearsIsByTheirValidity) {
  const Statement& row = row_named("untorn_invalid");
  const auto verdict = [&](const Json& untorn) {
    return row_verdict(row, runs_of(row, {}, found_with(untorn), AtStep::papers), {});
  };
  EXPECT_EQ(verdict({{"valid", true}}), "not reproduced");
  EXPECT_EQ(verdict({{"valid", false}}), "reproduced");
}

TEST(RowVerdict, OfTheLastSimulationComparesThree) {
  const Statement& row = row_named("last_is_largest");
  Finalist finalist;
  finalist.said["scenario_1"] = {{{"first_impact", 300.0}}};
  finalist.said["scenario_2"] = {{{"largest_force_discs", 250.0}}, {{"largest_force_discs", 350.0}}};
  finalist.said["scenario_3"] = {{{"largest_force_coupled", 330.0}}, {{"largest_force_coupled", 340.0}}};
  const std::vector<Json> runs = runs_of(row, finalist, found_with({}), AtStep::papers);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_NEAR(runs[0][row.id], 1.1, 1e-12);
  EXPECT_NEAR(runs[1][row.id], 340.0 / 350, 1e-12);
}

TEST(Rows, WithoutANumberSayWhyIfTheyAreOfOneEnd) {
  for (const Statement& row : the_rows()) {
    if (!row.holds) continue;
    const bool two = std::isfinite((*row.holds)[0]) && std::isfinite((*row.holds)[1]);
    EXPECT_TRUE(two || row.read.find("one end alone") != std::string::npos) << row.id;
  }
}

RunRecord record(const std::vector<std::array<double, 3>>& mm_fx_fy) {
  RunRecord run;
  for (const auto& [mm, fx, fy] : mm_fx_fy) {
    run.force.mm.push_back(mm);
    run.force.fx.push_back(fx);
    run.force.fy.push_back(fy);
    run.force.f.push_back(std::hypot(fx, fy));
  }
  return run;
}

double sentence(const RunRecord& run, const std::string& name, std::array<double, 2> window = {0, 1000}) {
  return measure_sentences(run, name, window)->value;
}
TEST(SentenceObservables, FollowTheFirstContactAndTheOrderOfTheSecond) {
  // Contact from 1 to 4 mm, Fx falls and Fy rises; from 8 mm on again, Fx first.
  const RunRecord run = record({{0, 0, 0},
                                {1, 90, 1},
                                {2, 80, 2},
                                {3, 30, 8},
                                {4, 0, 0},
                                {5, 0, 0},
                                {6, 0, 0},
                                {7, 0, 0},
                                {8, 50, 0},
                                {9, 10, -70},
                                {10, 5, 0}});
  EXPECT_NEAR(sentence(run, "first_contact_fx_change"), 30.0 / 2 - 170.0 / 2, 1e-12);
  EXPECT_GT(sentence(run, "first_contact_fy_change"), 0);
  EXPECT_EQ(sentence(run, "second_contact_order"), 1);
  EXPECT_EQ(sentence(run, "contacts_per_100"), 20) << "two in 10 mm";
}

TEST(SentenceObservables, OfTwoForcesThatChangeTogetherAreOne) {
  const RunRecord run = record({{0, 3, -1}, {1, 6, -2}, {2, -9, 3}, {3, 0, 0}});
  EXPECT_NEAR(sentence(run, "proportional"), 1, 1e-12);
  EXPECT_NEAR(sentence(record({{0, 1, 2}, {1, 2, 1}}), "proportional"), -1, 1e-12);
}

TEST(SentenceObservables, CompareTheHalvesOfAWindow) {
  EXPECT_NEAR(sentence(record({{0, 1, 0}, {1, 1, 0}, {3, 2, 0}, {4, 4, 0}}), "mean_rise", {0, 4}), 3, 1e-12);
}

TEST(SentenceObservables, CountTears) {
  RunRecord run = record({{0, 0, 0}, {50, 1, 0}});
  run.torn = {{10, 0}, {30, 0}, {40, 0}};
  EXPECT_EQ(sentence(run, "links_torn", {0, 33}), 2);
}

}  // namespace
}  // namespace furrow::validation
