// The pieces of a parallel loop: each done once, whoever else works, and nobody burns time while there are none.
#include "kernel/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <ctime>
#include <thread>
#include <vector>

namespace furrow {
namespace {

TEST(InParallel, EachPieceIsDoneOnceByAThreadThatIsThere) {
  for (const int threads : {2, 3, 7}) {
    for (const int pieces : {2, 3, 16, 1001}) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(pieces));
      std::atomic<int> strangers = 0;
      in_parallel(threads, pieces, [&](int piece, int thread) {
        ++done[piece];
        if (thread < 0 || thread >= threads) ++strangers;
      });
      EXPECT_EQ(strangers, 0);
      for (const auto& count : done) ASSERT_EQ(count, 1);
    }
  }
}

// Each loop must be over when the next begins: a piece of an earlier one would find what it works on gone.
TEST(InParallel, OneLoopEndsBeforeTheNextBegins) {
  for (int loop = 0; loop < 20'000; ++loop) {
    std::vector<int> sum(5, 0);
    in_parallel(2 + loop % 3, 5, [&](int piece, int /*thread*/) { sum[piece] += loop; });
    ASSERT_EQ(sum, std::vector<int>(5, loop));
  }
}

TEST(InParallel, SeveralCallersAtOnceAllGetTheirPieces) {
  std::vector<std::thread> callers;
  std::vector<int> right(4, 0);
  for (std::size_t caller = 0; caller < right.size(); ++caller) {
    callers.emplace_back([&right, caller] {
      for (int loop = 0; loop < 2000; ++loop) {
        std::atomic<int> done = 0;
        in_parallel(3, 10, [&](int piece, int /*thread*/) { done += piece; });
        if (done == 45) ++right[caller];
      }
    });
  }
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(right, std::vector<int>(4, 2000));
}

// clock() counts all threads of the process. Twenty microseconds of patience each; 20 ms leaves room for the system's own.
TEST(InParallel, ThreadsWithoutWorkSleep) {
  in_parallel(4, 64, [](int /*piece*/, int /*thread*/) {});
  const std::clock_t before = std::clock();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 0.02);
}

}  // namespace
}  // namespace furrow
