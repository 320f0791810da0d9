// The main of a tool that writes what it computes into the files that it is given.
#pragma once

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "output/files.h"

namespace furrow::verification {

// `rewritten` makes the new text of a file from (its text, its path). Exit code 0, or 2 and one line.
template <class Rewritten>
int rewrite_files(const std::string& program, int argc, char** argv, const Rewritten& rewritten) {
  try {
    for (int k = 1; k < argc; ++k) {
      const std::filesystem::path file = argv[k];
      std::ostringstream text;
      text << std::ifstream(file).rdbuf();
      replace_file(file, rewritten(text.str(), file));
    }
    return 0;
  } catch (const std::exception& fault) {
    std::cerr << program << ": error: " << fault.what() << "\n";
    return 2;
  }
}

}  // namespace furrow::verification
