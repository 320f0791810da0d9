// Two worlds that differ only in threads, in the width of the vectors or in the settings of the neighbour lists are
// compared after every step, body by body, to the bit (as Jolt's determinism tests do). A failure says after which
// step, of which body and which number.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "kernel/kernel.h"
#include "output/checkpoint.h"
#include "system/place.h"
#include "tests/property/differences.h"
#include "worlds.h"

namespace furrow {
namespace {

using namespace test;

// Snapshots of a world, one after the other.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::optional<Snapshot> next() = 0;
};

class Here final : public Source {
 public:
  Here(BedKind kind, const Setting& setting, const std::string& method) : world_(kind, setting, method) {}
  std::optional<Snapshot> next() override {
    if (started_) world_.step();
    started_ = true;
    return world_.now();
  }

 private:
  World world_;
  bool started_ = false;
};

// In a process of its own.
class Elsewhere final : public Source {
 public:
  Elsewhere(BedKind kind, const Setting& s, const std::string& method, int steps) {
    std::vector<std::string> words{FURROW_WORLD_STEPS,
                                   kind == BedKind::full ? "full" : "elastic",
                                   method,
                                   std::to_string(steps),
                                   std::to_string(s.threads),
                                   shortest(s.skin),
                                   shortest(s.cell_size)};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    child_ = fork();
    if (child_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      close(ends[1]);
      setenv("FURROW_VECTORS", s.vectors.c_str(), 1);
      execv(arguments[0], arguments.data());
      _exit(127);
    }
    close(ends[1]);
    stream_ = fdopen(ends[0], "rb");
  }
  ~Elsewhere() override {
    std::fclose(stream_);
    waitpid(child_, nullptr, 0);
  }

  std::optional<Snapshot> next() override {
    std::uint64_t length = 0;
    if (std::fread(&length, sizeof length, 1, stream_) != 1) return std::nullopt;
    std::string bytes(length, '\0');
    if (std::fread(bytes.data(), length, 1, stream_) != 1) return std::nullopt;
    Snapshot at;
    HistoryReader reader(bytes);
    at.history(reader);
    return at;
  }

 private:
  pid_t child_ = 0;
  FILE* stream_ = nullptr;
};

std::unique_ptr<Source> source_of(BedKind kind, const Setting& setting, const std::string& method, int steps) {
  if (setting.vectors.empty()) return std::make_unique<Here>(kind, setting, method);
  return std::make_unique<Elsewhere>(kind, setting, method, steps);
}

// Empty if the bits are the same.
std::string difference(const Snapshot& one, const Snapshot& other, System& at_one, System& at_other,
                       const Sides& sides) {
  if (!same_bits(one.t, other.t)) return differing("the time", sides, one.t, other.t);
  at_one.restore(one.discrete);
  at_other.restore(other.discrete);
  const std::string found = test::difference(at_one, one.y, at_other, other.y, sides);
  // What another process sends has no border: it follows from the torn links.
  return found.empty() ? test::difference(at_one.discrete_state(), at_other.discrete_state(), sides) : found;
}

struct Comparison {
  BedKind kind = BedKind::full;
  std::string method = "pece";
  int steps = 12;
  Setting one{}, other{};
};

std::string first_difference(const Comparison& c) {
  const auto one = source_of(c.kind, c.one, c.method, c.steps), other = source_of(c.kind, c.other, c.method, c.steps);
  System at_one(bed(c.kind, c.one)), at_other(bed(c.kind, c.other));  // to name the numbers by
  const Sides sides{to_string(c.one), to_string(c.other)};
  for (int n = 0; n <= c.steps; ++n) {
    const std::string after = c.method + ", after step " + std::to_string(n) + ": ";
    const std::optional<Snapshot> left = one->next(), right = other->next();
    if (!left || !right) return after + (left ? sides.other : sides.one) + " has ended";
    const std::string found = difference(*left, *right, at_one, at_other, sides);
    if (!found.empty()) return after + found;
  }
  return {};
}

TEST(EveryStep, ThreadsChangeNoBit) {
  for (const int threads : {2, 3, 4}) EXPECT_EQ(first_difference({.other = {.threads = threads}}), "");
}

TEST(EveryStep, SettingsOfTheListsChangeNoBit) {
  for (const Setting& lists :
       {Setting{.skin = 1e-4}, {.skin = 1e-2}, {.cell_size = 0.05}, {.skin = 3e-3, .cell_size = 0.03}})
    EXPECT_EQ(first_difference({.other = lists}), "");
}

TEST(EveryStep, TheWidthOfTheVectorsChangesNoBit) {
  for (const char* vectors : {"none", "avx2"}) EXPECT_EQ(first_difference({.other = {.vectors = vectors}}), "");
}

TEST(EveryStep, AllOfThemTogetherChangeNoBit) {
  const Setting other{.threads = 3, .skin = 1e-2, .cell_size = 0.04, .vectors = "none"};
  EXPECT_EQ(first_difference({.steps = 60, .other = other}), "");
}

// From the second step on there is a tear behind them. A method passes over its states on threads too, and a controlled one chooses its steps by sums over them.
TEST(EveryStep, NoMethodMinds) {
  for (const MethodInfo& info : method_catalogue()) {
    Comparison c{.method = info.name, .steps = 6, .other = {.threads = 3, .skin = 1e-2}};
    c.kind = info.conservative ? BedKind::elastic : BedKind::full;
    const System system(bed(c.kind, c.one));
    if (const std::string why = refusal(info, system); info.dense_jacobian && !why.empty()) continue;
    EXPECT_EQ(first_difference(c), "");
  }
}

// What the comparisons rest on: blocks, threads, contacts that slide, links that tear, lists that are made again.
TEST(EveryStep, TheBedHasWhatCouldDiffer) {
  World full(BedKind::full, {.threads = 3, .skin = 1e-4}, "pece"), elastic(BedKind::elastic, {}, "pece");
  for (int n = 0; n < 6; ++n) {
    full.step();
    elastic.step();
  }
  EXPECT_EQ(full.system().threads(), 3);
  EXPECT_GT(full.slips(), 0);
  EXPECT_GT(full.now().discrete.held.size(), 1000u);
  const NeighbourSearch& search = kernel_of(full.system().solver()).search();
  EXPECT_EQ(search.blocks.size(), 2u);
  EXPECT_GT(search.contributions, 0);
  EXPECT_GT(search.rebuilds, 1);
  for (const World* world : {&full, &elastic}) EXPECT_GT(world->now().discrete.torn.size(), 0u);
}

TEST(EveryStep, OneBitOfOneNumberIsSeenAndNamed) {
  const World world(BedKind::full, {}, "pece");
  System one(bed(BedKind::full, {})), other(bed(BedKind::full, {}));
  Snapshot changed = world.now();
  const int place = world.system().vy_of(places_in(one.parts().disc.number)[77]);
  changed.y[place] = std::nextafter(changed.y[place], 1e300);
  const std::string found = difference(world.now(), changed, one, other, {"this", "that"});
  EXPECT_EQ(found.substr(0, found.find(':')), "vy of disc 77");
  EXPECT_NE(found.find("this "), std::string::npos);
}

}  // namespace
}  // namespace furrow
