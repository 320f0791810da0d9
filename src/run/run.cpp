#include "run/run.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

#include "kernel/parallel.h"
#include "kernel/wide.h"
#include "physics/ramp.h"
#include "run/events.h"
#include "run/stiffness.h"
#include "scene/interrupt.h"
#include "scene/wording.h"
#include "system/floating_point.h"

namespace furrow {
namespace {

// Integers for the verdicts: they may be combined in any order, so the loop is vectorised. The exponent bits of a
// number that is not finite are all ones: adding one carries into the sign.
FURROW_WIDE bool all_finite_lanes(const double* y, std::size_t n) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000, one = 0x0010000000000000;
  std::uint64_t carried = 0;
  for (std::size_t k = 0; k < n; ++k) carried |= (std::bit_cast<std::uint64_t>(y[k]) & exponent) + one;
  return carried <= exponent;
}
FURROW_WIDTHS(bool, all_finite, (const double* y, std::size_t n), (y, n))

FURROW_WIDE bool all_near_lanes(const double* one, const double* other, const double* limit, std::size_t n) {
  std::int64_t far = 0;
  for (std::size_t i = 0; i < n; ++i) far += std::fabs(one[i] - other[i]) > limit[i] ? 1 : 0;
  return far == 0;
}
FURROW_WIDTHS(bool, all_near, (const double* one, const double* other, const double* limit, std::size_t n),
              (one, other, limit, n))

// A body that moves further than its size in a step, or a node further than the smallest disc's radius, passes contacts
// unseen: the step is too long, or the run has blown up.
class Watch {
 public:
  explicit Watch(const System& system) : system_(system) {
    const Parts& parts = system.parts();
    size_ = parts.disc.radius;
    for (const double radius : parts.disc.radius) least_radius_ = std::min(least_radius_, radius);
    for (int n = 0; n < parts.node.count(); ++n) {
      if (parts.node.body[n] >= 0) size_.push_back(std::min(parts.node.spacing[n], least_radius_));
    }
    for (const PlatePart& p : parts.plate) {
      quarter_side_ = std::min({quarter_side_, p.width / 4, p.height / 4});
      plate_speed_ = std::max(plate_speed_, std::hypot(p.vx, p.vy));
    }
    for (const double size : size_) least_size_ = std::min(least_size_, size);
  }

  // Empty if the step from `before` to `after` is sound; else `body` is the one that went too far, if any.
  std::string complaint(const Step& step, int& body) const {
    const State &before = step.before, &after = step.after;
    const std::size_t bodies = size_.size();
    std::atomic<bool> finite = true;
    in_ranges(system_.threads(), after.size(), [&](std::size_t first, std::size_t last) {
      if (!all_finite(after.data() + first, last - first)) finite = false;
    });
    if (finite && none_beyond_its_size(step)) {
      const std::string driven = driven_too_far(step);
      return driven.empty() ? stepped_over(step, body) : driven;
    }
    Sentence text;
    for (std::size_t i = 0; i < bodies; ++i) {
      const double moved = std::hypot(after[i] - before[i], after[bodies + i] - before[bodies + i]);
      if (moved <= size_[i]) continue;
      body = static_cast<int>(i);
      text << system_.parts().body_name(body);
      if (std::isfinite(moved)) {
        const bool by_disc = i >= system_.parts().disc.radius.size() && size_[i] == least_radius_;
        text << " moved " << moved << " m in one step of " << step.h << " s, more than "
             << (by_disc ? "the radius of the smallest disc, " : "its size of ") << size_[i] << " m";
      } else {
        text << " has a position that is not finite";
      }
      return text.str();
    }
    text << "a velocity or tangential spring is not finite";
    return text.str();
  }

 private:
  // Driven nodes are no bodies: further than the radius of the smallest disc in a step they pass discs unseen.
  std::string driven_too_far(const Step& step) const {
    if (system_.solver().preparing()) return {};
    for (const DrivePart& d : system_.parts().drive) {
      const double time = ramped(step.t, d.ramp).time - ramped(step.t - step.h, d.ramp).time;
      const double moved = std::hypot(d.vx, d.vy) * time;
      if (!(moved > least_radius_)) continue;
      Sentence text;
      text << "the driven nodes of lattice " << d.lattice << " moved " << moved << " m in one step of " << step.h
           << " s, more than the radius of the smallest disc, " << least_radius_ << " m";
      return text.str();
    }
    return {};
  }

  // If plates and bodies move by less than a quarter of a plate's smaller side in a step, no plate skips a body.
  std::string stepped_over(const Step& step, int& body) const {
    const Parts& parts = system_.parts();
    if (parts.plate.empty() ||
        (plate_speed_ * step.h <= quarter_side_ && step.motion.moved_squared <= quarter_side_ * quarter_side_))
      return {};
    const ContactId over = furrow::stepped_over(system_, step);
    if (over.a < 0) return {};
    body = of_disc(over.kind) ? over.a : parts.node.body[over.a];
    Sentence text;
    text << "plate " << over.b << " stepped over " << parts.body_name(body) << " in one step of " << step.h
         << " s: it was on one side of it before and is on the other now, and they never touched; the step is too long";
    return text.str();
  }

  bool none_beyond_its_size(const Step& step) const {
    if (step.motion.moved_squared <= least_size_ * least_size_) return true;
    std::atomic<bool> all = true;
    const std::size_t bodies = size_.size();
    in_ranges(system_.threads(), bodies, [&](std::size_t first, std::size_t last) {
      for (const std::size_t axis : {first, bodies + first}) {
        if (!all_near(step.before.data() + axis, step.after.data() + axis, size_.data() + first, last - first))
          all = false;
      }
    });
    return all;
  }

  const System& system_;
  std::vector<double> size_;        // m, by body
  double quarter_side_ = infinity;  // m, a quarter of the smallest side of a plate
  double least_size_ = infinity;    // m
  double plate_speed_ = 0;          // m/s, of the fastest
  double least_radius_ = infinity;  // m
};

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
std::string driven_by(const System& system, double t, const State& y, int body, const std::string& method) {
  const StiffPart bond = stiffest_bond(system, t, y, body);
  if (bond.name.empty()) return {};
  Sentence text;
  text.precision(3);
  text << "; the stiffest that acts there is " << bond.name << ", omega " << bond.oscillator.omega
       << " rad/s, damping ratio " << bond.oscillator.zeta;
  const double limit = largest_stable_step(method, bond.oscillator);
  if (std::isfinite(limit)) text << ", which by itself allows " << method << " a step of " << limit << " s";
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
  const Watch watch(system);
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
    if (const std::string complaint = watch.complaint(step, body); !complaint.empty()) throw Divergence(complaint);
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
      end.reason = plan.validity->failure() + driven_by(system, at.time, y, -1, method.info().name);
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
    end.reason = failure.what() + driven_by(system, at.time, y, body, method.info().name);
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
