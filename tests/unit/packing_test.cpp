// Discs at random: clear of everything, in their rectangle, and the same for the same seed.
#include "scene/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

Packing packing(int count, double radius_min, double radius_max) {
  Packing p;
  p.count = count;
  p.radius_min = radius_min;
  p.radius_max = radius_max;
  p.lower_left = {-0.2, 0.1};
  p.upper_right = {0.3, 0.5};
  p.material = "soft";
  return p;
}

Scene packed(std::vector<Packing> packings) {
  Scene scene = empty_scene();
  scene.packing = std::move(packings);
  return place_packings(scene);
}

void expect_no_overlap(const std::vector<Disc>& discs) {
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      const double dx = discs[i].position.x - discs[j].position.x;
      const double dy = discs[i].position.y - discs[j].position.y;
      EXPECT_GE(std::sqrt(dx * dx + dy * dy), (discs[i].radius + discs[j].radius) * (1 - 1e-15)) << i << ", " << j;
    }
  }
}

TEST(Packing, DiscsDoNotOverlapAndStayInTheirRectangle) {
  const Scene scene = packed({packing(100, 0.005, 0.015)});
  ASSERT_EQ(scene.disc.size(), 100u);
  EXPECT_TRUE(scene.packing.empty());
  expect_no_overlap(scene.disc);
  for (const Disc& d : scene.disc) {
    EXPECT_GE(d.position.x - d.radius, -0.2 - 1e-15);
    EXPECT_LE(d.position.x + d.radius, 0.3 + 1e-15);
    EXPECT_GE(d.position.y - d.radius, 0.1 - 1e-15);
    EXPECT_LE(d.position.y + d.radius, 0.5 + 1e-15);
    EXPECT_EQ(d.material, "soft");
    EXPECT_EQ(d.velocity, (Vec2{0, 0}));
    EXPECT_EQ(d.spin, 0);
  }
}

TEST(Packing, RadiiFillTheirRange) {
  const Scene scene = packed({packing(100, 0.005, 0.015)});
  double least = 1;
  double greatest = 0;
  double sum = 0;
  for (const Disc& d : scene.disc) {
    least = std::min(least, d.radius);
    greatest = std::max(greatest, d.radius);
    sum += d.radius;
  }
  EXPECT_GE(least, 0.005);
  EXPECT_LE(greatest, 0.015);
  EXPECT_LT(least, 0.0065);  // 100 uniform numbers miss a seventh of their range with a chance of 2e-7
  EXPECT_GT(greatest, 0.0135);
  EXPECT_NEAR(sum / 100, 0.01, 0.0015);  // five standard deviations of the mean
}

TEST(Packing, EqualRadiiAreExact) {
  for (const Disc& d : packed({packing(20, 0.01, 0.01)}).disc) EXPECT_EQ(d.radius, 0.01);
}

bool same(const Scene& a, const Scene& b) {
  return std::equal(a.disc.begin(), a.disc.end(), b.disc.begin(), b.disc.end(),
                    [](const Disc& p, const Disc& q) { return p.position == q.position && p.radius == q.radius; });
}

TEST(Packing, SameSeedSameDiscs) {
  EXPECT_TRUE(same(packed({packing(50, 0.005, 0.015)}), packed({packing(50, 0.005, 0.015)})));
  Packing other = packing(50, 0.005, 0.015);
  other.seed = 2;
  EXPECT_FALSE(same(packed({packing(50, 0.005, 0.015)}), packed({other})));
}

// Neighbours in the bed are near in memory: within the numbers of two columns, each a radius wide.
TEST(Packing, LargeOnesAreNumberedByPlace) {
  const Packing p = packing(6000, 0.0015, 0.0015);
  const std::vector<Disc> large = packed({p}).disc;
  ASSERT_EQ(large.size(), 6000u);
  const auto column = [&](std::size_t i) { return std::floor(large[i].position.x / p.radius_max); };
  for (std::size_t i = 1; i < large.size(); ++i) {
    ASSERT_LE(column(i - 1), column(i));
    const bool same = column(i - 1) == column(i);
    ASSERT_TRUE(!same || large[i - 1].position.y <= large[i].position.y);
  }
  // The same places as of a packing that is not sorted: the first of them, of as many attempts.
  const std::vector<Disc> small = packed({packing(3000, 0.0015, 0.0015)}).disc;
  for (const Disc& d : small) {
    EXPECT_TRUE(std::any_of(large.begin(), large.end(), [&](const Disc& e) {
      return d.position.x == e.position.x && d.position.y == e.position.y;
    }));
  }
}

TEST(Packing, SecondOneKeepsClearOfTheFirstAndOfSingleDiscs) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0.3}, 0.08)};
  scene.packing = {packing(30, 0.01, 0.01), packing(20, 0.005, 0.02)};
  const Scene placed = place_packings(scene);
  ASSERT_EQ(placed.disc.size(), 51u);
  EXPECT_EQ(placed.disc[0].radius, 0.08);
  expect_no_overlap(placed.disc);
}

TEST(Packing, KeepsClearOfWallsPlatesAndLattices) {
  Scene scene = empty_scene();
  scene.wall = {wall({0, 0.2}, {0.1, 1})};
  scene.plate = {plate({0, 0.3}, 0.05, 1), plate({-1, -1}, 3, 3)};
  scene.plate[1].lower_edge.reset();  // not known yet: of no account
  scene.lattice = {lattice({0.2, 0.1}, 30, 3, 0.01)};
  scene.packing = {packing(60, 0.005, 0.01)};
  const Scene placed = place_packings(scene);
  ASSERT_EQ(placed.disc.size(), 60u);
  expect_no_overlap(placed.disc);
  const double length = std::sqrt(1.01);
  for (const Disc& d : placed.disc) {
    const double x = d.position.x;
    const double y = d.position.y;
    EXPECT_GE((0.1 * x + (y - 0.2)) / length, d.radius * (1 - 1e-14));
    const double to_plate = std::hypot(std::max({0 - x, 0.0, x - 0.05}), std::max({0.3 - y, 0.0, y - 1.3}));
    EXPECT_GE(to_plate, d.radius * (1 - 1e-14));
    const double to_lattice = std::hypot(std::max({0.2 - x, 0.0, x - 0.22}), std::max({0.1 - y, 0.0, y - 0.39}));
    EXPECT_GE(to_lattice, d.radius * (1 - 1e-14));
  }
}

TEST(Packing, WithoutRoomIsAnErrorThatSaysHowFarItCame) {
  try {
    packed({packing(1, 0.01, 0.01), packing(50, 0.1, 0.1)});
    FAIL() << "0.5 m x 0.4 m hold no fifty discs of 0.1 m";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("packing 1"), std::string::npos) << text;
    EXPECT_NE(text.find("of 50"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace furrow
