// How old the kept numbers are, a line a study, and a line each for faults.json and judgements.json beside their directory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/study.h"

namespace furrow {

// "560     12   2026-01-30   2026-01-31  src/run/run.cpp": how many there are, how many of them are old, when the oldest
// and the newest were made, and what changed since: sources, then inputs.
std::string status_line(const Age& age);

// Prints them; runs nothing. `beside` the studies: the two files too, where they are there. Returns an exit code.
int print_status(const std::vector<const Study*>& studies, const std::filesystem::path& directory, bool beside);

}  // namespace furrow
