// Threads share the work of a step, and change no bit of it.
#include "kernel/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

#include "kernel/kernel.h"
#include "run/run.h"
#include "scenes.h"
#include "system/place.h"

namespace furrow {
namespace {

using namespace test;

TEST(Parallel, EveryPieceIsDoneOnce) {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> done(37);
    std::atomic<bool> strange = false;  // a thread of another number
    in_parallel(threads, 37, [&](int piece, int thread) {
      ++done[piece];
      if (thread < 0 || thread >= threads) strange = true;
    });
    for (const auto& times : done) EXPECT_EQ(times, 1) << threads;
    EXPECT_FALSE(strange);
  }
}

TEST(Parallel, RangesCoverAllOnce) {
  for (const int threads : {1, 3}) {
    for (const std::size_t count : {0ul, 1ul, 32768ul, 100000ul}) {
      std::vector<int> times(count, 0);
      in_ranges(threads, count, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) ++times[i];
      });
      EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<long>(count));
    }
  }
}

// Rows of discs that overlap a little and move at random; neighbours have distant numbers: `order` gives the number of
// the disc at each place.
Scene large_bed(const std::vector<int>& order, int first_place = 0, int places = -1) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.friction = 0.4;
  scene.contact.rolling_friction = 0.1;
  scene.wall = {wall({0, 0}, {0, 1})};
  std::mt19937_64 random(3);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  scene.disc.resize(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    const double x = 0.0198 * static_cast<double>(place % 100);
    const auto row = place / 100;
    const double y = 0.0098 + 0.0198 * static_cast<double>(row);
    const double radius = between(0.0095, 0.0105), spin = between(-50, 50), vx = between(-1, 1), vy = between(-1, 1);
    scene.disc[order[place]] = disc({x, y}, radius, {vx, vy}, spin);
  }
  if (places < 0) return scene;
  std::vector<Disc> some;
  for (int place = first_place; place < first_place + places; ++place) some.push_back(scene.disc[order[place]]);
  scene.disc = some;
  return scene;
}

std::vector<int> shuffled(int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(5);
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
  return order;
}

TEST(Threads, ChangeNoBitOfARun) {
  std::vector<State> ends;
  for (const int threads : {1, 2, 3}) {
    Scene scene = large_bed(shuffled(2 * discs_per_block + 100));
    scene.search.threads = threads;
    System system(scene);
    EXPECT_EQ(system.threads(), threads);
    State y = system.initial_state();
    const RunEnd end = run(system, *make_method("pece"), y, {.start = 0, .end = 2e-3, .step = 2e-5, .stop = {}},
                           [](double, const State&, const JumpReport&) { return true; });
    EXPECT_EQ(end.ending, Ending::finished) << end.reason;
    EXPECT_EQ(kernel_of(system.solver()).search().blocks.size(), 3u);
    EXPECT_GT(kernel_of(system.solver()).search().rebuilds, 2);
    EXPECT_GT(kernel_of(system.solver()).search().contributions, 50) << "of discs along two borders, each some 64 long";
    ends.push_back(y);
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
}

TEST(Threads, AreNotUsedForASmallBed) {
  Scene scene = busy_scene();
  scene.search.threads = 2;
  EXPECT_EQ(System(scene).threads(), 1);
}

// The forces on the lower rows are those of a bed small enough for one block, but for the order of their sums: some ten
// terms, each rounded by at most 1.1e-16 of the largest.
TEST(Threads, ManyBlocksGiveTheForcesOfOne) {
  const std::vector<int> order = shuffled(2 * discs_per_block);
  const int lower = 3000;
  System whole(large_bed(order));
  System part(large_bed(order, 0, lower));
  State y = whole.initial_state(), y_part = part.initial_state();
  whole.jump(0, y);
  part.jump(0, y_part);
  State rates(y.size()), rates_part(y_part.size());
  whole.rhs(1e-9, y, rates);
  part.rhs(1e-9, y_part, rates_part);
  const std::vector<int> stored = places_in(whole.parts().disc.number);
  double largest = 0;
  for (int place = 0; place < lower; ++place) largest = std::max(largest, std::fabs(rates_part[part.vx_of(place)]));
  EXPECT_GT(largest, 1);
  for (int place = 0; place < lower - 200; ++place) {  // the last rows have no neighbours above them in the part
    EXPECT_NEAR(rates[whole.vx_of(stored[order[place]])], rates_part[part.vx_of(place)], 2e-15 * largest) << place;
    EXPECT_NEAR(rates[whole.vy_of(stored[order[place]])], rates_part[part.vy_of(place)], 2e-15 * largest) << place;
  }
  EXPECT_EQ(kernel_of(part.solver()).search().blocks.size(), 1u);
}

}  // namespace
}  // namespace furrow
