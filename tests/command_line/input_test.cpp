// What the program is given: options that make no sense are refused in one line of plain words, and what it runs can be
// run again from the scene that it wrote.
#include <algorithm>

#include "tests/command_line/program.h"

namespace furrow::test {
namespace {

class Input : public Program {
 protected:
  // Refused with exit 2, one line that holds the words, and no file.
  void expect_refusal(const std::string& arguments, const std::string& words) const {
    const Result r = furrow(arguments);
    EXPECT_EQ(r.code, 2) << arguments << "\n" << r.err;
    EXPECT_EQ(r.out, "") << arguments;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << arguments << "\n" << r.err;
    EXPECT_NE(r.err.find(words), std::string::npos) << arguments << "\n" << r.err;
    EXPECT_LT(r.err.size(), 300u) << r.err;
    EXPECT_FALSE(fs::exists(directory_ / "runs")) << arguments;
  }

  nlohmann::json json_of(const std::string& run) const {
    return nlohmann::json::parse(text_of(directory_ / run / "run.json"));
  }
};

TEST_F(Input, NumbersThatMakeNoSenseAreRefusedInOneLineThatNamesTheOption) {
  const std::string run = "run " + scene("scenario_1"), explain = "explain " + scene("scenario_1");
  for (const char* number : {"nan", "-nan", "inf", "0", "-1e-4", "1e999", "abc", "1e-4s", "0x1", "''"}) {
    for (const std::string option : {"--dt", "--until"})
      expect_refusal(run + " " + option + "=" + number, option + ": ");
    expect_refusal(explain + " --dt=" + number, "--dt: ");
  }
  for (const char* number : {"nan", "-1", "inf", "abc", "1e3"})
    expect_refusal("stability " + scene("cantilever") + " --at=" + number, "--at: ");
  for (const char* number : {"0", "65", "1.5", "two", "-1", "99999999999999999999"})
    expect_refusal(run + " --threads=" + number, "--threads: ");
  for (const char* number : {"0", "-1", "1e3", "many"})
    expect_refusal("study --jobs=" + std::string(number), "--jobs: ");
}

TEST_F(Input, SizesAreSaidWithTheirLimitBeforeWorkBegins) {
  const std::string run = "run " + scene("scenario_1");
  expect_refusal(run + " --dt 1e-300", "--dt: time.end / time.step = 1.2e+300 steps; at most 1e+10");
  expect_refusal(run + " --until 1e308", "--until: time.step: time.end / time.step = inf steps; at most 1e+10");
  expect_refusal(run + " --until 1e9", "--until: time.step: time.end / time.step = 1e+13 steps; at most 1e+10");
}

TEST_F(Input, OptionsThatSetOneKeyTwiceAreRefusedNotDropped) {
  const std::string run = "run " + scene("scenario_1");
  expect_refusal(run + " --set time.step=1e-4 --dt 2e-4", "--dt: --set time.step sets it too; give one of them");
  expect_refusal(run + " --set time.step=1e-4 --set time.step=2e-4", "--set time.step: given twice; give one of them");
  expect_refusal(run + " --frames 3 --set output.frames=[0.1]", "--frames: --set output.frames sets it too");
  const std::string plate = run + " --set plate[0].velocity=[0.1,0] --set ";
  expect_refusal(plate + "plate[00].velocity=[0.2,0]", "--set plate[00].velocity: --set plate[0].velocity sets it too");
  expect_refusal(plate + "plate[0].velocity.=[0.2,0]", "--set plate[0].velocity.: --set plate[0].velocity sets it too");
  expect_refusal(plate + "plate[0].velocity.x=0.2", "--set plate[0].velocity.x: --set plate[0].velocity sets it too");
  expect_refusal(run + " --set plate[0].velocity.x=0.2 --set plate[0].velocity=[0.1,0]",
                 "--set plate[0].velocity: --set plate[0].velocity.x sets it too");
}

TEST_F(Input, AVectorWidthThatIsMisspeltIsRefusedNotAnother) {
  for (const char* wrong : {"None", "foo", "''", "avx", "sse2"}) {
    const Result r = furrow("methods", std::string("FURROW_VECTORS=") + wrong);
    EXPECT_EQ(r.code, 2) << wrong;
    EXPECT_NE(r.err.find("it can be none, avx2 or avx512"), std::string::npos) << r.err;
  }
  for (const char* right : {"none", "avx2", "avx512"})
    EXPECT_EQ(furrow("methods", std::string("FURROW_VECTORS=") + right).code, 0) << right;
}

// As a variable of a shell that is not set leaves it: no default, no file beside, and nothing is run before it is said.
TEST_F(Input, AnEmptyValueIsRefusedNotTheDefault) {
  expect_refusal("run " + scene("scenario_1") + " --until 0.01 --out ''", "--out: must not be empty");
  expect_refusal("run " + scene("scenario_1") + " --until 0.01 --resume ''", "--resume: must not be empty");
  expect_refusal("run ''", "scene: must not be empty");
  expect_refusal("run " + scene("scenario_1") + " --until 0.01 --out= --json", "--out: must not be empty");
  expect_refusal("study need --words --out= --status", "--out: must not be empty");
  expect_refusal("study --quick= need", "--quick: must not be empty");
  const std::string calibrate = "calibrate " + scene("scenario_1") + " --vary a=1:2 --to t.toml";
  for (const std::string& command : {std::string("study geometry --quick"), std::string("ensemble --few"),
                                     std::string("statements"), std::string("report"), calibrate})
    expect_refusal(command + " --out ''", "--out: must not be empty");
  expect_refusal("golden --quick --goldens ''", "--goldens: must not be empty");
  expect_refusal("judge --engine true --json ''", "--json: must not be empty");
  expect_refusal("judge --engine true --junit ''", "--junit: must not be empty");
  expect_refusal("report --checks '' --judgements there", "--checks: must not be empty");
}

TEST_F(Input, PicturesCloserThanAStepAreRefusedWhereStepsAreFixed) {
  const std::string run = "run " + scene("scenario_1") + " --until 0.01 --out here ";
  expect_refusal(run + "--set output.frames=[0.0,0.00005]",
                 "--set output.frames: frames[1] is less than a step of 1e-04 s after");
  expect_refusal(run + "--frames 150", "--frames: frames[1] is less than a step of 1e-04 s after the one before it");
  EXPECT_EQ(furrow(run + "--frames 101").code, 0);
}

TEST_F(Input, WordsThatAreMisspeltAreNamedWithTheNearest) {
  expect_refusal("rum x", "\"rum\"; did you mean \"run\"?");
  expect_refusal("--hlep", "\"--hlep\"; did you mean \"--help\"?");
  expect_refusal("run " + scene("scenario_1") + " --lcoate tears", "\"--lcoate\"; did you mean \"--locate\"?");
  expect_refusal("run " + scene("scenario_1") + " --lcoate=tears", "\"--lcoate\"; did you mean \"--locate\"?");
  expect_refusal("run " + scene("scenario_1") + " -x", "\"-x\"");
  expect_refusal("run " + scene("scenario_1") + " --locate tear", "none, tears, all, not \"tear\"; did you mean");
  expect_refusal("run " + scene("scenario_1") + " --locate 2", "none, tears, all, not \"2\"");
  expect_refusal("run " + scene("scenario_1") + " --method peec",
                 "\"peec\"; did you mean \"pece\"?; see furrow methods");
  expect_refusal("stability " + scene("scenario_1") + " --method peec", "did you mean \"pece\"?; see furrow methods");
}

TEST_F(Input, WhatIsMissingOrTooMuchIsSaid) {
  expect_refusal("run", "scene is missing");
  expect_refusal("check", "scenes is missing");
  expect_refusal("run " + scene("scenario_1") + " --dt", "--dt: takes one value");
  expect_refusal("run " + scene("scenario_1") + " --dt 1e-4 --dt 1e-3", "--dt: takes one value");
  expect_refusal("run " + scene("scenario_1") + " more", "\"more\" is one too many");
}

TEST_F(Input, WithoutACommandTheHelpIsPrinted) {
  const Result r = furrow("");
  EXPECT_EQ(r.code, 2);
  for (const char* word : {"run ", "check ", "explain ", "stability ", "Examples", "Exit codes:"})
    EXPECT_NE(r.err.find(word), std::string::npos) << word;
}

TEST_F(Input, HelpSpeaksNoTypeNames) {
  for (const char* command : {"run", "check", "explain", "stability", "report", "study", "golden"}) {
    const Result r = furrow(std::string(command) + " --help");
    EXPECT_EQ(r.code, 0);
    for (const char* noise : {"ENUM", "FLOAT", "UINT", "OR {", " in [", "/furrow "})
      EXPECT_EQ(r.out.find(noise), std::string::npos) << command << ": " << noise << "\n" << r.out;
  }
}

TEST_F(Input, AFileThatCannotBeReadExitsFourWhateverTheCommand) {
  for (const char* command : {"run", "check", "explain", "stability"}) {
    const Result r = furrow(std::string(command) + " nowhere.toml");
    EXPECT_EQ(r.code, 4) << command;
    EXPECT_NE(r.err.find("cannot read scene \"nowhere.toml\""), std::string::npos) << r.err;
  }
}

TEST_F(Input, OptionsAreJudgedTogetherWithTheScene) {
  expect_refusal("run " + scene("scenario_1") + " --dt 5", "--dt: longer than the whole run");
  expect_refusal("run " + scene("scenario_1") + " --until 1e-5", "--until: time.step: longer than the whole run");
}

// The scene that a run writes passes `check` and gives the same run.
class WrittenScene : public Input, public testing::WithParamInterface<const char*> {};

TEST_P(WrittenScene, PassesCheckAndRepeatsTheRun) {
  const Result first = furrow("run " + std::string(GetParam()) + " --out first");
  ASSERT_EQ(first.code, 0) << first.err;
  const Result checked = furrow("check first/scene.toml");
  EXPECT_EQ(checked.code, 0) << checked.err;
  const Result second = furrow("run first/scene.toml --out second");
  ASSERT_EQ(second.code, 0) << second.err;
  for (const char* key : {"scene_hash", "state_hash", "steps", "ended_at", "rhs_evaluations", "title", "seed"})
    EXPECT_EQ(json_of("first")[key], json_of("second")[key]) << key;
  for (const char* name : {"scene.toml", "plate_force.csv", "energy.csv", "state.csv", "frames/frames.csv"})
    EXPECT_EQ(text_of(directory_ / "first" / name), text_of(directory_ / "second" / name)) << name;
}

#define SCENE(name) "'" FURROW_SOURCE_DIR "/validation/scenes/" name ".toml'"
INSTANTIATE_TEST_SUITE_P(
    Options, WrittenScene,
    testing::Values(SCENE("scenario_1") " --until 0.35", SCENE("scenario_1") " --until 0.05 --dt 2e-3",
                    SCENE("scenario_1") " --until 0.05 --dt 3e-3 --method rk4",
                    SCENE("scenario_1") " --until 0.05 --method odeint_dopri5", SCENE("disc_on_wall") " --locate all",
                    SCENE("single_spring") " --dt 0.0123 --until 0.7", SCENE("cantilever") " --until 0.01 --threads 2",
                    SCENE("scenario_3") " --until 0.002"));

TEST_F(Input, CheckShowsAllThatIsWrongInAFileAtOnce) {
  put("many.toml", R"(title = "five faults"
[time]
end = 1.0
step = 1e-3
method = "peec"
[contact]
damping_factor = -1.0
[[material]]
name = "soil"
young = 2e5
poisson = 0.3
[[disc]]
position = [0.0, 1.0]
radius = 0.1
material = "common"
[[lattice]]
origin = [5.0, 0.0]
rows = 1.5
columns = 2
spacing = 0.1
node_mass = 1.0
material = "common"
fixed_rows = [7]
)");
  const Result r = furrow("check many.toml");
  EXPECT_EQ(r.code, 2);
  EXPECT_EQ(
      r.err,
      "many.toml:5:10: error: time.method: no method is named \"peec\"; did you mean \"pece\"?; see furrow methods\n"
      "many.toml:7:18: error: contact.damping_factor: -1 is outside 0 <= damping_factor < inf\n"
      "many.toml:15:12: error: disc[0].material: no material is named \"common\"; known: soil\n"
      "many.toml:18:8: error: lattice[0].rows: must be an integer, not a float\n"
      "many.toml:22:12: error: lattice[0].material: no material is named \"common\"; known: soil\n");
}

TEST_F(Input, CheckFindsWhatRunWouldRefuse) {
  const std::string good = text_of(FURROW_SOURCE_DIR "/validation/scenes/scenario_2.toml");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  const auto line_of = [&](const std::string& what) {
    return std::to_string(1 + std::count(good.begin(), good.begin() + static_cast<long>(good.find(what)), '\n'));
  };
  put("full.toml", changed("count = 230", "count = 900"));
  put("unfit.toml", changed("method = \"pece\"", "method = \"odeint_rosenbrock4\""));
  const Result full = furrow("check full.toml");
  EXPECT_EQ(full.code, 2);
  EXPECT_NE(full.err.find("full.toml:" + line_of("[[packing]]") + ":1: error: packing[0]: no room for disc"),
            std::string::npos)
      << full.err;
  EXPECT_EQ(furrow("run full.toml --out full").code, 2);
  const Result unfit = furrow("check unfit.toml");
  EXPECT_EQ(unfit.code, 2);
  EXPECT_NE(
      unfit.err.find("unfit.toml:" + line_of("method =") + ":10: error: time.method: the method odeint_rosenbrock4"),
      std::string::npos)
      << unfit.err;
}

TEST_F(Input, CheckRunAndExplainWarnOfWhatMayBeMeant) {
  const std::string scene = R"(title = "Über"
[time]
end = 1e-3
step = 1e-4
[[material]]
name = "Löß"
young = 2e5
poisson = 0.3
[[disc]]
position = [0.0, 0.1]
radius = 0.1
material = "Löß"
[[disc]]
position = [0.0, 0.28]
radius = 0.1
material = "Löß"
)";
  put("overlap.toml", scene);
  const std::string warning = "1 contact overlaps at the start";
  const Result checked = furrow("check overlap.toml");
  EXPECT_EQ(checked.code, 0);
  EXPECT_NE(checked.err.find("overlap.toml: warning: " + warning), std::string::npos) << checked.err;
  EXPECT_NE(furrow("explain overlap.toml").out.find("warning: " + warning), std::string::npos);
  const Result run = furrow("run overlap.toml --out here");
  EXPECT_NE(run.err.find(warning), std::string::npos) << run.err;
  EXPECT_NE(json_of("here")["warnings"].dump().find(warning), std::string::npos);
  EXPECT_EQ(json_of("here")["title"], "Über");
}

TEST_F(Input, AMethodWithoutALimitIsSkippedAmongOthersAndRefusedAlone) {
  const Result among = furrow("stability " + scene("cantilever") + " --method rkc --method pece");
  EXPECT_EQ(among.code, 0) << among.err;
  EXPECT_NE(among.out.find("skipped: rkc chooses its own step"), std::string::npos) << among.out;
  EXPECT_NE(among.out.find("\npece "), std::string::npos) << among.out;
  expect_refusal("stability " + scene("cantilever") + " --method rkc", "rkc chooses its own step");
}

}  // namespace
}  // namespace furrow::test
