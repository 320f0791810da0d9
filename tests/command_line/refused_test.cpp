// Calls that would do less than they say, or say it in words of a library, are refused in words of the program.
#include "tests/command_line/program.h"

namespace furrow::test {
namespace {

class Refused : public Program {
 protected:
  void expect_refused(const std::string& arguments, int code, const std::string& words) const {
    const Result r = furrow(arguments);
    EXPECT_EQ(r.code, code) << arguments << "\n" << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << arguments << "\n" << r.err;
    EXPECT_NE(r.err.find(words), std::string::npos) << arguments << "\n" << r.err;
  }
};

TEST_F(Refused, OptionsThatACallWouldIgnore) {
  for (const char* option : {"--dt 1e-4", "--set time.end=1", "--method rk4", "--until 1", "--to lammps", "--allow x"})
    expect_refused(std::string("export --compare deck ") + option, 2, "--compare");
  expect_refused("golden --reason because", 2, "--remake");
  expect_refused("study --quick", 2, "--quick and --anew need the name of a study");
  expect_refused("cases --protocol foo", 2, "--protocol");
}

TEST_F(Refused, NamesThatAreNotUtf8BeforeAnyWork) {
  const fs::path odd = directory_ / "caf\xE9.toml";
  fs::copy_file(fs::path(FURROW_SOURCE_DIR) / "validation/scenes/disc_on_wall.toml", odd);
  for (const std::string command : {"run", "check", "explain", "calibrate", "export --out deck"})
    expect_refused(command + " 'caf\xE9.toml'", 2, "\"caf?.toml\" is not UTF-8");
  expect_refused("view 'caf\xE9'", 2, "is not UTF-8");
  EXPECT_FALSE(has("runs"));
}

TEST_F(Refused, PlacesThatCannotBeAreSaidWithTheirPath) {
  const std::string longest(300, 'x');
  expect_refused("run " + scene("disc_on_wall") + " --out " + longest, 4, longest + ": File name too long");
  expect_refused("export --compare nodir", 4, "nodir: no such directory");
}

TEST_F(Refused, ABodyThatNoStepWouldMove) {
  const std::string far =
      "title = \"far\"\ntime = { end = 1e-3, step = 1e-6, method = \"verlet\" }\n"
      "material = [{ name = \"m\", young = 1e6, poisson = 0.3 }]\n[[disc]]\nradius = 0.1\n"
      "material = \"m\"\nvelocity = [0.05, 0.0]\n";
  put("far.toml", far + "position = [1e9, 0.0]\n");
  expect_refused("run far.toml --out here", 2, "position: so far out, 1e+09 m, that a step of 1e-06 s at 0.05 m/s");
  put("near.toml", far + "position = [1e4, 0.0]\n");
  EXPECT_EQ(furrow("run near.toml --out here").code, 0) << err();
  put("aside.toml", far + "position = [0.0, 1e9]\n");
  EXPECT_EQ(furrow("check aside.toml").code, 0) << "it moves along the other axis: " << err();
  put("short.toml", far + "position = [0.5, 0.2]\n");
  EXPECT_EQ(furrow("run short.toml --until 1e-7 --dt 1e-8 --set disc[0].velocity=[0.0,0.0] --out short").code, 0)
      << err();
}

TEST_F(Refused, TolerancesOfAMethodThatTakesFixedStepsAreWarnedOf) {
  const std::string check = "run " + scene("disc_on_wall") + " --until 1e-3 --set time.relative_tolerance=1e-8 --out ";
  ASSERT_EQ(furrow(check + "fixed --method rk4").code, 0) << err();
  EXPECT_NE(err().find("time.relative_tolerance: has no effect: rk4 takes fixed steps"), std::string::npos) << err();
  ASSERT_EQ(furrow(check + "controlled --method pece_adaptive").code, 0) << err();
  EXPECT_EQ(err().find("has no effect"), std::string::npos) << err();
}

}  // namespace
}  // namespace furrow::test
