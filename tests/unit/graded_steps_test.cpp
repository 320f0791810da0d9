// The steps after a located touch, one by one: t = t_touch + T s^q with s uniform.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// Another method, whose steps are written down.
class WritesDown final : public Method {
 public:
  explicit WritesDown(const std::string& name) : Method(make_method(name)->info()), inner_(make_method(name)) {}
  double step(const OdeSystem& system, double t, State& y, double h) override {
    const double taken = inner_->step(system, t, y, h);
    steps.push_back({t, h, y[1]});
    return taken;
  }
  void restart() override { inner_->restart(); }

  struct Step {
    double t, h, height;  // s, s, m: of the disc's centre afterwards
  };
  std::vector<Step> steps;

 private:
  std::unique_ptr<Method> inner_;
};

constexpr double radius = 0.1;  // m

std::vector<WritesDown::Step> steps_of_a_fall(double damping, double step, double speed = 1.3) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = damping;
  scene.disc = {disc({0, radius + speed * 2.5 * step}, radius, {0, -speed})};  // it touches in the third step
  scene.wall = {wall({0, 0}, {0, 1})};
  System system(scene);
  State y = system.initial_state();
  WritesDown method("rk4");
  run(system, method, y, {.start = 0, .end = 12 * step, .step = step, .locate = Locate::all},
      [](double, const State&, const JumpReport&) { return true; });
  return method.steps;
}

// (m^2/(E*^2 R v))^(1/5) / max(1, beta)^(4/5).
double time_of(double beta, double speed) {
  const double mass = 1000 * 3.14159265358979323846 * radius * radius, modulus = 1e6 / 1.875;
  return std::pow(mass * mass / (modulus * modulus * radius * speed), 0.2) / std::pow(std::fmax(1, beta), 0.8);
}

// T is a quarter of that, down to a power of two.
double scale(double beta, double speed) {
  // Of x = f 2^e with f in [1/2, 1): e/5 rounded down.
  return 0.25 * std::exp2(std::floor(std::log2(time_of(beta, speed) * std::exp2(0.2))));
}

void expect_graded(double damping, double step, double speed = 1.3) {
  const std::vector<WritesDown::Step> steps = steps_of_a_fall(damping, step, speed);
  // The step that ends soonest after the touch.
  std::size_t touch = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k].height < radius && (touch == 0 || steps[k].t + steps[k].h < steps[touch].t + steps[touch].h))
      touch = k;
  }
  const double start = steps[touch].t + steps[touch].h;
  EXPECT_NEAR(start, 2.5 * step, 1e-6 * step);
  const double q = damping > 0 ? 4 : 2, big = scale(damping, speed);
  double t = start;
  int graded = 0;
  for (std::size_t k = touch + 1; k < steps.size(); ++k) {
    EXPECT_NEAR(steps[k].t, t, 1e-12);
    const double end = (std::floor(t / step + 1e-6) + 1) * step;
    const double s = std::pow((t - start) / big, 1 / q) + step / (q * big);
    const double length = std::fmax(big * std::pow(s, q) - (t - start), 4e-15 * (t + step));
    if (length >= step) break;
    const double want = end - t < 1.5 * length ? end - t : length;
    EXPECT_NEAR(steps[k].h, want, 1e-6 * want) << k;
    t += steps[k].h;
    ++graded;
  }
  EXPECT_GT(graded, damping > 0 ? 10 : 6);
}

TEST(GradedSteps, BehindAnElasticTouchGoWithTheSquare) { expect_graded(0, 2e-3); }

TEST(GradedSteps, BehindADampedTouchGoWithTheFourthPower) {
  expect_graded(0.2, 2e-3);
  expect_graded(7, 2e-4);  // beyond 1 the damping shortens the scale
}

// A power of two hides by how much its argument is wrong, but where it changes: one in a hundred above and below.
TEST(GradedSteps, ChangeTheirScaleWhereTheFormulaDoes) {
  const double edge = std::floor(std::log2(time_of(1, 1.3) * std::exp2(0.2)));
  for (const double above : {0.99, 1.01}) {
    for (const int octaves : {0, 1, 2}) {
      const double beta = above * std::pow(time_of(1, 1.3) * std::exp2(0.2 - edge + octaves), 1.25);
      ASSERT_GT(beta, 1);
      expect_graded(beta, 2e-4);
    }
    // Below 1 damping has no part in it: 1.3 m/s times what brings the scale to that edge.
    const double speed = above * 1.3 * std::pow(time_of(1, 1.3) * std::exp2(0.2 - edge), 5);
    expect_graded(0.9, 2e-4, speed);
    expect_graded(0, 1e-3, speed);
  }
}

TEST(GradedSteps, EndWhereTheyAreAsLongAsTheUsualOnes) {
  const std::vector<WritesDown::Step> steps = steps_of_a_fall(0, 2e-3);
  EXPECT_NEAR(steps.back().h, 2e-3, 1e-12);
  for (const WritesDown::Step& one : steps) EXPECT_LE(one.h, 2e-3 * (1 + 1e-9));
}

}  // namespace
}  // namespace furrow
