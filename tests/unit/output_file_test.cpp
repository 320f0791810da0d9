#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "output/files.h"
#include "tests/files.h"
#include "validation/page/table.h"

namespace furrow {
using namespace validation;
namespace {

namespace fs = std::filesystem;
using test::text_of;

class OutputFiles : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) const { std::ofstream(directory_ / name) << text; }

  const test::OwnDirectory own_;
  const fs::path directory_ = own_.path();
};

TEST_F(OutputFiles, HasItsNameOnlyWhenItIsComplete) {
  OutputFile file(directory_ / "a.csv", "t [s]");
  file.row(0.5);
  file.flush();
  EXPECT_FALSE(fs::exists(directory_ / "a.csv"));
  EXPECT_EQ(text_of(directory_ / "a.csv.partial"), "t [s]\n0.5\n");
  file.finish();
  EXPECT_EQ(text_of(directory_ / "a.csv"), "t [s]\n0.5\n");
  EXPECT_FALSE(fs::exists(directory_ / "a.csv.partial"));
}

TEST_F(OutputFiles, NothingThatStandsThereIsOverwritten) {
  put("a.csv.partial", "mine");
  EXPECT_THROW(OutputFile(directory_ / "a.csv"), FileError);
  EXPECT_EQ(text_of(directory_ / "a.csv.partial"), "mine");

  put("precious", "mine");
  fs::create_symlink(directory_ / "precious", directory_ / "b.csv.partial");
  EXPECT_THROW(OutputFile(directory_ / "b.csv"), FileError);

  OutputFile file(directory_ / "c.csv", "t [s]");
  put("c.csv", "mine");
  EXPECT_THROW(file.finish(), FileError);
  EXPECT_EQ(text_of(directory_ / "c.csv"), "mine");
  EXPECT_EQ(text_of(directory_ / "precious"), "mine");
}

// Set for the time of a write: a disk that is full, but for this process only.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    std::signal(SIGXFSZ, SIG_IGN);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
};

TEST_F(OutputFiles, AWriteThatFailsIsSaidAtOnce) {
  OutputFile file(directory_ / "a.csv", "t [s]");
  const SmallDisk disk(10);
  file.row(0.5);
  file.flush();
  file.row(0.75);
  try {
    file.flush();
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("a.csv.partial: File too large"), std::string::npos) << error.what();
  }
}

TEST_F(OutputFiles, OfAFullDiskNothingIsLeftInPlaceOfTheOld) {
  put("kept.json", "old");
  const SmallDisk disk(10);
  EXPECT_THROW(replace_file(directory_ / "kept.json", "more than ten bytes"), FileError);
  EXPECT_EQ(text_of(directory_ / "kept.json"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), {}), 1);
}

TEST_F(OutputFiles, OneThatAppearsAtOnceLeavesNothingWhenItFailsAndNothingIsInItsWay) {
  {
    const SmallDisk disk(10);
    OutputFile file = OutputFile::at_once(directory_ / "page.html");
    file << "more than ten bytes";
    EXPECT_THROW(file.finish(), FileError);
  }
  EXPECT_TRUE(fs::is_empty(directory_));
  put("page.html.partial", "mine");
  OutputFile file = OutputFile::at_once(directory_ / "page.html");
  file << "whole";
  file.finish();
  EXPECT_EQ(text_of(directory_ / "page.html"), "whole");
  EXPECT_EQ(text_of(directory_ / "page.html.partial"), "mine");
  EXPECT_THROW(OutputFile::at_once(directory_ / "page.html"), FileError);
}

TEST_F(OutputFiles, GoesOnWhereItWas) {
  FileMark there;
  {
    OutputFile file(directory_ / "a.csv", "t [s]");
    file.row(0.5);
    there = file.mark();
    file.row(1.0);
    file.close();
  }
  {
    OutputFile file = OutputFile::reopened(directory_ / "a.csv", there);
    EXPECT_EQ(file.mark().bytes, there.bytes);
    EXPECT_EQ(file.mark().hash, there.hash);
    file.row(2.0);
    file.finish();
  }
  EXPECT_EQ(text_of(directory_ / "a.csv"), "t [s]\n0.5\n2\n");
  OutputFile::reopened(directory_ / "a.csv", there).finish();  // a finished one too
  EXPECT_EQ(text_of(directory_ / "a.csv"), "t [s]\n0.5\n");
  EXPECT_THROW(OutputFile::reopened(directory_ / "a.csv", {1000, there.hash}), FileError);
}

