#include "methods/stability.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "methods/method.h"
#include "physics/constants.h"

namespace furrow {
namespace {

// In units of 1/omega, with q = x and v = x'/omega, so that the numbers stay near one.
class UnitOscillator final : public OdeSystem {
 public:
  explicit UnitOscillator(double zeta) : zeta_(zeta) {}
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = -2 * zeta_ * y[1] - y[0];
  }

 private:
  double zeta_;
};

// Reads or sets all states that a method remembers, one after the other.
class Carried final : public HistoryVisitor {
 public:
  Carried(std::vector<double>& numbers, bool sets) : numbers_(numbers), sets_(sets) {}
  void number(std::string_view /*name*/, double& /*value*/) override {}
  void integer(std::string_view /*name*/, std::int64_t& /*value*/) override {}
  void text(std::string_view /*name*/, std::string& /*value*/) override {}
  void integers(std::string_view /*name*/, std::vector<std::int64_t>& /*values*/) override {}
  void state(std::string_view /*name*/, State& values) override {
    for (double& value : values) {
      if (sets_)
        value = numbers_[next_++];
      else
        numbers_.push_back(value);
    }
  }

 private:
  std::vector<double>& numbers_;
  bool sets_;
  std::size_t next_ = 0;
};

std::vector<double> carried(Method& method, State& y) {
  std::vector<double> numbers;
  Carried visitor(numbers, false);
  visitor("y", y);
  method.history(visitor);
  return numbers;
}

void carry(Method& method, State& y, std::vector<double> numbers) {
  Carried visitor(numbers, true);
  visitor("y", y);
  method.history(visitor);
}

// A step as a matrix that acts on all that is carried from one step to the next: linear, for the system is.
Eigen::MatrixXd step_matrix(const std::string& name, const OdeSystem& system, double h) {
  constexpr int opening_steps = 8;  // the longest history is of five
  const auto method = make_method(name);
  State y(system.size(), 1.0);
  for (int n = 0; n < opening_steps; ++n) method->step(system, n * h, y, h);
  const std::size_t size = carried(*method, y).size();
  Eigen::MatrixXd matrix(size, size);
  for (std::size_t k = 0; k < size; ++k) {
    std::vector<double> unit(size, 0.0);
    unit[k] = 1;
    carry(*method, y, unit);
    method->step(system, opening_steps * h, y, h);
    const std::vector<double> image = carried(*method, y);
    for (std::size_t i = 0; i < size; ++i) matrix(i, k) = image[i];
  }
  return matrix;
}

Eigen::VectorXcd eigenvalues(const std::string& name, const OdeSystem& system, double h) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(step_matrix(name, system, h), false).eigenvalues();
}

bool grows(const std::string& name, double zeta, double h) {
  const Eigen::MatrixXd step = step_matrix(name, UnitOscillator(zeta), h);
  if (!step.allFinite()) return true;  // its eigenvalues would be anything
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(step, false);
  return !(solver.eigenvalues().cwiseAbs().maxCoeff() <= std::exp(growth_seen));
}

// In units of 1/omega. Steps are lengthened until the solution grows. A region of stability need not begin at zero, and
// stable steps beyond its first end do not count.
double first_growing_step(const std::string& name, double zeta) {
  constexpr double stride = 1.15, most = 10;  // above the limit of every explicit method here
  double stable = 0;
  double next = 1e-3 / std::max(1.0, 2 * zeta);
  for (; !grows(name, zeta, next); next *= stride) {
    if (next > most) return infinity;
    stable = next;
  }
  if (stable == 0) return 0;
  while (next - stable > 5e-4 * next) {
    const double middle = 0.5 * (stable + next);
    (grows(name, zeta, middle) ? next : stable) = middle;
  }
  return stable;
}

// Above a ratio of 1e6 only the fast decay counts, at 2 zeta omega: the other one is slower by 4 zeta^2, so limits go
// by 1/zeta, to a part in 1e12. The matrix of a step would hold numbers too far apart for its eigenvalues.
double first_growing_step_at(const std::string& name, double zeta) {
  constexpr double steepest = 1e6;
  return zeta > steepest ? first_growing_step(name, steepest) * (steepest / zeta) : first_growing_step(name, zeta);
}

}  // namespace

std::vector<std::complex<double>> step_eigenvalues(const std::string& method, const OdeSystem& linear, double h) {
  const Eigen::VectorXcd values = eigenvalues(method, linear, h);
  return {values.begin(), values.end()};
}

double largest_stable_step(const std::string& name, const Oscillator& o) {
  if (make_method(name)->info().controlled || o.omega == 0) return infinity;
  if (!(o.omega < infinity && o.zeta < infinity)) return 0;  // not a number too
  // A scene asks again and again for the damping ratios of its contacts.
  static std::mutex mutex;
  static std::map<std::pair<std::string, double>, double> known;
  const std::scoped_lock lock(mutex);
  const auto [found, fresh] = known.try_emplace({name, o.zeta}, 0);
  if (fresh) found->second = first_growing_step_at(name, o.zeta);
  return found->second / o.omega;
}

}  // namespace furrow
