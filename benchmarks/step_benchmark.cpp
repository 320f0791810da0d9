// What a step costs beside the right-hand side: equal oscillators, at 2, 108 and 2,000 numbers of state; every method
// through furrow's interface, and three of Boost.Odeint's own steppers called directly on the same function. "f" counts
// evaluations a step. Each benchmark checks its answer: the oscillators agree and have kept their swing.
#include <benchmark/benchmark.h>

#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>

#include "methods/method.h"

namespace {

namespace odeint = boost::numeric::odeint;
using furrow::State;

// x' = v, v' = -x
struct Oscillators final : furrow::OdeSystem {
  explicit Oscillators(std::size_t numbers) : n(numbers / 2) {}
  std::size_t size() const override { return 2 * n; }
  std::size_t positions() const override { return n; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    for (std::size_t i = 0; i < n; ++i) {
      dydt[i] = y[n + i];
      dydt[n + i] = -y[i];
    }
  }
  std::size_t n;
};

constexpr double h = 1e-3;
constexpr int steps_a_swing = 6283;  // then all starts again, or a first-order method runs away

State at_rest(std::size_t numbers) {
  State y(numbers, 0.0);
  std::fill(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(numbers / 2), 1.0);
  return y;
}

// All the same, and on the unit circle but for the error of a first-order method over a swing.
void check(benchmark::State& state, const State& y) {
  const std::size_t n = y.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    if (y[i] != y[0] || y[n + i] != y[n]) return state.SkipWithError("equal oscillators differ");
  }
  if (std::fabs(std::hypot(y[0], y[n]) - 1) > 1e-2) state.SkipWithError("the swing was not kept");
}

template <class Step, class Restart>
void measure(benchmark::State& state, Step&& step, Restart&& restart) {
  const auto numbers = static_cast<std::size_t>(state.range(0));
  State y = at_rest(numbers);
  int n = 0;
  for (auto _ : state) {
    step(y, h * n);
    if (++n < steps_a_swing) continue;
    n = 0;
    y = at_rest(numbers);
    restart();
  }
  check(state, y);
}

void through_furrow(benchmark::State& state, const std::string& name) {
  const Oscillators system(static_cast<std::size_t>(state.range(0)));
  const auto method = furrow::make_method(name, {1e-3, 1e-3, h});
  measure(
      state, [&](State& y, double t) { method->step(system, t, y, h); }, [&] { method->restart(); });
  state.counters["f"] =
      benchmark::Counter(static_cast<double>(method->evaluations()), benchmark::Counter::kAvgIterations);
}

template <class Stepper>
void directly(benchmark::State& state) {
  const Oscillators system(static_cast<std::size_t>(state.range(0)));
  Stepper stepper;
  const auto f = [&](const State& y, State& dydt, double t) { system.rhs(t, y, dydt); };
  measure(
      state, [&](State& y, double t) { stepper.do_step(f, y, t, h); }, [&] { stepper = Stepper(); });
}

void rhs_alone(benchmark::State& state) {
  const Oscillators system(static_cast<std::size_t>(state.range(0)));
  State y = at_rest(system.size());
  State dydt = y;
  for (auto _ : state) {
    system.rhs(0, y, dydt);
    benchmark::ClobberMemory();
  }
  if (dydt[system.n] != -1) state.SkipWithError("wrong rates");
}

template <class... Arguments>
void add(const std::string& name, Arguments&&... what) {
  benchmark::RegisterBenchmark(name.c_str(), std::forward<Arguments>(what)...)->Arg(2)->Arg(108)->Arg(2000);
}

}  // namespace

int main(int argc, char** argv) {
  add("rhs", rhs_alone);
  for (const furrow::MethodInfo& info : furrow::method_catalogue()) {
    if (!info.dense_jacobian) add("furrow/" + info.name, through_furrow, info.name);
  }
  add("direct/euler", directly<odeint::euler<State>>);
  add("direct/rk4", directly<odeint::runge_kutta4<State>>);
  add("direct/abm2", directly<odeint::adams_bashforth_moulton<2, State>>);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
