// The neighbour lists hold what is near, and looking for it costs what is near: not what is large, far or many. Both
// are shown on scenes at random and on the worst that one can think of.
#include <gtest/gtest.h>

#include <limits>

#include "kernel/search.h"
#include "scenes.h"
#include "system/border.h"

namespace furrow {
namespace {

using namespace test;
using Pairs = std::vector<std::pair<int, int>>;

// Parts at random. Positions of the nodes are those of the parts.
struct Heap {
  explicit Heap(unsigned seed) : random(seed) {}

  double uniform(double from = 0, double to = 1) {
    return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
  }
  int number(int most) { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); }
  Vec2 somewhere(double side) { return {uniform(0, side), uniform(0, side)}; }

  void add_discs(int count, double least, double greatest, double side) {
    for (int k = 0; k < count; ++k)
      scene.disc.push_back(disc(somewhere(side), least * std::pow(greatest / least, uniform())));
  }
  // So that each has the room of a square, row by row.
  void add_bed(int count, double radius) {
    const int columns = static_cast<int>(std::sqrt(count));
    for (int k = 0; k < count; ++k)
      scene.disc.push_back(disc({2.1 * radius * (k % columns), 2.1 * radius * (k / columns)}, radius));
  }
  void add_lattice(Vec2 origin, int rows, int columns, double spacing, int displaced, double by) {
    Lattice l = lattice(origin, rows, columns, spacing);
    for (int k = 0; k < displaced; ++k)
      l.node.push_back(node_setting(number(rows - 1), number(columns - 1), {uniform(-by, by), uniform(-by, by)}));
    scene.lattice.push_back(l);
  }

  void finish() {
    parts = make_parts(scene);
    x = parts.disc.x;
    y = parts.disc.y;
  }
  Placement now(double t = 0) const { return {t, x.data(), y.data(), parts.node.x.data(), parts.node.y.data()}; }

