// What a contact costs in the first-level cache: the kernel's own loops beside the least that the law could take, two
// square roots, one division and some sixty other operations on whole vectors. FURROW_VECTORS sets the width of both.
// Each benchmark checks its answer: a time for a wrong result is worth nothing.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string_view>

#include "system/kernel.h"

namespace {

using furrow::TouchBlock;

constexpr int contacts = TouchBlock::capacity;
constexpr double radius = 0.01;  // m

void count_contacts(benchmark::State& state) {
  state.counters["s/contact"] =
      benchmark::Counter(contacts, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// A row of discs, each overlapping the next one a little more than the last, all sliding and spinning.
struct Row {
  std::vector<TouchBlock::DiscPair> first, second;
  std::vector<furrow::DiscLoad> load = std::vector<furrow::DiscLoad>(contacts + 1);
  std::unique_ptr<TouchBlock> block = std::make_unique<TouchBlock>();
  furrow::ContactLaw law = furrow::contact_law({2e5, -0.5}, {2e5, -0.5}, 20, 0.5, 0.5, false);
  furrow::ContactModel model{&law, true, true, 1, 1e-2};

  Row() {
    double x = 0;
    for (int i = 0; i <= contacts; ++i) {
      const double vy = 0.01 * (i % 7);
      const double spin = 0.1 * (i % 5);
      first.push_back({-x, 0, 0.02 * (i % 3), vy, spin, radius, 0, 0});
      second.push_back({-x, 0, 0.02 * (i % 3), vy, 0, 0, -spin, -radius});
      x += 2 * radius - 1e-5 * (i + 1);
    }
    block->count = contacts;
    for (int k = 0; k < contacts; ++k) {
      block->a[k] = k;
      block->b[k] = k + 1;
      block->reduced_radius[k] = radius / 2;
      block->reduced_mass[k] = 0.15;
      block->spring[k] = 1e-5 * (k % 11);
    }
  }

  // The law as physics/contact.h states it, contact by contact.
  bool right() const {
    for (int k = 0; k < contacts; ++k) {
      const TouchBlock::DiscPair& p = block->pair[k];
      const double overlap = 2 * radius - std::sqrt(p.dx * p.dx);
      const double arm = radius - 0.5 * overlap;
      const furrow::Touch touch{
          overlap,    p.vx, p.vy + (p.spin_a * arm + p.spin_b * arm), block->spring[k], p.spin_a - p.spin_b,
          radius / 2, 0.15};
      const furrow::TouchForce f = furrow::hertz_mindlin<true>(law, touch, model.rolling_smoothing);
      if (-f.normal != block->fx[k] || f.tangential != block->fy[k]) return false;
      if (arm * f.tangential - f.moment != block->torque_b[k]) return false;
    }
    return true;
  }
};

void law(benchmark::State& state) {
  Row row;
  furrow::kernel().pair_up(*row.block, row.first.data(), row.second.data());
  for (auto _ : state) {
    furrow::kernel().evaluate(*row.block, row.model, false, false);
    benchmark::ClobberMemory();
  }
  if (!row.right()) state.SkipWithError("the kernel's forces are not those of the law");
  count_contacts(state);
}

void whole(benchmark::State& state) {
  Row row;
  for (auto _ : state) {
    std::fill(row.load.begin(), row.load.end(), furrow::DiscLoad{});
    furrow::kernel().pair_up(*row.block, row.first.data(), row.second.data());
    furrow::kernel().evaluate(*row.block, row.model, false, false);
    furrow::kernel().add(*row.block, row.block->b.data(), row.load.data());
    benchmark::ClobberMemory();
  }
  double sum = 0, size = 0;
  for (const furrow::DiscLoad& load : row.load) {
    sum += load.fx;
    size += std::fabs(load.fx);
  }
  // Each force stands twice, with either sign; of some 130 roundings each is below 1.1e-16 of the size.
  if (!row.right() || !(std::fabs(sum) <= 1e-13 * size)) state.SkipWithError("actions and reactions do not cancel");
  count_contacts(state);
}

// ---- the bound ----

struct Numbers {
  alignas(64) double in[4][contacts];
  alignas(64) double out[contacts];
};

[[gnu::always_inline]] inline double least(double a, double b, double c, double d) {
  const double root = std::sqrt(a * b);
  const double second = std::sqrt(root * c);
  const double quotient = d / second;
  double p = quotient, q = root, r = second, s = a;
  for (int i = 0; i < 7; ++i) {  // four chains of fourteen operations
    p = p * a + b;
    q = q * b + c;
    r = r * c + d;
    s = s * d + a;
  }
  return (p + q) + (r + s);
}

[[gnu::always_inline]] inline void bound_lanes(Numbers& n) {
  for (int k = 0; k < contacts; ++k) n.out[k] = least(n.in[0][k], n.in[1][k], n.in[2][k], n.in[3][k]);
}

void bound_none(Numbers& n) { bound_lanes(n); }
#ifdef __x86_64__
[[gnu::target("avx2")]] void bound_avx2(Numbers& n) { bound_lanes(n); }
[[gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] void bound_avx512(Numbers& n) { bound_lanes(n); }
#endif

void bound(benchmark::State& state) {
  auto run = bound_none;
#ifdef __x86_64__
  const std::string_view width = furrow::kernel().name;
  if (width == "avx2") run = bound_avx2;
  if (width == "avx512") run = bound_avx512;
#endif
  const auto numbers = std::make_unique<Numbers>();
  for (int k = 0; k < contacts; ++k) {
    for (int i = 0; i < 4; ++i) numbers->in[i][k] = 0.1 + 0.003 * k + 0.05 * i;
  }
  for (auto _ : state) {
    run(*numbers);
    benchmark::ClobberMemory();
  }
  for (int k = 0; k < contacts; ++k) {
    const auto& in = numbers->in;
    if (numbers->out[k] != least(in[0][k], in[1][k], in[2][k], in[3][k])) state.SkipWithError("lanes differ");
  }
  count_contacts(state);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string width = furrow::kernel().name;
  benchmark::RegisterBenchmark(("bound/" + width).c_str(), bound);
  benchmark::RegisterBenchmark(("law/" + width).c_str(), law);
  benchmark::RegisterBenchmark(("pairs_law_and_sums/" + width).c_str(), whole);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
