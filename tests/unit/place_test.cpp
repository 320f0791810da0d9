// Beds of more than one block are stored along a curve through their places: whatever the order of the list, neighbours
// are near in memory, the bits are the same, and a user sees the scene's numbers.
#include "system/place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "csv.h"
#include "output/frames.h"
#include "run/run.h"
#include "scenes.h"
#include "system/order.h"
#include "tests/files.h"

namespace furrow {
namespace {

using namespace test;

constexpr int rows = 100, columns = 60;
static_assert(rows * columns > discs_per_block);

// Row by row, each overlaps its neighbours; each radius is another.
Scene bed(int count = rows * columns) {
  Scene scene = empty_scene();
  for (int k = 0; k < count; ++k)
    scene.disc.push_back(
        disc({0.199 * (k % columns), 0.199 * (k / columns)}, 0.1 + 1e-7 * k));  // NOLINT(*-integer-division)
  scene.contact.friction = 0.5;
  scene.output.energy = true;
  return scene;
}

// The numbers that each disc of a shuffled scene had.
std::vector<int> shuffle(Scene& scene) {
  std::vector<int> had(scene.disc.size());
  for (std::size_t k = 0; k < had.size(); ++k) had[k] = static_cast<int>(k);
  std::shuffle(had.begin(), had.end(), std::mt19937_64(1));
  const std::vector<Disc> old = scene.disc;
  for (std::size_t k = 0; k < had.size(); ++k) scene.disc[k] = old[had[k]];
  return had;
}

// How far from each other in memory the two of a contact are, in numbers of a state.
double mean_distance(const Scene& scene) {
  const System system(scene);
  double sum = 0, count = 0;
  system.for_each_contact(0, system.initial_state(), [&](const Contact& c) {
    sum += std::abs(system.x_of(c.id.a) - system.x_of(c.id.b));
    ++count;
  });
  return count > 0 ? sum / count : throw std::runtime_error("nothing touches");
}

State after_twenty_steps(const Scene& scene) {
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method("pece");
  run(system, *method, y, {.start = 0, .end = 20e-5, .step = 1e-5, .stop = {}, .validity = nullptr},
      [](double, const State&, const JumpReport&) { return true; });
  EXPECT_GT(system.discrete_state().held.size(), 2u * rows * (columns - 1)) << "contacts that hold a spring";
  return y;
}

TEST(Place, DiscsOfOneBlockKeepTheOrderOfTheScene) {
  Scene scene = bed(discs_per_block);
  shuffle(scene);
  const std::vector<int> number = make_parts(scene).disc.number;
  ASSERT_EQ(number.size(), discs_per_block);
  for (int k = 0; k < discs_per_block; ++k) ASSERT_EQ(number[k], k);
}

TEST(Place, TheCurveGoesFromEachCellToOneBesideIt) {
  constexpr int side = 128;
  std::vector<double> x, y;
  for (int k = 0; k < side * side; ++k) {
    x.push_back(k % side);
    y.push_back(k / side);  // NOLINT(*-integer-division)
  }
  const std::vector<int> order = order_of_storage(x, y);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const int from = order[k - 1], to = order[k];
    ASSERT_EQ(std::fabs(x[from] - x[to]) + std::fabs(y[from] - y[to]), 1) << "after " << k << " cells";
  }
}

TEST(Place, ADiscFlungFarOffLeavesTheOthersNear) {
  Scene scene = bed();
  shuffle(scene);
  scene.disc.push_back(disc({1e9, -1e9}, 0.1));
  EXPECT_LT(mean_distance(scene), columns);
}

TEST(Place, DiscsAtOnePlaceKeepTheirOrder) {
  const std::vector<double> same(discs_per_block + 1, 0.5);
  const std::vector<int> order = order_of_storage(same, same);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(Place, ListedInAnyOrderNeighboursAreNearInMemory) {
  Scene scene = bed();
  shuffle(scene);
  EXPECT_LT(mean_distance(scene), columns) << "row by row a neighbour in the next row is that far";
}

TEST(Place, ABedListedInAnyOrderRunsByTheSameBits) {
  Scene scene = bed();
  const State in_order = after_twenty_steps(scene);
  shuffle(scene);
  EXPECT_EQ(in_order, after_twenty_steps(scene));
}

TEST(Place, FilesAndMessagesHaveTheNumbersOfTheScene) {
  Scene scene = bed();
  shuffle(scene);
  const System system(scene);
  const std::vector<int> place = places_in(system.parts().disc.number);
  EXPECT_EQ(system.parts().body_name(place[997]), "disc 997");
  EXPECT_NE(place[997], 997);

  const OwnDirectory directory;
  std::filesystem::create_directory(directory.path() / "frames");
  Frames frames(directory.path(), nullptr);
  frames.add(system, 0, 0, system.initial_state());
  frames.close(true);
  const Csv discs(directory.path() / "frames/discs_000.csv");
  ASSERT_EQ(discs.rows.size(), scene.disc.size());
  for (std::size_t k = 0; k < scene.disc.size(); ++k) ASSERT_EQ(discs.number(k, "radius [m]"), scene.disc[k].radius);
  const Csv contacts(directory.path() / "frames/contacts_000.csv");
  ASSERT_GT(contacts.rows.size(), scene.disc.size());
  for (std::size_t k = 0; k < contacts.rows.size(); ++k) {
    const Disc& a = scene.disc[static_cast<std::size_t>(contacts.number(k, "a"))];
    ASSERT_EQ(contacts.number(k, "x1 [m]"), a.position.x);
    ASSERT_EQ(contacts.number(k, "y1 [m]"), a.position.y);
  }
}

}  // namespace
}  // namespace furrow
