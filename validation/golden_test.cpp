// The comparison of a run with its golden cannot say "the same" without having compared, and notices every spoilt
// number.
#include "validation/studies/golden.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "output/files.h"
#include "report/seal.h"
#include "validation/studies/golden_compare.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

Json kept(const std::string& name) {
  std::ifstream stream(fs::path(FURROW_SOURCE_DIR) / "reference_data/golden" / (name + ".json"));
  return Json::parse(stream);
}

struct Way {
  const char* name;
  std::function<void(Json&)> spoil;
};

// Each leaves a golden that says something else, or too little.
const std::vector<Way>& ways() {
  static const std::vector<Way> all{
      {"null", [](Json& g) { g = nullptr; }},
      {"empty object", [](Json& g) { g = Json::object(); }},
      {"a list", [](Json& g) { g = Json::array({g}); }},
      {"another format", [](Json& g) { g["golden"] = 1; }},
      {"another scene's name", [](Json& g) { g["scene"] = "scenario_9"; }},
      {"another reading", [](Json& g) { g["reading"] = "cube"; }},
      {"another end", [](Json& g) { g["end"] = 9.9; }},
      {"end is text", [](Json& g) { g["end"] = "1.2"; }},
      {"another setting", [](Json& g) { g["scene_text"] = g["scene_text"].get<std::string>() + "x = 1\n"; }},
      {"no scene text", [](Json& g) { g.erase("scene_text"); }},
      {"ended otherwise", [](Json& g) { g["ended"] = "diverged: not finite"; }},
      {"ended is no text", [](Json& g) { g["ended"] = 1; }},
      {"no checkpoints", [](Json& g) { g["checkpoints"] = Json::array(); }},
      {"checkpoints left out", [](Json& g) { g.erase("checkpoints"); }},
      {"checkpoints of other times", [](Json& g) { g["checkpoints"][1]["t"] = 0.5; }},
      {"first checkpoint later", [](Json& g) { g["checkpoints"][0]["t"] = 0.01; }},
      {"only the first checkpoint", [](Json& g) { g["checkpoints"] = Json::array({g["checkpoints"][0]}); }},
      {"no last checkpoint", [](Json& g) { g["checkpoints"].erase(2); }},
      {"no middle checkpoint", [](Json& g) { g["checkpoints"].erase(1); }},
      {"a checkpoint more", [](Json& g) { g["checkpoints"].push_back(g["checkpoints"].back()); }},
      {"checkpoint as in the old format",
       [](Json& g) {
         g["checkpoints"][1] = {0.1, "0123456789abcdef"};
       }},
      {"another hash at the start", [](Json& g) { g["checkpoints"][0]["hash"] = "0123456789abcdef"; }},
      {"another hash in the middle", [](Json& g) { g["checkpoints"][1]["hash"] = "0123456789abcdef"; }},
      {"another hash at the end", [](Json& g) { g["checkpoints"][2]["hash"] = "0123456789abcdef"; }},
      {"hash is a number", [](Json& g) { g["checkpoints"][1]["hash"] = 17; }},
      {"hash is no hash", [](Json& g) { g["checkpoints"][1]["hash"] = "x"; }},
      {"energies left out", [](Json& g) { g["checkpoints"][1].erase("energies"); }},
      {"one energy left out", [](Json& g) { g["checkpoints"][1]["energies"].erase("tear"); }},
      {"one energy of another name",
       [](Json& g) {
         g["checkpoints"][1]["energies"].erase("tear");
         g["checkpoints"][1]["energies"]["heat"] = 0.0;
       }},
      {"an energy by its last bit",
       [](Json& g) {
         Json& e = g["checkpoints"][1]["energies"]["kinetic"];
         e = std::nextafter(e.get<double>(), 1e9);
       }},
      {"the sign of zero", [](Json& g) { g["checkpoints"][0]["energies"]["tear"] = -0.0; }},
      {"an energy is null", [](Json& g) { g["checkpoints"][2]["energies"]["friction"] = nullptr; }},
      {"force doubled",
       [](Json& g) {
         for (Json& row : g["force"]) row[1] = 2 * row[1].get<double>();
       }},
      {"force by its last bit",
       [](Json& g) { g["force"][1][1] = std::nextafter(g["force"][1][1].get<double>(), 1e9); }},
      {"last force", [](Json& g) { g["force"].back()[2] = 1.0; }},
      {"force is NaN", [](Json& g) { g["force"][2][1] = std::nan(""); }},
      {"force is null", [](Json& g) { g["force"][2][1] = nullptr; }},
      {"force is text", [](Json& g) { g["force"][2][1] = "1.0"; }},
      {"force row is short", [](Json& g) { g["force"][2].erase(2); }},
      {"force row is missing", [](Json& g) { g["force"].erase(1); }},
      {"force row is doubled", [](Json& g) { g["force"].push_back(g["force"].back()); }},
      {"force rows swapped", [](Json& g) { std::swap(g["force"][1], g["force"][2]); }},
      {"no force rows", [](Json& g) { g["force"] = Json::array(); }},
      {"time of a force row", [](Json& g) { g["force"][1][0] = 0.06; }},
      {"no tears", [](Json& g) { g["tears"] = nullptr; }},
      {"a tear more",
       [](Json& g) {
         g["tears"].push_back({0.05, "structural link", 40.0});
       }},
      {"no position", [](Json& g) { g["positions"] = Json::array(); }},
      {"a position", [](Json& g) { g["positions"][0][0] = 99.0; }},
      {"a position is missing", [](Json& g) { g["positions"].erase(0); }},
      {"a position is text", [](Json& g) { g["positions"][1][1] = "here"; }},
      {"no seal", [](Json& g) { g.erase("seal"); }},
  };
  return all;
}

