// What becomes of a directory whose owner was killed, or whose journal is none.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include "owned_directories.h"

namespace furrow {
namespace {

using namespace test;

TEST_F(OwnedDirectories, OfAKilledOneWhatItMadeIsReplacedAndWhatItOnlyMeantToMakeIsNot) {
  make_killed();
  ASSERT_EQ(text_of(place_ / "a.csv.partial"), "rows");
  put(place_ / "frames/one.csv");
  EXPECT_TRUE(has(refusal(), "frames/one.csv is in the way: it is not a file of furrow's"));
  fs::remove(place_ / "frames/one.csv");
  make();
  EXPECT_FALSE(fs::exists(place_ / "a.csv.partial"));
}

TEST_F(OwnedDirectories, OneThatWasKilledMayBeCopiedOrMovedToAnotherDisk) {
  make_killed();
  fs::copy(place_, home_ / "copy", fs::copy_options::recursive);
  place_ = home_ / "copy";
  make();
  EXPECT_FALSE(fs::exists(place_ / "a.csv.partial"));
  EXPECT_FALSE(fs::exists(place_ / "frames/two.csv.partial"));
}

// In place: the same file as the killed one's, with other words in it.
TEST_F(OwnedDirectories, WordsOverAFileOfAKilledOneAreNotReplaced) {
  for (const char* name : {"run.json", "a.csv.partial", "frames/two.csv.partial"}) {
    fs::remove_all(place_);
    make_killed();
    std::ofstream(place_ / name, std::ios::in | std::ios::out | std::ios::trunc) << "my own words";
    EXPECT_TRUE(has(refusal(), std::string(name) + " is in the way: it is not the file that furrow wrote")) << name;
  }
  fs::remove_all(place_);
  make_killed();
  std::ofstream(place_ / "run.json", std::ios::app) << " and a remark";
  EXPECT_TRUE(has(refusal(), "run.json is in the way")) << "a finished one to which something was added";
}

TEST_F(OwnedDirectories, WhatHasTheNameOfTheJournalAndIsNoneIsNotTouched) {
  const fs::path journal = place_ / ".furrow.made";
  const std::map<std::string, std::function<void()>> in_the_way{
      {"words", [&] { put(journal, "my own words"); }},
      {"a directory", [&] { fs::create_directory(journal); }},
      {"a fifo", [&] { ASSERT_EQ(mkfifo(journal.c_str(), 0600), 0); }},
      {"a link", [&] { put(home_ / "precious"), fs::create_symlink(home_ / "precious", journal); }}};
  for (const auto& [what, put_there] : in_the_way) {
    for (const bool killed : {false, true}) {
      fs::remove_all(place_);
      killed ? make_killed() : make();
      fs::remove(journal);
      put_there();
      EXPECT_TRUE(has(refusal(), ".furrow.made is in the way")) << what << (killed ? " in one that was killed" : "");
    }
  }
}

// As a report owns the directory in which its runs have theirs.
TEST_F(OwnedDirectories, TheMarkerOfAnOwnerBelowIsNotRemovedWithAKilledOne) {
  const pid_t child = fork();
  if (child == 0) {
    OwnedDirectory above(place_, "report", {"index.html"});
    OwnedDirectory below(place_ / "scenario_1", "run", all);
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::exists(place_ / "scenario_1/.furrow.json"));
  { OwnedDirectory(place_, "report", {"index.html"}); }
  EXPECT_TRUE(fs::exists(place_ / "scenario_1/.furrow.json"));
  EXPECT_NO_THROW(OwnedDirectory(place_ / "scenario_1", "run", all));
}

TEST_F(OwnedDirectories, OneThatWasKilledBeforeItHadAMarkerIsTaken) {
  for (const char* text : {"", "furrow, files made"}) {
    fs::remove_all(place_);
    put(place_ / ".furrow.made", text);
    make();
    EXPECT_FALSE(fs::exists(place_ / ".furrow.made"));
  }
}

}  // namespace
}  // namespace furrow
