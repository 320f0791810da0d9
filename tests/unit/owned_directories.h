// Directories of an owner, in a home of their own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "output/owned_directory.h"
#include "tests/files.h"

namespace furrow::test {

namespace fs = std::filesystem;

inline const std::vector<std::string> all{"a.csv", "run.json", "frames/one.csv"};

class OwnedDirectories : public testing::Test {
 protected:
  static void put(const fs::path& file, const std::string& text = "mine") {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }

  // One that made all its files.
  void make(const std::string& kind = "run") const {
    OwnedDirectory directory(place_, kind, all);
    for (const std::string& file : all) OutputFile(place_ / file).finish();
    directory.conclude("finished");
  }

  // As if killed, after it had finished one of its files, written to another and planned a third.
  void make_killed() const {
    const pid_t child = fork();
    if (child == 0) {
      OwnedDirectory directory(place_, "run", all);
      OutputFile whole(place_ / "run.json");
      whole << "whole";
      whole.finish();
      OutputFile file(place_ / "a.csv");
      file << "rows";
      file.flush();
      OutputFile empty(place_ / "frames/two.csv");
      _exit(0);
    }
    waitpid(child, nullptr, 0);
  }

  // What is there, links not followed: name and what it holds.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(home_)) {
      const bool is_link = entry.is_symlink();
      found[fs::relative(entry.path(), home_)] = is_link ? "-> " + fs::read_symlink(entry.path()).string()
                                                 : entry.is_regular_file() ? text_of(entry.path())
                                                                           : "directory";
    }
    return found;
  }

  // The words with which the directory is refused; nothing may have changed.
  std::string refusal(const std::string& kind = "run") const {
    const auto before = contents();
    std::string words = "not refused";
    try {
      OwnedDirectory(place_, kind, all);
    } catch (const FileError& error) {
      words = error.what();
    }
    EXPECT_EQ(contents(), before);
    return words;
  }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

  const test::OwnDirectory own_;
  const fs::path home_ = own_.path();
  fs::path place_ = home_ / "run";
};

}  // namespace furrow::test
