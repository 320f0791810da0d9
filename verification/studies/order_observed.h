// The order of a method as it is observed: errors at many step sizes, root of the mean square over where in a step the
// events fall, and the slope of their logarithms.
#pragma once

#include <string>
#include <vector>

#include "methods/method.h"
#include "verification/studies/order_problems.h"

namespace furrow::verification {

// How finely: the first number of steps is the problem's, each next one `ratio` times as many; tolerances of controlled
// methods go from 1e-5 to 1e-10.
struct Series {
  int sizes = 11;
  double ratio = 1.5;
  int phases = 64;  // places of the events within a step
};
inline constexpr Series full{}, quick{9, 1.45, 24};

// One point: one step size, or one tolerance of a controlled method.
struct Point {
  double step = 0;         // s; of a controlled method the mean of the accepted ones
  double tolerance = 0;    // of a controlled method, relative
  double evaluations = 0;  // of a run, mean
  double per_step = 0;     // evaluations a step
  double position = 0;     // error over problem.length, root of the mean square over phases
  double velocity = 0;     // over problem.speed
  int failures = 0;        // runs that diverged; errors are of the others
};

// log error = a + slope log step by least squares. The standard error is that of the scatter about the line. Of an
// error C h^p (1 + D h + ...) a line over steps that can be afforded has not the slope p: `next` is how far the slope
// moves if D h is fitted too.
struct Slope {
  double value = 0, error = 0;
  double next = 0;
  double correlation = 0;  // of the two logarithms: 1 if all points stand on the line
  double spread = 0;       // sum of the squares of log step about its mean
  int points = 0;          // fewer than 4: no order can be given
  double step = 0;         // s, mean of the points
};

// How far an observed order may be from the predicted one: three standard errors, by Student's t of the fit's few
// degrees of freedom; what the next power of the step does, and as much again for the powers after it, each half of the
// one before or less. Below 0.05, a fifth of the difference of the two closest orders, 1 and 5/4, nothing
// counts.
double tolerance_of(const Slope& slope);

// The correlation of points that scatter about such a line by so much in log error. A slope alone can be that of no line
// at all: order 4 that halfway stops at a floor has slope 2.
double correlation_with(const Slope& slope, double scatter);

// The points whose error (a member of Point) lies between round-off and 1/30, at most `most` of them, the finest.
// Errors below 1e-11 may be round-off: of thousands of sums at 0.1 m, over lengths of some mm.
Slope fitted(const std::vector<Point>& points, double Point::*error, int most = 9,
             double Point::*abscissa = &Point::step, double round_off = 1e-11);

// On a smooth force nothing scatters, but of a method of order 5 the next powers reach far: the six finest points. Down
// to 1e-12: round-off of a thousand sums at 0.1 m over 5 mm is, as a random walk, 1e-13.
Slope fitted_smooth(const std::vector<Point>& points, double Point::*error);

// s of error = C tolerance^s, of a controlled method, from the points where a smaller tolerance makes smaller steps:
// not from those where the longest step rules.
Slope fitted_exponent(const std::vector<Point>& points);

std::vector<Point> observe(const std::string& method, const Problem& problem, const Series& series);

// The relative tolerance of a controlled method's point.
double planned_tolerance(const Series& series, int size);

// The mean step of a point of a fixed-step method, if no event divides a step and no run diverges.
double planned_step(const std::string& method, const Problem& problem, const Series& series, int size);

// The motion run to its end, reversed and run back to where it came from: the distance from there, as a Point.
std::vector<Point> observe_return(const std::string& method, const Problem& problem, const Series& series);

// Its order, of the six finest points: with the coarsest steps methods of order 5 lose a body of their own making. What
// is lost on the way is mostly found again, round-off too: errors count down to 1e-12.
Slope fitted_return(const std::vector<Point>& points);

}  // namespace furrow::verification
