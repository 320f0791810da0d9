// What a contact costs in the first-level cache: the law from overlap to forces, and all of an evaluation, beside the
// least that the law could take, two square roots, one division and some sixty other operations on whole vectors.
// FURROW_VECTORS sets the width of all. Each benchmark checks its answer: a time for a wrong result is worth nothing.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string_view>

#include "benchmarks/measuring/made_by.h"
#include "kernel/loops.h"
#include "kernel/wide.h"
#include "output/machine.h"

namespace {

using furrow::TouchBatch;

constexpr int contacts = TouchBatch::capacity;
constexpr double radius = 0.01;  // m

void count_contacts(benchmark::State& state) {
  state.counters["s/contact"] =
      benchmark::Counter(contacts, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// A piece of a bed: discs in rows of eight, each in touch with six, thus three pairs a disc, all sliding and spinning.
struct Patch {
  static constexpr int a_row = 8, discs = contacts / 3 + 2 * a_row;
  std::vector<double> x, y, vx, vy, spin;
  std::vector<furrow::DiscRow> rows = std::vector<furrow::DiscRow>(discs);
  std::vector<furrow::DiscLoad> load = std::vector<furrow::DiscLoad>(discs);
  std::vector<double> spring = std::vector<double>(contacts + 1), rate = spring;  // the last one is the dummy
  std::unique_ptr<TouchBatch> batch = std::make_unique<TouchBatch>();
  furrow::ContactLaw law = furrow::contact_law({2e5, -0.5}, {2e5, -0.5}, 20, 0.5, 0.5);
  furrow::ContactModel model{&law, true, true, 1e-2};

  Patch() {
    constexpr double distance = 1.96 * radius;
    for (int i = 0; i < discs; ++i) {
      const int row = i / a_row;
      x.push_back(distance * (i % a_row + 0.5 * row) + 1e-5 * (i % 11));
      y.push_back(distance * std::sqrt(0.75) * row);
      vx.push_back(2e-4 * (i % 3));
      vy.push_back(1e-4 * (i % 7));
      spin.push_back(1e-3 * (i % 5));
    }
    TouchBatch& c = *batch;
    for (int i = 0; c.count < contacts; ++i) {
      for (const int step : {1, a_row - 1, a_row}) {
        const bool leaves_row = (step == 1 && i % a_row == a_row - 1) || (step == a_row - 1 && i % a_row == 0);
        if (leaves_row || c.count == contacts) continue;
        c.own_slot[c.count] = (37 * c.count) % contacts;  // slots in no order
        c.own_a[c.count] = i;
        c.own_b[c.count++] = i + step;
      }
    }
    c.use_own();
    c.radius_a.fill(radius);
    c.radius_b.fill(radius);
    c.reduced_radius.fill(radius / 2);
    c.reduced_mass.fill(0.15);
    for (int k = 0; k < contacts; ++k) spring[k] = 1e-5 * (k % 11);
  }

  void gather() {
    furrow::interleave(x.data(), y.data(), vx.data(), vy.data(), rows.data(), 0, rows.size());
    furrow::locate_pairs(*batch, {rows.data(), spin.data(), nullptr, 0.5, 1, 0});
    furrow::gather_springs(*batch, spring.data(), contacts);
  }

  // The law as physics/contact.h states it, contact by contact.
  bool right() const {
    int pushing = 0;
    for (int k = 0; k < contacts; ++k) {
      const int a = batch->a[k], b = batch->b[k];
      const double dx = x[b] - x[a], dy = y[b] - y[a];
      const double distance = std::sqrt(dx * dx + dy * dy), overlap = 2 * radius - distance;
      const double nx = dx / distance, ny = dy / distance, arm = radius - 0.5 * overlap;
      const double relative_x = vx[a] - vx[b], relative_y = vy[a] - vy[b];
      const furrow::Touch touch{overlap,
                                relative_x * nx + relative_y * ny,
                                relative_y * nx - relative_x * ny + (spin[a] * arm + spin[b] * arm),
                                spring[batch->slot[k]],
                                spin[a] - spin[b],
                                radius / 2,
                                0.15};
      const furrow::TouchForce f = furrow::hertz_mindlin(law, touch, model.rolling_smoothing);
      pushing += f.normal > 0 ? 1 : 0;
      if (-f.normal * nx - f.tangential * ny != batch->fx[k]) return false;
      if (-f.normal * ny + f.tangential * nx != batch->fy[k]) return false;
      if (arm * f.tangential - f.moment != batch->torque_b[k]) return false;
      if (touch.slip != batch->slip[k]) return false;
    }
    return pushing > contacts / 2;
  }
};

void law(benchmark::State& state) {
  Patch bed;
  bed.gather();
  for (auto _ : state) {
    furrow::evaluate(*bed.batch, bed.model, {.returning = false, .all_fields = false});
    benchmark::ClobberMemory();
  }
  if (!bed.right()) state.SkipWithError("the kernel's forces are not those of the law");
  count_contacts(state);
}

void whole(benchmark::State& state) {
  Patch bed;
  for (auto _ : state) {
    std::fill(bed.load.begin(), bed.load.end(), furrow::DiscLoad{});
    bed.gather();
    furrow::evaluate(*bed.batch, bed.model, {.returning = false, .all_fields = false});
    furrow::add_loads(*bed.batch, bed.batch->b, bed.load.data());
    furrow::scatter_to_slots(*bed.batch, bed.batch->slip, bed.rate.data());
    benchmark::ClobberMemory();
  }
  double sum = 0, size = 0;
  for (const furrow::DiscLoad& load : bed.load) {
    sum += load.fx;
    size += std::fabs(load.fx);
  }
  for (int k = 0; k < contacts; ++k) {
    if (bed.rate[bed.batch->slot[k]] != bed.batch->slip[k]) state.SkipWithError("a spring has another's rate");
  }
  // Each force stands twice, with either sign; of some 400 roundings each is below 1.1e-16 of the size.
  if (!bed.right() || !(std::fabs(sum) <= 1e-13 * size)) state.SkipWithError("actions and reactions do not cancel");
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
  const std::string_view width = furrow::vector_width_name();
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
  const std::string width = furrow::vector_width_name();
  benchmark::RegisterBenchmark(("bound/" + width).c_str(), bound);
  benchmark::RegisterBenchmark(("law/" + width).c_str(), law);
  benchmark::RegisterBenchmark(("pairs_law_and_sums/" + width).c_str(), whole);
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("machine", furrow::processor_name());
  benchmark::AddCustomContext("made_by", furrow::benchmarks::made_by().dump());
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
