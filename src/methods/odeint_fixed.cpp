// Boost.Odeint's steppers of fixed step size.
#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/modified_midpoint.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/symplectic_euler.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>

#include "methods/odeint.h"
#include "methods/odeint_memory.h"

namespace furrow {
namespace odeint = boost::numeric::odeint;

// Starts with steps of rk4, whose error of h^5 leaves order 5 as it is. The default starter of adams_bashforth, an
// extrapolation, spoils its input when it works in place: order 1 for all.
template <template <std::size_t, class...> class Stepper, std::size_t N>
using Multistep = Stepper<N, State, double, State, double, odeint::range_algebra, odeint::default_operations,
                          odeint::initially_resizer, odeint::runge_kutta4<State>>;
template <std::size_t N>
using Bashforth = Multistep<odeint::adams_bashforth, N>;
template <std::size_t N>
using BashforthMoulton = Multistep<odeint::adams_bashforth_moulton, N>;

struct Started {};
struct Predictor {};
#define FURROW_REVEAL_MULTISTEP(N)                                        \
  FURROW_REVEAL(Bashforth<N>, std::size_t, m_steps_initialized, Started); \
  FURROW_REVEAL(BashforthMoulton<N>, Bashforth<N>, m_adams_bashforth, Predictor)
FURROW_REVEAL_MULTISTEP(1);
FURROW_REVEAL_MULTISTEP(2);
FURROW_REVEAL_MULTISTEP(3);
FURROW_REVEAL_MULTISTEP(4);
FURROW_REVEAL_MULTISTEP(5);

namespace {

template <std::size_t N>
Bashforth<N>& predictor(Bashforth<N>& stepper) {
  return stepper;
}
template <std::size_t N>
Bashforth<N>& predictor(BashforthMoulton<N>& stepper) {
  return reveal(stepper, Predictor{});
}

// Of a multistep method: how many steps were made since the start, and the rates at them. The stepper is a new one
// afterwards, with buffers for states of the size that is returned.
template <class Stepper>
std::size_t remember_rates(Stepper& stepper, HistoryVisitor& visit) {
  Stepper after;
  auto& from = predictor(stepper);
  auto& to = predictor(after);
  reveal(to, Started{}) = reveal(from, Started{});
  visit("started", reveal(to, Started{}));
  for (std::size_t k = 0; k < Stepper::steps; ++k) {
    to.step_storage()[k].m_v = from.step_storage()[k].m_v;
    visit("rates", to.step_storage()[k].m_v);
  }
  stepper = after;
  return to.step_storage()[0].m_v.size();
}

// Buffers keep the size of the first state, and a stepper would write beyond them: another size takes a new stepper.
// A history belongs to its step size: with another one ab<2..> and abm<3..> drop to first order, so they restart.
template <class Stepper>
class Fixed final : public Method {
 public:
  Fixed(MethodInfo info, const Tolerances& /*tolerances*/) : Method(std::move(info)) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    if (y.size() != size_) stepper_ = Stepper();
    if (h != h_) restart();
    size_ = y.size();
    h_ = h;
    const auto f = [&](const State& state, State& dydt, double time) {
      const bool start = time == t && std::addressof(state) == std::addressof(y);  // y itself is changed last
      start ? evaluate_start(system, t, y, dydt) : evaluate(system, time, state, dydt);
    };
    stepper_.do_step(f, y, t, h);
    return h;
  }

  void restart() override {
    if constexpr (requires { stepper_.reset(); }) stepper_.reset();
  }

 private:
  void remember(HistoryVisitor& visit) override {
    visit("h", h_);
    if constexpr (requires { stepper_.reset(); }) size_ = remember_rates(stepper_, visit);
  }

