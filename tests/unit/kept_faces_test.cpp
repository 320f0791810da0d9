// Faces of plates that bodies keep, and plates that are one surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "output/checkpoint.h"
#include "watched_run.h"

namespace furrow {
namespace {

using namespace test;

constexpr double modulus = 1e6 / (2 * (1 - 0.0625)), radius = 0.1;  // Pa, E* of scenes.h; m

// m/s: a disc, or node of that contact radius, that is as fast goes as deep as `overlap`.
double speed_to(double overlap, double mass) {
  return std::sqrt(2 * 8.0 / 15.0 * modulus * std::sqrt(radius) * std::pow(overlap, 2.5) / mass);
}
const double disc_mass = 1000 * std::numbers::pi * radius * radius;  // kg

// An elastic law gives back what it took, however deep: 1.05 times the speed that brings a centre to the middle.
TEST(KeptFaces, ADiscThatMetAPlateOnOneFaceIsNotPushedOutOfTheOther) {
  const double width = 0.05, speed = 1.05 * speed_to(radius + width / 2, disc_mass);
  Scene scene = empty_scene();
  scene.model.tight_plates = true;
  scene.plate = {plate({0, -1}, width, 2)};
  scene.disc = {disc({-radius, 0}, radius, {speed, 0})};
  const WatchedRun r = watched(allowing_all(scene), "verlet", 1e-5, 0.3);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_TRUE(std::fabs(r.y[2] + speed) < 1e-4 * speed)
      << "it leaves where it came from, at " << -speed << " m/s; it was " << r.y[2] << " m/s";
}

TEST(KeptFaces, ANodeThatMetAPlateOnOneFaceIsNotPushedOutOfTheOther) {
  const double width = 0.05;
  Scene scene = empty_scene();
  scene.model.tight_plates = true;
  Lattice l = lattice({-0.01, 0}, 1, 1, 0.1);
  l.contact_radius = radius;
  const double speed = 1.05 * speed_to(width / 2, l.node_mass);
  l.node = {node_setting(0, 0, {}, {speed, 0})};
  scene.lattice = {l};
  scene.plate = {plate({0, -1}, width, 2)};
  const WatchedRun r = watched(allowing_all(scene), "verlet", 1e-5, 0.3);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_TRUE(std::fabs(r.y[2] + speed) < 1e-4 * speed)
      << "it leaves where it came from, at " << -speed << " m/s; it was " << r.y[2] << " m/s";
}

// ---- what a plate sees, by hand ----

constexpr double inf = infinity;

Rectangle goes_on(const Scene& scene, int plate) { return make_parts(scene).plate[plate].goes_on; }

void expect_rectangle(const Rectangle& got, const Rectangle& want) {
  EXPECT_EQ(got.left, want.left);
  EXPECT_EQ(got.right, want.right);
  EXPECT_EQ(got.lower, want.lower);
  EXPECT_EQ(got.upper, want.upper);
}

Scene with_plates(const std::vector<Plate>& plates) {
  Scene scene = empty_scene();
  scene.model.tight_plates = true;
  scene.plate = plates;
  scene.disc = {disc({0, 10}, radius)};
  return scene;
}

TEST(FlushPlates, GoOnToEachOthersFarSides) {
  const Scene scene = with_plates({plate({0, 0}, 1, 2), plate({1, 0}, 4, 2)});
  expect_rectangle(goes_on(scene, 0), {0, 4, 0, 0});
  expect_rectangle(goes_on(scene, 1), {1, 0, 0, 0});
}

TEST(FlushPlates, OnlyAWhollyCoveredFaceIsNone) {
  const Scene scene = with_plates({plate({0, 0}, 1, 2), plate({1, 1}, 4, 1)});
  expect_rectangle(goes_on(scene, 0), {0, 0, 0, 0});
  expect_rectangle(goes_on(scene, 1), {1, 0, 0, 0});
}

TEST(FlushPlates, MoveAlike) {
  const Scene scene = with_plates({plate({0, 0}, 1, 2), plate({1, 0}, 4, 2, {0.1, 0})});
  expect_rectangle(goes_on(scene, 0), {0, 0, 0, 0});
  EXPECT_TRUE(make_parts(scene).plate[0].flush.empty());
}

TEST(FlushPlates, OnAWallGoOnBehindIt) {
  Scene scene = with_plates({plate({0, 0}, 1, 2, {0.1, 0}), plate({3, 0.5}, 1, 2), plate({5, 0}, 1, 2, {0, 0.1})});
  scene.wall = {wall({0, 0}, {0, 1})};
  expect_rectangle(goes_on(scene, 0), {0, 0, inf, 0});
  expect_rectangle(goes_on(scene, 1), {0, 0, 0, 0});
  expect_rectangle(goes_on(scene, 2), {0, 0, 0, 0});
}

TEST(FlushPlates, GiveADiscOverTheirJointOneContact) {
  for (const double x : {-0.3, -1e-3, 0.0, 1e-3, 0.3}) {
    for (const double lower : {-1.0, -2.0}) {
      Scene scene = with_plates({plate({-1, lower}, 1, -lower), plate({0, -1}, 1, 1)});
      scene.disc = {disc({x, 0.09}, radius)};
      const System system(scene);
      std::vector<Contact> all;
      system.for_each_contact(0, system.initial_state(), [&](const Contact& c) { all.push_back(c); });
      ASSERT_EQ(all.size(), 1u) << "x " << x << ", lower " << lower;
      EXPECT_EQ(all[0].ny, -1);
      EXPECT_NEAR(all[0].touch.overlap, 0.01, 1e-17);
      EXPECT_TRUE(x == 0 || all[0].id.b == (x < 0 ? 0 : 1)) << "the plate beneath bears it: x " << x;
    }
  }
}

// ---- the life of a face ----

Face face_at(System& system, double x, double y) {
  State state = system.initial_state();
  state[0] = x;
  state[1] = y;
  system.jump(0, state);
  return system.held_face({disc_plate, 0, 0});
}

TEST(KeptFaces, AreTakenHandedOverAndGivenBack) {
  System system(with_plates({plate({0, 0}, 1, 2)}));
  EXPECT_EQ(face_at(system, -0.2, 1), no_face) << "too far away";
  EXPECT_EQ(face_at(system, -0.1, 1), left_face);
  EXPECT_EQ(face_at(system, 0.9, 1), left_face) << "past the middle";
  EXPECT_EQ(face_at(system, 1.05, 1), left_face) << "and through";
  EXPECT_EQ(face_at(system, 0.45, 0.4), left_face) << "nearer to the lower one, but that would be another force";
  EXPECT_EQ(face_at(system, 0.3, 0.2), lower_face) << "by now the same";
  EXPECT_EQ(face_at(system, 0.9, 0.0), lower_face);
  EXPECT_EQ(face_at(system, 1.05, -0.05), right_face) << "round the end";
  EXPECT_EQ(face_at(system, 1.2, 1), no_face);
  EXPECT_EQ(face_at(system, 0.9, 1), right_face);
}

TEST(KeptFaces, AreStateThatARestoredSystemHas) {
  const Scene scene = with_plates({plate({0, 0}, 1, 2)});
  System system(scene), other(scene);
  EXPECT_EQ(face_at(system, -0.05, 1), left_face);
  State y = system.initial_state();
  y[0] = 0.7;
  y[1] = 1;
  other.jump(0, y);
  EXPECT_NE(system.state_hash(y), other.state_hash(y)) << "the same places, other faces";
  EXPECT_LT(force_on(system, rates(system, 0, y), 0).x, 0);
  EXPECT_GT(force_on(other, rates(other, 0, y), 0).x, 0);
  other.restore(system.discrete_state());
  EXPECT_EQ(rates(system, 0, y), rates(other, 0, y));
  EXPECT_EQ(system.state_hash(y), other.state_hash(y));
}

TEST(KeptFaces, AreInACheckpoint) {
  const Scene scene = with_plates({plate({0, 0}, 1, 2)});
  System system(scene), other(scene);
  ASSERT_EQ(face_at(system, 0.95, 1), right_face);
  HistoryWriter writer;
  system.discrete_state().history(writer);
  HistoryReader reader(writer.bytes());
  DiscreteState read;
  read.history(reader);
  other.restore(read);
  EXPECT_EQ(other.held_face({disc_plate, 0, 0}), right_face);
}

TEST(KeptFaces, ThatAreNotOfTheSceneAreRefused) {
  System system(with_plates({plate({0, 0}, 1, 2)}));
  for (const HeldFace& bad : {HeldFace{disc_plate, 0, 1, left_face}, HeldFace{disc_plate, 1, 0, left_face},
                              HeldFace{disc_wall, 0, 0, left_face}, HeldFace{node_plate, 0, 0, left_face},
                              HeldFace{disc_plate, 0, 0, no_face}}) {
    DiscreteState discrete = system.discrete_state();
    discrete.faces = {bad};
    EXPECT_THROW(system.restore(discrete), std::invalid_argument);
  }
  DiscreteState twice = system.discrete_state();
  twice.faces = {{disc_plate, 0, 0, left_face}, {disc_plate, 0, 0, right_face}};
  EXPECT_THROW(system.restore(twice), std::invalid_argument);
}

TEST(KeptFaces, AreWatchedOnlyWhereOneIsLost) {
  // 1.05 times the speed to the middle: with faces it is no crossing.
  const double width = 0.05, speed = 1.05 * speed_to(radius + width / 2, disc_mass);
  Scene scene = empty_scene();
  scene.plate = {plate({0, -1}, width, 2)};
  scene.disc = {disc({-radius, 0}, radius, {speed, 0})};
  EXPECT_EQ(watched(allowing_all(scene), "verlet", 1e-5, 0.3).of(WatchKind::through_plates).worst, 1);
  scene.model.tight_plates = true;
  EXPECT_EQ(watched(allowing_all(scene), "verlet", 1e-5, 0.3).of(WatchKind::through_plates).worst, 0);
}

}  // namespace
}  // namespace furrow
