#include "verification/studies/published_problems.h"

#include <algorithm>
#include <cmath>

namespace furrow::verification {
namespace {

using std::cos, std::sin, std::sqrt;

// Both precisions from one formula f(t, piece, y, dydt).
template <class Formula>
PublishedProblem with(PublishedProblem problem, Formula f) {
  problem.rate = f;
  problem.long_rate = f;
  return problem;
}

constexpr double mu = 0.012277471;                                    // mass of the moon, of both
constexpr double arenstorf_period = 17.0652165601579625588917206249;  // s
constexpr double arenstorf_speed = -2.00158510637908252240537862224;  // m/s
constexpr double eta = 3;                                             // of CVODE's Van der Pol

std::vector<PublishedProblem> scalar_ones() {
  return {
      with({.name = "A1", .equation = "y' = -y", .start = {1}, .published = {2.061153353012535e-09}, .digits = 2e-7},
           [](auto, int, const auto& y, auto& d) { d[0] = -y[0]; }),
      with({.name = "A2", .equation = "y' = -y^3/2", .start = {1}, .published = {0.2182178902359887}},
           [](auto, int, const auto& y, auto& d) { d[0] = -y[0] * y[0] * y[0] / 2; }),
      with({.name = "A3", .equation = "y' = y cos t", .start = {1}, .published = {2.491650271850414}},
           [](auto t, int, const auto& y, auto& d) { d[0] = y[0] * cos(t); }),
      with({.name = "A4", .equation = "y' = y/4 (1 - y/20)", .start = {1}, .published = {17.73016648131483}},
           [](auto, int, const auto& y, auto& d) { d[0] = y[0] / 4 * (1 - y[0] / 20); }),
      with({.name = "A5", .equation = "y' = (y - t)/(y + t)", .start = {4}, .published = {-0.7887826688964196}},
           [](auto t, int, const auto& y, auto& d) { d[0] = (y[0] - t) / (y[0] + t); }),
  };
}

std::vector<PublishedProblem> systems() {
  return {
      with({.name = "B1",
            .equation = "a' = 2 (a - a b), b' = a b - b",
            .start = {1, 3},
            .published = {0.6761876008576667, 0.1860816099640036}},
           [](auto, int, const auto& y, auto& d) {
             d[0] = 2 * (y[0] - y[0] * y[1]);
             d[1] = -(y[1] - y[0] * y[1]);
           }),
      with({.name = "B2",
            .equation = "a' = b - a, b' = a - 2 b + c, c' = b - c",
            .start = {2, 0, 1},
            .published = {1.000000001030576, 1, 0.9999999989694235},
            .judged = 2},
           [](auto, int, const auto& y, auto& d) {
             d[0] = -y[0] + y[1];
             d[1] = y[0] - 2 * y[1] + y[2];
             d[2] = y[1] - y[2];
           }),
      with({.name = "B3",
            .equation = "a' = -a, b' = a - b^2, c' = b^2",
            .start = {1, 0, 0},
            .published = {2.061153488557776e-09, 0.05257228022048349, 0.947427717718363}},
           [](auto, int, const auto& y, auto& d) {
             d[0] = -y[0];
             d[1] = y[0] - y[1] * y[1];
             d[2] = y[1] * y[1];
           }),
      with({.name = "B5",
            .equation = "a' = b c, b' = -a c, c' = -0.51 a b",
            .start = {0, 1, 1},
            .published = {-0.9396570798729192, -0.3421177754000779, 0.7414126596199957}},
           [](auto, int, const auto& y, auto& d) {
             d[0] = y[1] * y[2];
             d[1] = -y[0] * y[2];
             d[2] = -0.51 * y[0] * y[1];
           }),
  };
}

std::vector<PublishedProblem> second_order_ones() {
  return {
      with({.name = "E2",
            .equation = "q'' = (1 - q^2) q' - q",
            .start = {2, 0},
            .published = {2.008149762174948, -0.04250887527320057},
            .second_order = true},
           [](auto, int, const auto& y, auto& d) {
             d[0] = y[1];
             d[1] = (1 - y[0] * y[0]) * y[1] - y[0];
           }),
      with({.name = "E3",
            .equation = "q'' = q^3/6 - q + 2 sin 2.78535 t",
            .start = {0, 0},
            .published = {-0.1004178858647128, 0.2411400132095954},
            .second_order = true,
            .velocity_matters = false},
           [](auto t, int, const auto& y, auto& d) {
             d[0] = y[1];
             d[1] = y[0] * y[0] * y[0] / 6 - y[0] + 2 * sin(2.78535 * t);
           }),
      with({.name = "E4",
            .equation = "q'' = 0.032 - 0.4 q'^2",
            .start = {30, 0},
            .published = {33.95091444646555, 0.2767822659672869},
            .least_steps = 20,
            .second_order = true},
           [](auto, int, const auto& y, auto& d) {
             d[0] = y[1];
             d[1] = 0.032 - 0.4 * y[1] * y[1];
           }),
      with({.name = "E5",
            .equation = "q'' = sqrt(1 + q'^2)/(25 - t)",
            .start = {0, 0},
            .published = {14.11797390542629, 2.4},
            .second_order = true},
           [](auto t, int, const auto& y, auto& d) {
             d[0] = y[1];
             d[1] = sqrt(1 + y[1] * y[1]) / (25 - t);
           }),
      with({.name = "Van der Pol",
            .equation = "q'' = 3 (1 - q^2) q' - q",
            .start = {2, 0},
            .published = {1.680102, -0.291056},
            .digits = 1e-6,
            .end = 1.39284,
            .floor = 1e-13,
            .least_steps = 20,
            .fastest = 9,
            .second_order = true},
           [](auto, int, const auto& y, auto& d) {
             d[0] = y[1];
             d[1] = eta * (1 - y[0] * y[0]) * y[1] - y[0];
           }),
      with({.name = "Arenstorf",
            .equation = "restricted three bodies, mu = 0.012277471",
            .start = {0.994, 0, 0, arenstorf_speed},
            .published = {0.994, 0, 0, arenstorf_speed},
            .digits = 1e-9,
            .end = arenstorf_period,
            .floor = 1e-8,
            .least_steps = 40000,
            .order_two = 32,
            .order_one = 0,
            .fastest = 200,
            .second_order = true},
           [](auto, int, const auto& y, auto& d) {
             const auto cube = [](auto x, auto z) { return (x * x + z * z) * sqrt(x * x + z * z); };
             const auto earth = (1 - mu) / cube(y[0] + mu, y[1]), moon = mu / cube(y[0] - (1 - mu), y[1]);
             d[0] = y[2];
             d[1] = y[3];
             d[2] = y[0] + 2 * y[3] - earth * (y[0] + mu) - moon * (y[0] - (1 - mu));
             d[3] = y[1] - 2 * y[2] - earth * y[1] - moon * y[1];
           }),
  };
}

PublishedProblem with_jumps(const std::string& name, bool located) {
  return with({.name = name,
               .equation = "y' = 55 - 1.5 y, 55 - 0.5 y, by turns, a second each",
               .start = {110},
               .published = {70.03731057008607},
               .jumps = true,
               .located = located},
              [](auto t, int piece, const auto& y, auto& d) {
                const int now = piece < 0 ? static_cast<int>(std::floor(t)) : piece;
                d[0] = 55 - (now % 2 == 0 ? 1.5 : 0.5) * y[0];
              });
}

}  // namespace

const std::vector<PublishedProblem>& published_problems() {
  static const std::vector<PublishedProblem> all = [] {
    std::vector<PublishedProblem> list = scalar_ones();
    for (auto* make : {systems, second_order_ones})
      for (PublishedProblem& p : make()) list.push_back(std::move(p));
    list.push_back(with_jumps("F2", false));
    list.push_back(with_jumps("F2, located", true));
    return list;
  }();
  return all;
}

// The time travels as the last number.
State extrapolated(const PublishedProblem& problem, double t) {
  Numbers y(problem.start.begin(), problem.start.end());
  y.push_back(0);
  const int steps = std::max(800, 2 * problem.least_steps), pieces = problem.jumps ? static_cast<int>(t) : 1;
  for (int n = 0; n < steps; ++n) {
    const int piece = problem.jumps ? n * pieces / steps : -1;
    const Rate f = [&](const Numbers& at) {
      Numbers d(at.size());
      problem.long_rate(at.back(), piece, at, d);
      d.back() = 1;
      return d;
    };
    y = extrapolated_step(f, y, static_cast<long double>(t) / steps);
  }
  y.pop_back();
  return rounded(y);
}

std::string PublishedSystem::velocity_dependence() const {
  if (!problem_.second_order) return "y' = f(t, y)";
  return problem_.velocity_matters ? "q'' = f(t, q, q')" : "";
}

void PublishedSystem::rhs(double t, const State& y, State& dydt) const { problem_.rate(t, piece_, y, dydt); }

}  // namespace furrow::verification
