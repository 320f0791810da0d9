// What the paper leaves open, and the search over it.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "run/prepare.h"
#include "scene/read.h"
#include "validation/calibration/varied_key.h"
#include "validation/page/chapters/readings_parts.h"
#include "validation/page/chapters/readings_rows.h"
#include "validation/page/sentence_observables.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/reading_search.h"

namespace furrow::validation {
namespace {

Scene applied(const std::string& scene, const Alternative& alternative) {
  return read_as(scene, literal_scene(scene, 1), alternative);
}

const std::vector<std::string> scenes{"scenario_1", "scenario_2", "scenario_3"};

TEST(Readings, FirstAlternativesAreWhatTheLiteralSceneFilesSay) {
  for (const Choice& choice : the_readings().choices) {
    for (const std::string& scene : scenes)
      EXPECT_EQ(canonical_text(applied(scene, choice.alternatives.front())), canonical_text(literal_scene(scene, 1)))
          << choice.id << " in " << scene;
  }
}

TEST(Readings, EveryOtherAlternativeChangesASceneIntoOneThatCanBeRun) {
  for (const Choice& choice : the_readings().choices) {
    for (std::size_t a = 1; a < choice.alternatives.size(); ++a) {
      int changed = 0;
      for (const std::string& scene : scenes) {
        const Scene made = applied(scene, choice.alternatives[a]);
        changed += canonical_text(made) != canonical_text(literal_scene(scene, 1)) ? 1 : 0;
        EXPECT_TRUE(problems_of(made).empty()) << choice.id << ", " << choice.alternatives[a].name << " in " << scene;
      }
      EXPECT_GT(changed, 0) << choice.id << ", " << choice.alternatives[a].name;
    }
  }
}

// What the paper leaves open is searched, or it is said why not.
TEST(Readings, NameThePointsThatNoFirstSearchKnew) {
  std::string all;
  for (const Choice& choice : the_readings().choices) {
    for (const Alternative& a : choice.alternatives) all += choice.id + ": " + a.name + ", " + a.reason + "\n";
  }
  for (const auto& [open, why] : the_readings().unsearched) all += open + ": " + why + "\n";
  for (const char* point : {"order of the time levels", "absent while the bed settles", "once it has settled",
                            "auxiliary points against the plate", "half of m*", "m* of node contacts", "Eq. (1)"})
    EXPECT_NE(all.find(point), std::string::npos) << point;
}

// A made-up world in which some alternatives alone bring a row each, whatever else is chosen, one of them to runs that
// furrow run would end.
ReadingsFound search_in_the_made_up_world(std::size_t& made) {
  return search_readings(
      [&](const std::vector<Wanted>& runs) {
        std::vector<Json> results;
        for (const Wanted& run : runs) {
          const auto with = [&](const char* words) { return run.key.find(words) != std::string::npos; };
          Json said = Json::object();
          if (with("box 0.54_m")) said["largest_force_discs"] = 341.0;
          if (with("damper whole_velocity")) said["first_impact"] = 238.0;
          if (with("faces the_nearest")) said["first_tear"] = 333.0;
          if (with(" watched ") || with("strength")) said = {{"valid", !with("faces the_nearest")}};
          results.push_back(said);
        }
        made += runs.size();
        return results;
      },
      false);
}

// What a run is kept under stays where words change: choice and id of each alternative, and no name.
TEST(Readings, KeysOfRunsAreIdsNotWords) {
  const std::regex id("[a-z0-9_.]+");
  for (std::size_t k = 0; k < the_readings().choices.size(); ++k) {
    const Choice& choice = the_readings().choices[k];
    std::set<std::string> ids;
    for (std::size_t a = 0; a < choice.alternatives.size(); ++a) {
      const Alternative& alternative = choice.alternatives[a];
      EXPECT_TRUE(std::regex_match(alternative.id, id)) << alternative.id;
      EXPECT_TRUE(ids.insert(alternative.id).second) << choice.id << ": two of " << alternative.id;
      Interpretation reading(the_readings().choices.size(), 0);
      reading[k] = static_cast<int>(a);
      for (const std::string& scene : scenes) {
        if (a > 0 && concerns(k, scene)) {
          EXPECT_EQ(wanted(scene, reading, 1e-4, 1).key,
                    scene + " dt 1e-04 packing 1: " + choice.id + " " + alternative.id);
        }
      }
    }
  }
}

TEST(Readings, AScenesRunIsNotMadeReadyToBeLookedUp) {
  Interpretation reading(the_readings().choices.size(), 0);
  const Wanted run = wanted("scenario_1", reading, 1e-4, 1);
  const Task task = run.task();
  EXPECT_EQ(task.key, run.key);
  EXPECT_EQ(task.input, task_of("scenario_1", reading, 1e-4, 1).input);
}

TEST(Search, ExchangesItsWayToWhatBringsARow) {
  std::size_t made = 0;
  const ReadingsFound found = search_in_the_made_up_world(made);
  const std::string best = words_of(found.best(scenes).reading);
  for (const char* words : {"box 0.54 m", "damper whole velocity", "faces the nearest"})
    EXPECT_NE(best.find(words), std::string::npos) << best;
  EXPECT_EQ(found.finalists.front().reading, Interpretation(the_readings().choices.size(), 0)) << "the literal one";
  EXPECT_EQ(found.finalists.size(), 1 + static_cast<std::size_t>(the_readings().finalists));
  EXPECT_EQ(found.random, static_cast<std::size_t>(the_readings().random));
  EXPECT_LT(made, 6 * found.points.size() +
                      9 * found.finalists.size() * static_cast<std::size_t>(the_readings().packings) +
                      untorn_runs().size())
      << "readings that make one scene share its run";
}

// What two scenes choose is led by these two alone: the third has taken no part, however good a row of it.
TEST(Search, FitsTwoScenesWithoutTheThird) {
  std::size_t made = 0;
  const ReadingsFound found = search_in_the_made_up_world(made);
  for (const auto& [out, fitted] : found.fitted_without) {
    const std::string words = words_of(fitted.reading);
    EXPECT_EQ(words.find("box 0.54 m") != std::string::npos, out != "scenario_2") << out << ": " << words;
    EXPECT_EQ(fitted.said.at("scenario_3").size(), static_cast<std::size_t>(the_readings().packings));
  }
}

TEST(Search, TriesWhatOthersHaveFound) {
  std::size_t made = 0;
  const ReadingsFound found = search_in_the_made_up_world(made);
  ASSERT_FALSE(the_readings().named.empty());
  for (const auto& [by, reading] : the_readings().named) EXPECT_NO_THROW(found.at(reading)) << by;
}

TEST(Search, GoesOnFromTheBestThatIsValid) {
  std::size_t made = 0;
  const ReadingsFound found = search_in_the_made_up_world(made);
  const std::string winner = words_of(best_valid_finalist(found).reading),
                    best = words_of(best_finalist(found).reading);
  EXPECT_NE(best.find("faces the nearest"), std::string::npos) << best;
  EXPECT_EQ(winner.find("faces the nearest"), std::string::npos) << winner;
  for (const char* words : {"box 0.54 m", "damper whole velocity"})
    EXPECT_NE(winner.find(words), std::string::npos) << winner;
  for (const auto& [out, fitted] : found.fitted_without)
    EXPECT_EQ(words_of(fitted.reading).find("faces the nearest"), std::string::npos) << out;
  EXPECT_EQ(found.fitted_without.size(), scenes.size());
}

TEST(Readings, TheRuleIsAskedOfTheSceneFilesThemselves) {
  const Interpretation literal(the_readings().choices.size(), 0);
  EXPECT_TRUE(is_of_the_scene_files(literal, scenes));
  for (std::size_t k = 0; k < literal.size(); ++k) {
    Interpretation other = literal;
    other[k] = 1;
    EXPECT_FALSE(is_of_the_scene_files(other, scenes)) << the_readings().choices[k].id;
  }
}

TEST(Readings, TheBestValidOneOfTheKeptSearchStandsAsSceneFiles) {
  const Numbers numbers = Numbers::read(FURROW_SOURCE_DIR "/reference_data/studies/readings.json");
  const Interpretation best = best_valid_finalist(kept_search(numbers)).reading;
  EXPECT_TRUE(is_of_the_scene_files(best, scenes, "best_reading/")) << words_of(best);
  Interpretation other = best;
  other.back() = 1 - std::min(1, other.back());
  EXPECT_FALSE(is_of_the_scene_files(other, scenes, "best_reading/")) << "it compares";
}

}  // namespace
}  // namespace furrow::validation
