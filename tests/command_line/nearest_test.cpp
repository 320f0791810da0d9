// A name that there is not is refused in one line that says which one may be meant, whatever takes the name; and a file
// that there is not in one that says where it was looked for and what is there.
#include "tests/command_line/program.h"

namespace furrow::test {
namespace {

class Nearest : public Program {
 protected:
  void expect_refused(const std::string& arguments, int code, const std::string& words) const {
    const Result r = furrow(arguments);
    EXPECT_EQ(r.code, code) << arguments << "\n" << r.err;
    EXPECT_EQ(r.out, "") << arguments;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << arguments << "\n" << r.err;
    EXPECT_NE(r.err.find(words), std::string::npos) << arguments << "\n" << r.err;
  }
  const std::string run_ = "run " + scene("scenario_1"), set_ = run_ + " --set ";
};

TEST_F(Nearest, NameOfAMethod) {
  for (const std::string& command :
       {run_, "explain " + scene("scenario_1"), "stability " + scene("cantilever"), std::string("engine")}) {
    expect_refused(command + " --method peec", 2, "--method: no method is named \"peec\"; did you mean \"pece\"?");
    expect_refused(command + " --method abm4", 2, "\"abm4\"; did you mean \"odeint_abm4\"?; see furrow methods");
    expect_refused(command + " --method no-such", 2, "\"no-such\"; the least far of those that there are: ");
  }
  expect_refused(set_ + "time.method=abm4", 2, "did you mean \"odeint_abm4\"?");
}

TEST_F(Nearest, NameOfAStudy) {
  for (const char* how : {"study ", "study --status ", "study --words ", "study --check "}) {
    expect_refused(how + std::string("ordr"), 2,
                   "no study is named \"ordr\"; did you mean \"order\"?; see furrow study");
    expect_refused(how + std::string("nosuch"), 2, "no study is named \"nosuch\"; known: order, ");
  }
}

TEST_F(Nearest, NameOfACase) {
  for (const char* how : {"cases ", "judge --engine true --cases "}) {
    expect_refused(how + std::string("herz_pair"), 2, "; did you mean \"hertz_pair\"?; see furrow cases");
    expect_refused(how + std::string("no-such"), 2, "; the least far of those that there are: ");
  }
}

TEST_F(Nearest, WordsOfOptions) {
  expect_refused(run_ + " --solver kernl", 2, "did you mean \"kernel\"?");
  expect_refused(run_ + " --locate tear", 2, "did you mean \"tears\"?");
  expect_refused("export " + scene("single_spring") + " --out deck --to lamps", 2, "did you mean \"lammps\"?");
  expect_refused("export " + scene("single_spring") + " --out deck --allow contact.frction", 2,
                 "did you mean \"contact.friction\"?");
  expect_refused("export " + scene("single_spring") + " --out deck --allow no-such", 2, "the least far of those");
  expect_refused("keys frction", 2, "did you mean \"friction\"?");
  expect_refused("keys no-such", 2, "the least far of those that there are: ");
}

TEST_F(Nearest, Keys) {
  expect_refused(set_ + "time.sept=1e-4", 2, "--set time.sept: unknown key \"sept\"; did you mean \"step\"?");
  expect_refused(set_ + "step=1e-4", 2, "--set step: unknown key \"step\"; did you mean \"time.step\"?");
  expect_refused(set_ + "tiem.step=1e-4", 2, "did you mean \"time\"?");
  expect_refused(set_ + "foo.bar=1", 2, "unknown key \"foo\"; known: title, model, time,");
  expect_refused("calibrate " + scene("scenario_1") + " --to t.toml --vary time.sept=1e-5:1e-4", 2,
                 "did you mean \"step\"?");
}

TEST_F(Nearest, NameOfASceneFile) {
  put("validation/scenes/scenario_1.toml");
  put("validation/scenes/notes.md");
  const std::string here = directory_.string();
  for (const char* command : {"run ", "check ", "explain ", "stability ", "export --out deck "}) {
    expect_refused(command + std::string("validation/scenes/scenario1.toml"), 4,
                   "No such file or directory; did you mean \"validation/scenes/scenario_1.toml\"?");
    expect_refused(command + std::string("validation/scens/scenario_1.toml"), 4,
                   "; did you mean \"validation/scenes/scenario_1.toml\"?");
    expect_refused(command + std::string("bed.toml"), 4,
                   "; there is no \".toml\" file in \".\", seen from \"" + here + "\"");
    expect_refused(command + std::string("validation/scenes/bed.toml"), 4,
                   "; in \"validation/scenes\", seen from \"" + here + "\" there are scenario_1.toml");
    expect_refused(command + std::string("nowhere/at/all.toml"), 4, "; there is no directory \"nowhere\", seen from");
  }
}

// It may be what was left out.
TEST_F(Nearest, NameOfASceneFileWithoutItsEnding) {
  put("scenes/bed.toml");
  put("scenes/notes.md");
  fs::create_directory(directory_ / "none");
  const std::string here = directory_.string();
  expect_refused("check scenes/bed", 4, "; did you mean \"scenes/bed.toml\"?");
  expect_refused("check scens/bed", 4, "; did you mean \"scenes/bed.toml\"?");
  expect_refused("check scenes/nowhere", 4, "; in \"scenes\", seen from \"" + here + "\" there are bed.toml, notes.md");
  expect_refused("check none/nofile", 4, "; there is no file in \"none\", seen from \"" + here + "\"");
  expect_refused("check none/nofile.txt", 4, "; there is no \".txt\" file in \"none\"");
}

TEST_F(Nearest, NameOfADirectoryOfARun) {
  put("runs/bed/notes.txt");
  expect_refused("view runs/bde", 4, "; did you mean \"runs/bed\"?");
  expect_refused("run " + scene("disc_on_wall") + " --resume runs/bde", 4, "; did you mean \"runs/bed\"?");
  expect_refused("export --compare runs/bde/", 4, "; did you mean \"runs/bed\"?");
}

TEST_F(Nearest, OutsideOfTheSourceTreeAReportSaysWhichOptionNamesTheScenes) {
  expect_refused("report", 4,
                 "validation/scenes/scenario_1.toml, seen from " + directory_.string() +
                     ": run in the source tree, or say with --scenes DIR where the scenes are");
  EXPECT_FALSE(has("report"));
}

}  // namespace
}  // namespace furrow::test
