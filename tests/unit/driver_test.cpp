// Whom `furrow stability` names as the driver of a motion: the contact with the greatest power |dF . dv|, by the law of
// the contact. Expected from the Jacobian by differences, of which the law's own formulas are no part.
#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "methods/method.h"
#include "report/linearise.h"
#include "run/events.h"

namespace furrow {
namespace {

// Two discs pressed into a floor each, too far from each other to touch: two contacts that share nothing.
Scene two_discs_on_a_floor() {
  Scene s;
  s.material = {{.name = "one", .young = 1e6, .poisson = 0.25},
                {.name = "other", .young = 1e6, .poisson = 0.25},
                {.name = "floor", .young = 1e6, .poisson = 0.25}};
  s.wall = {{"", {0, 0}, {0, 1}, "floor"}};
  s.contact.damping_factor = 0.5;
  const double radius = 0.01, overlap = 1e-4;  // m
  s.disc = {{{0, radius - overlap}, radius, {}, 0, "one"}, {{1, radius - overlap}, radius, {}, 0, "other"}};
  return s;
}

// All speeds and spins of one body.
struct Moving {
  double vx = 0, vy = 0, spin = 0;  // m/s, rad/s
};

// W: of the forces on a disc that answer to its own motion. Speeds act on forces at once, and by the place and the springs
// that they change, at a rate (1/s).
double power(const System& system, const Linearised& l, int disc, const Moving& moving, double rate) {
  const Eigen::MatrixXd j = l.rates;
  Eigen::VectorXd v = Eigen::VectorXd::Zero(j.rows());
  std::vector<std::pair<int, double>> places{{system.vx_of(disc), system.parts().disc.mass[disc]},
                                             {system.vy_of(disc), system.parts().disc.mass[disc]}};
  v[system.vx_of(disc)] = moving.vx;
  v[system.vy_of(disc)] = moving.vy;
  if (system.has_friction()) {
    places.emplace_back(system.spin_of(disc), system.parts().disc.inertia[disc]);
    v[system.spin_of(disc)] = moving.spin;
  }
  const Eigen::VectorXd at_once = j * v;  // also how places and springs change
  Eigen::VectorXd changed = at_once;
  for (const auto& [place, inertia] : places) changed[place] = 0;
  const Eigen::VectorXd later = j * changed / rate;
  double sum = 0;
  for (const auto& [place, inertia] : places) sum -= inertia * v[place] * (at_once[place] + later[place]);
  return sum;
}

// Both discs move alike. The share of the one whose contact has the greater power, and how that acts.
void expect_first_drives(const Scene& scene, const Moving& moving, const std::string& how) {
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method("pece");
  jump(system, *method, 0, y);
  const Linearised l = linearise(system, 0, y);
  const double rate = 300;  // 1/s
  const std::array powers{power(system, l, 0, moving, rate), power(system, l, 1, moving, rate)};
  ASSERT_GT(powers[0], 1.05 * powers[1]);  // the case is one
  Eigen::VectorXcd motion = Eigen::VectorXcd::Zero(l.rates.rows());
  for (const int disc : {0, 1}) {
    motion[system.vx_of(disc)] = moving.vx;
    motion[system.vy_of(disc)] = moving.vy;
    if (system.has_friction()) motion[system.spin_of(disc)] = moving.spin;
  }
  const Driver driver = driver_of(system, 0, y, l, motion, {-rate, 0});
  EXPECT_EQ(driver.name, "contact of disc 0 and wall 0");
  EXPECT_EQ(driver.how, how);
  // Central differences over 1e-5 of the overlap: their error is some 1e-10.
  EXPECT_NEAR(driver.share, powers[0] / (powers[0] + powers[1]), 1e-9);
}

TEST(Driver, IsTheContactWithADashpot) {
  Scene s = two_discs_on_a_floor();
  s.contact.pair = {{.materials = {"one", "floor"}, .damping = 50}};  // N s/m; beta gives the other 17
  expect_first_drives(s, {.vy = 1}, "normal");
}

TEST(Driver, IsTheContactThatRollsOnTheStifferSpring) {
  Scene s = two_discs_on_a_floor();
  s.model.rolling = Rolling::spring;
  s.contact.friction = 0.5;
  s.contact.rolling_friction = 0.1;
  s.contact.pair = {{.materials = {"one", "floor"}, .rolling_stiffness = 100, .rolling_damping = 2}};
  expect_first_drives(s, {.spin = 1}, "rolling");
}

// The slope of the smoothed moment is least where a disc spins fast.
TEST(Driver, IsTheContactOfTheDiscThatSpinsTheLeast) {
  Scene s = two_discs_on_a_floor();
  s.contact.friction = 0;
  s.contact.rolling_friction = 0.5;
  s.disc[0].spin = 0.5;
  s.disc[1].spin = 4;
  expect_first_drives(s, {.spin = 1}, "rolling");
}

// A force that is zero because no contact may pull answers to nothing.
TEST(Driver, IsNoContactThatLetsGo) {
  Scene s = two_discs_on_a_floor();
  s.disc[1].velocity = {0, 10};
  expect_first_drives(s, {.vy = 1}, "normal");
}

}  // namespace
}  // namespace furrow
