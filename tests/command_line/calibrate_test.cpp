// `furrow calibrate` from outside: what it leaves, and what it says of a wrong call.
#include "program.h"

namespace {

constexpr const char* stem = R"(title = "Stem"
time = { end = 0.1, step = 1e-4 }
contact = { damping_factor = 0.5 }
material = [{ name = "wood", young = 2e5, poisson = 0.3 }]
[[lattice]]
origin = [0.0, 0.0]
rows = 3
columns = 2
spacing = 0.01
node_mass = 0.02
material = "wood"
fixed_rows = [0]
structural = { stiffness = 2e3, damping = 4.0 }
shear = { stiffness = 1e3, damping = 4.0 }
[[plate]]
left_edge = -0.012
lower_edge = 0.012
width = 0.01
height = 0.02
velocity = [0.1, 0.0]
material = "wood"
)";

class Calibrate : public furrow::test::Program {
 protected:
  Calibrate() {
    put("stem.toml", stem);
    put("to.toml", "[[target]]\nobservable = \"largest_force\"\nvalue = 5.0\ntolerance = 0.1\n");
  }
  int calibrate(const std::string& options) const { return furrow("calibrate stem.toml --to to.toml " + options).code; }
};

TEST_F(Calibrate, LeavesAResultAndASceneThatRuns) {
  ASSERT_EQ(calibrate("--vary 'lattice[0].structural.stiffness=1e3,2e3,4e3' --out fitted"), 0) << err();
  const auto json = nlohmann::json::parse(text("fitted/calibration.json"));
  EXPECT_EQ(json.at("search").at("points"), 3);
  EXPECT_EQ(furrow("run fitted/best/stem.toml --out run").code, 0) << err();
}

TEST_F(Calibrate, AnswersAWrongKeyInOneLineAndRunsNothing) {
  EXPECT_EQ(calibrate("--vary lattice[0].stifness=1:2 --out fitted"), 2);
  const std::string said = err();
  EXPECT_NE(said.find("--vary lattice[0].stifness"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_FALSE(has("fitted"));
}

TEST_F(Calibrate, DoesNotWriteIntoWhatIsNotItsOwn) {
  put("fitted/runs.jsonl", "notes of mine\n");
  EXPECT_EQ(calibrate("--vary 'lattice[0].structural.stiffness=1e3,2e3' --out fitted"), 4) << err();
  EXPECT_EQ(text("fitted/runs.jsonl"), "notes of mine\n");
}

}  // namespace
