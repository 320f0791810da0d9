// Follows the project's speed by its fixed kernels; called by scripts/track and ctest.
//
// usage: track gate ACCEPTED KERNELS BEDS             instruction counts against the accepted ones
//        track accept ACCEPTED KERNELS BEDS REASON    makes today's counts the accepted ones
//        track compare KERNELS BASE BEDS ROUNDS       times and counts against those of another build; one line of JSON
//                                                     to standard output, a table to standard error
//        track profile RESULT KERNELS BEDS            the paper's scenes by part of the solver
// ACCEPTED: benchmarks/accepted_instructions.json; KERNELS, BASE: two builds of track_kernels; BEDS: a directory for
// what they start from. Exit codes: 0 good; 1 an answer is wrong, or a count is too high; 2 usage; 4 input or output;
// 77 the accepted counts belong to another compiler or machine, so that only the answers were checked.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "benchmarks/tracking/comparison.h"
#include "benchmarks/tracking/gate.h"
#include "benchmarks/tracking/profile.h"

int main(int argc, char** argv) {
  namespace benchmarks = furrow::benchmarks;
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::size_t count = words.size();
  try {
    if (count == 4 && words[0] == "gate") return benchmarks::gate(words[1], {words[2], words[3]});
    if (count == 5 && words[0] == "accept") return benchmarks::accept(words[1], {words[2], words[3]}, words[4]);
    if (count == 4 && words[0] == "profile") return benchmarks::profile({words[2], words[3]}, words[1]);
    if (count == 5 && words[0] == "compare")
      return benchmarks::compare({words[1], words[3]}, {words[2], words[3]}, std::stoi(words[4]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "track: %s\n", error.what());
    return 4;
  }
  std::fprintf(stderr,
               "usage: track gate ACCEPTED KERNELS BEDS | accept ACCEPTED KERNELS BEDS REASON | "
               "compare KERNELS BASE BEDS ROUNDS | profile RESULT KERNELS BEDS\n");
  return 2;
}