  Stepper stepper_;
  std::size_t size_ = 0;
  double h_ = 0;  // s
};

template <std::size_t N>
MethodEntry bashforth() {
  const std::string n = std::to_string(N);
  return odeint_entry<Fixed<Bashforth<N>>>(
      {"odeint_ab" + n, "adams_bashforth<" + n + ">", static_cast<int>(N), 1, false});
}

// The corrector of N values is of order N; adams_moulton<N>::order() says N + 1. PECE; for N = 2 the paper's scheme.
template <std::size_t N>
MethodEntry bashforth_moulton() {
  const std::string n = std::to_string(N);
  return odeint_entry<Fixed<BashforthMoulton<N>>>(
      {"odeint_abm" + n, "adams_bashforth_moulton<" + n + ">" + (N == 2 ? ": the paper's scheme" : ""),
       static_cast<int>(N), 2, false});
}

// The stepper's own force is a(q_(n+1), v_n), of first order with any damping; here it is given v_n + h a_n, as in
// verlet.cpp. The overload without memory leaves the accelerations, z' among them, to this class.
class VelocityVerlet final : public Method {
 public:
  VelocityVerlet(MethodInfo info, const Tolerances& /*tolerances*/) : Method(std::move(info)) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    const auto positions = static_cast<std::ptrdiff_t>(system.positions());
    q_.assign(y.begin(), y.begin() + positions);
    v_.assign(y.begin() + positions, y.end());
    next_a_.resize(v_.size());
    rates_.resize(y.size());
    if (!started_) {
      evaluate(system, t, y, rates_);
      a_.assign(rates_.begin() + positions, rates_.end());
    }
    started_ = true;
    const auto f = [&](const State& q, const State& v, State& a, double time) {
      std::copy(q.begin(), q.end(), y.begin());
      for (std::size_t i = 0; i < v.size(); ++i) y[q.size() + i] = v[i] + h * a_[i];
      evaluate(system, time, y, rates_);
      std::copy(rates_.begin() + positions, rates_.end(), a.begin());
    };
    stepper_.do_step(f, q_, v_, a_, q_, v_, next_a_, t, h);
    std::copy(v_.begin(), v_.end(), y.begin() + positions);
    a_.swap(next_a_);
    return h;
  }

  void restart() override { started_ = false; }
  void state_changed() override { started_ = false; }

 private:
  void remember(HistoryVisitor& visit) override {
    visit("started", started_);
    visit("rates of v", a_);
  }

  odeint::velocity_verlet<State> stepper_;
  State q_, v_, a_, next_a_, rates_;  // v: velocities and z
  bool started_ = false;
};

// Splits y into [q, t] and [v, z]: the steppers know no time, so it travels as one more position of speed 1.
template <class Stepper>
class Symplectic final : public Method {
 public:
  Symplectic(MethodInfo info, const Tolerances& /*tolerances*/) : Method(std::move(info)) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    const std::size_t n = system.positions();
    if (y.size() != rates_.size()) stepper_.adjust_size(State(y.size() + 1));  // room for q and for v alike
    const auto positions = static_cast<std::ptrdiff_t>(n);
    q_.assign(y.begin(), y.begin() + positions);
    q_.push_back(t);
    v_.assign(y.begin() + positions, y.end());
    rates_.resize(y.size());
    const auto velocities = [n](const State& v, State& dqdt) {
      std::copy_n(v.begin(), n, dqdt.begin());
      dqdt[n] = 1;
    };
    const auto forces = [&](const State& q, State& dvdt) {
      std::copy_n(q.begin(), n, y.begin());
      evaluate(system, q[n], y, rates_);
      std::copy(rates_.begin() + positions, rates_.end(), dvdt.begin());
    };
    stepper_.do_step(std::make_pair(velocities, forces), q_, v_, t, h);
    std::copy_n(q_.begin(), n, y.begin());
    std::copy(v_.begin(), v_.end(), y.begin() + positions);
    return h;
  }

 private:
  Stepper stepper_;
  State q_, v_, rates_;
};

template <class Stepper>
MethodEntry symplectic(const std::string& name, int order, int evaluations) {
  MethodInfo info{"odeint_" + name, name, order, evaluations, false};
  info.conservative = true;
  return odeint_entry<Symplectic<Stepper>>(info);
}

}  // namespace

FURROW_METHODS(odeint_fixed) {
  catalogue.insert(
      catalogue.end(),
      {
          odeint_entry<Fixed<odeint::euler<State>>>({"odeint_euler", "euler", 1, 1, false}),
          odeint_entry<Fixed<odeint::modified_midpoint<State>>>(
              {"odeint_modified_midpoint", "modified_midpoint of two substeps", 2, 3, false}),
          odeint_entry<Fixed<odeint::runge_kutta4<State>>>({"odeint_rk4", "runge_kutta4", 4, 4, false}),
          bashforth<1>(),
          bashforth<2>(),
          bashforth<3>(),
          bashforth<4>(),
          bashforth<5>(),
          bashforth_moulton<1>(),
          bashforth_moulton<2>(),
          bashforth_moulton<3>(),
          bashforth_moulton<4>(),
          bashforth_moulton<5>(),
          odeint_entry<VelocityVerlet>(
              {"odeint_velocity_verlet", "velocity_verlet, given predicted velocities", 2, 1, false}),
          symplectic<odeint::symplectic_euler<State>>("symplectic_euler", 1, 1),
          symplectic<odeint::symplectic_rkn_sb3a_mclachlan<State>>("symplectic_rkn_sb3a_mclachlan", 4, 6),
          symplectic<odeint::symplectic_rkn_sb3a_m4_mclachlan<State>>("symplectic_rkn_sb3a_m4_mclachlan", 4, 5),
      });
}

}  // namespace furrow
