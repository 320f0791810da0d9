// Writes the values that the oracles expect into case files: for a new case, and after an oracle was mended.
//
// usage: expected_values FILE...
#include "verification/engines/oracles.h"
#include "verification/engines/rewritten_files.h"

int main(int argc, char** argv) {
  using namespace furrow::verification;
  return rewrite_files("expected_values", argc, argv, [](const std::string& text, const std::filesystem::path& file) {
    const Json whole = case_from(text, file.stem());
    return whole.contains("view") ? text : with_values(text, expected_of(whole));
  });
}
