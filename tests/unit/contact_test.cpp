// Hertz-Mindlin: every expected number is worked out here, from the equations at the top of physics/contact.h.
#include "physics/contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/contact_force.h"

namespace furrow {
namespace {

// A few multiplications and roots: some units in the last place.
constexpr double round_off = 1e-14;
void expect_close(double got, double want) { EXPECT_NEAR(got, want, round_off * std::fabs(want)); }

// E* = 133333.3 Pa, G* = 40000 Pa, beta = 20. With R* = 0.04 m, d = 1e-4 m and m* = 0.03 kg:
//   sqrt(R* d)  = 2e-3 m
//   Sn          = 1600/3 N/m
//   St          = 640 N/m
//   Fe          = 2/3 Sn d = 0.32/9 N
//   sqrt(Sn m*) = 4 kg/s
//   sqrt(St m*) = sqrt(19.2) kg/s
constexpr Elastic paper{.young = 2e5, .poisson = -0.5, .rigid = false};
constexpr Elastic rigid{.young = 0, .poisson = 0, .rigid = true};
constexpr double elastic = 0.32 / 9;                // N
const double viscous = 160 * std::sqrt(5.0 / 6.0);  // N s/m, 2 sqrt(5/6) 20 sqrt(Sn m*)

ContactLaw paper_law(double mu = 0.5, double mu_rolling = 0.5, bool pull = false) {
  ContactLaw law = contact_law(paper, paper, 20, mu, mu_rolling);
  if (pull) let_pull(law);
  return law;
}

Touch touch() {
  return {
      .overlap = 1e-4, .approach = 0, .slip = 0, .spring = 0, .spin = 0, .reduced_radius = 0.04, .reduced_mass = 0.03};
}

TEST(ContactModuli, PaperMaterialAgainstItself) {
  const ContactLaw law = paper_law();
  expect_close(law.modulus, 2e5 / (2 * 0.75));       // (1 - 0.25)/E twice
  expect_close(law.shear_modulus, 2e5 / (2 * 2.5));  // G = E, (2 + 0.5)/G twice
  EXPECT_NEAR(law.modulus, 133333.3, 0.05);
  EXPECT_NEAR(law.shear_modulus, 40000, 1e-9);
}

TEST(ContactModuli, RigidPartnerAddsNothing) {
  const ContactLaw law = contact_law(paper, rigid, 20, 0.5, 0.5);
  expect_close(law.modulus, 2e5 / 0.75);
  expect_close(law.shear_modulus, 2e5 / 2.5);
}

TEST(ContactModuli, DifferentMaterialsAddCompliances) {
  const Elastic one{.young = 1e6, .poisson = 0.25, .rigid = false};  // (1 - 1/16)/1e6; G = 4e5: 1.75/4e5
  const Elastic two{.young = 3e6, .poisson = 0.5, .rigid = false};   // 0.75/3e6; G = 1e6: 1.5/1e6
  const ContactLaw law = contact_law(one, two, 0, 0, 0);
  expect_close(law.modulus, 1e6 / 1.1875);
  expect_close(law.shear_modulus, 1e6 / 5.875);
}

TEST(ContactModuli, OrderOfPartnersDoesNotMatter) {
  const Elastic one{.young = 1e6, .poisson = 0.25, .rigid = false};
  const Elastic two{.young = 3e6, .poisson = 0.5, .rigid = false};
  const ContactLaw forth = contact_law(one, two, 0.1, 0.2, 0.3);
  const ContactLaw back = contact_law(two, one, 0.1, 0.2, 0.3);
  EXPECT_EQ(forth.modulus, back.modulus);
  EXPECT_EQ(forth.shear_modulus, back.shear_modulus);
}

TEST(NormalForce, ElasticPartAndStiffness) {
  const TouchForce f = hertz_mindlin(paper_law(), touch(), 1);
  expect_close(f.stiffness, 1600.0 / 3);
  expect_close(f.shear_stiffness, 640);
  expect_close(f.elastic, elastic);
  expect_close(f.normal, elastic);
}

TEST(NormalForce, GrowsWithOverlapToTheThreeHalves) {
  Touch c = touch();
  c.overlap = 4e-4;
  expect_close(hertz_mindlin(paper_law(), c, 1).elastic, 8 * elastic);
}

TEST(NormalForce, GrowsWithTheRootOfTheRadius) {
  Touch c = touch();
  c.reduced_radius = 0.16;
  expect_close(hertz_mindlin(paper_law(), c, 1).elastic, 2 * elastic);
}

TEST(NormalForce, ViscousPartOpposesApproach) {
  Touch c = touch();
  c.approach = 1e-3;
  expect_close(hertz_mindlin(paper_law(), c, 1).normal, elastic + viscous * 1e-3);
}

TEST(NormalForce, ViscousPartGrowsWithTheRootOfTheMass) {
  Touch c = touch();
  c.approach = 1e-3;
  c.reduced_mass = 0.12;
  expect_close(hertz_mindlin(paper_law(), c, 1).normal, elastic + 2 * viscous * 1e-3);
}

TEST(NormalForce, NeverPulls) {
  Touch c = touch();
  c.approach = -1e-3;  // 0.0356 N of push against 0.146 N of viscous pull
  const TouchForce f = hertz_mindlin(paper_law(), c, 1);
  EXPECT_EQ(f.normal, 0);
  expect_close(f.elastic, elastic);
}

TEST(NormalForce, PullsIfAllowed) {
  Touch c = touch();
  c.approach = -1e-3;
  expect_close(hertz_mindlin(paper_law(0.5, 0.5, true), c, 1).normal, elastic - viscous * 1e-3);
}

TEST(TangentialForce, SticksBelowTheCoulombLimit) {
  Touch c = touch();
  c.spring = 1e-6;
  c.slip = -1e-5;
  const double dashpot = 40 * std::sqrt(5.0 / 6.0) * std::sqrt(19.2);  // N s/m
  const TouchForce f = hertz_mindlin(paper_law(), c, 1);
  expect_close(f.shear_viscosity, dashpot);
  expect_close(f.tangential, -640 * 1e-6 + dashpot * 1e-5);
}

TEST(TangentialForce, IsLimitedByFrictionBothWays) {
  Touch c = touch();
  c.spring = 1e-3;  // 0.64 N, limit 0.5 * 0.0356 N
  expect_close(hertz_mindlin(paper_law(), c, 1).tangential, -0.5 * elastic);
  c.spring = -1e-3;
  expect_close(hertz_mindlin(paper_law(), c, 1).tangential, 0.5 * elastic);
}

TEST(TangentialForce, LimitCountsTheViscousPush) {
  Touch c = touch();
  c.spring = 1;
  c.approach = 1e-3;
  expect_close(hertz_mindlin(paper_law(0.3), c, 1).tangential, -0.3 * (elastic + viscous * 1e-3));
}

TEST(TangentialForce, VanishesWithoutFrictionOrPush) {
  Touch c = touch();
  c.spring = 1e-3;
  c.slip = 0.1;
  EXPECT_EQ(hertz_mindlin(paper_law(0), c, 1).tangential, 0);
  c.approach = -1;  // clipped, and pulling
  EXPECT_EQ(hertz_mindlin(paper_law(0.5), c, 1).tangential, 0);
  EXPECT_EQ(hertz_mindlin(paper_law(0.5, 0.5, true), c, 1).tangential, 0);
}

TEST(RollingMoment, OpposesRelativeSpin) {
  Touch c = touch();
  c.spin = 3;  // rad/s, against w0 = 4 rad/s: 3/5
  expect_close(hertz_mindlin(paper_law(0.5, 0.25), c, 4).moment, -0.25 * 0.04 * elastic * 0.6);
  c.spin = -3;
  expect_close(hertz_mindlin(paper_law(0.5, 0.25), c, 4).moment, 0.25 * 0.04 * elastic * 0.6);
}

TEST(RollingMoment, SaturatesAtFastSpin) {
  Touch c = touch();
  c.spin = 1e9;  // w0/w = 1e-9: short of its limit by 5e-19
  expect_close(hertz_mindlin(paper_law(0.5, 0.25), c, 1).moment, -0.25 * 0.04 * elastic);
}

TEST(RollingMoment, VanishesWithoutPush) {
  Touch c = touch();
  c.spin = 3;
  c.approach = -1;
  EXPECT_EQ(hertz_mindlin(paper_law(), c, 1).moment, 0);
  EXPECT_EQ(hertz_mindlin(paper_law(0.5, 0.5, true), c, 1).moment, 0);
}

TEST(RollingMoment, IsLeftOutWhereNothingRolls) {
  Touch c = touch();
  c.spin = 3;
  EXPECT_EQ(hertz_mindlin(paper_law(0.5, 0), c, 1).moment, 0);
}

TEST(ElasticEnergy, IsTheIntegralOfTheElasticForce) {
  // Simpson's rule in s = sqrt(d), where F dd = 2 K s^4 ds; 200 intervals leave an error of 1e-10.
  const int intervals = 200;
  const double end = 1e-2;
  double sum = 0;
  for (int k = 0; k <= intervals; ++k) {
    const double s = end * k / intervals;
    sum += (k == 0 || k == intervals ? 1 : k % 2 == 1 ? 4 : 2) * 2 * (elastic / 1e-6) * s * s * s * s;
  }
  const double integral = sum * end / intervals / 3;
  EXPECT_NEAR(elastic_energy(elastic, 1e-4), integral, 1e-8 * integral);
}

TEST(DampingFactor, OfKnownRestitutions) {
  EXPECT_EQ(damping_factor(1), 0);
  expect_close(damping_factor(std::exp(-3.14159265358979323846)), std::sqrt(0.5));        // ln e = -pi
  expect_close(damping_factor(std::exp(-3.14159265358979323846 / std::sqrt(3.0))), 0.5);  // 1/sqrt(1 + 3)
}

// alpha = 20, a reading of the paper's "damping factor 20": beta = 8.944.
TEST(DampingFactor, IsTsujisCoefficientOverTheRootOfFive) {
  expect_close(damping_factor_of_tsuji(20), 8.94427190999916);
  EXPECT_EQ(damping_factor_of_tsuji(0), 0);
}

// The law maps a head-on impact to an oscillator of damping ratio beta, so that e = exp(-pi beta/sqrt(1 - beta^2)).
TEST(DampingFactor, GivesTheRestitutionBack) {
  for (const double e : {0.05, 0.3, 0.7, 0.95}) {
    const double beta = damping_factor(e);
    EXPECT_NEAR(std::exp(-3.14159265358979323846 * beta / std::sqrt(1 - beta * beta)), e, 1e-13);
  }
}

// xi* = mu Fe/St = mu E* d/(6 G*), damped or not, so that xi* d'/(2 d) has no d in it.
TEST(RescaledMindlin, ASpringBeyondItsLimitHasABoundedRateHoweverSmallTheOverlap) {
  for (const double beta : {0.0, 0.2, 0.9}) {
    ContactLaw law = contact_law(paper, paper, beta, 0.5, 0);
    law.options.force = ForceLaw::rescaled_mindlin;
    for (const double overlap : {1e-6, 1e-12, 1e-18}) {
      for (const double spring : {1e-4, -1e-4}) {
        Touch c = touch();
        c.overlap = overlap;
        c.spring = spring;
        c.approach = 0.1;
        c.slip = 0.3;
        const double most = 0.5 * law.modulus * 0.1 / (12 * law.shear_modulus);
        expect_close(spring_rate(law, c, contact_force(law, c, 1)), 0.3 - (spring > 0 ? most : -most));
        c.approach = -0.1;
        EXPECT_EQ(spring_rate(law, c, contact_force(law, c, 1)), 0.3);
      }
    }
  }
}

// What the spring stores, by its own rate and by that of St, is what its force was given, less what is lost, and what is
// supplied beyond twice the limit.
TEST(RescaledMindlin, BooksWhatItDoesNotStoreWithinItsLimitAndBeyond) {
  int supplied = 0;
  for (const double beta : {0.0, 0.2}) {
    ContactLaw law = contact_law(paper, paper, beta, 0.5, 0);
    law.options.force = ForceLaw::rescaled_mindlin;
    for (const double spring : {1e-6, -1e-6, 4e-5, -4e-5, 1e-4, -1e-4}) {  // the limit is 2.8e-5 m
      for (const double approach : {0.1, -0.1}) {
        Touch c = touch();
        c.spring = spring;
        c.approach = approach;
        c.slip = 0;
        const TouchForce f = contact_force(law, c, 1);
        const double stores = f.shear_stiffness * spring * spring_rate(law, c, f) +
                              0.25 * f.shear_stiffness * spring * spring * approach / c.overlap;
        const TouchPowers p = contact_powers(law, c, f);
        EXPECT_GE(p.stiffening, 0);
        supplied += p.stiffening > 0 ? 1 : 0;
        expect_close(p.stiffening - p.sliding - p.sticking, stores);
      }
    }
  }
  EXPECT_EQ(supplied, 4) << "both signs of 1e-4, damped and not, while the contact loads";
}

// kt xi^2/2 is heat of friction, kr theta^2/2 of rolling.
TEST(EnergyAtOpening, IsBookedSpringBySpring) {
  ContactLaw law = contact_law(paper, paper, 0, 0.5, 0.1);
  law.options.rolling_spring = true;
  const SpringEnergies of_hertz = energy_at_opening(law, 0.1, 2e-3, 0.3);
  EXPECT_EQ(of_hertz.tangential, 0);
  EXPECT_EQ(of_hertz.rolling, 0);
  law.options.rolling_stiffness = 7;
  EXPECT_EQ(energy_at_opening(law, 0.1, 2e-3, 0.3).tangential, 0);
  expect_close(energy_at_opening(law, 0.1, 2e-3, 0.3).rolling, 0.5 * 7 * 0.09);
  law.options.force = ForceLaw::linear;
  law.options.tangential_stiffness = 500;
  expect_close(energy_at_opening(law, 0.1, 2e-3, 0.3).tangential, 0.5 * 500 * 4e-6);
  expect_close(energy_at_opening(law, 0.1, 2e-3, 0.3).rolling, 0.5 * 7 * 0.09);
}

}  // namespace
}  // namespace furrow
