// One System may be asked by several threads at once: the same bits as one after the other. The preset thread_sanitizer
// builds this alone and lets the sanitizer judge.
#include <gtest/gtest.h>

#include <thread>

#include "run/run.h"
#include "tests/unit/scenes.h"

namespace furrow {
namespace {

using namespace test;

class SharedSystem : public testing::TestWithParam<SolverKind> {};
INSTANTIATE_TEST_SUITE_P(Solvers, SharedSystem, testing::Values(SolverKind::kernel, SolverKind::reference),
                         [](const auto& of) { return of.param == SolverKind::kernel ? "kernel" : "reference"; });

// States far apart, so that each asks for neighbour lists of its own.
std::vector<State> states_of(const Scene& scene) {
  std::vector<State> states;
  for (int k = 0; k < 4; ++k) {
    System system(scene);
    State y = system.initial_state();
    run(system, *make_method("rk4"), y, {.start = 0, .end = 1e-3 * (1 + 10 * k), .step = 1e-4, .stop = {}},
        [](double, const State&, const JumpReport&) { return true; });
    states.push_back(y);
  }
  return states;
}

TEST_P(SharedSystem, IsAskedByFourThreadsAtOnce) {
  Scene scene = busy_scene();
  scene.time.solver = GetParam();
  const std::vector<State> states = states_of(scene);
  const System system(scene);
  const auto rates_at = [&](const State& y) {
    State rates(y.size());
    system.rhs(0.01, y, rates);
    return rates;
  };
  std::vector<State> want;
  for (const State& y : states) want.push_back(rates_at(y));
  EXPECT_NE(want[0], want[3]);

  std::vector<int> wrong(states.size(), 0);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < states.size(); ++k) {
    threads.emplace_back([&, k] {
      for (int n = 0; n < 50; ++n) {
        if (rates_at(states[k]) != want[k]) ++wrong[k];
        long touching = 0;
        system.for_each_contact(0.01, states[k], [&](const Contact& /*contact*/) { ++touching; });
        if (touching == 0) ++wrong[k];
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(states.size(), 0));
}

}  // namespace
}  // namespace furrow
