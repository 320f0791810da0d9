// The writer writes what the reader reads, and the hash of that text knows a scene.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>

#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

TEST(SceneWriter, WritesWhatReadsBackAsTheSameText) {
  const std::string text = canonical_text(read_scene(source_dir / "validation/scenes/scenario_3.toml"));
  EXPECT_EQ(canonical_text(parse_scene(text, "f")), text);
}

TEST(SceneWriter, WritesEveryKindOfPart) {
  Scene s = sound_scene();
  s.title = "quote \" and backslash \\";
  s.settle = Settle{.step = 1e-5, .loose = 0.1};
  s.contact.pair = {{.materials = {"soft", "hard"}, .friction = 0.1}};
  s.packing = {Packing{.upper_right = {1, 1}, .material = "soft", .seed = 9'000'000'000'000'000'001}};
  s.lattice[0].node = {{.row = 1, .displacement = {-0.0, 5e-324}}, {.row = 2}};
  s.lattice[0].bending.strength = 1e21;
  s.output.frames = {0.1, 0.2};
  const Scene read = parse_scene(canonical_text(s), "f");
  EXPECT_EQ(canonical_text(read), canonical_text(s));
  EXPECT_EQ(read.title, s.title);
  EXPECT_EQ(read.packing.at(0).seed, s.packing[0].seed);
  EXPECT_TRUE(std::signbit(read.lattice.at(0).node.at(0).displacement.x));
  EXPECT_EQ(read.lattice.at(0).node.at(0).displacement.y, 5e-324);
  EXPECT_EQ(read.lattice.at(0).structural.strength, infinity);
  EXPECT_EQ(read.lattice.at(0).bending.strength, 1e21);
}

TEST(SceneWriter, LeavesOutWhatHasNoValue) {
  const std::string text = canonical_text(parse_scene(good, "f"));
  for (const char* absent : {"shear", "damping_factor", "settle", "wall"})
    EXPECT_EQ(text.find(absent), std::string::npos) << absent;
}

RC_GTEST_PROP(SceneWriter, ReturnsEveryNumberToTheLastBit, ()) {
  Scene s = sound_scene();
  s.disc[0].velocity = {*rc::gen::arbitrary<double>(),
                        std::ldexp(*rc::gen::arbitrary<double>(), *rc::gen::inRange(-1100, 400))};
  RC_PRE(std::isfinite(s.disc[0].velocity.y));
  RC_ASSERT(parse_scene(canonical_text(s), "f").disc.at(0).velocity == s.disc[0].velocity);
}

TEST(SceneHash, IsBlindToHowASceneIsWritten) {
  const std::string other = R"(# the same in other words
disc = [ { material = 'soft', radius = 1_00e-3, position = [ 0, +1 ], spin = 0.0 } ]   # spin by default
title = "a disc falls"
material = [ { poisson = 3e-1, young = 200000, name = "soft" } ]
time.step = 0.001
time.end = 1
)";
  EXPECT_EQ(scene_hash(parse_scene(other, "f")), scene_hash(parse_scene(good, "f")));
}

TEST(SceneHash, SeesEveryValue) {
  const std::uint64_t hash = scene_hash(sound_scene());
  const auto changes_hash = [&](const std::function<void(Scene&)>& change) {
    Scene scene = sound_scene();
    change(scene);
    return scene_hash(scene) != hash;
  };
  EXPECT_FALSE(changes_hash([](Scene&) {}));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.title += ' '; }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.disc[0].radius = std::nextafter(s.disc[0].radius, 1); }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.model.moment_arm = MomentArm::radius; }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.lattice[0].fixed_rows = {1}; }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.settle.emplace(); }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.output.energy = false; }));
}

// The definition written out again, itself held to the published hash of "a".
TEST(SceneHash, IsFnv1aOfTheCanonicalText) {
  const auto fnv1a = [](const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x100000001b3u;
    return hash;
  };
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(scene_hash(sound_scene()), fnv1a(canonical_text(sound_scene())));
}

}  // namespace
}  // namespace furrow
