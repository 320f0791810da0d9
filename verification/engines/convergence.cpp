#include "verification/engines/convergence.h"

#include <algorithm>
#include <cmath>

#include "scene/wording.h"

namespace furrow::verification {
namespace {

// An observed order may be below the predicted one by so much: at three resolutions the next term of the error, and the
// phase in which events fall into steps, bend the slope by up to a third.
constexpr double slack = 0.35;
// Less is no order: nothing is arrived at.
constexpr double least_order = 0.4;
// A value is another one than expected only if it is further off than so many times what its last changes leave open.
constexpr double beyond_doubt = 3;
// A swing this small a part of the error does not lead back to what is expected.
constexpr double small_part = 0.1;

// Errors by resolution; of resolutions that are close to each other the root of the mean square, so that the phase in
// which an event falls into a step makes less of a difference.
struct Errors {
  std::vector<double> steps, error;
};

Errors grouped(const std::vector<int>& steps, const std::vector<double>& errors) {
  Errors all;
  std::size_t begin = 0;
  while (begin < steps.size()) {
    double logs = 0, squares = 0, count = 0;
    std::size_t k = begin;
    for (; k < steps.size() && steps[k] < close_resolutions * steps[begin]; ++k, ++count) {
      logs += std::log(steps[k]);
      squares += errors[k] * errors[k];
    }
    all.steps.push_back(std::exp(logs / count));
    all.error.push_back(std::sqrt(squares / count));
    begin = k;
  }
  return all;
}

double slope(const Errors& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0, n = 0;
  for (std::size_t k = 0; k < errors.steps.size(); ++k) {
    if (!(errors.error[k] > 0)) continue;
    const double x = -std::log(errors.steps[k]), y = std::log(errors.error[k]);
    sx += x, sy += y, sxx += x * x, sxy += x * y, ++n;
  }
  return n < 2 ? NAN : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// Where the group of resolutions begins that ends before `end`.
std::size_t begin_of_group(const std::vector<int>& steps, std::size_t end) {
  std::size_t begin = end - 1;
  while (begin > 0 && steps[end - 1] < close_resolutions * steps[begin - 1]) --begin;
  return begin;
}

// The greatest change from the group before to the one that ends before `end`, each over what `weight` says of the two
// resolutions; 0 if there is no group before.
template <class Weight>
double change_to(const std::vector<int>& steps, const std::vector<double>& values, std::size_t end, Weight weight) {
  const std::size_t last = begin_of_group(steps, end);
  double most = 0;
  for (std::size_t i = last > 0 ? begin_of_group(steps, last) : 0; i < last; ++i) {
    for (std::size_t k = last; k < end; ++k)
      most = std::max(most, std::fabs(values[k] - values[i]) / weight(steps[i], steps[k]));
  }
  return most;
}

// How far the values before `end` may still be from where they go if the last change is one of this order: an error C h^p
// changes by C h^p (r^p - 1) from the resolution before, with steps r times as long, and by little more or less with the
// phase of events. Of resolutions that are close to each other the two that differ most count, since a change may be small
// by chance. Earlier changes say nothing: coarse values may be wild.
double left_to_go(const std::vector<int>& steps, const std::vector<double>& values, std::size_t end, double order) {
  constexpr double phase = 1.8;
  return phase *
         change_to(steps, values, end, [&](double coarse, double fine) { return std::pow(fine / coarse, order) - 1; });
}

// The last change is of another order than the one before, or smaller: changes of an error C h^p go as the differences of
// h^p.
bool changes_fall(const std::vector<int>& steps, const std::vector<double>& values) {
  const auto lowest = [](double coarse, double fine) {
    return std::pow(coarse, -least_order) - std::pow(fine, -least_order);
  };
  const std::size_t end = values.size(), before = begin_of_group(steps, end);
  if (before == 0 || begin_of_group(steps, before) == 0) return false;
  return change_to(steps, values, end, lowest) <= change_to(steps, values, before, lowest);
}

// The last change has not the sign of the one before: no slow drift.
bool turns_back(const std::vector<double>& values, const std::vector<int>& steps) {
  const std::size_t last = begin_of_group(steps, values.size());
  const std::size_t middle = last > 0 ? begin_of_group(steps, last) : 0;
  if (middle == 0) return false;
  return (values.back() - values[last - 1]) * (values[last - 1] - values[middle - 1]) < 0;
}

// What is left to go where values settle elsewhere, by the last change or by the one before, whichever leaves more: the
// last may be small by chance. NaN if they do not settle, or on both sides of the expected value, or so near to it that it
// may be where they go.
double left_elsewhere(const Finding& f, const std::vector<int>& steps, double floor) {
  const std::size_t end = f.values.size(), last = begin_of_group(steps, end);
  if (last == 0) return NAN;
  double nearest = INFINITY, low = INFINITY, high = -INFINITY;
  for (std::size_t k = begin_of_group(steps, last); k < end; ++k) {
    if ((f.values[k] > f.expected) != (f.values.back() > f.expected)) return NAN;
    if (k >= last) nearest = std::min(nearest, std::fabs(f.values[k] - f.expected));
    low = std::min(low, f.values[k]), high = std::max(high, f.values[k]);
  }
  const double by_last = left_to_go(steps, f.values, end, 1);
  if (high - low <= floor) return nearest > beyond_doubt * by_last ? by_last : NAN;
  const double refined = static_cast<double>(steps.back()) / steps[last - 1];
  const double left = std::max(by_last, left_to_go(steps, f.values, last, 1) / refined);
  if (nearest > beyond_doubt * left && changes_fall(steps, f.values)) return left;
  const bool swings = turns_back(f.values, steps) && high - low < small_part * nearest;
  return swings ? std::max(left, high - low) : NAN;
}

}  // namespace

std::string few(double value) { return rounded(value, 3); }

double scale_of(const Json& seen, double expected) {
  if (seen.contains("scale")) return seen["scale"];
  return std::fabs(expected) > 0 ? std::fabs(expected) : 1;
}

Finding judge_converging(Finding f, const Json& seen, const std::vector<int>& steps, double claimed) {
  const double scale = scale_of(seen, f.expected), floor = seen["floor"];
  std::vector<double> errors;
  for (const double value : f.values) errors.push_back(std::fabs(value - f.expected) / scale);
  const Errors by_step = grouped(steps, errors);
  f.error = by_step.error.back();
  f.order = slope(by_step);
  f.limit = f.values.back();
  const auto said = [&](CaseVerdict verdict, const std::string& words) {
    f.verdict = verdict, f.words = words;
    return f;
  };
  if (f.error <= floor) return said(CaseVerdict::right, "error " + few(f.error));
  const double predicted = std::min(claimed, seen["limit"].get<double>());
  const std::string orders =
      "error " + few(f.error) + ", order " + few(f.order) + " (" + few(predicted) + " predicted)";
  const auto arrives = [&](double order) {
    const double left = left_to_go(steps, f.values, f.values.size(), std::min(order, 1.0));
    return f.order >= order && f.error * scale <= left + floor * scale;
  };
  if (arrives(predicted - slack)) return said(CaseVerdict::right, orders);
  if (arrives(least_order)) return said(CaseVerdict::lower_order, orders);
  constexpr int digits = 8;  // enough to tell two apart that are taken for different ones
  f.left = left_elsewhere(f, steps, floor * scale);
  if (!std::isnan(f.left))
    return said(CaseVerdict::another_law, "goes to " + rounded(f.limit, digits) + " within " + few(f.left) +
                                              " in place of " + rounded(f.expected, digits) + ", off by " +
                                              few(f.error));
  f.undecided = true;
  return said(CaseVerdict::failed, "does not converge up to " + std::to_string(steps.back()) + " steps: " + orders);
}

}  // namespace furrow::verification
