// The energy of a mass on an undamped spring changes by each method's own error, known in closed form.
//
//   q = omega h;  y_n the method's closed form of free_spring.cpp
//   E_n/E_0 = |y_n|^2 exactly, and to leading order
//     rk4     loses q^6/72 a step
//     pece    gains q^4/2 a step
//     verlet  swings by q^2/4
//
// Source: as in free_spring.cpp.
#include <algorithm>
#include <cmath>
#include <string>

#include "run/observe.h"
#include "verification/discrete_spring.h"

namespace furrow::verification::free_spring {
namespace {

TEST(FreeSpring, EnergyIsKeptButForWhatTheMethodDoes) {
  requirement("spring.free");
  constexpr double q = 0.05;
  const Scene scene = spring_scene(0);
  for (const char* method : {"pece", "rk4", "verlet"}) {
    const Ran ran = run_scene(scene, method, q / omega, steps * q / omega);
    const double energy =
        observe(ran.system, ran.end.time, ran.y).energy.stored() / (0.5 * stiffness * stretch * stretch);
    expect(std::string(method) + ": energy over k x0^2/2 after 1000 steps", energy,
           static_cast<double>(std::norm(discrete_solution(method, q, steps))),
           absolute(5e-14, "round-off of 1000 steps, each of 1e-16 l/x0"));
  }
  // What that comes to: rk4 loses q^6/72 a step, pece q^4/2, Verlet swings by q^2/4.
  struct Change {
    const char* method;
    double greatest, beyond;
    const char* why;
  };
  const double q2 = q * q;
  for (const Change& c :
       {Change{"pece", steps * q2 * q2 / 2, 4 * q2, "terms of order q^2 and half of the change itself"},
        {"rk4", steps * q2 * q2 * q2 / 72, q2 / 4, "the next term, q^2/8, doubled"},
        {"verlet", q2 / 4, q2 * q2 / 4, "a step may miss the turn by q/2"}}) {
    double greatest = 0;
    run_scene(scene, c.method, q / omega, steps * q / omega, [&](double, const State& y, const JumpReport&) {
      const double energy = position(y) * position(y) + velocity(y) * velocity(y);
      greatest = std::max(greatest, std::fabs(energy - 1));
      return true;
    });
    expect(std::string(c.method) + ": greatest change of energy over the run", greatest, c.greatest,
           relative(c.beyond, c.why));
  }
}

}  // namespace
}  // namespace furrow::verification::free_spring
