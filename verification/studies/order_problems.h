// The motions on which the order of a method is observed: one for each kind of force, each with a solution that needs
// no solver. Where the force after an event (touch, release, slip, tear) starts like (t - t0)^a, and the event falls
// anywhere within a step, a method of order p shows at most the order min(p, a + 1).
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "system/ode.h"

namespace furrow::verification {

inline constexpr double no_limit = std::numeric_limits<double>::infinity();

struct Problem {
  std::string name;   // a word, for keys
  std::string title;  // of its column
  std::string event;  // what limits the order
  // The greatest order of a method that steps over the events: a + 1.
  double limit = no_limit;
  double indistinct = 0.5;  // a method's order p this much above the limit may still show p
  // That of the error after which an error-controlled method chooses its steps: it grades them through events that its
  // error estimate sees, not through those that the jump map makes between steps.
  bool controller_sees_it = true;
  Locate locate = Locate::none;  // as the scene's key
  bool from_rest = false;        // no force when it starts, and none that depends on a velocity
  bool rebounds = false;         // leaves an elastic contact before it ends
  bool speed_by_energy = false;  // the speed at the end follows from the energy alone, which may err by less
  double fastest = 0;            // rad/s, highest frequency of a smooth motion
  double unit = 1;               // s, duration of a contact or 1/omega
  double duration = 1;           // s, of the longest run
  double earliest = 0.8;         // of the duration, of the shortest
  double length = 1, speed = 1;  // m, m/s: errors are given over these
  double touch = 0;              // s, when the contact begins
  int least_steps = 0;           // coarsest step is duration / least_steps
  std::function<std::unique_ptr<OdeSystem>()> system{};
  // The exact state at time t: the run starts anywhere on it. Numbers that no error is taken of (spins, tangential
  // springs) need be right only where runs start.
  std::function<State(long double)> state{};
};

// Smooth ones first.
const std::vector<Problem>& problems();
const Problem& problem(const std::string& name);

// Used by problems(), a file each.
std::vector<Problem> spring_problems();    // undamped, damped, lattice, tear
std::vector<Problem> contact_problems();   // linear, with dashpot, Hertz, Hertz with damping
std::vector<Problem> friction_problems();  // sliding, stick-slip, sticking

}  // namespace furrow::verification
