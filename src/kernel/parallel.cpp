#include "kernel/parallel.h"

#include <pthread.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <thread>

#include "system/floating_point.h"

namespace furrow {
namespace {

using Clock = std::chrono::steady_clock;

// Steps follow one another within microseconds, and to wake a thread takes longer; what waits longer sleeps.
constexpr auto patience = std::chrono::microseconds(20);

// The threads of the process. Each has a share of the pieces and takes from the others' when it is done, the caller
// too: a thread that the machine does not run holds up nobody but for the piece that it is at.
class Pool {
 public:
  static constexpr int most = 128;  // threads
  static constexpr int most_pieces = (1 << 20) - 1;

  void run(int threads, int pieces, void (*work)(void*, int, int), void* argument) {
    const std::unique_lock alone(callers_, std::try_to_lock);
    if (!alone || pieces > most_pieces) {  // they are at another caller's work, or a share's word has no room
      for (int k = 0; k < pieces; ++k) work(argument, k, 0);
      return;
    }
    threads = std::min({threads, pieces, most});
    while (started_ < threads) start(started_++);
    const std::uint64_t job = (job_.load(std::memory_order_relaxed) / most + 1) % (1U << 24U);
    work_ = work;
    argument_ = argument;
    left_.store(pieces, std::memory_order_relaxed);
    for (int k = 0; k < threads; ++k) {
      const auto first = static_cast<std::uint64_t>(pieces) * k / threads;
      const auto last = static_cast<std::uint64_t>(pieces) * (k + 1) / threads;
      share_[k].word.store(job << 40U | last << 20U | first, std::memory_order_release);
    }
    job_.store(static_cast<std::uint32_t>(job) * most + (threads - 1), std::memory_order_release);
    job_.notify_all();
    take_part(job, 0, threads);
    wait_while(left_, [](int left) { return left > 0; });
  }

 private:
  // The next piece and the end of a thread's share, and the job that they belong to, in one word: so no thread that
  // comes late takes a piece of a job that it does not know.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> word{0};  // job: 24 bits, end: 20, next: 20
  };

  template <class Number, class Waits>
  static void wait_while(const std::atomic<Number>& number, Waits waits) {
    const auto until = Clock::now() + patience;
    for (Number seen = number.load(std::memory_order_acquire); waits(seen);
         seen = number.load(std::memory_order_acquire)) {
      if (Clock::now() > until) number.wait(seen, std::memory_order_acquire);
    }
  }

  // -1: none is left.
  int take(std::uint64_t job, Share& share) {
    std::uint64_t word = share.word.load(std::memory_order_acquire);
    for (;;) {
      const std::uint64_t next = word & 0xfffffU, end = word >> 20U & 0xfffffU;
      if (word >> 40U != job || next >= end) return -1;
      if (share.word.compare_exchange_weak(word, word + 1, std::memory_order_acq_rel)) return static_cast<int>(next);
    }
  }

  // As long as a piece is taken and not done, the job lasts: work_ and argument_ are its own.
  void take_part(std::uint64_t job, int thread, int threads) {
    for (int k = 0; k < threads; ++k) {
      Share& share = share_[(thread + k) % threads];
      for (int piece = take(job, share); piece >= 0; piece = take(job, share)) {
        work_(argument_, piece, thread);
        if (left_.fetch_sub(1, std::memory_order_acq_rel) == 1) left_.notify_one();
      }
    }
  }

  void serve(int thread) {
    const DefaultFloatingPoint environment;  // a thread starts with its creator's
    std::uint32_t known = 0;
    for (;;) {
      wait_while(job_, [known](std::uint32_t job) { return job == known; });
      known = job_.load(std::memory_order_acquire);
      const int threads = static_cast<int>(known % most) + 1;
      if (thread < threads) take_part(known / most, thread, threads);
    }
  }

  // Signals are for the threads that the caller knows. The thread ends with the process.
  void start(int thread) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread([this, thread] { serve(thread); }).detach();
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  std::mutex callers_;
  int started_ = 1;                    // with the caller
  std::atomic<std::uint32_t> job_{0};  // its number times `most`, and its threads less one
  std::atomic<int> left_{0};           // pieces not done
  std::array<Share, most> share_;
  void (*work_)(void*, int, int) = nullptr;
  void* argument_ = nullptr;
};

}  // namespace

void distribute(int threads, int pieces, void (*work)(void*, int piece, int thread), void* argument) {
  static auto* const pool = new Pool;  // never destroyed: its threads may outlive all that is
  const DefaultFloatingPoint environment;
  pool->run(threads, pieces, work, argument);
}

}  // namespace furrow
