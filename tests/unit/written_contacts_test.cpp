// The contacts and the angles in the pictures of a run, read back.
#include "written_contacts.h"

#include <gtest/gtest.h>

#include "csv.h"
#include "output/run_files.h"

namespace furrow {
namespace {

using namespace test;

TEST(WrittenContacts, AreThoseThatTouchWithTheirForces) {
  const OwnDirectory directory;
  const KnownRun known(written_scene());
  run_with_files({.scene_file = "written.toml", .scene = written_scene(), .directory = directory.path() / "run"});
  const double times[] = {0, 0.0051, 0.02};
  std::size_t seen = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Csv file(directory.path() / "run/frames" / ("contacts_00" + std::to_string(k) + ".csv"));
    const auto want = contact_rows(known, known.nearest(times[k]));
    ASSERT_EQ(file.rows.size(), want.size());
    seen += want.size();
    const char* kinds[] = {"disc-disc", "disc-wall", "disc-plate"};
    const char* headings[] = {"a", "b", "x1 [m]", "y1 [m]", "x2 [m]", "y2 [m]", "overlap [m]", "normal force [N]"};
    for (std::size_t row = 0; row < want.size(); ++row) {
      EXPECT_EQ(file.text(row, "kind"), kinds[static_cast<int>(want[row][0])]);
      for (std::size_t n = 0; n < 8; ++n)
        EXPECT_NEAR(file.number(row, headings[n]), want[row][n + 1], 1e-9 * std::max(1.0, want[row][n + 1]));
    }
  }
  EXPECT_GT(seen, 6U);
}

TEST(WrittenAngles, AreTheTurnsOfEachDiscWhereTheSceneAsksForThem) {
  const OwnDirectory directory;
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1), disc({1, 0}, 0.1)};
  scene.disc[1].spin = -3;
  scene.time = {.end = 0.5, .step = 1e-3, .method = "pece"};
  scene.output.frames = {0, 0.5};
  scene.output.angles = true;
  run_with_files({.scene_file = "angles.toml", .scene = scene, .directory = directory.path() / "run"});
  const Csv file(directory.path() / "run/frames/discs_001.csv");
  EXPECT_EQ(file.number(0, "angle [rad]"), 0);
  EXPECT_NEAR(file.number(1, "angle [rad]"), -1.5, 1e-12);  // nothing brakes it
}

}  // namespace
}  // namespace furrow
