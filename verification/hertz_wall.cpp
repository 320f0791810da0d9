// An elastic disc or sphere meets a wall head-on and comes back as fast as it came.
//
//   m d'' = -K d^(3/2),  d(0) = 0, d'(0) = v
//   K = 4/3 E* sqrt(R),  1/E* = (1 - nu^2)/E + (1 - nu_w^2)/E_w
//   d_max = (5 m v^2 / (4 K))^(2/5)
//   F_max = K d_max^(3/2)
//   t_c = (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) d_max / v
//
// Source: Hertz 1882; test 2 of Chung and Ooi 2011 (Granular Matter 13, 643): sphere of radius 0.1 m at 0.2 m/s.
// For a rigid wall the second term of 1/E* vanishes; a wall of the sphere's material doubles it.
#include "verification/hertz_wall.h"

#include "run/observe.h"

namespace furrow::verification::hertz_wall {
namespace {

struct Published {
  double overlap, force, time;  // m, N, s
};

void expect_published(const std::string& what, const Hertz& h, const Published& p) {
  expect(what + ": d_max of the table [m]", p.overlap, h.peak_overlap(), last_digit(1e-8));
  expect(what + ": F_max of the table [N]", p.force, h.peak_force(), last_digit(5e-7));
  expect(what + ": t_c of the table [s]", p.time, h.contact_time(), last_digit(7e-9));
}

void expect_elastic(const std::string& what, const Hertz& h, const Scene& scene) {
  expect_hertz(what, h, scene, h.mass, steps);
}

TEST(HertzWall, ClosedFormAgreesWithQuadratureAndTheTable) {
  requirement("normal.hertz_wall");
  const Hertz h = closed_form(aluminium, DiscMass::sphere, true);
  expect("t_c v / d_max by quadrature", static_cast<double>(2 * integral_of_contact()),
         h.contact_time() * speed / h.peak_overlap(), relative(1e-15, "round-off of tgamma and pow"));
  expect_published("aluminium, rigid wall", h, {4.9717175e-5, 11369.86, 7.3165664e-4});
  expect_published("magnesium, rigid wall", closed_form(magnesium, DiscMass::sphere, true),
                   {5.2123288e-5, 7232.681, 7.6706591e-4});
  expect_published("aluminium, wall of aluminium", closed_form(aluminium, DiscMass::sphere, false),
                   {6.5602206e-5, 8616.74, 9.6542673e-4});
}

TEST(HertzWall, RigidWallGivesOverlapForceAndTimeOfHertz) {
  requirement("normal.hertz_wall");
  for (const Matter& m : {aluminium, magnesium}) {
    for (const DiscMass reading : {DiscMass::sphere, DiscMass::disc}) {
      expect_elastic(std::string(m.name) + (reading == DiscMass::disc ? " disc" : " sphere"),
                     closed_form(m, reading, true), wall_impact(m, radius, speed, reading, true));
    }
  }
}

TEST(HertzWall, WallOfTheSameMaterialHalvesTheModulus) {
  requirement("normal.hertz_wall");
  expect_elastic("aluminium on aluminium", closed_form(aluminium, DiscMass::sphere, false),
                 wall_impact(aluminium, radius, speed, DiscMass::sphere, false));
}

TEST(HertzWall, LeaningWallIsTheSameWall) {
  requirement("normal.hertz_wall");
  Scene scene = wall_impact(aluminium, radius, speed, DiscMass::sphere, true, -0.6, 0.8);
  scene.wall[0].normal = {-3, 4};  // any length will do
  expect_elastic("normal (-3, 4)", closed_form(aluminium, DiscMass::sphere, true), scene);
}

TEST(HertzWall, ContactHoldsTheWholeEnergyAtTheTurn) {
  requirement("normal.hertz_wall");
  const Hertz h = closed_form(aluminium, DiscMass::sphere, true);
  const double half = h.contact_time() / 2;
  const Ran ran =
      run_scene(wall_impact(aluminium, radius, speed, DiscMass::sphere, true), "rk4", half / (steps / 2.0), half);
  const Energies energy = observe(ran.system, half, ran.y).energy;
  const auto truncation = relative(2 * 0.1 * std::pow(steps, -2.5), "truncation of rk4, C N^-5/2, C measured, doubled");
  expect("elastic energy over m v^2/2", energy.contact_elastic / (0.5 * h.mass * speed * speed), 1, truncation);
}

// From a start at the touch the order is that of the first step where the method's own is higher.
TEST(HertzWall, GreatestOverlapConvergesWithTheOrderOfTheMethodButAtMostFiveHalves) {
  requirement("normal.hertz_wall");
  const Hertz h = closed_form(aluminium, DiscMass::sphere, true);
  const Scene scene = wall_impact(aluminium, radius, speed, DiscMass::sphere, true);
  for (const auto& [method, order] : {std::pair{"pece", 2.0}, {"verlet", 2.0}, {"rk4", 2.5}}) {
    std::vector<double> lengths, errors;
    for (const int n : {200, 400, 800, 1600}) {
      const Plan plan{method, h.contact_time() / n, 0.6 * h.contact_time()};
      lengths.push_back(1.0 / n);
      errors.push_back(std::fabs(measure(scene, h.mass, plan).peak_overlap / h.peak_overlap() - 1));
    }
    expect(std::string(method) + ": observed order", fitted_slope(lengths, errors), order,
           absolute(0.04, "the next term of the error, of order 5/2 or 3, is 3 % of the leading one at 200 steps"));
  }
}

}  // namespace
}  // namespace furrow::verification::hertz_wall
