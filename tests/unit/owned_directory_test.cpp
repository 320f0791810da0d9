#include "output/owned_directory.h"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "owned_directories.h"

namespace furrow {
namespace {

using namespace test;

TEST_F(OwnedDirectories, MarkerSaysWhoOwnsWhatFromTheFirstMoment) {
  OwnedDirectory directory(place_, "run", all);
  const auto marker = nlohmann::json::parse(text_of(place_ / ".furrow.json"));
  EXPECT_EQ(marker["kind"], "run");
  EXPECT_EQ(marker["pid"], getpid());
  EXPECT_EQ(marker["standing"], "running");
  EXPECT_TRUE(marker["files"].empty()) << "none is made yet";
  for (const char* key : {"version", "commit", "host", "process_start", "began"})
    EXPECT_TRUE(marker.contains(key)) << key;
  directory.conclude("finished");
  const auto ended = nlohmann::json::parse(text_of(place_ / ".furrow.json"));
  EXPECT_EQ(ended["standing"], "finished");
  EXPECT_TRUE(ended["files"].empty()) << "it made none";
}

TEST_F(OwnedDirectories, AnOwnersFilesAreReplacedAndNoOthers) {
  make();
  put(place_ / "notes.txt");
  put(place_ / "frames/mine.csv");
  OwnedDirectory again(place_, "run", {"b.csv"});
  EXPECT_EQ(contents().size(), 6U);  // run, its marker and journal, notes, frames and what is in it
  EXPECT_EQ(text_of(place_ / "notes.txt"), "mine");
  EXPECT_EQ(text_of(place_ / "frames/mine.csv"), "mine");
}

TEST_F(OwnedDirectories, AFileThatAnotherPutInThePlaceOfOnesOwnIsNotReplaced) {
  make();
  put(place_ / "a.csv", "my own words");
  EXPECT_TRUE(has(refusal(), "a.csv is in the way: it is not the file that furrow wrote"));
}

// They hear of the files of all threads, so also while they begin and end.
TEST_F(OwnedDirectories, MayEndWhileOtherThreadsMakeFiles) {
  std::atomic<bool> done = false;
  fs::create_directory(home_ / "other");
  std::jthread other([&] {
    for (int k = 0; !done; ++k) replace_file(home_ / "other" / std::to_string(k % 10), "words");
  });
  for (int k = 0; k < 300; ++k) OwnedDirectory(place_, "run", all).conclude("finished");
  done = true;
}

TEST_F(OwnedDirectories, ADirectoryGoesWithItsLastFile) {
  make();
  OwnedDirectory again(place_, "run", {"b.csv"});
  EXPECT_FALSE(fs::exists(place_ / "frames"));
}

TEST_F(OwnedDirectories, AnEmptyDirectoryAndALinkToOneMayBeTaken) {
  fs::create_directory(home_ / "there");
  fs::create_symlink(home_ / "there", place_);
  make();
  EXPECT_TRUE(fs::exists(home_ / "there/run.json"));
  make();
  EXPECT_TRUE(fs::is_symlink(place_));
}

TEST_F(OwnedDirectories, WhatHasNoMarkerIsNotOurs) {
  put(place_ / "letter.txt");
  EXPECT_TRUE(has(refusal(), "choose another --out"));
  put(place_ / "run.json", "{}");
  EXPECT_TRUE(has(refusal(), "written by an earlier version, or by hand"));
}

TEST_F(OwnedDirectories, AMarkerThatIsNoneRefuses) {
  make();
  const std::string good = text_of(place_ / ".furrow.json");
  const auto with = [&](const char* key, const nlohmann::json& value) {
    auto json = nlohmann::json::parse(good);
    json[key] = value;
    return json.dump();
  };
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), good.substr(0, good.size() / 2), with("program", "other"),
        with("files", "all"), with("files", {"../letter.txt"}), with("files", {"/etc/passwd"}), with("files", {""}),
        with("files", {"a/../../b"}), with("files", {".furrow.json"}), with("pid", "x"), with("kind", 7)}) {
    put(place_ / ".furrow.json", text);
    EXPECT_TRUE(has(refusal(), ".furrow.json is not a marker that furrow can read")) << text;
  }
  fs::remove(place_ / ".furrow.json");
  put(home_ / "elsewhere", good);
  fs::create_symlink(home_ / "elsewhere", place_ / ".furrow.json");
  EXPECT_TRUE(has(refusal(), ".furrow.json is not a marker")) << "a link";
}

TEST_F(OwnedDirectories, OneOfAnotherKindIsNotReplaced) {
  make("report");
  EXPECT_TRUE(has(refusal("run"), "belongs to a report of furrow's, not to a run"));
}

