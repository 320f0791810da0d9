// A stem held at its lower end: small and large deflection, first swing, buckling.
//
//   across, small:  d = P L^3/(3 EI) + P L/GA
//   across, any size (the elastica), a = L sqrt(P/EI), p = sqrt((1 + sin f)/2), f the slope of the tip:
//     a = K(p) - F(t, p),  sin t = 1/(p sqrt 2)
//     along  x/L = sqrt(2 sin f)/a,  across  d/L = 1 - 2 (E(p) - E(t, p))/a
//   swing:  w = 1.8751^2 sqrt(EI/(rho A L^4)), less by shear and rotary inertia, about 5/2 (d/4L)^2 (1 + EA/GA) of it
//   buckling:  P_E = pi^2 EI/(2 L)^2,  P = P_E/(1 + P_E/GA)
//
// Source: Timoshenko and Gere 1961; Bisshopp and Drucker 1945, Q. Appl. Math. 3, 272; Engesser 1891.
#include <cmath>

#include "verification/check.h"
#include "verification/stem_scenes.h"

namespace furrow::verification::stem {
namespace {

constexpr double length = 0.12;  // m: 20 diameters
const double GA = EA / (2 * (1 + 1.0 / 3));

Rest pushed(double across, double along) {
  Scene scene = scene_of({});
  load(scene, 1, {across, along});
  const System system(scene);
  Rest rest{system, system.initial_state()};
  constexpr int parts = 8;  // of the load, each from where the one before came to rest
  for (int k = 1; k <= parts; ++k) {
    scene.lattice[0].node[0].force = {across * k / parts, along * k / parts};
    rest = {System(scene), rest.y};
    rest.y = verification::at_rest(rest.system, 0, rest.y, 1e-6 * diameter);
  }
  return rest;
}

TEST(StemBending, TipYieldsAsTimoshenkoSays) {
  requirement("stem.cantilever");
  const double load = 1e-3;  // N
  const Rest rest = pushed(load, 0);
  expect("tip deflection [m]", rest.at(rest.rows() - 1, 1).x - diameter / 2,
         load * (std::pow(length, 3) / (3 * EI) + length / GA),
         relative(4.2e-3, "the clamp holds the width of half a row, s/2, whose EI is 9/8 then: 3 (1/9) (s/2)/L"));
}

// Sine of the slope by bisection, then along and across, of the length.
Vec2 elastica(double a) {
  const auto left = [&](double f) {
    const double p = std::sqrt((1 + std::sin(f)) / 2);
    return std::comp_ellint_1(p) - std::ellint_1(p, std::asin(1 / (p * std::sqrt(2.0)))) - a;
  };
  double low = 1e-9, high = pi / 2 - 1e-9;
  while (high - low > 1e-14) (left(0.5 * (low + high)) > 0 ? high : low) = 0.5 * (low + high);
  const double p = std::sqrt((1 + std::sin(low)) / 2), t = std::asin(1 / (p * std::sqrt(2.0)));
  return {1 - 2 * (std::comp_ellint_2(p) - std::ellint_2(p, t)) / a, std::sqrt(2 * std::sin(low)) / a};
}

TEST(StemBending, LargeDeflectionIsTheElastica) {
  requirement("stem.elastica");
  expect("across, a^2 = 1, of the length", elastica(1).x, 0.30172, absolute(5e-6, "five digits in the literature"));
  for (const double squared : {1.0, 4.0}) {
    const Rest rest = pushed(squared * EI / (length * length), 0);
    const Vec2 tip = rest.at(rest.rows() - 1, 1), want = elastica(std::sqrt(squared));
    const char* reason =
        "stretch and shear, P/GA and P/EA: at most a^2 (d/4L)^2 (1 + EA/GA) = 2.3e-3; the clamp as above";
    const std::string name = ", a^2 = " + std::to_string(squared);
    expect("across, of the length" + name, (tip.x - diameter / 2) / length, want.x, absolute(3e-3, reason));
    expect("along, of the length" + name, tip.y / length, want.y, absolute(3e-3, reason));
  }
}

TEST(StemBending, SwingsFirstAsItsRod) {
  requirement("stem.swing");
  const System system(scene_of({}));
  const Eigen::MatrixXd k = tangent(system, 0, system.initial_state(), 1e-6 * diameter);
  const double slowest = softest_mode(k);
  const double beam = std::pow(1.8751040687119611 / length, 2) * std::sqrt(EI / (density * area));
  const double slower = 5 * std::pow(diameter / (4 * length), 2) * (1 + EA / GA) / 2;
  expect("first frequency, of the thin rod's", std::sqrt(slowest) / beam, 1 - slower,
         absolute(slower + 2.1e-3, "the factor of the mode is between 1 and 10; half of the clamp's 4.2e-3 above"));
}

TEST(StemBending, BucklesAtEulersLoad) {
  requirement("stem.buckling");
  const double euler = pi * pi * EI / (4 * length * length);
  const auto softest = [&](double load) {  // 1/s^2, of the stem under the load along it
    const Rest rest = pushed(0, -load);
    return softest_mode(tangent(rest.system, 0, rest.y, 1e-6 * diameter));
  };
  const double low = 0.9 * euler, high = 1.1 * euler;  // it stiffens almost in proportion to P - load
  const double at_low = softest(low), got = low + (high - low) * at_low / (at_low - softest(high));
  expect("buckling load, of Euler's", got / euler, 1 / (1 + euler / GA),
         absolute(4e-3, "the clamp, as above; the bend of the line between the two loads"));
}

}  // namespace
}  // namespace furrow::verification::stem
