#include "run/events.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/impact.h"
#include "run/observe.h"

namespace furrow {
namespace {

constexpr int most_events_in_a_step = 50;
constexpr long enough_to_judge = 200;  // steps, after which at most every second one may hold an event

Regime::Phase phase_of(const Contact& c, double friction) {
  if (friction == 0 || !(c.force.normal > 0)) return Regime::sticks;
  const double limit = friction * c.force.normal;
  const double reach = limit / c.force.shear_stiffness;
  const double stick = c.force.shear_stiffness * c.touch.spring + c.force.shear_viscosity * c.touch.slip;
  // A spring beyond its reach will be returned to it, so the sign of the slip decides.
  if (c.touch.spring >= reach ? c.touch.slip > 0 : stick > limit) return Regime::slides_forward;
  if (c.touch.spring <= -reach ? c.touch.slip < 0 : stick < -limit) return Regime::slides_backward;
  return Regime::sticks;
}

// s, a quarter of the contact's time scale, to a power of two: roots of the fifth order are not the same on every
// machine.
double time_scale(const ContactLaw& law, const Touch& c) {
  int exponent = 0;
  std::frexp(time_scale_to_the_fifth(law, c.reduced_radius, c.reduced_mass, std::max(c.approach, 1e-6)), &exponent);
  return std::ldexp(0.25, (exponent - (exponent % 5 + 5) % 5) / 5);
}

bool same_pair(const Regime::Pushing& one, const Regime::Pushing& other) {
  return one.kind == other.kind && one.a == other.a && one.b == other.b;
}

double power(double x, int q) { return q == 4 ? x * x * x * x : x * x; }
double root(double x, int q) { return q == 4 ? std::sqrt(std::sqrt(x)) : std::sqrt(x); }

std::vector<int> overstretched(const System& system, double t, const State& y) {
  const LinkArrays& link = system.parts().link;
  std::vector<int> which;
  if (link.count() == 0) return which;
  const std::vector<double> force = link_forces(system, t, y);
  for (int k = 0; k < link.count(); ++k) {
    if ((link.in_magnitude[k] != 0 ? std::fabs(force[k]) : force[k]) > link.strength[k]) which.push_back(k);
  }
  return which;
}

}  // namespace

void EventMemory::history(HistoryVisitor& visit) {
  visit("started", started);
  visit.list("pushing", now.pushing, [&](Regime::Pushing& p) {
    visit("kind", p.kind);
    visit("a", p.a);
    visit("b", p.b);
    visit("phase", p.phase);
  });
  visit("overstretched", now.overstretched);
  visit.list("grades", grades, [&](Grade& g) {
    visit("start", g.start);
    visit("scale", g.scale);
    visit("power", g.power);
  });
  visit("events", events);
  visit("evaluations", evaluations);
  visit("steps", steps);
}

JumpReport jump(System& system, Method& method, double t, State& y) {
  JumpReport report = system.jump(t, y);
  if (report.grown.count > 0) {
    GrowHistory grow(report.grown);
    method.history(grow);
  }
  if (report.flow_jumped()) {
    method.restart();
  } else if (report.springs_changed) {
    method.state_changed();
  }
  report.rates ? method.know(t, *report.rates) : method.know_nothing();
  return report;
}

Regime EventSteps::regime(double t, const State& y) const {
  Regime r{{}, overstretched(system_, t, y)};
  if (what_ != Locate::all) return r;
  system_.for_each_contact(t, y, [&](const Contact& c) {
    const ContactLaw& law = system_.parts().law[c.law];
    if (c.force.normal > law.floor) r.pushing.push_back({c.id.kind, c.id.a, c.id.b, phase_of(c, law.friction)});
  });
  return r;
}

double EventSteps::step(double t, State& y, double end, double h, JumpReport& report) {
  if (!memory_.started) memory_.now = regime(t, y);
  memory_.started = true;
  ++memory_.steps;
  const bool controlled = method_.info().controlled;
  int found = 0;
  double plain_until =
      t;  // s: where a trial step saw an event that does not happen, its change of regime is taken as it is
  while (t < end) {
    const State before = y;
    const bool plain = t < plain_until;
    const double target = plain ? plain_until : controlled ? end : next_time(t, end, h);
    const bool whole = !controlled && std::fabs(target - t - h) < 1e-9 * h;  // round-off makes no other step
    const double length = whole ? h : target - t;
    const double taken = method_.step(system_, t, y, length);
    const double reached = taken < length ? t + taken : target;
    const Regime then = regime(reached, y);
    if (then == memory_.now || plain) {
      accept(before, reached, y, taken, report);
      if (then != memory_.now) memory_.now = regime(reached, y);
      t = reached;
      if (controlled) break;
      continue;
    }
    if (then.pushing == memory_.now.pushing) {
      const double torn = back_to_tear(t, before, reached, y);
      accept(before, torn, y, torn - t, report);
      memory_.now = regime(torn, y);
      t = torn;
    } else {
      y = before;
      method_.restart();
      const long events = memory_.events;
      t = approach(t, y, reached, report);
      if (memory_.events == events) plain_until = reached;
    }
    if (++found > most_events_in_a_step || (memory_.steps > enough_to_judge && memory_.events > memory_.steps / 2))
      throw Divergence("events come in nearly every step, " + std::to_string(memory_.events) + " in " +
                       std::to_string(memory_.steps) + " steps: to locate them is for scenes with few; run it without");
  }
  if (found > 0 && !controlled) method_.restart();  // after so short a step the history is useless
  return t;
}

// From y, reached by a whole step, to where on the way from `before` the first link is overstretched.
double EventSteps::back_to_tear(double t, const State& before, double reached, State& y) {
  const double h = reached - t;
  const State after = y;
  rates_.resize(y.size());
  ahead_.resize(y.size());
  system_.rhs(t, before, rates_);
  system_.rhs(reached, after, ahead_);
  memory_.evaluations += 2;
  ++memory_.events;
  const auto place = [&](double s) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double rise = after[i] - before[i];
      const double bend = (1 - 2 * s) * rise + h * ((s - 1) * rates_[i] + s * ahead_[i]);
      y[i] = before[i] + s * rise + s * (s - 1) * bend;
    }
  };
  double whole = 0, torn = 1;  // of the step
  for (int halvings = 0; halvings < 40; ++halvings) {
    const double middle = 0.5 * (whole + torn);
    place(middle);
    (overstretched(system_, t + middle * h, y).empty() ? whole : torn) = middle;
  }
  place(torn);
  return t + torn * h;
}

