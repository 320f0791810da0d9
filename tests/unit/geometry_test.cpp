// Nearest points: hand-made cases, and brute force over points on the boundary.
#include "physics/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace furrow {
namespace {

constexpr double round_off = 1e-14;
void expect_nearest(const Nearest& got, double distance, double nx, double ny) {
  EXPECT_NEAR(got.distance, distance, round_off);
  EXPECT_NEAR(got.nx, nx, round_off);
  EXPECT_NEAR(got.ny, ny, round_off);
}

class Uniform {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 random_{20};
};

TEST(NearestOnWall, DistanceIsSignedAndNormalPointsIntoTheWall) {
  expect_nearest(nearest_on_wall({7, 3}, {1, 1}, {0, 1}), 2, 0, -1);
  expect_nearest(nearest_on_wall({7, 0.5}, {1, 1}, {0, 1}), -0.5, 0, -1);
  expect_nearest(nearest_on_wall({3, 4}, {0, 0}, {0.6, 0.8}), 5, -0.6, -0.8);
}

// The rectangle [1, 3] x [0, 1].
Nearest on_rectangle(double x, double y) { return nearest_on_rectangle({x, y}, {1, 3, 0, 1}); }

TEST(NearestOnRectangle, FromOutsideAFaceIsStraightAcross) {
  expect_nearest(on_rectangle(0.5, 0.5), 0.5, 1, 0);
  expect_nearest(on_rectangle(3.25, 0.5), 0.25, -1, 0);
  expect_nearest(on_rectangle(2, -0.5), 0.5, 0, 1);
  expect_nearest(on_rectangle(2, 1.5), 0.5, 0, -1);
}

TEST(NearestOnRectangle, FromOutsideACornerIsTheCorner) {
  expect_nearest(on_rectangle(0.7, -0.4), 0.5, 0.6, 0.8);
  expect_nearest(on_rectangle(3.3, -0.4), 0.5, -0.6, 0.8);
  expect_nearest(on_rectangle(0.7, 1.4), 0.5, 0.6, -0.8);
  expect_nearest(on_rectangle(3.3, 1.4), 0.5, -0.6, -0.8);
}

// n points to the rectangle's inside, against the way out, so that a force along -n pushes out.
TEST(NearestOnRectangle, FromInsideTheWayOutIsTheNearestFace) {
  expect_nearest(on_rectangle(1.125, 0.5), -0.125, 1, 0);
  expect_nearest(on_rectangle(2.875, 0.5), -0.125, -1, 0);
  expect_nearest(on_rectangle(2, 0.125), -0.125, 0, 1);
  expect_nearest(on_rectangle(2, 0.875), -0.125, 0, -1);
}

TEST(NearestOnRectangle, OnTheEdgeTheDistanceIsZero) {
  expect_nearest(on_rectangle(1, 0.5), 0, 1, 0);
  expect_nearest(on_rectangle(3, 0.5), 0, -1, 0);
  expect_nearest(on_rectangle(2, 0), 0, 0, 1);
  expect_nearest(on_rectangle(2, 1), 0, 0, -1);
}

TEST(NearestOnRectangle, TiesGoToTheFirstOfLeftRightLowerUpper) {
  expect_nearest(on_rectangle(1.25, 0.25), -0.25, 1, 0);                   // left and lower
  expect_nearest(on_rectangle(2.75, 0.75), -0.25, -1, 0);                  // right and upper
  expect_nearest(on_rectangle(2, 0.5), -0.5, 0, 1);                        // lower and upper
  expect_nearest(nearest_on_rectangle({0, 0}, {-1, 1, -1, 1}), -1, 1, 0);  // all four
  expect_nearest(nearest_on_rectangle({0, 0}, {-1, 1, -5, 5}), -1, 1, 0);  // left and right
}

TEST(NearestOnRectangle, AgreesWithBruteForceOverItsBoundary) {
  Uniform uniform;
  for (int n = 0; n < 200; ++n) {
    const double x = uniform(0, 4);
    const double y = uniform(-1, 2);
    double least = 1e9;
    for (int k = 0; k <= 1000; ++k) {
      const double s = k / 1000.0;
      for (const auto& [px, py] : {std::pair{1 + 2 * s, 0.0}, {1 + 2 * s, 1.0}, {1.0, s}, {3.0, s}}) {
        least = std::min(least, std::hypot(px - x, py - y));
      }
    }
    const Nearest got = on_rectangle(x, y);
    const bool inside = x > 1 && x < 3 && y > 0 && y < 1;
    EXPECT_LE(std::fabs(got.distance), least + 1e-12);
    EXPECT_GE(std::fabs(got.distance), least - 1e-3);  // the points are 2e-3 apart at most
    EXPECT_EQ(got.distance < 0, inside);
    EXPECT_NEAR(got.nx * got.nx + got.ny * got.ny, 1, 1e-14);
  }
}

struct Segment {
  double ax, ay, bx, by;
};

Segment random_segment(Uniform& uniform) { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

TEST(NearestOnSegment, NineAuxiliaryPointsAgreeWithBruteForceOverEleven) {
  Uniform uniform;
  for (int n = 0; n < 2000; ++n) {
    const Segment s = random_segment(uniform);
    const double x = uniform(-1.5, 1.5);
    const double y = uniform(-1.5, 1.5);
    double least2 = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 10; ++k) {
      const double dx = s.ax + k * 0.1 * (s.bx - s.ax) - x;
      const double dy = s.ay + k * 0.1 * (s.by - s.ay) - y;
      least2 = std::min(least2, dx * dx + dy * dy);
    }
    const NearestOnSegment got = nearest_on_segment({x, y}, {s.ax, s.ay}, {s.bx, s.by}, 9);
    EXPECT_NEAR(got.distance2, least2, 1e-13);
    EXPECT_NEAR(got.share * 10, std::round(got.share * 10), 1e-14);
    EXPECT_NEAR(x + got.dx, s.ax + got.share * (s.bx - s.ax), 1e-14);
    EXPECT_NEAR(y + got.dy, s.ay + got.share * (s.by - s.ay), 1e-14);
    EXPECT_EQ(got.distance2, got.dx * got.dx + got.dy * got.dy);
  }
}

TEST(NearestOnSegment, ExactPointIsPerpendicularOrAnEnd) {
  Uniform uniform;
  for (int n = 0; n < 2000; ++n) {
    const Segment s = random_segment(uniform);
    const double x = uniform(-1.5, 1.5);
    const double y = uniform(-1.5, 1.5);
    const NearestOnSegment got = nearest_on_segment({x, y}, {s.ax, s.ay}, {s.bx, s.by}, 0);
    const double along =
        got.dx * (s.bx - s.ax) + got.dy * (s.by - s.ay);  // of the way from the point to the nearest one
    if (got.share > 0 && got.share < 1) {
      EXPECT_NEAR(along, 0, 1e-14);
    } else {
      EXPECT_TRUE(got.share == 0 ? along >= -1e-14 : along <= 1e-14);
    }
  }
}

TEST(NearestOnSegment, ExactShareByHand) {
  const NearestOnSegment got = nearest_on_segment({1, 2}, {0, 0}, {4, 0}, 0);
  EXPECT_EQ(got.share, 0.25);
  EXPECT_EQ(got.distance2, 4);
  EXPECT_EQ(got.dx, 0);
  EXPECT_EQ(got.dy, -2);
}

TEST(NearestOnSegment, TornHasOnlyItsEnds) {
  Uniform uniform;
  for (int n = 0; n < 500; ++n) {
    const Segment s = random_segment(uniform);
    const double x = uniform(-1.5, 1.5);
    const double y = uniform(-1.5, 1.5);
    const double to_a = std::hypot(x - s.ax, y - s.ay);
    const double to_b = std::hypot(x - s.bx, y - s.by);
    const NearestOnSegment got = nearest_end({x, y}, {s.ax, s.ay}, {s.bx, s.by});
    EXPECT_EQ(got.share, to_a < to_b ? 0 : 1);
    EXPECT_NEAR(std::sqrt(got.distance2), std::min(to_a, to_b), 1e-14);
  }
}

TEST(NearestOnSegment, DegenerateSegmentIsItsPoint) {
  const Vec2 p{3, 4}, end{0, 0};
  for (const NearestOnSegment& got :
       {nearest_on_segment(p, end, end, 0), nearest_on_segment(p, end, end, 9), nearest_end(p, end, end)}) {
    EXPECT_EQ(got.distance2, 25);
    EXPECT_EQ(got.share, 0);
  }
}

}  // namespace
}  // namespace furrow