// Each stands where a file must be written, or where one of the owner's own was.
TEST_F(OwnedDirectories, WhatStandsInTheWayIsNotTouched) {
  put(home_ / "precious");
  put(home_ / "album/one.csv");
  const std::map<std::string, std::function<void()>> in_the_way{
      {"a link for a file",
       [&] { fs::remove(place_ / "a.csv"), fs::create_symlink(home_ / "precious", place_ / "a.csv"); }},
      {"a dangling link", [&] { fs::create_symlink(home_ / "nowhere", place_ / "a.csv.partial"); }},
      {"a directory for a file", [&] { fs::remove(place_ / "a.csv"), put(place_ / "a.csv/one"); }},
      {"a link for a directory",
       [&] { fs::remove_all(place_ / "frames"), fs::create_symlink(home_ / "album", place_ / "frames"); }},
      {"a file for a directory", [&] { fs::remove_all(place_ / "frames"), put(place_ / "frames"); }}};
  for (const auto& [what, put_there] : in_the_way) {
    fs::remove_all(place_);
    make();
    put_there();
    EXPECT_TRUE(has(refusal(), "is in the way")) << what;
  }
}

TEST_F(OwnedDirectories, AForeignFileWhereANewOneMustBeIsNotTouched) {
  { OwnedDirectory(place_, "run", {"b.csv"}); }
  put(place_ / "frames/one.csv.partial");
  EXPECT_TRUE(has(refusal(), "frames/one.csv.partial is in the way: it is not a file of furrow's"));
}

TEST_F(OwnedDirectories, MoreFilesMayBeAddedButNotOverOthers) {
  OwnedDirectory directory(place_, "run", all);
  put(place_ / "x.svg");
  EXPECT_THROW(directory.add({"x.svg"}), FileError);
  EXPECT_THROW(directory.add({"../x.svg"}), FileError);
  directory.add({"y.svg"});
  OutputFile(place_ / "y.svg").finish();
  directory.conclude("finished");
  EXPECT_TRUE(has(text_of(place_ / ".furrow.json"), "y.svg"));
  EXPECT_FALSE(has(text_of(place_ / ".furrow.json"), "x.svg"));
}

TEST_F(OwnedDirectories, WhatIsGoneOnWithKeepsItsFiles) {
  make();
  OwnedDirectory again(place_, "run", all, OwnedDirectory::Earlier::kept);
  EXPECT_TRUE(fs::exists(place_ / "frames/one.csv"));
  again.discard("frames/one.csv");
  EXPECT_FALSE(fs::exists(place_ / "frames/one.csv"));
}

TEST_F(OwnedDirectories, OneThatALivingProcessHoldsIsRefused) {
  std::array<int, 2> ready{}, done{};
  ASSERT_EQ(pipe(ready.data()), 0);
  ASSERT_EQ(pipe(done.data()), 0);
  char c = 'x';
  const pid_t child = fork();
  if (child == 0) {
    OwnedDirectory directory(place_, "run", all);
    (void)!write(ready[1], &c, 1);
    (void)!read(done[0], &c, 1);
    _exit(0);  // as if killed: the marker says "running"
  }
  ASSERT_EQ(read(ready[0], &c, 1), 1);
  EXPECT_TRUE(has(refusal(), "is in use by process " + std::to_string(child)));
  ASSERT_EQ(write(done[1], &c, 1), 1);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(has(text_of(place_ / ".furrow.json"), "running"));
  EXPECT_NO_THROW(OwnedDirectory(place_, "run", all)) << "nobody holds it any more";
}

TEST_F(OwnedDirectories, OneThatWasKilledWithItsMarkerHalfWrittenIsTaken) {
  put(place_ / ".furrow.json.partial-abcdef", "{\n  \"program\": \"fur");
  make();
  EXPECT_FALSE(fs::exists(place_ / ".furrow.json.partial-abcdef"));
  fs::remove_all(place_);
  put(place_ / ".furrow.json.partial-abcdef", "my own words");
  EXPECT_TRUE(has(refusal(), "is not empty"));
}

TEST_F(OwnedDirectories, OneWithoutAResultSaysSo) {
  { OwnedDirectory(place_, "run", all); }
  EXPECT_TRUE(has(text_of(place_ / ".furrow.json"), "\"failed\""));
}

TEST_F(OwnedDirectories, OwnedDirectoriesInOneAreNoneOfItsBusiness) {
  place_ = home_ / "page/scenario_1";
  make();
  place_ = home_ / "page";
  make("report");
  EXPECT_TRUE(fs::exists(home_ / "page/scenario_1/run.json"));
}

TEST_F(OwnedDirectories, NoPlaceIsAnErrorOfFiles) {
  put(home_ / "file");
  place_ = home_ / "file/below";
  EXPECT_TRUE(has(refusal(), "cannot make"));
  place_ = home_ / "file";
  EXPECT_TRUE(has(refusal(), "is not a directory"));
  fs::create_symlink(home_ / "nowhere", home_ / "link");
  place_ = home_ / "link";
  EXPECT_TRUE(has(refusal(), "cannot make"));
}

}  // namespace
}  // namespace furrow
