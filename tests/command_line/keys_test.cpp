// The command `keys`, and single keys set on the command line.
#include "scene/keys.h"

#include "program.h"
#include "tests/unit/scene_of_examples.h"

namespace furrow::test {
namespace {

TEST_F(Program, TheExampleOfEveryKeyPassesCheck) {
  int n = 0;
  for (const SceneKey& key : scene_keys())
    if (key.type != SceneKey::Type::table)
      put("example_" + std::to_string(++n) + "_" + key.name() + ".toml", scene_with(key, key.example));
  const Result r = furrow("check example_*.toml");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(std::count(r.out.begin(), r.out.end(), '\n'), n);
}

TEST_F(Program, KeysPrintsAllOrThoseAskedFor) {
  const Result all = furrow("keys"), some = furrow("keys node.row shear"), json = furrow("keys --json");
  ASSERT_EQ(all.code + some.code + json.code, 0);
  const auto list = nlohmann::json::parse(json.out);
  ASSERT_EQ(list.size(), scene_keys().size());
  for (const auto& key : list) {
    EXPECT_NE(all.out.find(key["key"].get<std::string>() + "\n    "), std::string::npos);
    EXPECT_NE(all.out.find(key["meaning"].get<std::string>()), std::string::npos);
  }
  EXPECT_NE(some.out.find("lattice.node.row\n"), std::string::npos);
  EXPECT_NE(some.out.find("material.shear\n"), std::string::npos);
  EXPECT_EQ(some.out.find("time.step\n"), std::string::npos);
}

TEST_F(Program, ABadPatternOfKeysIsAUsageErrorWithTheNearestName) {
  const Result r = furrow("keys time.stp");
  EXPECT_EQ(r.code, 2);
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(r.err,
            "furrow: error: no key has \"time.stp\" in its name; did you mean \"time.step\"?; see furrow keys\n");
}

// The page and the schema in the repository are those of this program.
TEST_F(Program, TheCommittedPageAndSchemaOfKeysAreThoseOfTheProgram) {
  const fs::path source = FURROW_SOURCE_DIR;
  EXPECT_EQ(furrow("keys --markdown").out, text_of(source / "src/scene/KEYS.md"))
      << "write it again: furrow keys --markdown >src/scene/KEYS.md";
  EXPECT_EQ(furrow("keys --schema").out, text_of(source / "reference_data/schemas/scene.schema.json"))
      << "write it again: furrow keys --schema >reference_data/schemas/scene.schema.json";
}

TEST_F(Program, SetGivesKeysOfTheSceneOtherValues) {
  const Result r = furrow("run " + scene("scenario_1") +
                          " --set time.end=0.01 --set time.method=rk4 --set 'plate[0].velocity=[0.2, 0.0]'"
                          " --set contact.damping_factor=0.3 --set lattice[0].gravity=true --out here");
  ASSERT_EQ(r.code, 0) << r.err;
  const std::string ran = text("here/scene.toml");
  for (const char* line : {"end = 0.01\n", "method = \"rk4\"\n", "velocity = [0.2, 0.0]\n", "damping_factor = 0.3\n",
                           "gravity = true\n", "frames = [0.0]\n"})
    EXPECT_NE(ran.find(line), std::string::npos) << line;
}

TEST_F(Program, SetSaysWhatIsWrongAndExitsWithTwo) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"time.stp=1", "--set time.stp: unknown key \"stp\"; did you mean \"step\"?"},
      {"time.step=fast", "--set time.step: must be a number [s], not \"fast\""},
      {"time.step=-1", "--set time.step: -1 is outside 0 < step < inf [s]"},
      {"plate[0].velocity=[0.1, inf]", "--set plate[0].velocity: inf is outside -inf < velocity[1] < inf [m/s]"},
      {"plate[7].width=1", "--set plate[7].width: there is no item 7: the scene has 1"},
      {"time=1", "--set time: is a table; set one of its keys: end, step, method,"},
      {"time.step.x=1", "--set time.step.x: is a value: it has no key \"x\""},
      {"time[0].step=1", "--set time[0].step: is no list: leave out the [...]"},
      {"plate=1", "--set plate: is a list; say which item, as in plate[0]"},
      {"lattice[0].damper=axal", "must be one of axial, full, not \"axal\"; did you mean \"axial\"?"},
      {"lattice[0].gravity=yes", "must be true or false, not \"yes\""},
      {"output.frames=0.1", "must be a list, [a, b], [s], not \"0.1\""},
      {"plate[0].velocity=1", "must be two numbers, [x, y], [m/s], not \"1\""},
      {"time.step", "--set: must be KEY=VALUE, as in time.step=1e-4, not \"time.step\""}};
  for (const auto& [set, message] : faults) {
    const Result r = furrow("run " + scene("scenario_1") + " --set '" + set + "'");
    EXPECT_EQ(r.code, 2) << set;
    EXPECT_NE(r.err.find(message), std::string::npos) << set << ": " << r.err;
    EXPECT_TRUE(files().empty());
  }
}

}  // namespace
}  // namespace furrow::test