// Of the runs whose goldens are kept: each is also short where --quick makes it short.
Json quick_run(const Json& golden) {
  Json now = golden;
  now["checkpoints"] = Json::array({golden["checkpoints"][0], golden["checkpoints"][1]});
  for (const char* key : {"force", "tears"}) {
    now[key] = Json::array();
    for (const Json& row : golden[key]) {
      if (row[0] <= first_checkpoint) now[key].push_back(row);
    }
  }
  return now;
}

const std::vector<std::string> runs{"scenario_1_disc",
                                    "scenario_2_disc",
                                    "scenario_2_sphere",
                                    "scenario_3_disc",
                                    "scenario_3_sphere",
                                    "deformable_tool_disc",
                                    "best_reading/scenario_1_disc",
                                    "best_reading/scenario_2_disc",
                                    "best_reading/scenario_3_disc"};

TEST(Golden, SaysWhatItComparedIfAllIsTheSame) {
  const Json golden = kept("scenario_1_disc");
  const Comparison found = compare_golden(golden, golden, Extent::whole);
  EXPECT_TRUE(found.same) << found.text;
  EXPECT_EQ(found.text,
            "the same bits: 3 of 3 checkpoints, each with 11 energies, 25 force rows, 9 tears, 24 positions");
}

TEST(Golden, SaysHowFarAShortRunWasCompared) {
  const Json golden = kept("scenario_3_disc");
  const Comparison found = compare_golden(quick_run(golden), golden, Extent::to_first_checkpoint);
  EXPECT_TRUE(found.same) << found.text;
  EXPECT_EQ(
      found.text,
      "the same bits: 2 of 3 checkpoints, each with 11 energies, 3 force rows, 0 tears; up to t = 0.1 s, the rest "
      "was not run");
}

TEST(Golden, EveryWayToSpoilAWholeOneIsADifference) {
  for (const std::string& name : runs) {
    const Json sound = kept(name);
    ASSERT_TRUE(compare_golden(sound, sound, Extent::whole).same) << name;
    for (const Way& way : ways()) {
      for (const bool sealed : {false, true}) {
        Json spoilt = sound;
        way.spoil(spoilt);
        if (sealed && std::string(way.name) == "no seal") continue;
        if (sealed && spoilt.is_object()) seal(spoilt);
        const Comparison found = compare_golden(sound, spoilt, Extent::whole);
        EXPECT_FALSE(found.same) << name << ": " << way.name << (sealed ? ", sealed: " : ": ") << found.text;
      }
    }
  }
}

TEST(Golden, EveryWayToSpoilOneIsADifferenceToAShortRunToo) {
  for (const std::string& name : runs) {
    const Json sound = kept(name);
    const Json now = quick_run(sound);
    ASSERT_TRUE(compare_golden(now, sound, Extent::to_first_checkpoint).same) << name;
    for (const Way& way : ways()) {
      Json spoilt = sound;
      way.spoil(spoilt);
      EXPECT_FALSE(compare_golden(now, spoilt, Extent::to_first_checkpoint).same) << name << ": " << way.name;
    }
  }
}

TEST(Golden, ARunThatLacksWhatTheGoldenHasIsADifference) {
  const Json golden = kept("scenario_1_disc");
  for (const char* key : {"checkpoints", "force", "tears", "positions"}) {
    Json now = golden;
    now[key].erase(now[key].size() - 1);
    EXPECT_FALSE(compare_golden(now, golden, Extent::whole).same) << key;
  }
}

TEST(Golden, ARunThatFailedIsADifference) {
  const Comparison found = compare_golden({{"failed", "bad_alloc"}}, kept("scenario_1_disc"), Extent::whole);
  EXPECT_FALSE(found.same);
  EXPECT_EQ(found.text, "did not run: bad_alloc");
}

TEST(Golden, TheEarliestDifferenceIsNamedWithItsPlace) {
  const Json golden = kept("scenario_1_disc");
  Json now = golden;
  now["tears"][0][2] = 41.5;
  now["positions"][3][1] = 7.0;
  now["force"].back()[1] = 5.0;
  const Comparison found = compare_golden(now, golden, Extent::whole);
  EXPECT_EQ(found.text.substr(0, found.text.find(';')), "differs at t = " + golden["tears"][0][0].dump() +
                                                            " s, tears, row 0, force [N]: ours 41.5, golden " +
                                                            golden["tears"][0][2].dump());
}

TEST(Golden, AnotherSettingIsNamed) {
  const Json golden = kept("scenario_1_disc");
  Json now = golden;
  std::string text = now["scene_text"];
  text.replace(text.find("method = \"pece\""), 15, "method = \"pec\"");
  now["scene_text"] = text;
  EXPECT_EQ(
      compare_golden(now, golden, Extent::whole).text,
      "the golden is of another scene or other settings: ours \"method = \"pec\"\", golden \"method = \"pece\"\"");
}

TEST(Golden, NoDirectoryIsAnErrorThatSaysWhatToDo) {
  try {
    check_goldens({.directory = "no/such/place", .say = [](const std::string&) {}});
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "no directory no/such/place; run in the source tree or give --goldens");
  }
}

}  // namespace
}  // namespace furrow::validation