// The end of the next step: the usual one, or a shorter one after a touch; it never leaves less than half a step.
double EventSteps::next_time(double t, double end, double h) {
  double length = end - t;
  std::erase_if(memory_.grades, [&](const Grade& g) {
    const double s = root((t - g.start) / g.scale, g.power) + h / (g.power * g.scale);
    const double graded = g.scale * power(s, g.power) - (t - g.start);
    length = std::min(length, std::max(graded, 4e-15 * (t + h)));  // it must move the time
    return graded >= h;
  });
  return end - t < 1.5 * length ? end : t + length;
}

void EventSteps::accept(const State& before, double t, State& y, double h, JumpReport& report) {
  const Step step = step_of(system_, t, h, before, y);
  check_(step);
  const JumpReport one = jump(system_, method_, t, y);
  if (validity_) validity_->see(step, one);
  report.torn.insert(report.torn.end(), one.torn.begin(), one.torn.end());
  report.springs_changed = report.springs_changed || one.springs_changed;
  report.grown = {report.grown.count + one.grown.count, one.grown.before_end};
}

// From (t, y) to just after the event that a trial step met before `bound`. The first two steps stop short of it, so
// that no stage of a method of some length sees the forces after the event; the last one, which crosses, is short.
double EventSteps::approach(double t, State& y, double bound, JumpReport& report) {
  const double span = bound - t;
  double short_of = 0.03;  // of the way; the error of the extrapolation goes with the square of the step
  for (int tries = 0; tries < 12; ++tries) {
    const double left = bound - t;
    if (!(left > 0)) break;
    const double ahead = first_change(t, y, left);
    const bool crossing = ahead < 1e-4 * span;
    const double want = crossing ? ahead * (1 + 1e-6) + 1e-9 * span : ahead * (1 - short_of);
    const double h = std::min(want, left);
    const State before = y;
    const double taken = method_.step(system_, t, y, h);
    const Regime then = regime(t + taken, y);
    if (!crossing && then != memory_.now) {  // stop shorter
      y = before;
      method_.restart();
      short_of = std::min(0.9, 4 * short_of);
      continue;
    }
    t += taken;
    accept(before, t, y, taken, report);
    short_of = 1e-3;
    if (then == memory_.now) continue;
    const Regime old = std::exchange(memory_.now, regime(t, y));
    grade_touches(t, y, old);
    method_.restart();
    ++memory_.events;
    return t;
  }
  return t;  // the trial step saw an event that does not happen
}

// How far off the regime changes, by halving, on  q + v s + a s^2/2,  v + a s  from here; `within` if it does not.
double EventSteps::first_change(double t, const State& y, double within) {
  rates_.resize(y.size());
  ahead_.resize(y.size());
  system_.rhs(t, y, rates_);
  ++memory_.evaluations;
  const std::size_t n = system_.positions();
  double low = 0;
  double high = within;
  for (int k = 0; k < 40 && high - low > 1e-7 * high; ++k) {
    const double s = k == 0 ? high : 0.5 * (low + high);
    for (std::size_t i = 0; i < y.size(); ++i)
      ahead_[i] = y[i] + s * (rates_[i] + (i < n ? 0.5 * s * rates_[n + i] : 0));
    const bool changed = regime(t + s, ahead_) != memory_.now;
    if (k == 0 && !changed) return within;
    (changed ? high : low) = s;
  }
  return high;
}

void EventSteps::grade_touches(double t, const State& y, const Regime& before) {
  system_.for_each_contact(t, y, [&](const Contact& c) {
    const Regime::Pushing one{c.id.kind, c.id.a, c.id.b, {}};
    if (!(c.force.normal > system_.parts().law[c.law].floor) ||
        std::any_of(before.pushing.begin(), before.pushing.end(), [&](const auto& o) { return same_pair(one, o); }))
      return;
    const ContactLaw& law = system_.parts().law[c.law];
    if (is_linear(law)) return;  // its forces are no fractional powers of the time
    memory_.grades.push_back({t, time_scale(law, c.touch), law.viscosity > 0 ? 4 : 2});
  });
}

}  // namespace furrow
