#include "verification/engines/independent.h"

#include <algorithm>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "verification/engines/independent_world.h"

namespace furrow::verification {
namespace {

namespace odeint = boost::numeric::odeint;

template <class Odeint>
Stepper stepper(const char* name, int order) {
  return {name, order,
          [](const Rates& rates, Numbers& y, double t, double h) { Odeint().do_step(std::cref(rates), y, t, h); }};
}

}  // namespace

const std::vector<Stepper>& odeint_steppers() {
  static const std::vector<Stepper> all{stepper<odeint::runge_kutta4<Numbers>>("rk4", 4),
                                        stepper<odeint::runge_kutta_dopri5<Numbers>>("dopri5", 5),
                                        stepper<odeint::euler<Numbers>>("euler", 1)};
  return all;
}

Json independent_answer(const Json& request, const Stepper& stepper, AfterSlip after) {
  const Json& c = request["case"];
  const std::vector<std::string> known{"hertz",
                                       "linear",
                                       "wall",
                                       "pair",
                                       "plate",
                                       "outline",
                                       "point",
                                       "damping",
                                       "pull",
                                       "no_pull",
                                       "friction",
                                       "tangential_damping",
                                       "no_tangential_damping",
                                       "rolling",
                                       "rolling_spring",
                                       "gravity",
                                       "spring",
                                       "spring_damping",
                                       "tear",
                                       "load",
                                       "arm_contact_point",
                                       "arm_radius"};
  for (const std::string need : c["needs"]) {
    if (std::find(known.begin(), known.end(), need) == known.end())
      return {{"engine", "independent"}, {"cannot", need}};
  }
  independent::World world(c, after);
  Observer observer(c);
  const double h = request["step"];
  const long count = request["count"];
  const Rates rates = [&world](const Numbers& y, Numbers& dydt, double t) { world.rates(y, dydt, t); };
  world.jump(0);
  observer.look(world.moment(0));
  for (long n = 0; n < count; ++n) {
    stepper.step(rates, world.y, static_cast<double>(n) * h, h);
    world.jump(static_cast<double>(n + 1) * h);
    observer.look(world.moment(static_cast<double>(n + 1) * h));
  }
  return {{"engine", "independent"},
          {"method", stepper.name},
          {"order", stepper.order},
          {"observables", observer.observables()}};
}

}  // namespace furrow::verification
