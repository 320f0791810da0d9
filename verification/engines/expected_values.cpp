// Writes the values that the oracles expect into case files: for a new case, and after an oracle was mended.
//
// usage: expected_values FILE...
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "output/files.h"
#include "verification/engines/oracles.h"

int main(int argc, char** argv) {
  using namespace furrow::verification;
  try {
    for (int k = 1; k < argc; ++k) {
      const std::filesystem::path file = argv[k];
      std::ostringstream text;
      text << std::ifstream(file).rdbuf();
      const Json whole = case_from(text.str(), file.stem());
      if (!whole.contains("view")) furrow::replace_file(file, with_values(text.str(), expected_of(whole)));
    }
    return 0;
  } catch (const std::exception& fault) {
    std::cerr << "expected_values: error: " << fault.what() << "\n";
    return 2;
  }
}
