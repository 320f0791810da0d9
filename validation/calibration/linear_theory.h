// Weighted least squares about one point, by its slopes: numbers alone, no runs. The formulas are those of identify.h.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>

namespace furrow::validation {

// A model as its slopes describe it about one point.
struct Slopes {
  Eigen::VectorXd residuals, weights;  // of all targets, in tolerances; mean over packings
  Eigen::MatrixXd slopes;              // residual by key, per range of the key
  Eigen::VectorXd from;                // the point: of each key the share of its range, 0 to 1
  Eigen::VectorXd least;               // a shorter step of that key is none, as less than half an integer; a share
};

// What the theory knows: half the 95 % interval of each key, and along each direction; in shares of the ranges. There
// must be more residuals than keys.
struct Intervals {
  explicit Intervals(const Slopes& about);
  Eigen::MatrixXd directions;
  Eigen::VectorXd half, along;
};

// The Gauss-Newton step, in shares: to the least sum of w r^2 within the ranges, were the model its slopes. A key that
// the step would take out of its range goes to the end of it, and the others to the least from there.
Eigen::VectorXd step_within_ranges(const Slopes& about);

// Whether the step that is left is in no key longer than half its interval. If it is longer the point is no minimum, or
// the model is not its slopes so far off: either way no interval says anything, those of the other keys neither, since
// their best values move with this one.
bool arrived(const Slopes& about, const Eigen::VectorXd& half);

// How far a model is from a straight line over the reach of a key: residuals at the point, off the line between those on
// its two sides, of half their difference; weighted. 0: straight; 1: all of the change is on one side, as where the model
// jumps; infinite where only the middle is off. `at` is the place of the point between the sides, 0 to 1; at one of them
// nothing can be said: 0.
double bend(const Eigen::VectorXd& low, const Eigen::VectorXd& middle, const Eigen::VectorXd& high, double at,
            const Eigen::VectorXd& weights);
constexpr double most_bend = 0.5;  // an interval of slopes is then off by half

constexpr int most_shares = 5;

// The longest share of a step, of 1, 1/2, ... 1/16, after which the misfit is less than before; none after none of them.
std::optional<double> falling_share(const std::function<double(double)>& misfit_after, double before);

}  // namespace furrow::validation
