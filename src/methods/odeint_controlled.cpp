// Boost.Odeint's explicit steppers with step control.
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "methods/odeint.h"
#include "methods/odeint_memory.h"
#include "physics/constants.h"

namespace furrow {
namespace {

namespace odeint = boost::numeric::odeint;

// The greatest error of the controlled numbers: the energy ledger follows the motion and must not steer it. A NaN is an
// infinite error; odeint's own norm ignores it. The steppers construct their algebra themselves, so the count cannot be
// passed to it: it is one variable for each thread, set before each try.
struct LeadingNorm : odeint::range_algebra {
  static double norm_inf(const State& errors) {
    double greatest = 0;
    for (std::size_t i = 0; i < controlled; ++i) {
      if (!std::isfinite(errors[i])) return infinity;
      greatest = std::max(greatest, std::fabs(errors[i]));
    }
    return greatest;
  }
  static thread_local std::size_t controlled;
};
thread_local std::size_t LeadingNorm::controlled = 0;

// Error against  absolute + relative (|y| + h |y'|).
using ErrorChecker = odeint::default_error_checker<double, LeadingNorm, odeint::default_operations>;

template <template <class...> class RungeKutta>
using Pair = odeint::controlled_runge_kutta<RungeKutta<State, double, State, double, LeadingNorm>, ErrorChecker>;
using BulirschStoer = odeint::bulirsch_stoer<State, double, State, double, LeadingNorm>;

}  // namespace

struct Rejected {};
struct First {};
struct LastStep {};
struct Order {};
FURROW_REVEAL(BulirschStoer, bool, m_last_step_rejected, Rejected);
FURROW_REVEAL(BulirschStoer, bool, m_first, First);
FURROW_REVEAL(BulirschStoer, double, m_dt_last, LastStep);
FURROW_REVEAL(BulirschStoer, std::size_t, m_current_k_opt, Order);

namespace {

// The numbers by which a stepper that has made a step chooses its order.
void remember_order(BulirschStoer& stepper, HistoryVisitor& visit) {
  visit("last rejected", reveal(stepper, Rejected{}));
  visit("first", reveal(stepper, First{}));
  visit("last h", reveal(stepper, LastStep{}));
  visit("order", reveal(stepper, Order{}));
}

// f at the state is kept here, not in the stepper: a jump makes it worthless, and a first-same-as-last stepper would go
// on with it.
template <class Stepper>
class Controlled final : public ControlledOdeint {
  static constexpr bool hands_on =
      std::is_same_v<typename Stepper::stepper_category, odeint::explicit_controlled_stepper_fsal_tag>;
  static constexpr bool extrapolates = std::is_same_v<Stepper, BulirschStoer>;

 public:
  Controlled(MethodInfo info, const Tolerances& tolerances)
      : ControlledOdeint(std::move(info), tolerances), tolerances_(tolerances), stepper_(made()) {}

  void restart() override {
    ControlledOdeint::restart();
    fresh_ = false;
    if constexpr (extrapolates) stepper_.reset();
  }
  void state_changed() override { fresh_ = false; }

 private:
  void remember(HistoryVisitor& visit) override {
    ControlledOdeint::remember(visit);
    visit("fresh", fresh_);
    visit("rates", now_);
    if constexpr (extrapolates) {
      stepper_.adjust_size(now_);  // without this it would begin again
      if (!now_.empty()) remember_order(stepper_, visit);
    } else {
      stepper_ = made();
    }
  }

  Stepper made() const {
    if constexpr (extrapolates)
      return Stepper(tolerances_.absolute, tolerances_.relative);
    else
      return Stepper(ErrorChecker(tolerances_.absolute, tolerances_.relative));
  }

  void begin(const OdeSystem& system, double t, const State& y) override {
    if (y.size() != now_.size()) stepper_ = made();  // its buffers never grow
    for (State* room : {&now_, &next_, &next_now_}) room->resize(y.size());
    if (!fresh_) evaluate_start(system, t, y, now_);
    fresh_ = true;
  }

  bool attempt(const OdeSystem& system, double t, const State& y, double& trial) override {
    LeadingNorm::controlled = system.controlled();
    const auto f = [&](const State& state, State& dydt, double time) { evaluate(system, time, state, dydt); };
    if constexpr (hands_on)
      return stepper_.try_step(f, y, now_, t, next_, next_now_, trial) == odeint::success;
    else
      return stepper_.try_step(f, y, now_, t, next_, trial) == odeint::success;
  }

  void accept() override {
    if constexpr (hands_on)
      now_.swap(next_now_);
    else
      fresh_ = false;
  }

  Tolerances tolerances_;
  Stepper stepper_;
  bool fresh_ = false;  // now_ is f at the present state
  State now_, next_now_;
};

}  // namespace

// fehlberg78 walks through collisions at any tolerance when its steps are longer than some thirtieth of them: in free
// flight its error is zero. run() caps them all at the scene's time.max_step.
FURROW_METHODS(odeint_controlled) {
  catalogue.insert(
      catalogue.end(),
      {
          odeint_entry<Controlled<Pair<odeint::runge_kutta_cash_karp54>>>(
              {"odeint_cash_karp54", "runge_kutta_cash_karp54", 5, 6, true}),
          odeint_entry<Controlled<Pair<odeint::runge_kutta_dopri5>>>(
              {"odeint_dopri5", "runge_kutta_dopri5", 5, 6, true}),
          odeint_entry<Controlled<Pair<odeint::runge_kutta_fehlberg78>>>(
              {"odeint_fehlberg78", "runge_kutta_fehlberg78; needs time.max_step below 1/30 of a collision", 8, 13,
               true}),
          odeint_entry<Controlled<BulirschStoer>>(
              {"odeint_bulirsch_stoer", "bulirsch_stoer: extrapolated midpoint, order 4 to 16 as it goes", 4, 0, true}),
      });
}

}  // namespace furrow
