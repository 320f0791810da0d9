#include "run/step_check.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

#include "kernel/parallel.h"
#include "kernel/wide.h"
#include "physics/ramp.h"
#include "run/crossing.h"
#include "scene/wording.h"

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

}  // namespace

StepCheck::StepCheck(const System& system) : system_(system) {
  const Parts& parts = system.parts();
  size_ = parts.disc.radius;
  for (const double radius : parts.disc.radius) least_radius_ = std::min(least_radius_, radius);
  for (int n = 0; n < parts.node.count(); ++n) {
    if (parts.node.body[n] < 0) continue;
    size_.push_back(std::min(parts.node.spacing[n], least_radius_));
    spacing_.push_back(parts.node.spacing[n]);
  }
  for (const PlatePart& p : parts.plate) {
    quarter_side_ = std::min({quarter_side_, p.width / 4, p.height / 4});
    plate_speed_ = std::max(plate_speed_, std::hypot(p.vx, p.vy));
  }
  for (const double size : size_) least_size_ = std::min(least_size_, size);
}

std::string StepCheck::complaint(const Step& step, int& body) const {
  const State& after = step.after;
  std::atomic<bool> finite = true;
  in_ranges(system_.threads(), after.size(), [&](std::size_t first, std::size_t last) {
    if (!all_finite(after.data() + first, last - first)) finite = false;
  });
  if (finite && (none_beyond_its_size(step) || none_beyond_what_it_may_meet(step))) {
    const std::string driven = driven_too_far(step);
    return driven.empty() ? over_a_plate(step, body) : driven;
  }
  return too_far(step, finite, body);
}

std::string StepCheck::too_far(const Step& step, bool finite, int& body) const {
  Sentence text;
  for (std::size_t i = 0; i < size_.size(); ++i) {
    const double moved = distance(step, i);
    if (moved <= size_[i] || (finite && meets_no_disc(step, i))) continue;
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

// Driven nodes are no bodies: further than the radius of the smallest disc in a step they pass discs unseen.
std::string StepCheck::driven_too_far(const Step& step) const {
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
std::string StepCheck::over_a_plate(const Step& step, int& body) const {
  const Parts& parts = system_.parts();
  if (parts.plate.empty() ||
      (plate_speed_ * step.h <= quarter_side_ && step.motion.moved_squared <= quarter_side_ * quarter_side_))
    return {};
  const ContactId over = stepped_over(system_, step);
  if (over.a < 0) return {};
  body = of_disc(over.kind) ? over.a : parts.node.body[over.a];
  Sentence text;
  text << "plate " << over.b << " stepped over " << parts.body_name(body) << " in one step of " << step.h
       << " s: it was on one side of it before and is on the other now, which it no longer touches; the step is too "
          "long";
  return text.str();
}

bool StepCheck::none_beyond_what_it_may_meet(const Step& step) const {
  for (std::size_t i = 0; i < size_.size(); ++i) {
    if (distance(step, i) > size_[i] && !meets_no_disc(step, i)) return false;
  }
  return true;
}

double StepCheck::distance(const Step& step, std::size_t i) const {
  const std::size_t bodies = size_.size();
  return std::hypot(step.after[i] - step.before[i], step.after[bodies + i] - step.before[bodies + i]);
}

// Whether a node has moved by less than its spacing, with no disc within a spacing of its way.
bool StepCheck::meets_no_disc(const Step& step, std::size_t i) const {
  const std::size_t bodies = size_.size(), discs = system_.parts().disc.radius.size();
  if (i < discs || distance(step, i) > spacing_[i - discs]) return false;
  const auto apart = [&](std::size_t axis, std::size_t d) {
    const auto [low, high] = std::minmax(step.before[axis + i], step.after[axis + i]);
    const auto [from, to] = std::minmax(step.before[axis + d], step.after[axis + d]);
    const double reach = system_.parts().disc.radius[d] + spacing_[i - discs];
    return from > high + reach || to < low - reach;
  };
  for (std::size_t d = 0; d < discs; ++d) {
    if (!apart(0, d) && !apart(bodies, d)) return false;
  }
  return true;
}

bool StepCheck::none_beyond_its_size(const Step& step) const {
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

}  // namespace furrow
