// Programs are run without a shell: what a directory is called is never part of a command.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "report/measured_process.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

TEST(Process, ANameWithAnApostropheIsAName) {
  const fs::path place = fs::temp_directory_path() / ("it's; touch owned; '$(touch owned)" + std::to_string(getpid()));
  fs::create_directories(place / "work");
  std::ofstream(place / "text") << "read";
  const MeasuredEnd ran =
      run_measured({.words = {"cat", place / "text"}, .directory = place / "work", .errors = place / "work/errors"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.output, "read");
  EXPECT_FALSE(fs::exists(place / "work/owned"));
  fs::remove_all(place);
}

TEST(Process, OneThatCannotBeStartedIsAnError) {
  EXPECT_THROW(run_measured({.words = {"no_such_program_of_this_name"}}), std::runtime_error);
}

// The fault study starts everything by this helper.
TEST(Process, TheFaultStudyAsksNoShell) {
  for (const char* name : {"workshop.cpp", "study.cpp"}) {
    std::ifstream stream(fs::path(FURROW_SOURCE_DIR) / "verification/fault_study" / name);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_FALSE(text.empty()) << name;
    for (const char* call : {"std::system", "popen"}) EXPECT_EQ(text.find(call), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace furrow::benchmarks
