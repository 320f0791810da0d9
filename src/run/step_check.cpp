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

}  // namespace

StepCheck::StepCheck(const System& system) : system_(system) {
  const Parts& parts = system.parts();
  for (const double radius : parts.disc.radius) least_size_ = std::min(least_size_, radius);
  for (const double spacing : parts.node.spacing) least_size_ = std::min(least_size_, spacing);
  for (const PlatePart& p : parts.plate) {
    quarter_side_ = std::min({quarter_side_, p.width / 4, p.height / 4});
    plate_speed_ = std::max(plate_speed_, std::hypot(p.vx, p.vy));
  }
}

std::string StepCheck::complaint(const Step& step, int& body) const {
  const State& after = step.after;
  std::atomic<bool> finite = true;
  in_ranges(system_.threads(), after.size(), [&](std::size_t first, std::size_t last) {
    if (!all_finite(after.data() + first, last - first)) finite = false;
  });
  if (!finite) return not_finite(step, body);
  if (!within_half_a_size(step)) {
    const Unseen unseen = unseen_meeting(system_, step);
    body = unseen.body;
    if (!unseen.what.empty()) return unseen.what;
  }
  return over_a_plate(step, body);
}

std::string StepCheck::not_finite(const Step& step, int& body) const {
  const auto bodies = static_cast<std::size_t>(system_.parts().bodies());
  for (std::size_t i = 0; i < bodies; ++i) {
    if (std::isfinite(step.after[i]) && std::isfinite(step.after[bodies + i])) continue;
    body = static_cast<int>(i);
    return system_.parts().body_name(body) + " has a position that is not finite";
  }
  return "a velocity or tangential spring is not finite";
}

// If nothing moves by more than half of the smallest size, no two move against each other by more than that.
bool StepCheck::within_half_a_size(const Step& step) const {
  const double half = 0.5 * least_size_;
  if (step.motion.moved_squared > half * half || plate_speed_ * step.h > half) return false;
  if (system_.solver().preparing()) return true;
  const std::vector<DrivePart>& drives = system_.parts().drive;
  return std::all_of(drives.begin(), drives.end(), [&](const DrivePart& d) {
    const double time = ramped(step.t, d.ramp).time - ramped(step.t - step.h, d.ramp).time;
    return std::hypot(d.vx, d.vy) * time <= half;
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
  const std::string& name = parts.plate[over.b].name;
  text << "plate " << (name.empty() ? std::to_string(over.b) : name) << " stepped over " << parts.body_name(body)
       << " in one step of " << step.h
       << " s: it was on one side of it before and is on the other now, which it no longer touches; the step is too "
          "long";
  return text.str();
}

}  // namespace furrow
