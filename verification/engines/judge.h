// What is to be said of an engine: its answers at several resolutions against the expected values of a case.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "verification/engines/case.h"

namespace furrow::verification {

// From good to bad.
enum class CaseVerdict { right, cannot, lower_order, another_law, failed };
std::string to_string(CaseVerdict verdict);  // "right", "cannot", "lower order", "another law", "failed"

struct Finding {  // of one observable
  std::string name, unit;
  CaseVerdict verdict = CaseVerdict::failed;
  std::vector<double> values;  // at each resolution
  double expected = 0;         // of kind interval: its middle
  double error = 0;            // of the last value, over the scale; of kind step: in steps
  double order = 0;            // observed; NaN if nothing falls
  double limit = 0;            // what it converges to if that is something else
  double left = NAN;       // how far `limit` may still be from where the values go; NaN unless they settle elsewhere
  bool undecided = false;  // failed, but finer resolutions may say more
  std::string words;       // why
};

struct Judgement {
  std::string name, title, engine, method;
  std::string command;  // that was asked; empty if it is no program
  std::string input;    // hash of the case
  double claimed = 0;   // order
  CaseVerdict verdict = CaseVerdict::failed;
  std::string words;
  std::vector<int> steps;  // those of the case; up to twice twice as many if it stayed undecided
  std::vector<Finding> findings;
};

// A request to an answer; throws std::runtime_error with what went wrong.
using Engine = std::function<Json(const Json& request)>;

// A program, called with the request on its standard input; `command` is for the shell. Stopped after `limit` s.
Engine program_engine(const std::string& command, double limit);

Judgement judge_case(const Json& whole, const Engine& engine);

// One observable alone. `steps` and `values` go together; `h` are the steps in s.
Finding judge_observable(const Json& seen, const std::vector<int>& steps, const std::vector<double>& h,
                         const std::vector<double>& values, double claimed);

}  // namespace furrow::verification
