// What the correlation adds to an observed order: errors that have the slope of an order, but stand on no line.
//
//   k               0   1   2   3   4   5   6   7   8          x = -k, step (1/2)^k
//   y = log error   0  -4  -8 -12 -16 -16 -16 -16 -16          order 4 that stops halfway, at a floor
//
//   sum (x - mean)^2 = 60,   sum (x - mean)(y - mean) = 120,   sum (y - mean)^2 = 16 (94 - 26^2/9)
//   slope 120/60 = 2,   correlation 120/sqrt(60 * 16 (94 - 26^2/9)) = 0.891
//
// Source: by hand. A method of order 2 would pass by the slope alone.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/studies/order_observed.h"

namespace furrow::verification {
namespace {

TEST(OrderCertificate, AFloorHalfwayHasASlopeButNoLine) {
  requirement("order.smooth");
  std::vector<Point> points(9);
  for (int k = 0; k < 9; ++k) {
    points[k].step = std::pow(0.5, k);
    points[k].position = 1e-3 * std::pow(points[std::min(k, 4)].step, 4);
  }
  const Slope slope = fitted(points, &Point::position);
  const Tolerance round_off = absolute(1e-12, "round-off of nine logarithms");
  expect("slope", slope.value, 2, round_off);
  expect("correlation", slope.correlation, 120 / std::sqrt(60 * (94 - 26 * 26 / 9.0) * 16), round_off);
  expect_true("no method would pass with these errors", slope.correlation < correlation_with(slope, 0.5),
              "scatter 0.5 is the most that is let pass, with events");
}

}  // namespace
}  // namespace furrow::verification
