// The heights of a bouncing disc shrink by the square of the restitution, but for its weight in the contact.
//
//   h_k = R + (h - R) e^(2k) exp(-2 loss gamma (1 + e^(-6/5) + ... + e^(-6/5 (k-1))))
//   gamma = g L/v^2, L as in damped_hertz.h: goes as E^(-2/5), so it vanishes for a hard disc, and as v^(-6/5), so it
//           grows from bounce to bounce
//   loss = 1/e int_0^end e^(-decay r) (cos(turn r) + decay/turn sin(turn r)) p^(-1/5) dr
//
// `loss` is what a small constant force inwards does to the rebound, to first order; zero without damping.
//
// Source: perturbation of the exact solution of damped_hertz.h, worked out here. Parameters: drop.h.
#include "verification/damped_hertz.h"
#include "verification/drop.h"

namespace furrow::verification {
namespace {

constexpr double pi = 3.14159265358979323846;

// Heights of the first peaks, each worked out from a state in flight.
std::vector<double> peaks_of(const Scene& scene, std::size_t count) {
  System system(scene);
  State y = system.initial_state();
  std::vector<double> heights;
  double before = 0;
  const auto method = make_method("odeint_dopri5", {.relative = 1e-12, .absolute = 1e-14, .first_step = 1e-5});
  run(system, *method, y, {.start = 0, .end = 10, .step = 1e-2, .stop = {}},
      [&](double, const State& now, const JumpReport&) {
        if (before > 0 && now[3] <= 0) heights.push_back(now[1] + now[3] * now[3] / (2 * g));
        before = now[3];
        return heights.size() < count;
      });
  return heights;
}

// With the force f d^(-1/4) as a perturbation of the linear oscillator in s; r counts back from the release.
double loss_by_weight(double e) {
  const double beta = -std::log(e) / std::hypot(std::log(e), pi);
  const DampedHertz exact(beta);
  const long double w = std::sqrt(1.25L);
  const long double turn = w * std::sqrt(1 - static_cast<long double>(beta) * beta);
  const long double sum = integral(
      [&](long double s, long double r) {
        const long double p = s < r ? exact.p(s) : exact.p_before_release(r);
        return std::exp(-w * beta * r) * (std::cos(turn * r) + w * beta / turn * std::sin(turn * r)) *
               std::pow(p, -0.2L);
      },
      0, exact.release());
  return static_cast<double>(sum) / e;
}

TEST(DampedBounce, HeightsShrinkByTheSquareOfTheRestitution) {
  requirement("normal.bounce");
  constexpr double e = 0.8;
  const double v = std::sqrt(2 * g * (drop - ball_radius));
  for (const double young : {1e7, 1e8, 1e9, 1e10}) {
    Scene scene = drop_scene(young);
    scene.model.pull = true;
    scene.contact.restitution = e;
    const std::vector<double> heights = peaks_of(scene, 3);
    const double mass = mass_of(of_modulus(young), ball_radius, DiscMass::sphere);
    const double stiffness = hertz_stiffness(softness(of_modulus(young)), ball_radius);
    const double weight = g * std::pow(mass * v * v / stiffness, 0.4) / (v * v);  // g L / v^2
    double sum = 0;  // of the weight, which grows as v^(-6/5) from bounce to bounce
    double squares = 0;
    for (int k = 1; k <= 3; ++k) {
      sum += std::pow(e, -1.2 * (k - 1));
      squares += std::pow(e, -2.4 * (k - 1));
      const double want = std::pow(e, 2 * k) * std::exp(-2 * loss_by_weight(e) * weight * sum);
      expect("E = " + std::to_string(young) + ", peak " + std::to_string(k) + ": (h_k - R)/(h - R)",
             (heights.at(k - 1) - ball_radius) / (drop - ball_radius), want,
             relative(2 * 0.79 * weight * weight * squares, "next term in g L/v^2, C measured at one peak, doubled"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification
