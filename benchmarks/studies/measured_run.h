// One run of a case with one method: what came out, and what it cost.
#pragma once

#include "report/cases.h"

namespace furrow::benchmarks {

struct Effort {
  std::string method;
  double step = 0;       // s; of a controlled method the largest one
  double tolerance = 0;  // relative, of a controlled method; the absolute one is this times 0.01 m, m/s, rad/s
  Locate locate = Locate::none;
  long most_evaluations = 20000000;  // then the run is given up
  double most_cpu = infinity;        // s
};

struct Outcome {
  std::string failure;              // empty: the run came to its end
  bool given_up = false;            // it cost too much
  double reached = 0;               // s
  long steps = 0, evaluations = 0;  // -, of the right-hand side
  double cpu = 0;                   // s, of this thread, for steps, jumps and samples
  int torn = 0;                     // links
  std::vector<double> place{},
      force{};                  // m, x and y of all bodies at the end; N, Fx and Fy on all plates, sample by sample
  std::vector<double> reach{};  // m, by body: greatest distance from its start, at the samples
};

Outcome run_case(const Case& scene, const Effort& effort);

// Relative to what happens at all: positions to the root mean square over the bodies of how far each one gets from its
// start, forces to the root mean square of the force.
struct Error {
  double place = 0, force = 0;  // -
};
Error error_of(const Outcome& outcome, const Outcome& reference);

// 0 of no values.
double root_mean_square(const std::vector<double>& values);

}  // namespace furrow::benchmarks
