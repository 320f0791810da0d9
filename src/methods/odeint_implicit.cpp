// Boost.Odeint's implicit steppers. Their uBLAS needs std::allocator::construct, gone since C++20: this file alone is
// compiled as C++17. Dense factorisations, so for small systems only; the Jacobian is taken by differences.
#define BOOST_UBLAS_NDEBUG  // its checks throw on a NaN; here a NaN is to come out, and to be noticed
#include <boost/numeric/odeint/stepper/implicit_euler.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>

#include "methods/odeint.h"
#include "physics/constants.h"

namespace furrow {
namespace {

namespace odeint = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;

using Vector = ublas::vector<double>;
using Matrix = ublas::matrix<double>;

// f(t, y) with its derivatives by forward differences. The increments are the square root of the machine's epsilon
// times the number itself, or times 1e-2 m, m/s for small ones: well below an overlap, well above its round-off.
class Differences {
 public:
  using Rhs = std::function<void(double, const State&, State&)>;

  void set(Rhs rhs, const OdeSystem& system) {
    rhs_ = std::move(rhs);
    counted_ = system.controlled();  // nothing depends on the numbers after them, the ledger
  }

  void f(const Vector& x, Vector& dxdt, double t) {
    at_.assign(x.begin(), x.end());
    rates_.resize(at_.size());
    rhs_(t, at_, rates_);
    std::copy(rates_.begin(), rates_.end(), dxdt.begin());
  }

  // Both steppers ask for the Jacobian where they have just asked for f.
  void jacobian(const Vector& x, Matrix& jacobian, double t) {
    at_.assign(x.begin(), x.end());
    moved_.resize(at_.size());
    for (std::size_t k = 0; k < at_.size(); ++k) {
      if (k < counted_) {
        at_[k] = x[k] + root_epsilon * std::max(std::fabs(x[k]), 1e-2);
        rhs_(t, at_, moved_);
      }
      for (std::size_t i = 0; i < at_.size(); ++i)
        jacobian(i, k) = k < counted_ ? (moved_[i] - rates_[i]) / (at_[k] - x[k]) : 0;
      at_[k] = x[k];
    }
  }

  void time_derivative(double t, double h, Vector& dfdt) {
    const double later = t + root_epsilon * std::max(std::fabs(t), h);
    rhs_(later, at_, moved_);
    for (std::size_t i = 0; i < at_.size(); ++i) dfdt[i] = (moved_[i] - rates_[i]) / (later - t);
  }

 private:
  static constexpr double root_epsilon = 0x1p-26;
  Rhs rhs_;
  std::size_t counted_ = 0;
  State at_, rates_, moved_;
};

// One Newton step, that is, the linearly implicit Euler method. The stepper's second one would factorise a matrix that
// is factorised already, and then never converge: an infinite tolerance keeps it from that. Where the matrix is
// singular the stepper ends the program, with exit code 0: that is found out beforehand.
class ImplicitEuler final : public Method {
 public:
  ImplicitEuler(MethodInfo info, const Tolerances& /*tolerances*/) : Method(std::move(info)) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    if (y.size() != x_.size()) stepper_ = Stepper(infinity);
    x_.resize(y.size(), false);
    std::copy(y.begin(), y.end(), x_.begin());
    differences_.set([&](double time, const State& at, State& rates) { evaluate(system, time, at, rates); }, system);
    const auto f = [this](const Vector& x, Vector& dxdt, double time) { differences_.f(x, dxdt, time); };
    const auto jacobian = [&](const Vector& x, Matrix& matrix, double time) {
      differences_.jacobian(x, matrix, time);
      require_regular(matrix, h);
    };
    stepper_.do_step(std::make_pair(f, jacobian), x_, t, h);
    std::copy(x_.begin(), x_.end(), y.begin());
    return h;
  }

 private:
  using Stepper = odeint::implicit_euler<double>;

