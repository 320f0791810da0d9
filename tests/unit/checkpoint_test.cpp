// The file that a run goes on from: it gives back what it was given, and refuses all else in one line.
#include "output/checkpoint.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace furrow {
namespace {

namespace fs = std::filesystem;

struct Things {
  double number = 0.1;
  bool yes = true;
  int whole = -7;
  std::uint64_t hash = 0xfedcba9876543210;
  std::string word = "two\nlines";
  State y{1.0 / 3, -0.0, 5e-324};
  std::vector<int> slots{3, -1, 2};
  void history(HistoryVisitor& visit) {
    visit("number", number);
    visit("yes", yes);
    visit("whole", whole);
    visit("hash", hash);
    visit("word", word);
    visit("y", y);
    visit("slots", slots);
  }
  CheckpointPart part(const std::string& name = "things") {
    return {name, [this](HistoryVisitor& visit) { history(visit); }};
  }
};

class CheckpointFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(directory);
    fs::remove(file);
    write_checkpoint(file, {things.part(), {"more", [](HistoryVisitor& visit) {
                                              double nan = std::numeric_limits<double>::quiet_NaN();
                                              visit("nan", nan);
                                            }}});
  }
  static std::string bytes() {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void put(const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }
  // What is said of a file that is refused; empty: it is read.
  static std::string refusal() {
    try {
      const Checkpoint read(file);
      return {};
    } catch (const FileError& error) {
      return error.what();
    }
  }

  static inline const fs::path directory =
      fs::path(testing::TempDir()) / ("furrow_checkpoint_" + std::to_string(getpid()));
  static inline const fs::path file = directory / "checkpoint";
  Things things;
};

TEST_F(CheckpointFile, GivesBackWhatItWasGiven) {
  Things back{0, false, 0, 0, "", {}, {}};
  double nan = 0;
  const Checkpoint read(file);
  read.read({"more", [&](HistoryVisitor& visit) { visit("nan", nan); }});
  read.read(back.part());
  EXPECT_EQ(back.number, things.number);
  EXPECT_EQ(back.yes, things.yes);
  EXPECT_EQ(back.whole, things.whole);
  EXPECT_EQ(back.hash, things.hash);
  EXPECT_EQ(back.word, things.word);
  EXPECT_EQ(back.y, things.y);
  EXPECT_TRUE(std::signbit(back.y[1]));
  EXPECT_EQ(back.slots, things.slots);
  EXPECT_TRUE(std::isnan(nan));
}

TEST_F(CheckpointFile, IsTheSameBytesOnEveryMachine) {
  const std::string all = bytes();
  EXPECT_EQ(all.substr(0, 12), std::string("\x89"
                                           "FURROW\n\x01\0\0\0",
                                           12));
  HistoryWriter writer;
  int minus_two = -2;
  writer("n", minus_two);
  EXPECT_EQ(writer.bytes(), std::string("i\x01\0\0\0n\xfe\xff\xff\xff\xff\xff\xff\xff", 14));
}

TEST_F(CheckpointFile, ADamagedByteIsRefusedWhereverItIs) {
  const std::string good = bytes();
  ASSERT_EQ(refusal(), "");
  for (std::size_t k = 0; k < good.size(); ++k) {
    std::string bad = good;
    bad[k] = static_cast<char>(bad[k] ^ 0x10);
    put(bad);
    EXPECT_NE(refusal(), "") << k;
  }
}

TEST_F(CheckpointFile, AFileCutShortIsRefusedWhereverItEnds) {
  const std::string good = bytes();
  for (std::size_t k = 0; k < good.size(); ++k) {
    put(good.substr(0, k));
    EXPECT_NE(refusal(), "") << k;
  }
  put(good.substr(0, good.size() - 1));
  EXPECT_NE(refusal().find("is cut short"), std::string::npos) << refusal();
  put(good + "x");
  EXPECT_NE(refusal().find("is damaged"), std::string::npos) << refusal();
}

TEST_F(CheckpointFile, AnotherFormatIsNamed) {
  std::string bad = bytes();
  bad[8] = 77;
  put(bad);
  EXPECT_NE(refusal().find("of format 77, this program reads format 1"), std::string::npos) << refusal();
  put("no such thing, but long enough to be one of them");
  EXPECT_NE(refusal().find("is not a checkpoint"), std::string::npos) << refusal();
  fs::remove(file);
  EXPECT_NE(refusal().find("cannot read"), std::string::npos) << refusal();
}

TEST_F(CheckpointFile, OtherNamesThanThoseLookedForAreRefused) {
  const Checkpoint read(file);
  const auto refused = [&](const CheckpointPart& part) {
    try {
      read.read(part);
      return std::string();
    } catch (const FileError& error) {
      return std::string(error.what());
    }
  };
  double d = 0;
  int i = 0;
  EXPECT_NE(refused({"none", [](HistoryVisitor&) {}}).find("'none'"), std::string::npos);
  EXPECT_NE(refused({"more", [](HistoryVisitor&) {}}).find("more than this program knows"), std::string::npos);
  EXPECT_NE(refused({"more", [&](HistoryVisitor& v) { v("man", d); }}).find("holds 'nan' where 'man'"),
            std::string::npos);
  EXPECT_NE(refused({"more", [&](HistoryVisitor& v) { v("nan", i); }}).find("'nan'"), std::string::npos);
  EXPECT_NE(refused({"more", [&](HistoryVisitor& v) { v("nan", d), v("nan", d); }}).find("too soon"),
            std::string::npos);
}

// The one before stays whole until the new one is.
TEST_F(CheckpointFile, IsReplacedAsAWhole) {
  const std::string before = bytes();
  EXPECT_THROW(write_checkpoint(file, {{"half", [](HistoryVisitor&) { throw FileError("on purpose"); }}}), FileError);
  EXPECT_EQ(bytes(), before);
  EXPECT_FALSE(fs::exists(file.string() + ".partial"));
}

}  // namespace
}  // namespace furrow
