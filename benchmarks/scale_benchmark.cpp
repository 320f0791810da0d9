// From the paper's bed to a million discs: what an evaluation and a step of the paper's method cost a disc, what memory
// a disc takes, and how long the program needs to pack and settle large beds by itself. The beds are wider than the
// paper's second scene, not deeper. For evaluations and steps its settled bed is put side by side, for packing and
// settling the box is made wider. Without the energy ledger. Each benchmark checks its answer.
//
// Memory is the most that the process has held, so each size needs a process of its own: scripts/scale.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "benchmarks/measuring/made_by.h"
#include "benchmarks/tracking/kernels.h"
#include "kernel/kernel.h"
#include "methods/method.h"
#include "output/machine.h"
#include "run/events.h"
#include "run/prepare.h"
#include "scene/packing.h"
#include "system/place.h"

namespace {

namespace fs = std::filesystem;
namespace benchmarks = furrow::benchmarks;

constexpr int tile = 230;  // discs of the paper's second scene

// Numbers of threads to measure with.
const std::vector<int> workers{1, 2};

struct Bed {
  explicit Bed(const furrow::Scene& scene) : step(scene.time.step), system(scene), y(system.initial_state()) {
    system.jump(0, y);
    rates.resize(y.size());
  }
  double step;  // s
  furrow::System system;
  furrow::State y, rates;
  std::vector<int> number{};  // of each disc of the tiles; empty: as they lie
  int discs() const { return system.parts().disc.count(); }
};

// The paper's bed, settled, as often as needed for so many discs.
const furrow::Scene& side_by_side(long discs) {
  static std::map<long, furrow::Scene> all;
  if (const auto found = all.find(discs); found != all.end()) return found->second;
  const fs::path beds = fs::temp_directory_path() / ("furrow_scale_" + std::to_string(getpid()));
  benchmarks::make_beds(beds);
  furrow::Scene scene = benchmarks::with_bed(benchmarks::paper_scene("scenario_2"), beds / "scenario_2");
  fs::remove_all(beds);
  scene.output.energy = false;
  return all[discs] = benchmarks::repeated(scene, static_cast<int>(discs + tile - 1) / tile);
}

Bed bed_of(const benchmark::State& state) {
  furrow::Scene scene = side_by_side(state.range(0));
  scene.search.threads = static_cast<int>(state.range(1));
  return Bed(scene);
}

// The same, numbered as a random packing numbers its discs: without regard to where they lie.
Bed bed_in_random_order(const benchmark::State& state) {
  furrow::Scene scene = side_by_side(state.range(0));
  const std::vector<furrow::Disc> lying = scene.disc;
  std::vector<int> number(lying.size());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937_64 random(1);
  for (std::size_t k = number.size(); k > 1; --k) std::swap(number[k - 1], number[random() % k]);
  for (std::size_t k = 0; k < number.size(); ++k) scene.disc[number[k]] = lying[k];
  scene.search.threads = static_cast<int>(state.range(1));
  Bed bed(scene);
  bed.number = number;
  return bed;
}

// For `times` evaluations or steps an iteration.
void count(benchmark::State& state, int discs) {
  using benchmark::Counter;
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  state.counters["discs"] = discs;
  state.counters["s/disc"] = Counter(discs, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["per_second"] = Counter(1, Counter::kIsIterationInvariantRate);
  state.counters["peak_bytes/disc"] = 1024.0 * static_cast<double>(used.ru_maxrss) / discs;
}

// m/s^2: how much the accelerations of two tiles within the bed differ, which lie alike but for the last bits of x.
double difference(const Bed& bed) {
  const int one = tile;
  const int other = bed.discs() - 2 * tile;
  double greatest = 0;
  const std::vector<int> place = furrow::places_in(bed.system.parts().disc.number);
  for (int i = 0; i < tile; ++i) {
    for (const auto at : {&furrow::System::vx_of, &furrow::System::vy_of}) {
      const auto rate = [&](int disc) {
        return bed.rates[(bed.system.*at)(place[bed.number.empty() ? disc : bed.number[disc]])];
      };
      greatest = std::max(greatest, std::fabs(rate(one + i) - rate(other + i)));
    }
  }
  return greatest;
}
constexpr double alike = 1e-5;  // m/s^2: x is known to 5e-13 m at 2.6 km, omega^2 is below 1e6 /s^2; g is 9.81

void evaluate(benchmark::State& state, Bed bed) {
  bed.system.rhs(0, bed.y, bed.rates);
  for (auto _ : state) bed.system.rhs(0, bed.y, bed.rates);
  if (!(difference(bed) <= alike)) state.SkipWithError("equal tiles are not accelerated alike");
  count(state, bed.discs());
}

void evaluation(benchmark::State& state) { evaluate(state, bed_of(state)); }
void evaluation_in_random_order(benchmark::State& state) { evaluate(state, bed_in_random_order(state)); }

// The whole bed jumps up by half a metre and down again, so that no neighbour list outlives an evaluation.
void evaluation_with_new_list(benchmark::State& state) {
  Bed bed = bed_of(state);
  double height = 0.5;  // m
  const long before = furrow::kernel_of(bed.system.solver()).search().rebuilds;
  for (auto _ : state) {
    for (int i = 0; i < bed.discs(); ++i) bed.y[bed.system.y_of(i)] += height;
    height = -height;
    bed.system.rhs(0, bed.y, bed.rates);
  }
  if (furrow::kernel_of(bed.system.solver()).search().rebuilds - before != static_cast<long>(state.iterations()))
    state.SkipWithError("an evaluation went without a new list");
  count(state, bed.discs());
}

void step(benchmark::State& state) {
  Bed bed = bed_of(state);
  const auto method = furrow::make_method("pece");
  long steps = 0;
  const auto once = [&] {
    method->step(bed.system, static_cast<double>(steps) * bed.step, bed.y, bed.step);
    ++steps;
    furrow::jump(bed.system, *method, static_cast<double>(steps) * bed.step, bed.y);
  };
  for (int k = 0; k < 3; ++k) once();  // finds room for its history
  for (auto _ : state) once();
  bed.system.rhs(static_cast<double>(steps) * bed.step, bed.y, bed.rates);
  for (const double value : bed.y) {
    if (!std::isfinite(value)) state.SkipWithError("diverged");
  }
  if (!(difference(bed) <= 1)) state.SkipWithError("equal tiles do not move alike");
  count(state, bed.discs());
}

// ---- the bed, made by the program itself ----

furrow::Scene wide(long discs) {
  furrow::Scene scene = benchmarks::paper_scene("scenario_2");
  furrow::Packing& packing = scene.packing.at(0);
  const double times = static_cast<double>(discs) / tile;
  packing.count = static_cast<int>(discs);
  packing.upper_right.x *= times;
  scene.wall.back().point.x *= times;
  scene.plate.clear();
  scene.output.energy = false;
  return scene;
}

void packing(benchmark::State& state) {
  const furrow::Scene scene = wide(state.range(0));
  std::size_t discs = 0;
  for (auto _ : state) discs = furrow::place_packings(scene).disc.size();
  if (discs != static_cast<std::size_t>(state.range(0))) state.SkipWithError("not all discs are there");
  count(state, static_cast<int>(discs));
}

// What the floor and the side walls carry, of the weight of all discs.
double share_carried(const furrow::Prepared& p) {
  double carried = 0, weight = 0;
  p.system.for_each_contact(0, p.y, [&](const furrow::Contact& c) {
    if (c.id.kind != furrow::disc_wall) return;
    carried += c.fy;
  });
  for (const double mass : p.system.parts().disc.mass) weight += mass * p.system.gravity();
  return carried / weight;
}

// Until no more than one disc in a thousand has been faster than 50 mm/s for a tenth of a second: at the paper's step
// forces chatter, so that the fastest of very many discs never is at rest.
void settling(benchmark::State& state) {
  furrow::Scene scene = wide(state.range(0));
  scene.settle = furrow::Settle{.speed = 0.05, .hold = 0.1, .step = {}, .limit = 20, .loose = 0.001};
  scene.search.threads = static_cast<int>(state.range(1));
  double carried = 0;
  try {
    for (auto _ : state) {
      const furrow::Prepared p = furrow::prepare(scene);
      carried = share_carried(p);
      state.counters["model_seconds"] = p.settling_time;
      state.counters["steps"] = static_cast<double>(p.settling_steps);
      state.counters["surface"] = p.surface.value_or(0);
    }
  } catch (const furrow::Divergence& failure) {
    return state.SkipWithError(failure.what());
  }
  // Where no speed changes by more than 2 x 50 mm/s in a tenth of a second, the mean acceleration is below a tenth of
  // g.
  if (!(std::fabs(carried - 1) < 0.1)) state.SkipWithError("the walls do not carry the bed's weight");
  count(state, static_cast<int>(state.range(0)));
}

void add(const char* name, void (*run)(benchmark::State&), const std::vector<long>& sizes, bool once) {
  for (const long discs : sizes) {
    for (const int threads : run == packing ? std::vector{1} : workers) {
      auto* one = benchmark::RegisterBenchmark(name, run)->ArgNames({"discs", "workers"})->Args({discs, threads});
      one->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
      if (once) one->Iterations(1)->Repetitions(1);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<long> sizes{2'300, 23'000, 230'000, 1'000'000};
  add("evaluation", evaluation, sizes, false);
  add("evaluation_in_random_order", evaluation_in_random_order, sizes, false);
  add("evaluation_with_new_list", evaluation_with_new_list, sizes, false);
  add("step", step, sizes, false);
  add("packing", packing, sizes, true);
  add("settling", settling, sizes, true);
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("machine", furrow::processor_name());
  benchmark::AddCustomContext("made_by", furrow::benchmarks::made_by().dump());
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
