// The program from outside, in a directory of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace furrow::test {

class Outside : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "furrow_outside_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    directory_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  static std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(directory_ / name) << text; }

  // The exit code; out() and err() have what was said.
  int furrow(const std::string& arguments) const {
    const std::string command =
        "cd '" + directory_.string() + "' && '" FURROW_PROGRAM "' " + arguments + " >out.txt 2>err.txt </dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string out() const { return text_of(directory_ / "out.txt"); }
  std::string err() const { return text_of(directory_ / "err.txt"); }

  static std::string scene(const std::string& name) {
    return "'" FURROW_SOURCE_DIR "/validation/scenes/" + name + ".toml'";
  }

  std::filesystem::path directory_;
};

}  // namespace furrow::test
