// Time of one evaluation of the right-hand side, of one jump and of one step of the paper's method, for each scene of
// the paper where it stands at t = 0. Each benchmark checks its answer: a time for a wrong result is worth nothing.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>

#include "run/events.h"
#include "run/prepare.h"
#include "run/run.h"
#include "scene/read.h"

namespace {

furrow::Scene scene_of(const std::string& name, bool energy) {
  furrow::Scene scene =
      furrow::read_scene(std::filesystem::path(FURROW_SOURCE_DIR) / "validation/scenes" / (name + ".toml"));
  scene.output.energy = energy;
  return scene;
}

// Prepared once a scene: settling takes longer than all else.
const furrow::Prepared& prepared(const std::string& name, bool energy) {
  static std::map<std::pair<std::string, bool>, furrow::Prepared> all;
  const auto key = std::make_pair(name, energy);
  if (const auto found = all.find(key); found != all.end()) return found->second;
  return all.emplace(key, furrow::prepare(scene_of(name, energy))).first->second;
}

void count_discs(benchmark::State& state, const furrow::System& system) {
  if (const int discs = system.parts().disc.count(); discs > 0) {
    state.counters["s/disc"] =
        benchmark::Counter(discs, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  }
}

void rhs(benchmark::State& state, const std::string& name, bool energy) {
  furrow::Prepared p = prepared(name, energy);
  p.system.jump(0, p.y);
  furrow::State first(p.y.size());
  furrow::State again(p.y.size());
  p.system.rhs(0, p.y, first);
  for (auto _ : state) {
    p.system.rhs(0, p.y, again);
    benchmark::ClobberMemory();
  }
  if (first != again) state.SkipWithError("the right-hand side is not pure");
  count_discs(state, p.system);
}

void jump(benchmark::State& state, const std::string& name) {
  furrow::Prepared p = prepared(name, false);
  p.system.jump(0, p.y);
  const furrow::State before = p.y;
  for (auto _ : state) benchmark::DoNotOptimize(p.system.jump(0, p.y));
  if (before != p.y) state.SkipWithError("a second jump from the same state changed it");
  count_discs(state, p.system);
}

void step(benchmark::State& state, const std::string& name) {
  furrow::Prepared p = prepared(name, false);
  const double h = scene_of(name, false).time.step;
  const auto method = furrow::make_method("pece");
  long n = 0;
  p.system.jump(0, p.y);
  for (auto _ : state) {
    method->step(p.system, static_cast<double>(n) * h, p.y, h);
    ++n;
    furrow::jump(p.system, *method, static_cast<double>(n) * h, p.y);
    if (n == 10'000) {  // the first second of the scene, over and over
      state.PauseTiming();
      p = prepared(name, false);
      method->restart();
      p.system.jump(0, p.y);
      n = 0;
      state.ResumeTiming();
    }
  }
  for (const double value : p.y) {
    if (!std::isfinite(value)) state.SkipWithError("the run diverged");
  }
  count_discs(state, p.system);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::string name : {"scenario_1", "scenario_2", "scenario_3"}) {
    benchmark::RegisterBenchmark(("rhs/" + name).c_str(), rhs, name, false);
    benchmark::RegisterBenchmark(("rhs_with_ledger/" + name).c_str(), rhs, name, true);
    benchmark::RegisterBenchmark(("jump/" + name).c_str(), jump, name);
    benchmark::RegisterBenchmark(("step_pece/" + name).c_str(), step, name);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
