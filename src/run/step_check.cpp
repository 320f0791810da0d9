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
#include "run/meeting.h"
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
  if (!finite) return not_finite(step, body);
  if (!within_its_size(step) || !driven_within_a_disc(step)) {
    const Unseen unseen = unseen_meeting(system_, step);
    body = unseen.body;
    if (!unseen.what.empty()) return unseen.what;
  }
  return over_a_plate(step, body);
}

std::string StepCheck::not_finite(const Step& step, int& body) const {
  const std::size_t bodies = size_.size();
  for (std::size_t i = 0; i < bodies; ++i) {
    if (std::isfinite(step.after[i]) && std::isfinite(step.after[bodies + i])) continue;
    body = static_cast<int>(i);
    return system_.parts().body_name(body) + " has a position that is not finite";
  }
  return "a velocity or tangential spring is not finite";
}

// Driven nodes are no bodies.
bool StepCheck::driven_within_a_disc(const Step& step) const {
  if (system_.solver().preparing()) return true;
  const std::vector<DrivePart>& drives = system_.parts().drive;
  return std::all_of(drives.begin(), drives.end(), [&](const DrivePart& d) {
    const double time = ramped(step.t, d.ramp).time - ramped(step.t - step.h, d.ramp).time;
    return std::hypot(d.vx, d.vy) * time <= least_radius_;
  });
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

bool StepCheck::within_its_size(const Step& step) const {
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
