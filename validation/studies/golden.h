// Golden outputs: what earlier runs of the paper's scenes gave, to the bit. A golden says same; it does not say right.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace furrow::validation {

struct GoldenOptions {
  std::filesystem::path directory = "reference_data/golden";
  bool quick = false;   // scene 1 whole, the beds of discs up to their first checkpoint
  bool remake = false;  // write the goldens again
  std::string reason;   // why; must be given to remake
  unsigned jobs = 1;
  std::function<bool(double, double)> progress{};  // (runs done, of all); false stops
  std::function<void(const std::string&)> say{};   // a line for each run
};

// Runs the scenes and compares them with the goldens, or makes the goldens again. Returns how many runs differ. Of each
// it says what was compared, or what differs first and when. A golden that is missing, malformed, of another scene or
// other settings counts as different. Throws std::invalid_argument for a remake without a reason, Interrupted,
// FileError if there is no directory of goldens.
int check_goldens(const GoldenOptions& options);

}  // namespace furrow::validation