  std::mt19937_64 random;
  Scene scene = empty_scene();
  Parts parts;
  std::vector<double> x, y;
};

int others_of(const Parts& parts, ContactKind kind) {
  return static_cast<int>(kind == disc_wall || kind == node_wall ? parts.wall.size() : parts.plate.size());
}

// Every pair closer than `reach`, looked for among all.
Pairs near_pairs(const Parts& parts, const Placement& now, ContactKind kind, double reach) {
  Pairs near;
  for (int a = 0; a < (of_disc(kind) ? parts.disc.count() : parts.node.count()); ++a) {
    if (!of_disc(kind) && parts.node.body[a] < 0) continue;
    if (kind == disc_disc) {
      for (int b = a + 1; b < parts.disc.count(); ++b) {
        const double within = parts.disc.radius[a] + parts.disc.radius[b] + reach;
        const double dx = now.disc_x[b] - now.disc_x[a], dy = now.disc_y[b] - now.disc_y[a];
        if (dx * dx + dy * dy < within * within) near.push_back({a, b});
      }
    } else {
      for (int b = 0; b < others_of(parts, kind); ++b) {
        if (flat_gap(parts, {kind, a, b}, of_disc(kind) ? now.disc(a) : now.node(a), now.t).gap < reach)
          near.push_back({a, b});
      }
    }
  }
  return near;
}

// Discs and border segments.
Pairs near_segments(const Parts& parts, const Placement& now, double reach) {
  Pairs near;
  for (int a = 0; a < parts.disc.count(); ++a) {
    for (int s = 0; s < parts.border.count(); ++s) {
      const double within = parts.disc.radius[a] + reach;
      const Vec2 i = now.node(parts.border.a[s]), j = now.node(parts.border.b[s]);
      if (nearest_on_segment(now.disc(a), i, j, 0).distance2 < within * within) near.push_back({a, s});
    }
  }
  return near;
}

Pairs listed(const NeighbourSearch& search, ContactKind kind) {
  Pairs pairs;
  const Candidates& list = search.candidates[kind];
  for (int k = 0; k < list.count(); ++k) pairs.push_back({list.a[k], list.b[k]});
  return pairs;
}

Pairs listed_segments(const NeighbourSearch& search) {
  Pairs pairs;
  const Candidates& list = search.candidates[disc_lattice];
  for (int k = 0; k < list.count(); ++k) {
    for (int s = list.first_segment[k]; s < list.first_segment[k + 1]; ++s)
      pairs.push_back({list.a[k], list.segment[s]});
  }
  return pairs;
}

void expect_complete(const Heap& heap, double t, double skin, double cell, const std::string& what) {
  Search how;
  how.skin = skin;
  how.cell_size = cell;
  NeighbourSearch search(heap.parts, how);
  search.border = touched_segments(heap.parts, {});
  search.update(heap.parts, heap.now(t));
  const double reach = search.margin + skin;
  for (const ContactKind kind : {disc_disc, disc_wall, disc_plate, node_wall, node_plate})
    EXPECT_EQ(listed(search, kind), near_pairs(heap.parts, heap.now(t), kind, reach))
        << contact_kind_names[kind] << ", " << what;
  const Pairs segments = near_segments(heap.parts, heap.now(t), reach);
  EXPECT_EQ(listed_segments(search), segments) << what;
  Pairs lattices;
  for (const auto& [a, s] : segments) {
    const std::pair pair{a, heap.parts.border.lattice[s]};
    if (lattices.empty() || lattices.back() != pair) lattices.push_back(pair);
  }
  EXPECT_EQ(listed(search, disc_lattice), lattices) << what;
}

// Discs of sizes up to `ratio` apart, in one heap or several far from each other; some on one spot, some flung far off.
Heap wild_heap(unsigned seed, double ratio) {
  Heap heap(seed);
  const double greatest = 0.01 * std::sqrt(ratio), side = greatest * heap.uniform(1, 30);
  heap.add_discs(20 + heap.number(60), 0.01 / std::sqrt(ratio), greatest, side);
  for (int k = heap.number(3); k > 0; --k) heap.scene.disc.push_back(disc(heap.scene.disc[k].position, 0.01));
  for (int k = heap.number(3); k > 0; --k)
    heap.scene.disc[heap.number(15)].position = {heap.uniform(-1, 1) * std::pow(10, heap.uniform(0, 12)), side};
  for (int k = heap.number(10); k > 0; --k) heap.scene.disc[heap.number(15)].position.y += 1e5;
  for (int k = heap.number(2); k > 0; --k)
    heap.add_lattice(heap.somewhere(side), 1 + heap.number(3), 1 + heap.number(9), side * heap.uniform(0.01, 0.3),
                     heap.number(3), side * heap.uniform(0, 3));
  for (int k = heap.number(5); k > 0; --k) {
    const double angle = k == 1 ? 0.5 * pi * heap.number(3) : heap.uniform(0, 2 * pi);
    heap.scene.wall.push_back(wall(heap.somewhere(side), {std::cos(angle), std::sin(angle)}));
  }
  for (int k = heap.number(5); k > 0; --k)
    heap.scene.plate.push_back(plate(heap.somewhere(side), side * heap.uniform(1e-3, 2), side * heap.uniform(1e-3, 2),
                                     {heap.uniform(-1, 1), heap.uniform(-1, 1)}));
  heap.finish();
  return heap;
}

class Ratios : public testing::TestWithParam<double> {};

TEST_P(Ratios, ListsAreThoseOfAllPairsInTheirOrder) {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    Heap heap = wild_heap(seed, GetParam());
    const double skin = 0.01 * heap.uniform(0.01, 1) / std::sqrt(GetParam());
    const double cell = seed % 5 == 0 ? heap.uniform(1e-3, 0.1) : 0;
    expect_complete(heap, heap.uniform(0, 0.1), skin, cell, "seed " + std::to_string(seed));
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(UpTo, Ratios, testing::Values(1.0, 1.5, 5.0, 50.0, 1000.0),
                         [](const auto& ratio) { return std::to_string(static_cast<int>(10 * ratio.param)); });

// ---- cost ----

constexpr int many = 3000;
constexpr double r = 0.01;  // m

long looks(const Heap& heap) {
  NeighbourSearch search(heap.parts, {});
  search.update(heap.parts, heap.now());
  return search.checks;
}

// Looks for the lists of `many` discs of 1 cm and whatever `add` adds, over those of the discs alone.
template <class Add>
double cost(Add&& add) {
  Heap alone(1), with(1);
  for (Heap* heap : {&alone, &with}) heap->add_bed(many, r);
  add(with);
  for (Heap* heap : {&alone, &with}) heap->finish();
  // What is far off takes nothing away; a small disc makes the margin narrower.
  EXPECT_GT(static_cast<double>(looks(with)), 0.9 * static_cast<double>(looks(alone)));
  return static_cast<double>(looks(with)) / static_cast<double>(looks(alone));
}

constexpr double most = 1.3;  // what must be said to be near

TEST(SearchCost, OfALatticeFarAwayIsNothing) {
  EXPECT_LT(cost([](Heap& h) { h.add_lattice({100, 100}, many, 3, 0.01, 0, 0); }), most);
}

TEST(SearchCost, OfALatticeFarAwayWithSegmentsOfAnyLengthIsNothing) {
  EXPECT_LT(cost([](Heap& h) { h.add_lattice({100, 100}, many, 3, 0.01, 300, 5); }), most);
}

TEST(SearchCost, OfALatticeAlongTheBedIsThatOfTheDiscsBesideIt) {
  EXPECT_LT(cost([](Heap& h) { h.add_lattice({-0.02, 0}, 100, 3, 0.01, 0, 0); }), most);
}

TEST(SearchCost, OfLongSegmentsThroughTheBedIsThatOfTheDiscsBesideThem) {
  EXPECT_LT(cost([](Heap& h) { h.add_lattice({-0.5, -0.5}, 2, 3, 1, 3, 1); }), most);
}

TEST(SearchCost, OfOneLargeDiscIsThatOfOneDisc) {
  for (const double radius : {0.011, 0.014, 0.019, 0.03, 0.1, 1.0, 100.0}) {
    EXPECT_LT(cost([&](Heap& h) { h.scene.disc.push_back(disc({-radius - r, 0.5}, radius)); }), most) << radius;
  }
}

TEST(SearchCost, OfOneSmallDiscIsThatOfOneDisc) {
  for (const double radius : {0.009, 0.005, 1e-3, 1e-5, 1e-8}) {
    EXPECT_LT(cost([&](Heap& h) { h.scene.disc.push_back(disc({-2 * r, 0.5}, radius)); }), most) << radius;
  }
}

TEST(SearchCost, OfAsManySmallDiscsIsThatOfAsManyDiscs) {
  EXPECT_LT(cost([](Heap& h) {
              for (int k = 0; k < many; ++k) h.scene.disc.push_back(disc({-1 + 3e-4 * k, -1}, 1e-4));
            }),
            2 * most);
}

TEST(SearchCost, OfDiscsFlungFarOffIsThatOfSoManyDiscs) {
  EXPECT_LT(cost([](Heap& h) {
              for (int k = 0; k < 10; ++k) h.scene.disc.push_back(disc({h.uniform(-1e9, 1e9), 1e3 * k}, r));
            }),
            most);
}

TEST(SearchCost, OfAnotherBedFarAwayIsThatOfTheOtherBed) {
  EXPECT_LT(cost([](Heap& h) {
              h.add_bed(many, r);
              for (int k = many; k < 2 * many; ++k) h.scene.disc[k].position.x += 12345.678;
            }),
            2 * most);
}

TEST(SearchCost, OfPlatesFarAwayIsNothing) {
  EXPECT_LT(cost([](Heap& h) {
              for (int k = 0; k < many; ++k) h.scene.plate.push_back(plate({5 + 0.01 * k, 3}, 0.005, 1));
            }),
            most);
}

TEST(SearchCost, OfWallsAllRoundIsThatOfTheDiscsAtThem) {
  EXPECT_LT(cost([](Heap& h) {
              for (int k = 0; k < 100; ++k) {
                const double angle = 0.02 * pi * k;
                h.scene.wall.push_back(
                    wall({0.5 - 2 * std::cos(angle), 0.5 - 2 * std::sin(angle)}, {std::cos(angle), std::sin(angle)}));
              }
            }),
            most);
}

TEST(SearchCost, OfNodesIsThatOfTheirRowsAndOfThoseNearAWall) {
  Heap heap(1);
  heap.add_lattice({0, 0}, many, 3, 0.01, 0, 0);
  for (int k = 0; k < 100; ++k) heap.scene.plate.push_back(plate({1 + k * 0.1, 0}, 0.05, 1));
  heap.scene.wall = {wall({0, -0.001}, {0, 1})};
  heap.finish();
  EXPECT_LT(looks(heap), many + 10);  // of 909,000 pairs
}

// How often lists are made again, while a bed trembles.
long renewals(const Heap& heap, int bed) {
  Heap moving = heap;
  NeighbourSearch search(moving.parts, {});
  for (int step = 0; step < 100; ++step) {
    for (int k = 0; k < bed; ++k) moving.x[k] += moving.uniform(-1e-4, 1e-4);
    search.update(moving.parts, moving.now());
  }
  return search.rebuilds;
}

TEST(SearchCost, OfAFewSmallPartsIsNoShorterLifeOfTheLists) {
  Heap alone(1), with(1);
  for (Heap* heap : {&alone, &with}) heap->add_bed(100, r);
  with.scene.disc.push_back(disc({-1, -1}, 1e-5));
  with.add_lattice({100, 100}, 3, 3, 1e-4, 0, 0);
  with.scene.lattice[0].contact_radius = 1e-6;
  for (Heap* heap : {&alone, &with}) heap->finish();
  EXPECT_EQ(renewals(with, 100), renewals(alone, 100));
}

}  // namespace
}  // namespace furrow
