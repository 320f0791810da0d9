// Neighbour lists: complete, of linear size, and without influence on a result.
#include "kernel/search.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "kernel/kernel.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;
using Pairs = std::set<std::pair<int, int>>;

// Discs at random in a square, overlapping as they like; one on each square as wide as a mean disc.
struct Cloud {
  explicit Cloud(int count, double mean_radius = 0.01) {
    Scene scene = empty_scene();
    const double side = 2 * mean_radius * std::sqrt(static_cast<double>(count));
    for (int k = 0; k < count; ++k) {
      x.push_back(side * uniform());
      y.push_back(side * uniform());
      scene.disc.push_back(disc({x.back(), y.back()}, mean_radius * (0.4 + 1.2 * uniform())));
    }
    parts = make_parts(scene);
  }

  double uniform() { return static_cast<double>(random() >> 11) * 0x1p-53; }
  Placement now(double t = 0) const { return {t, x.data(), y.data(), nullptr, nullptr}; }

  Pairs closer_than(double gap) const {
    Pairs pairs;
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = i + 1; j < x.size(); ++j) {
        if (std::hypot(x[i] - x[j], y[i] - y[j]) < parts.disc.radius[i] + parts.disc.radius[j] + gap) {
          pairs.insert({static_cast<int>(i), static_cast<int>(j)});
        }
      }
    }
    return pairs;
  }

  std::mt19937_64 random{11};
  std::vector<double> x, y;
  Parts parts;
};

Search settings(double skin, double cell_size = 0) {
  Search s;
  s.skin = skin;
  s.cell_size = cell_size;
  return s;
}

Pairs listed(const NeighbourSearch& search, ContactKind kind = disc_disc) {
  Pairs pairs;
  const Candidates& list = search.candidates[kind];
  for (int k = 0; k < list.count(); ++k) pairs.insert({list.a[k], list.b[k]});
  return pairs;
}

TEST(NeighbourSearch, FindsThePairsThatBruteForceFinds) {
  for (const double cell_size : {0.0, 0.003, 0.01, 0.07, 1.0}) {
    Cloud cloud(300);
    NeighbourSearch search(cloud.parts, settings(0.002, cell_size));
    search.update(cloud.parts, cloud.now());
    EXPECT_EQ(listed(search), cloud.closer_than(search.margin + 0.002)) << "cell size " << cell_size;
  }
}

TEST(NeighbourSearch, ListsAreSortedByPair) {
  Cloud cloud(300);
  NeighbourSearch search(cloud.parts, settings(0.002));
  search.update(cloud.parts, cloud.now());
  const Candidates& list = search.candidates[disc_disc];
  for (int k = 1; k < list.count(); ++k) {
    EXPECT_LT(std::pair(list.a[k - 1], list.b[k - 1]), std::pair(list.a[k], list.b[k]));
  }
}

TEST(NeighbourSearch, NoNearPairIsMissedWhileDiscsWander) {
  Cloud cloud(150);
  NeighbourSearch search(cloud.parts, settings(0.003));
  for (int step = 0; step < 100; ++step) {
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      cloud.x[i] += 8e-4 * (cloud.uniform() - 0.5) + (i % 2 == 0 ? 2e-4 : -2e-4);
      cloud.y[i] += 8e-4 * (cloud.uniform() - 0.5);
    }
    search.update(cloud.parts, cloud.now());
    const Pairs on_list = listed(search);
    for (const auto& pair : cloud.closer_than(search.margin)) EXPECT_TRUE(on_list.count(pair)) << "step " << step;
  }
  EXPECT_GT(search.rebuilds, 5);
  EXPECT_LT(search.rebuilds, 60);  // a skin that saves nothing would need 100
}

TEST(NeighbourSearch, IsNotRenewedWhileNothingMoves) {
  Cloud cloud(50);
  NeighbourSearch search(cloud.parts, {});
  for (int k = 0; k < 5; ++k) search.update(cloud.parts, cloud.now());
  EXPECT_EQ(search.rebuilds, 1);
}

TEST(NeighbourSearch, ListsGrowInProportionToTheDiscs) {
  Cloud few(500);
  Cloud many(8000);
  NeighbourSearch of_few(few.parts, {});
  NeighbourSearch of_many(many.parts, {});
  of_few.update(few.parts, few.now());
  of_many.update(many.parts, many.now());
  const double ratio = static_cast<double>(listed(of_many).size()) / static_cast<double>(listed(of_few).size());
  // 16 times the discs; the border of the smaller cloud, 8 % of its discs, lacks half its neighbours. Pairs: 256 times.
  EXPECT_GT(ratio, 14);
  EXPECT_LT(ratio, 20);
}

