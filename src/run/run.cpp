#include "run/run.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/parallel.h"
#include "run/events.h"
#include "run/step_check.h"
#include "run/stiffness.h"
#include "scene/interrupt.h"
#include "scene/wording.h"
#include "system/floating_point.h"

namespace furrow {
namespace {

// A controlled method that takes ever shorter steps would never reach the end.
class Pace {
 public:
  Pace(const RunPlan& plan, RunPoint& at) : end_(plan.end), at_(at) {}

  void check() {
    if (at_.steps == 0 || at_.steps % looks_every != 0) return;
    const double left = (end_ - at_.time) / (at_.time - at_.paced) * looks_every;
    at_.paced = at_.time;
    if (!(left > most_steps)) return;
    Sentence text;
    text << "the last " << looks_every << " steps led nowhere: at their pace " << left
         << " more would be needed to the end; the tolerance is too tight for what the scene does here";
    throw Divergence(text.str());
  }

 private:
  static constexpr long looks_every = 2000;
  static constexpr double most_steps = 1e9;
  double end_;  // s
  RunPoint& at_;
};

// What drove a run that has blown up, as far as the last good state shows.
std::string driven_by(const System& system, double t, const State& y, int body, const std::string& method,
                      double step) {
  const StiffPart bond = stiffest_bond(system, t, y, body);
  if (bond.name.empty()) return {};
  Sentence text;
  text.precision(3);
  text << "; the stiffest that acts there is " << bond.name << ", omega " << bond.oscillator.omega
       << " rad/s, damping ratio " << bond.oscillator.zeta;
  const double limit = largest_stable_step(method, bond.oscillator);
  if (limit < step) text << ", which by itself allows " << method << " a step of " << limit << " s";
  return text.str();
}

}  // namespace

void RunPoint::history(HistoryVisitor& visit) {
  visit("begun", begun);
  visit("time", time);
  visit("steps", steps);
  visit("paced", paced);
  events.history(visit);
}

std::string to_string(Ending ending) {
  constexpr std::array words{"finished", "interrupted", "diverged", "invalid"};
  return words[static_cast<std::size_t>(ending)];
}

RunEnd run(System& system, Method& method, State& y, const RunPlan& plan, const AfterStep& after_step) {
  const DefaultFloatingPoint environment;
  if (const std::string why = refusal(method.info(), system); !why.empty()) throw std::invalid_argument(why);
  const StepCheck steps(system);
  RunPoint own;
  RunPoint& at = plan.point ? *plan.point : own;
  if (!at.begun) at.time = at.paced = plan.start;
  RunEnd end;
  const bool fixed = !method.info().controlled;
  const double tiny = 1e-9 * plan.step;
  // The last good state: kept by the method, or copied.
  State copied = y;
  const State* before = &copied;
  const bool copies = plan.locate != Locate::none || !method.start();
  int body = -1;
  const auto check = [&](const Step& step) {
    if (const std::string complaint = steps.complaint(step, body); !complaint.empty()) throw Divergence(complaint);
  };
  EventSteps stepper(system, method, plan.locate, check, plan.validity, at.events);
  Pace pace(plan, at);
  const auto accept = [&](const JumpReport& report) {
    before = &y;
    copied.resize(y.size());
    if (copies) copy_in_ranges(system.threads(), y.data(), y.size(), copied.data());
    if (!after_step(at.time, y, report)) end.ending = Ending::stopped;
    if (plan.validity && system.keeps_ledger() && at.time >= plan.end - tiny)
      plan.validity->book(at.time, observe(system, at.time, y));
    if (plan.validity && !plan.validity->failure().empty()) {
      end.ending = Ending::invalid;
      end.reason = plan.validity->failure() + driven_by(system, at.time, y, -1, method.info().name, plan.step);
    }
    if (plan.stops_when_interrupted && interrupt_requested() && end.ending == Ending::finished)
      end.ending = Ending::stopped;
    if (!plan.stops_when_interrupted) throw_if_interrupted();
  };
  bool end_in_sight = false;
  try {
    JumpReport report;
    if (!at.begun) {
      report = jump(system, method, plan.start, y);
      if (plan.validity) plan.validity->see(step_of(system, plan.start, 0, y, y), report);
      at.begun = true;
      accept(report);
    }
    while (end.ending == Ending::finished && at.time < plan.end - tiny) {
      // Fixed steps are counted, not summed: t = start + n h has no drift.
      double next = plan.start + static_cast<double>(at.steps + 1) * plan.step;
      if (!fixed) next = std::min(at.time + plan.step, plan.stop ? plan.stop(at.time) : plan.end);
      if (next > plan.end - tiny) next = plan.end;
      if (next == plan.end && !end_in_sight && plan.before_end) plan.before_end();
      end_in_sight = next == plan.end || end_in_sight;
      pace.check();
      report = {};
      const double h = fixed && next != plan.end ? plan.step : next - at.time;
      before = copies ? &copied : &y;
      if (plan.locate != Locate::none) {
        at.time = stepper.step(at.time, y, next, h, report);
      } else {
        const double taken = method.step(system, at.time, y, h);
        if (!copies) before = method.start();
        const double reached = taken == h ? next : at.time + taken;
        stepper.accept(*before, reached, y, taken, report);
        at.time = reached;
      }
      ++at.steps;
      accept(report);
    }
  } catch (const Divergence& failure) {
    if (before != &y) y = *before;
    system.fit(y);
    if (plan.validity && system.keeps_ledger()) plan.validity->book(at.time, observe(system, at.time, y));
    end.ending = Ending::diverged;
    end.reason = failure.what() + driven_by(system, at.time, y, body, method.info().name, plan.step);
  } catch (const Interrupted&) {
    if (!plan.stops_when_interrupted) throw;
    if (before != &y) y = *before;
    system.fit(y);
    end.ending = Ending::stopped;
    end.cut = true;
  }
  end.time = at.time;
  end.steps = at.steps;
  end.events = at.events.events;
  end.event_evaluations = at.events.evaluations;
  return end;
}

}  // namespace furrow
