// What other codes, papers and experiments have printed, beside furrow's own numbers: the files of verification/published.
#pragma once

#include <string>
#include <vector>

namespace furrow::verification {

struct NumberOfOthers {
  std::string name, unit;         // what it is; SI
  std::string printed;            // as it stands there, every digit
  std::string said;               // how that is to be read where it is not the number in SI: its unit, sign, scale
  double number = 0;              // offset + factor times the printed one, in `unit`
  double got = 0;                 // furrow's, in `unit`; the tests compute it and compare
  double tolerance = 0;           // of `scale`: |got - number| is at most tolerance times scale
  double scale = 0;               // in `unit`; the size of the number unless it is given
  std::string reason, known_off;  // why just so far; what the printed number is known to be off by, if it is
  double off() const;             // |got - number|/scale
};

struct ProblemOfOthers {
  std::string suite, source, name, of, title;  // `of`: the model, test or case of the suite that it belongs to
  std::string cannot;                          // why furrow cannot say it; then without numbers
  std::string page;                            // the page of verification that computes `got`, if not a case
  std::vector<NumberOfOthers> numbers;
};

// All, by file and in its order. Throws std::invalid_argument with file and line of what is wrong.
const std::vector<ProblemOfOthers>& problems_of_others();

// Throws std::invalid_argument if there is none of these names.
const NumberOfOthers& number_of_others(const std::string& problem, const std::string& name);

}  // namespace furrow::verification
