// A body in a corner of a plate goes round it: the force turns from one face to the other without a jump, and has a
// potential, so that a closed way costs nothing.
//
//   U = 8/15 E* sqrt(R) (R + D)^(5/2),   D = min*(a, b) with the depths a <= b behind the two faces
//   min*(a, b) = a                         if 2 a <= b
//              = a - (4/7) b (a/b - 1/2)^2 else
//
// Source: src/physics/held_face.h; U, an integration and differences of U in long double, written here a second time.
#include <algorithm>
#include <string>

#include "verification/check.h"
#include "verification/kept_face_scenes.h"

namespace furrow::verification::kept_face {
namespace {

struct Force {
  double x, y;  // N
};

// After the jump at each of `count` places on the way through the corner, from the left face to the lower one.
template <class At>
void along_diagonal(int count, At at) {
  constexpr double across = 0.004;  // m
  System system(thrown_disc({0, across}, {}));
  State y = system.initial_state(), rates(y.size());
  for (int k = 0; k <= count; ++k) {
    y[0] = across * k / count;
    y[1] = across - y[0];
    system.jump(0, y);
    system.rhs(0, y, rates);
    at(y[0], y[1], Force{mass * rates[2], mass * rates[3]});
  }
}

TEST(KeptFace, ForceInACornerIsTheSlopeOfItsPotential) {
  requirement("coupling.kept_face_corner");
  constexpr long double h = 1e-8L;  // m
  double worst = 0, greatest = 0;
  along_diagonal(101, [&](double x, double y, Force f) {
    if (x == 0 || y == 0) return;  // beyond a face D has another form
    const auto fx = static_cast<double>((potential(x - h, y) - potential(x + h, y)) / (2 * h));
    const auto fy = static_cast<double>((potential(x, y - h) - potential(x, y + h)) / (2 * h));
    worst = std::max({worst, std::fabs(f.x - fx), std::fabs(f.y - fy)});
    greatest = std::max(greatest, std::hypot(f.x, f.y));
  });
  expect("greatest difference to -grad U, of the greatest force", worst / greatest, 0,
         absolute(1e-10, "central differences: h^2/6 of the third derivative, of the order of 1/b^2, b from 40 um on"));
}

TEST(KeptFace, ForceInACornerIsContinuous) {
  requirement("coupling.kept_face_corner");
  const auto greatest_change = [](int count) {
    double most = 0;
    Force before{0, 0};
    along_diagonal(count, [&](double x, double, Force f) {
      if (x > 0) most = std::max(most, std::hypot(f.x - before.x, f.y - before.y));
      before = f;
    });
    return most;
  };
  expect("greatest change of the force from place to place, at twice the places", greatest_change(2000),
         0.5 * greatest_change(1000),
         relative(0.01, "a continuous slope: next term of the series, a thousandth of the way times its curvature"));
}

TEST(KeptFace, AWayRoundACornerReturnsItsEnergy) {
  requirement("coupling.kept_face_corner");
  constexpr double end = 0.03;  // s
  const Vec2 from{-radius - 0.001, 0.006}, velocity{1.9, -0.55};
  double most = -1, least = 1;
  const Ran ran =
      run_scene(thrown_disc(from, velocity), "rk4", end / 20000, end, [&](double, const State& y, const JumpReport&) {
        if (y[1] > 0) most = std::max(most, y[0]);
        if (y[0] > 0) least = std::min(least, y[1]);
        return true;
      });
  const Motion want = integrated({from.x, from.y, velocity.x, velocity.y}, end, 40000);
  const char* reason = "truncation, where the second derivative of U jumps: measured once and doubled";
  expect_true("it goes in by the left face", most > 1e-3, "else it has not been in the corner");
  expect_true("it comes out of the lower face", least < -1e-3, "else it has not gone round");
  expect("kinetic energy afterwards, of that before",
         (ran.y[2] * ran.y[2] + ran.y[3] * ran.y[3]) / (velocity.x * velocity.x + velocity.y * velocity.y), 1,
         relative(3.2e-9, reason));
  for (std::size_t i = 0; i < 4; ++i)
    expect("number " + std::to_string(i) + " of the state against the integration", ran.y[i],
           static_cast<double>(want[i]), absolute(8e-9, reason));
}

}  // namespace
}  // namespace furrow::verification::kept_face
