// What moves as it is given feels nothing of walls, of its like and of held nodes: where it passes through is said.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/read.h"
#include "tests/unit/scenes.h"

namespace furrow {
namespace {

using namespace test;

Lattice held(Vec2 origin) {
  Lattice l = lattice(origin, 3, 2, 0.1);
  l.fixed_columns = {0, 1};
  return l;
}

// One disc far off, so that something moves; 1 s.
Scene scene() {
  Scene s = empty_scene();
  s.time.end = 1;
  s.material.resize(1);
  s.disc = {disc({0, 50}, 0.1)};
  return s;
}

Plate moving(double left, Vec2 velocity, double ramp = 0) {
  Plate p = plate({left, 0}, 0.1, 1, velocity);
  p.ramp = ramp;
  return p;
}

std::vector<std::string> warnings_of(const Scene& s) {
  EXPECT_TRUE(problems_of(s).empty());
  return scene_warnings(s);
}

using Lines = std::vector<std::string>;

TEST(ScenePaths, APlateThatGoesBehindAWallIsSaidWithTheTime) {
  Scene s = scene();
  s.wall = {wall({1, 0}, {-1, 0})};
  s.plate = {moving(0.4, {1, 0})};  // 0.5 m off
  EXPECT_EQ(warnings_of(s), Lines{"plate[0]: reaches behind wall[0] from t = 0.5 s on: they do not feel each other"});
  s.plate[0].ramp = 0.2;  // x = t - 0.1
  EXPECT_EQ(warnings_of(s), Lines{"plate[0]: reaches behind wall[0] from t = 0.6 s on: they do not feel each other"});
  s.plate[0].velocity = {-1, 0};
  EXPECT_EQ(warnings_of(s), Lines{});
}

TEST(ScenePaths, APlateThatOnlyReachesAWallIsNotSaid) {
  Scene s = scene();
  s.wall = {wall({1, 0}, {-1, 0}), wall({0, 0}, {0, 1})};  // and slides along a floor
  s.plate = {moving(0.4, {0.5, 0})};
  for (const std::string& text : warnings_of(s)) EXPECT_EQ(text.find("reaches"), std::string::npos) << text;
}

TEST(ScenePaths, PlatesThatRunIntoEachOtherAreSaid) {
  Scene s = scene();
  s.plate = {moving(0, {1, 0}), moving(0.6, {0, 0})};
  EXPECT_EQ(warnings_of(s), Lines{"plate[1]: reaches into plate[0] from t = 0.5 s on: they do not feel each other"});
  s.plate[1].velocity = {1, 0};  // the same motion
  EXPECT_EQ(warnings_of(s), Lines{});
  s.plate[1] = moving(0.6, {0, 0});
  s.plate[1].lower_edge = 2;  // above
  EXPECT_EQ(warnings_of(s), Lines{});
}

TEST(ScenePaths, APlateThroughFixedNodesIsSaid) {
  Scene s = scene();
  s.plate = {moving(0, {1, 0})};
  s.lattice = {held({0.6, 0.3})};
  const Lines want{
      "plate[0]: passes through fixed or driven nodes of lattice[0] from t = 0.5 s on: they do not feel each other"};
  EXPECT_EQ(warnings_of(s), want);
  s.lattice[0].structural = s.lattice[0].shear = link_kind(1, 0);
  s.lattice[0].fixed_columns = {};  // nodes that move feel it
  EXPECT_EQ(warnings_of(s), Lines{});
}

TEST(ScenePaths, DrivenNodesThatGoBehindAWallAreSaid) {
  Scene s = scene();
  s.wall = {wall({1, 0}, {-1, 0})};
  s.lattice = {lattice({0.4, 0}, 3, 2, 0.1)};  // its right column is 0.5 m off
  s.lattice[0].structural = s.lattice[0].shear = link_kind(1, 0);
  s.lattice[0].drive = {{.rows = {0}, .velocity = {2, 0}}};
  EXPECT_EQ(warnings_of(s),
            Lines{"lattice[0]: has driven nodes behind wall[0] from t = 0.25 s on: they do not feel each other"});
}

}  // namespace
}  // namespace furrow
