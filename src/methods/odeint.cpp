// Boost.Odeint behind one adapter: the only file that includes its steppers, which are slow to compile.
//
// Traps handled (Boost 1.74): a NaN in the error estimate counts as a good step, so every new state is checked; a
// controlled step that never succeeds is given up after a bounded number of tries; a first-same-as-last stepper would
// keep f of a state that a jump has changed, so f is kept here, by the overload that takes it (the one that takes only
// y does not compile out of place); the ledger takes no part in the error control.
#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "methods/method.h"

namespace furrow {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr int most_tries = 60;  // a step is divided by up to 5 at a try: enough to reach round-off from any start

bool all_finite(const State& y) {
  return std::all_of(y.begin(), y.end(), [](double v) { return std::isfinite(v); });
}

// Steppers of fixed step size: rk4, and adams_bashforth_moulton<2>, which is the paper's scheme but for its start.
template <class Stepper>
class FixedOdeint final : public Method {
 public:
  explicit FixedOdeint(MethodInfo info) : Method(std::move(info)) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    const auto f = [&](const State& state, State& dydt, double time) { evaluate(system, time, state, dydt); };
    stepper_.do_step(f, y, t, h);
    return h;
  }

  void restart() override { stepper_ = Stepper(); }

 private:
  Stepper stepper_;
};

// Greatest error against  absolute + relative (|y| + h |y'|)  over the controlled numbers.
class LeadingErrorChecker {
 public:
  LeadingErrorChecker(Tolerances tolerances, const std::size_t* controlled)
      : tolerances_(tolerances), controlled_(controlled) {}

  template <class Algebra>
  double error(Algebra& /*algebra*/, const State& y, const State& dydt, State& difference, double h) const {
    double greatest = 0;
    for (std::size_t i = 0; i < *controlled_; ++i) {
      const double scale = tolerances_.absolute + tolerances_.relative * (std::fabs(y[i]) + std::fabs(h * dydt[i]));
      const double error = std::fabs(difference[i]) / scale;
      if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();  // odeint takes a NaN for a good step
      greatest = std::max(greatest, error);
    }
    return greatest;
  }

 private:
  Tolerances tolerances_;
  const std::size_t* controlled_;
};

class ControlledDopri5 final : public Method {
  using Stepper = odeint::controlled_runge_kutta<odeint::runge_kutta_dopri5<State>, LeadingErrorChecker>;

 public:
  ControlledDopri5(MethodInfo info, const Tolerances& tolerances)
      : Method(std::move(info)),
        proposal_(tolerances.first_step),
        stepper_(LeadingErrorChecker(tolerances, &controlled_)) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    controlled_ = system.controlled();
    for (State* room : {&now_, &next_, &next_now_}) room->resize(y.size());
    const auto f = [&](const State& state, State& dydt, double time) { evaluate(system, time, state, dydt); };
    if (!fresh_) evaluate(system, t, y, now_);
    fresh_ = true;
    const bool cut = proposal_ > h;
    double trial = std::min(proposal_, h);
    for (int tries = 0; tries < most_tries; ++tries) {
      const double tried = trial;
      double reached = t;
      bool good = false;
      try {
        good = stepper_.try_step(f, y, now_, reached, next_, next_now_, trial) == odeint::success;
        if (good && !all_finite(next_)) {
          good = false;
          trial = 0.2 * tried;
        }
      } catch (const Divergence&) {  // the trial left what can be computed; a shorter one may not
        trial = 0.2 * tried;
      }
      if (good) {
        proposal_ = cut && tries == 0 ? std::max(proposal_, trial) : trial;
        y.swap(next_);
        now_.swap(next_now_);
        return tried;
      }
      ++rejections_;
    }
    throw Divergence("no step of " + info_.name + " met its tolerance in " + std::to_string(most_tries) +
                     " tries; the last was " + std::to_string(trial) + " s long");
  }

  void restart() override { fresh_ = false; }
  void state_changed() override { fresh_ = false; }

 private:
  double proposal_;
  std::size_t controlled_ = 0;
  bool fresh_ = false;  // now_ is f at the present state
  State now_, next_, next_now_;
  Stepper stepper_;
};

}  // namespace

std::unique_ptr<Method> make_odeint_rk4(const Tolerances& /*tolerances*/) {
  return std::make_unique<FixedOdeint<odeint::runge_kutta4<State>>>(
      MethodInfo{"odeint_rk4", "Boost.Odeint runge_kutta4", 4, 4, false});
}

std::unique_ptr<Method> make_odeint_abm2(const Tolerances& /*tolerances*/) {
  return std::make_unique<FixedOdeint<odeint::adams_bashforth_moulton<2, State>>>(
      MethodInfo{"odeint_abm2", "Boost.Odeint adams_bashforth_moulton<2>: the paper's scheme, started by a step of rk4",
                 2, 2, false});
}

std::unique_ptr<Method> make_odeint_dopri5(const Tolerances& tolerances) {
  return std::make_unique<ControlledDopri5>(
      MethodInfo{"odeint_dopri5", "Boost.Odeint runge_kutta_dopri5, controlled", 5, 6, true}, tolerances);
}

}  // namespace furrow
