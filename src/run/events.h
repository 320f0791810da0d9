// Steps that end at events: a link exceeds its strength; a contact begins or ends, its normal force is or is no longer
// held at zero, it starts or stops to slide. Inside a step such an event costs a method its order: at most alpha + 1 is
// left where the force after it grows like (t - t_event)^alpha. Here a step ends at it, and the method's history is
// dropped. No force changes at a tear before the jump: it is found on Hermite's cubic through both ends of the step,
// of order 4, for two evaluations (Hairer, Norsett and Wanner, Solving ODEs I, II.6). The others are approached by
// shorter and shorter steps. After a touch, where the force is a fractional power of the time, steps are graded,
//
//   t = t_touch + T s^q,  s uniform,  q = 2 without and 4 with damping
//   order min(p, q (alpha + 1))
//
// with alpha = 3/2 for Hertz's law, 1/4 with damping in sqrt(Sn), so that any p up to 5 is restored. T is a quarter of
// the contact's time scale, (m*^2 / (E*^2 R* v))^(1/5) / max(1, beta)^(4/5), to a power of two. Not located: a disc
// that passes from one auxiliary point of a border to the next, a corner of a plate, a rolling spring at its limit, the
// fractional power before the end of an undamped contact, a tangential spring that reaches its limit while it slides
// (order 2 is left), and what begins and ends within one step. Source of the order rule: graded meshes for weakly
// singular equations, Brunner 1985 (Math. Comput. 45, 417).
#pragma once

#include <functional>
#include <vector>

#include "methods/method.h"
#include "run/validity.h"

namespace furrow {

// The discrete part of a motion: which contacts push and whether they slide, which links exceed their strength. A
// contact whose normal force is held at zero does not push.
struct Regime {
  enum Phase { sticks, slides_forward, slides_backward };
  struct Pushing {
    ContactKind kind;
    int a, b;
    Phase phase;
    bool operator==(const Pushing&) const = default;
  };
  std::vector<Pushing> pushing;
  std::vector<int> overstretched;  // links
  bool operator==(const Regime&) const = default;
};

// What the steps to events carry from one to the next.
struct EventMemory {
  struct Grade {
    double start = 0, scale = 0;  // s
    int power = 0;
  };
  bool started = false;
  Regime now;                                   // of the accepted state
  std::vector<Grade> grades;                    // of the last touches
  long events = 0, evaluations = 0, steps = 0;  // evaluations of f besides those of the method
  void history(HistoryVisitor& visit);
};

// Applies the jumps to y at t, and tells the method what it needs to know of them.
JumpReport jump(System& system, Method& method, double t, State& y);

class EventSteps {
 public:
  // `check` throws Divergence if the step is not sound. `validity`, if there is one, sees each state that is accepted.
  using Check = std::function<void(const Step& step)>;
  EventSteps(System& system, Method& method, Locate what, Check check, Validity* validity, EventMemory& memory)
      : system_(system), method_(method), what_(what), check_(std::move(check)), validity_(validity), memory_(memory) {}

  // Carries y from t to `end`, or, for a controlled method, over a step of its choice, applies the jumps on the way and
  // reports them together. `h` is the usual step. Returns the time reached. Throws Divergence, also where events are
  // too many for it to make sense.
  double step(double t, State& y, double end, double h, JumpReport& report);

  // Jumps at the end of a step of h that led from `before` to (t, y), and tells the method.
  void accept(const State& before, double t, State& y, double h, JumpReport& report);

 private:
  using Grade = EventMemory::Grade;
  double next_time(double t, double end, double h);
  Regime regime(double t, const State& y) const;
  double back_to_tear(double t, const State& before, double reached, State& y);
  double approach(double t, State& y, double bound, JumpReport& report);
  double first_change(double t, const State& y, double within);
  void grade_touches(double t, const State& y, const Regime& before);

  System& system_;
  Method& method_;
  Locate what_;
  Check check_;
  Validity* validity_;
  EventMemory& memory_;
  State rates_, ahead_;
};

}  // namespace furrow
