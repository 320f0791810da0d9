// What a kept verdict of the fault study depends on.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/unit/run_directory.h"
#include "verification/fault_study/workshop.h"

namespace furrow::test {
namespace {
namespace fs = std::filesystem;
using verification::code_of;

void append(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::app) << text;
}

// Each room is a directory of the sources: none is left out.
TEST(FaultVerdict, DependsOnTheSourcesOfEveryRoom) {
  const RunDirectory tree;
  fs::create_directories(tree.path() / "src");
  for (const auto& room : fs::directory_iterator(fs::path(FURROW_SOURCE_DIR) / "src")) {
    const std::string before = code_of(tree.path());
    append(tree.path() / "src" / room.path().filename() / "file.cpp", "int one = 1;\n");
    EXPECT_NE(code_of(tree.path()), before) << room.path().filename();
  }
  const std::string before = code_of(tree.path());
  append(tree.path() / "src/kernel/file.cpp", "  // one\n");
  EXPECT_EQ(code_of(tree.path()), before) << "a comment";
}

}  // namespace
}  // namespace furrow::test
