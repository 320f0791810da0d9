// Around the best setting: what each key moves, how well each is known, and what cannot be told apart.
//
// With residuals r_i, in tolerances and of weight w_i, and J = dr/dx, x the keys as shares of their ranges:
//   covariance  C = s^2 (J'WJ)^-1 (J'W^2 J) (J'WJ)^-1    s^2 = max(1, n/(n - p) sum w r^2 / sum w)
//   interval    x +- t sqrt(C_jj)                        t: 97.5 % quantile of Student's, n - p degrees of freedom
// n residuals, p keys: the linear theory of weighted least squares (Seber and Wild 1989, Nonlinear Regression, 2 and 5),
// the errors independent and at least as large as the tolerances say. A direction along which the 95 % interval is longer
// than the ranges themselves is flat: the targets do not say where on it the truth lies.
//
// All of this is about a minimum. Where the Gauss-Newton step that is left, x_j - ((J'WJ)^-1 J'W r)_j within the ranges, is
// in any key longer than the half interval, the search has not arrived at one, and no interval is given. Nor is one where
// a target bends or jumps over what the interval covers.
#pragma once

#include <optional>

#include "validation/calibration/evaluate.h"

namespace furrow::validation {

struct Known {
  std::string key, value;
  std::string low, high;  // 95 % interval; empty: none shorter than the range, or not arrived
  bool at_edge = false;   // the best value is at an end of its range
  bool arrived = true;    // the step that is left is within the intervals of all keys
};

constexpr const char* not_a_minimum = "not a minimum yet: try more --points";
constexpr const char* at_the_edge = "at the edge of its range";

// "1 to 2", or why there is none; and all in one line: "KEY = VALUE, 95 % interval 1 to 2; it is at the edge of its range".
std::string interval_of(const Known& known);
std::string words_of(const Known& known);

struct Flat {
  std::vector<double> direction;  // by ranged key, in shares of the ranges, of length 1
  // The misfit at the best, and as far along it as the ranges allow, both ways.
  double misfit = 0, backward = 0, forward = 0;
  double from = 0, to = 0;  // shares
};

// What a target says more when a key goes up by a tenth of its range, or takes another listed value.
struct Effect {
  std::string key, change;            // "+ 0.08", "tension to magnitude"
  std::vector<double> effect, error;  // by target: mean over packings; standard error, NaN for one packing
  double misfit = 0;                  // change of the misfit; of a range: of the larger side
};

struct Identified {
  std::vector<Known> known;  // by ranged key
  std::vector<Flat> flat;
  std::vector<Effect> effects;
  std::vector<std::string> ranged;
  std::string why_not;  // why there are no intervals; empty if there are
};

// The point to which the same linear theory leads from this one, if its misfit is less: a Gauss-Newton step, or half,
// a quarter, ... a sixteenth of it, for what a search without slopes leaves on a smooth misfit.
std::optional<Point> stepped(const Evaluator& evaluator, const Point& best, const Packings& packings);

int runs_to_step(const Evaluator& evaluator, int packings);  // at most

// Takes further runs about the point, which must have been made with the same packings.
Identified identify(const Evaluator& evaluator, const Point& best, const Packings& packings);
int runs_to_identify(const Evaluator& evaluator, int packings);  // at most

}  // namespace furrow::validation