  static void require_regular(Matrix matrix, double h) {  // the stepper's own operations, on a copy
    matrix *= h;
    matrix -= ublas::identity_matrix<double>(matrix.size1());
    ublas::permutation_matrix<std::size_t> order(matrix.size1());
    if (ublas::lu_factorize(matrix, order) != 0)
      throw Divergence("odeint_implicit_euler cannot solve for a step of " + shortest(h) +
                       " s: its matrix is singular");
  }

  Stepper stepper_{infinity};
  Vector x_;
  Differences differences_;
};

// The method is RODAS. Boost has its gamma_4, the factor of df/dt in the fourth stage, with the wrong sign: second
// order where a force depends on time. It is -0.0362: Hairer and Wanner 1996, section IV.7, and what the other
// coefficients demand, 4 gamma_4 = 1 + c41 gamma_1 + c42 gamma_2 + c43 gamma_3.
struct Rodas : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -default_rosenbrock_coefficients::d4;  // hides that of the base
};

// Step control as by Hairer and Wanner 1996, section IV.7, in the root mean square of the numbers that count, per
// number that lasts; rosenbrock4_controller would let the energy ledger steer. The stepper does not look whether its
// matrix is singular: what then comes out is not finite, and rejected.
class Rosenbrock4 final : public ControlledOdeint {
 public:
  Rosenbrock4(MethodInfo info, const Tolerances& tolerances)
      : ControlledOdeint(std::move(info), tolerances), tolerances_(tolerances) {}

 private:
  using Stepper = odeint::rosenbrock4<double, Rodas>;

  void begin(const OdeSystem& /*system*/, double /*t*/, const State& y) override {
    if (y.size() != x_.size()) stepper_ = std::make_unique<Stepper>();
    for (Vector* room : {&x_, &after_, &error_}) room->resize(y.size(), false);
    std::copy(y.begin(), y.end(), x_.begin());
  }

  bool attempt(const OdeSystem& system, double t, const State& /*y*/, double& trial) override {
    differences_.set([&](double time, const State& at, State& rates) { evaluate(system, time, at, rates); }, system);
    const auto f = [this](const Vector& x, Vector& dxdt, double time) { differences_.f(x, dxdt, time); };
    const auto jacobian = [&](const Vector& x, Matrix& matrix, double time, Vector& dfdt) {
      differences_.jacobian(x, matrix, time);
      differences_.time_derivative(time, trial, dfdt);
    };
    stepper_->do_step(std::make_pair(f, jacobian), x_, t, after_, trial, error_);
    next_.assign(after_.begin(), after_.end());
    const double error = error_norm(system);
    if (!std::isfinite(error)) return false;
    trial /= std::min(std::max(std::sqrt(std::sqrt(error)) / 0.9, 1.0 / 6), 5.0);
    return error <= 1;
  }

  double error_norm(const OdeSystem& system) const {
    double sum = 0;
    for (std::size_t i = 0; i < system.controlled(); ++i) {
      const double size = std::max(std::fabs(x_[i]), std::fabs(after_[i]));
      const double error = error_[i] / (tolerances_.absolute + tolerances_.relative * size);
      sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(system.lasting()));
  }

  Tolerances tolerances_;
  std::unique_ptr<Stepper> stepper_;
  Vector x_, after_, error_;
  Differences differences_;
};

template <class Adapter>
MethodEntry implicit(MethodInfo info) {
  info.dense_jacobian = true;
  return odeint_entry<Adapter>(info);
}

}  // namespace

FURROW_METHODS(odeint_implicit) {
  catalogue.insert(
      catalogue.end(),
      {
          implicit<Rosenbrock4>({"odeint_rosenbrock4", "rosenbrock4", 4, 7, true}),
          implicit<ImplicitEuler>({"odeint_implicit_euler", "implicit_euler, one Newton step", 1, 1, false}),
      });
}

}  // namespace furrow