TEST_F(OutputFiles, IsNotGoneOnWithWhereItsBeginningWasChanged) {
  FileMark there;
  {
    OutputFile file(directory_ / "a.csv", "t [s],F [N]");
    file.row(0.5, 238.0);
    there = file.mark();
    file.finish();
  }
  put("a.csv", "t [s],F [N]\n0.5,239\n");  // as long as before
  EXPECT_THROW(OutputFile::reopened(directory_ / "a.csv", there), FileError);
  EXPECT_EQ(text_of(directory_ / "a.csv.partial"), "t [s],F [N]\n0.5,239\n");
}

TEST_F(OutputFiles, LeaveNothingWhereSomethingElseStandsInTheirPlace) {
  put("a.html", "mine");
  EXPECT_THROW(OutputFile(directory_ / "a.html"), FileError);
  EXPECT_FALSE(fs::exists(directory_ / "a.html.partial"));
}

// A device was replaced by a file once.
TEST_F(OutputFiles, ReplaceRegularFilesAndNothingElse) {
  put("precious", "mine");
  fs::create_symlink("precious", directory_ / "link");
  fs::create_directory(directory_ / "directory");
  ASSERT_EQ(mkfifo((directory_ / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "directory", "pipe"}) {
    const fs::file_type before = fs::symlink_status(directory_ / name).type();
    EXPECT_THROW(replace_file(directory_ / name, "text"), FileError) << name;
    EXPECT_EQ(fs::symlink_status(directory_ / name).type(), before) << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), {}), 4);
}

TEST_F(OutputFiles, WhatReplacesIsWholeOrNotThere) {
  put("kept.json", "old");
  {
    OutputFile file = OutputFile::replacing(directory_ / "kept.json");
    file << "half";
    file.flush();
    EXPECT_EQ(text_of(directory_ / "kept.json"), "old");
  }
  EXPECT_EQ(text_of(directory_ / "kept.json"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), {}), 1) << "the half is gone";
  replace_file(directory_ / "kept.json", "new");
  EXPECT_EQ(text_of(directory_ / "kept.json"), "new");
}

TEST_F(OutputFiles, AnOwnersOwnMayBeRewritten) {
  for (const std::string text : {"one", "two"}) {
    put("own.partial", "of one that was killed");
    OutputFile file = OutputFile::rewriting(directory_ / "own");
    file << text;
    file.finish();
    EXPECT_EQ(text_of(directory_ / "own"), text);
    EXPECT_FALSE(fs::exists(directory_ / "own.partial"));
  }
}

TEST_F(OutputFiles, ManyAreCountedWhileTheyAreWritten) {
  const int before = files_being_written();
  {
    OutputFile one(directory_ / "a"), other = OutputFile::replacing(directory_ / "b");
    EXPECT_EQ(files_being_written(), before + 2);
    one.close();
    EXPECT_EQ(files_being_written(), before + 1);
  }
  EXPECT_EQ(files_being_written(), before);
}

TEST_F(OutputFiles, NamesOfAnyKindComeBackFromATable) {
  const std::vector<std::string> names{"plain", "a,b", "say \"hm\"", "two\nlines", "\r", "", " ", "\"", "7", "\u00fc"};
  OutputFile file(directory_ / "names.csv", "name,number");
  for (const std::string& name : names) file.row(name, 3);
  file.finish();
  const Table table(directory_ / "names.csv");
  EXPECT_EQ(table.texts("name"), names);
  EXPECT_EQ(table.numbers("number"), std::vector<double>(names.size(), 3.0));
}

// Or a killed run could not go on from it.
TEST_F(OutputFiles, WhatAMarkCountsIsInTheFile) {
  OutputFile file(directory_ / "a.csv", "t [s]");
  const FileMark headed = file.mark();
  EXPECT_EQ(headed.bytes, 6u);
  EXPECT_EQ(fs::file_size(directory_ / "a.csv.partial"), 6u);
  file.row(0.5);
  EXPECT_EQ(file.mark().bytes, 10u);
  EXPECT_EQ(text_of(directory_ / "a.csv.partial"), "t [s]\n0.5\n");
}

}  // namespace
}  // namespace furrow
