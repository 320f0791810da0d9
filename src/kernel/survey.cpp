// The survey of the contacts in a jump, batch by batch.
#include <algorithm>

#include "kernel/kernel.h"

namespace furrow {
namespace {

double size_of(const TouchBatch& c, int k) {
  return c.kind == disc_disc ? std::min(c.radius_a[k], c.radius_b[k]) : c.radius_a[k];
}

void find_deepest(const TouchBatch& c, ContactExtremes& seen) {
  for (int k = 0; k < c.count; ++k) {
    if (c.touching[k] == 0 || c.overlap[k] / size_of(c, k) != seen.overlap) continue;
    seen.deepest = {c.kind, c.a[k], c.b[k]};
    return;
  }
}

}  // namespace

void Kernel::survey_batch(const TouchBatch& c, int block) {
  ContactExtremes& seen = block_seen_[block];
  if (c.kind != disc_disc && c.kind != disc_wall) {  // there are few
    for (int k = 0; k < c.count; ++k) {
      if (c.touching[k] != 0) survey_.see(*parts_, contact_of(c, k), seen);
    }
    return;
  }
  const BatchExtremes batch = extremes(c);
  seen.contacts += batch.contacts;
  if (batch.overlap > seen.overlap) {
    seen.overlap = batch.overlap;
    if (batch.overlap > survey_.known_overlap) find_deepest(c, seen);
  }
  if (batch.approach > survey_.fast) {
    for (int k = 0; k < c.count; ++k) {
      if (c.touching[k] != 0) survey_.see_impact(*parts_, contact_of(c, k), seen);
    }
  }
  if (c.kind == disc_wall && batch.overlap > 1) {
    for (int k = 0; k < c.count; ++k) seen.behind_walls += c.overlap[k] > c.radius_a[k] ? 1 : 0;
  }
}

void Kernel::begin_survey() {
  std::fill(block_seen_.begin(), block_seen_.end(), ContactExtremes{});
  survey_.begin(*parts_);
}

void Kernel::finish_survey() {
  for (const ContactExtremes& seen : block_seen_) survey_.seen.join(seen);
}

}  // namespace furrow
