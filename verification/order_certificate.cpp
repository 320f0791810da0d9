// The order of every method of the catalogue on every kind of force: observed against predicted.
//
//   observed    slope of log(error) over log(step), error: root of the mean square over runs whose events fall at
//               different places within a step; with the standard error of the fit (studies/order_observed.h)
//   line        correlation of the two, near 1; points end above round-off, 1e-12 of a smooth motion, 1e-11 of others
//   predicted   min(p, a + 1), where the force at an event starts as (t - t0)^a (studies/order_predicted.h)
//
// The quick form of `furrow study order`. Slope and correlation are what Principia's order tests ask. Sources: closed
// forms; two unrelated integrations where there are none.
#include <string>

#include "run/system.h"
#include "verification/check.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_predicted.h"

namespace furrow::verification {
namespace {

const char* const slope_reason =
    "three standard errors of the fit, by Student's t, and twice what the next power of the step does to the slope, or "
    "0.05, and the predictor's share of the next power; no more than half of what the order would fall by with a "
    "method of one order less; where p is little above the limit, anything between the two";

void expect_line(const std::string& what, const Slope& slope, double least) {
  expect("correlation of log error and log step, " + what, slope.correlation, 1,
         absolute(1 - least,
                  "points that scatter about the line by 3 % of the error on a smooth force, which its next "
                  "power bends; by half where one of the places of an event may make the whole mean square"));
}

void expect_orders(const std::string& name) {
  const Problem& p = problem(name);
  for (const MethodInfo& method : method_catalogue()) {
    if (method.controlled || !applies(method, p)) continue;
    const auto v = verdict(method, p, observe(method.name, p, quick));
    const auto& want = *v.predicted;
    const double room = (want.most - want.position) / 2;
    const auto near = [&](double gate) { return absolute(room + gate, slope_reason); };
    const std::string what = method.name + ", " + p.title;
    expect("order of the position, " + what, v.position.value, want.position + room, near(v.position_gate));
    expect_line("position, " + what, v.position, v.position_line);
    if (want.at_least) {
      expect_true(
          "order of the speed, " + what, v.velocity_holds,
          "after a rebound what is lost on the way in is regained on the way out: at least min(p + 1, a + 1) for "
          "even p; after a tear it follows from the energy alone: at least p");
    } else {
      expect("order of the velocity, " + what, v.velocity.value, want.velocity + room, near(v.velocity_gate));
      expect_line("velocity, " + what, v.velocity, v.velocity_line);
    }
  }
}

TEST(OrderCertificate, SmoothForcesShowTheMethodsOwnOrder) {
  requirement("order.smooth");
  for (const char* name : {"spring", "damped_spring", "driven_spring", "lattice"}) expect_orders(name);
}

TEST(OrderCertificate, LinearContactsShowTheOrderOfTheirKink) {
  requirement("order.contact");
  for (const char* name : {"linear_contact", "dashpot_contact"}) expect_orders(name);
}

TEST(OrderCertificate, ElasticHertzContactsShowOrderFiveHalvesAtMost) {
  requirement("order.contact");
  for (const char* name : {"hertz_inside", "hertz"}) expect_orders(name);
}

TEST(OrderCertificate, DampedHertzContactsShowOrderFiveQuartersAtMost) {
  requirement("order.contact");
  for (const char* name : {"damped_hertz_inside", "damped_hertz"}) expect_orders(name);
}

TEST(OrderCertificate, FrictionShowsTheOrderOfItsKink) {
  requirement("order.friction");
  for (const char* name : {"stick_slip", "sliding", "sticking"}) expect_orders(name);
}

TEST(OrderCertificate, ATornLinkLeavesFirstOrderUnlessItIsLocated) {
  requirement("order.tear");
  for (const char* name : {"tear", "located_tear"}) expect_orders(name);
}

}  // namespace
}  // namespace furrow::verification
