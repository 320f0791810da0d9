// What a program that embeds furrow has set up for itself changes neither a bit nor a character.
#include <gtest/gtest.h>
#include <unistd.h>
#include <xmmintrin.h>

#include <cfenv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>

#include "output/run_files.h"
#include "run/prepare.h"
#include "run/run.h"
#include "scene/wording.h"
#include "scenes.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

// Two discs fall on a wall, with friction and damping, into a heap.
Scene heap() {
  Scene scene = test::empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.friction = 0.5;
  scene.contact.damping_factor = 0.8;
  scene.disc = {test::disc({0.1, 0.0301}, 0.01, {0.3, 0}), test::disc({0.11, 0.011}, 0.01)};
  scene.wall = {test::wall({0, 0}, {0, 1})};
  scene.time.step = 1e-4;
  scene.time.end = 0.1;
  scene.output.interval = 0.01;
  scene.output.frames = {0, 0.0001};
  return scene;
}

std::uint64_t hash_of_run() {
  Prepared prepared = prepare(heap());
  const auto method = make_method("pece");
  run(prepared.system, *method, prepared.y, {.end = 0.1}, [](double, const State&, const JumpReport&) { return true; });
  return prepared.system.state_hash(prepared.y);
}

// In one place each is undone.
class Environment {
 public:
  Environment() { std::fegetenv(&before_); }
  ~Environment() { std::fesetenv(&before_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::fenv_t before_{};
};

TEST(CallersEnvironment, ItsRoundingModeChangesNoBitAndIsLeftAsItWas) {
  const std::uint64_t usual = hash_of_run();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Environment kept;
    std::fesetround(mode);
    EXPECT_EQ(hash_of_run(), usual);
    EXPECT_EQ(std::fegetround(), mode);
  }
}

TEST(CallersEnvironment, ThatItFlushesSubnormalNumbersChangesNoBit) {
  const std::uint64_t usual = hash_of_run();
  const Environment kept;
  _mm_setcsr(_mm_getcsr() | 0x8040U);  // flush to zero, subnormals are zero
  EXPECT_EQ(hash_of_run(), usual);
}

TEST(CallersEnvironment, ItsTrapsAreNotSprung) {
  const Environment kept;
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  hash_of_run();
  EXPECT_EQ(fegetexcept(), FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
}

// Of a language that writes 1.000.000,5.
class Commas : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class CallersLocale {
 public:
  CallersLocale() : before_(std::locale::global(std::locale(std::locale(), new Commas))) {}
  ~CallersLocale() { std::locale::global(before_); }
  CallersLocale(const CallersLocale&) = delete;
  CallersLocale& operator=(const CallersLocale&) = delete;

 private:
  std::locale before_;
};

std::map<std::string, std::string> files_of_run(const Scene& scene, const fs::path& directory) {
  run_with_files({.scene_file = "heap.toml", .scene = scene, .directory = directory});
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    const std::string name = fs::relative(entry.path(), directory);
    if (!entry.is_regular_file() || name == ".furrow.json") continue;  // times and processes
    std::ifstream stream(entry.path());
    files[name] = {std::istreambuf_iterator<char>(stream), {}};
  }
  files["run.json"] = files["run.json"].substr(0, files["run.json"].find("cpu_seconds"));
  return files;
}

TEST(CallersEnvironment, ItsLocaleChangesNoCharacterOfAFile) {
  const fs::path place = fs::temp_directory_path() / ("furrow_locale_" + std::to_string(getpid()));
  Scene scene = heap();
  scene.time.end = 0.11;
  scene.output.frames.clear();
  for (int k = 0; k <= 1001; ++k) scene.output.frames.push_back(1e-4 * k);  // discs_1000.vtp
  const auto usual = files_of_run(scene, place);
  const CallersLocale locale;
  EXPECT_EQ(files_of_run(scene, place), usual);
  EXPECT_TRUE(usual.contains("frames/discs_1000.vtp"));
  fs::remove_all(place);
}

TEST(CallersEnvironment, ItsLocaleChangesNoCharacterOfAMessage) {
  const auto message = [] {
    Scene scene = heap();
    scene.disc[0].velocity = {-1234567, -1234567};
    Prepared prepared = prepare(scene);
    const auto method = make_method("pece");
    return run(prepared.system, *method, prepared.y, {.end = 0.1},
               [](double, const State&, const JumpReport&) { return true; })
        .reason;
  };
  const std::string usual = message();
  ASSERT_NE(usual.find("one step of 0.0001 s"), std::string::npos) << usual;
  const CallersLocale locale;
  EXPECT_EQ(message(), usual);
}

// As C prints it in its own locale; the program of another caller may have set another one.
TEST(Rounded, IsWhatPrintfSays) {
  for (const double number : {0.0, 1.0, -2.5, 0.1, 1e-5, 1.23456e-7, 123456.0, 99999.5, 1e100, 0.099999, -1e-300}) {
    for (const int digits : {0, 2, 3, 6}) {
      char text[64];
      std::snprintf(text, sizeof text, "%.*g", digits, number);
      EXPECT_EQ(rounded(number, digits), text);
      char decimals[400];
      std::snprintf(decimals, sizeof decimals, "%.*f", digits, number);
      EXPECT_EQ(fixed(number, digits), decimals);
      std::snprintf(decimals, sizeof decimals, "%.*e", digits, number);
      EXPECT_EQ(scientific(number, digits), decimals);
    }
  }
}

}  // namespace
}  // namespace furrow
