// No step takes memory once a run is under way: not the method, not the contacts, not a new neighbour list. In a
// program of its own, for it counts every call of operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>

#include "kernel/kernel.h"
#include "methods/method.h"
#include "run/events.h"
#include "tests/unit/scenes.h"

namespace {
std::atomic<long> taken{0};  // calls of operator new

void* take(std::size_t bytes, std::size_t alignment) {
  ++taken;
  // aligned_alloc wants whole multiples of the alignment.
  if (void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)) return memory;
  throw std::bad_alloc();
}
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t bytes) { return take(bytes, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t a) {
  return take(bytes, static_cast<std::size_t>(a));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace furrow {
namespace {

using namespace test;

constexpr double h = 1e-4;  // s
constexpr long window = 1000;

struct Memory {
  long taken, rebuilds;
};

// What `window` steps take, after the same motion has shown once how much room it needs: contacts come and go, and an
// array may grow the first time that it holds so many.
Memory of_steps(const Scene& scene, const std::string& name) {
  System system(scene);
  const auto method = make_method(name);
  const State start = system.initial_state();
  State y = start;
  const auto go = [&] {
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = start[k];
    for (long n = 0; n < window; ++n) {
      const double t = static_cast<double>(n) * h;
      method->step(system, t, y, h);
      jump(system, *method, t + h, y);
    }
  };
  go();
  const long before = taken, rebuilds = furrow::kernel_of(system.solver()).search().rebuilds;
  go();
  return {taken - before, furrow::kernel_of(system.solver()).search().rebuilds - rebuilds};
}

class Steps : public testing::TestWithParam<const char*> {};

TEST_P(Steps, OfDiscsPlateAndLatticeTakeNoMemory) {
  Scene scene = busy_scene();
  scene.lattice[0].structural.strength = scene.lattice[0].shear.strength = 1e9;  // N: a torn link may be reported
  const Memory memory = of_steps(scene, GetParam());
  EXPECT_GT(memory.rebuilds, 3) << "or new neighbour lists are not among what was tried";
  EXPECT_EQ(memory.taken, 0);
}

TEST(CountOfMemory, SeesEveryAllocation) {
  const long before = taken;
  const State a(10);
  const auto b = std::make_unique<double>(1);
  EXPECT_EQ(taken - before, 2) << a.size() << *b;
}

INSTANTIATE_TEST_SUITE_P(Methods, Steps, testing::Values("pece", "symplectic_euler", "verlet", "rk4"),
                         [](const auto& method) { return std::string(method.param); });

}  // namespace
}  // namespace furrow