TEST(NeighbourSearch, ADiscFarAwayDoesNoHarm) {
  Cloud cloud(100);
  cloud.x[7] = 1e9;
  cloud.y[8] = -1e12;
  NeighbourSearch search(cloud.parts, settings(0.002));
  search.update(cloud.parts, cloud.now());
  EXPECT_EQ(listed(search), cloud.closer_than(search.margin + 0.002));
}

TEST(NeighbourSearch, FindsAPlateThatComesNearer) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.01)};
  scene.plate = {plate({-1.1, -0.5}, 0.1, 1, {1, 0})};  // touches at t = 0.99 s
  const Parts parts = make_parts(scene);
  NeighbourSearch search(parts, {});
  const double x = 0;
  const double y = 0;
  for (int step = 0; step <= 999; ++step) {
    const double t = step * 1e-3;
    search.update(parts, {t, &x, &y, nullptr, nullptr});
    EXPECT_TRUE(t > 0.9 || listed(search, disc_plate).empty());
    EXPECT_TRUE(1 - t - 0.01 > search.margin || listed(search, disc_plate).size() == 1);
  }
}

// Positions that are not finite, first and later, in every place of the lists.
void expect_refused(const Parts& parts, const Search& how, std::vector<double> x, std::vector<double> y,
                    std::size_t bad, double value) {
  const Placement now{0, x.data(), y.data(), x.data() + parts.disc.count(), y.data() + parts.disc.count()};
  NeighbourSearch later(parts, how);
  later.update(parts, now);
  (bad % 2 == 0 ? x : y)[bad] = value;
  NeighbourSearch first(parts, how);
  EXPECT_THROW(first.update(parts, now), Divergence) << "at first, place " << bad;
  EXPECT_THROW(later.update(parts, now), Divergence) << "later, place " << bad;
}

TEST(NeighbourSearch, RefusesPositionsThatAreNotFinite) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1), disc({1, 0}, 0.1), disc({2, 0}, 0.1)};
  scene.lattice = {lattice({0, 5}, 1, 3, 1)};
  const Parts parts = make_parts(scene);
  const std::vector<double> x{0, 1, 2, 0, 1, 2};
  const std::vector<double> y{0, 0, 0, 5, 5, 5};
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for (std::size_t bad = 0; bad < x.size(); ++bad) expect_refused(parts, {}, x, y, bad, value);
  }
}

struct Trace {
  std::vector<std::uint64_t> hash;
  long rebuilds = 0, contacts = 0;
  std::size_t torn = 0;
};

Trace trace(const Search& search, SolverKind solver = SolverKind::kernel) {
  Scene scene = busy_scene();
  scene.search = search;
  scene.time.solver = solver;
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method("pece");
  Trace seen;
  RunPlan plan;
  plan.end = 0.05;
  plan.step = 1e-4;
  long step = 0;
  const RunEnd end = run(system, *method, y, plan, [&](double t, const State& now, const JumpReport& jump) {
    seen.torn += jump.torn.size();
    if (step++ % 10 != 0) return true;
    seen.hash.push_back(system.state_hash(now));
    system.for_each_contact(t, now, [&](const Contact& /*contact*/) { ++seen.contacts; });
    return true;
  });
  EXPECT_EQ(end.ending, Ending::finished) << end.reason;
  if (solver == SolverKind::kernel) seen.rebuilds = kernel_of(system.solver()).search().rebuilds;
  return seen;
}

TEST(NeighbourSearch, NeverChangesABitOfTheResult) {
  const Trace want = trace({}, SolverKind::reference);
  EXPECT_GT(want.contacts, 500);  // the scene is worth it
  EXPECT_GT(want.torn, 0u);
  for (const double skin : {0.0, 2e-4, 5e-3, 0.05}) {
    for (const double cell_size : {0.0, 4e-3, 0.1}) {
      const Trace got = trace(settings(skin, cell_size));
      EXPECT_EQ(got.hash, want.hash) << "skin " << skin << " m, cells of " << cell_size << " m";
      EXPECT_TRUE(skin > 0.01 || got.rebuilds > 3);
    }
  }
}

}  // namespace
}  // namespace furrow
