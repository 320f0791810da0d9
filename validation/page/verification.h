// The page's part about verification: the checks, and the faults that they notice.
#pragma once

#include <filesystem>
#include <string>

namespace furrow {

// Where the results are; a file that is not there makes a sentence that says so, not an error.
struct Evidence {
  std::filesystem::path checks;     // checks.json, written by the verification tests
  std::filesystem::path faults;     // faults.json, written by the fault study
  std::filesystem::path studies{};  // directory of the results of `furrow study`
};

// HTML. Throws std::runtime_error if a file is malformed.
std::string verification_section(const Evidence& evidence);

// 0 if there are no checks to read.
std::size_t failed_checks(const Evidence& evidence);

}  // namespace furrow
