// What a jump of the kernel sees of its contacts, block by block.
#include <algorithm>

#include "kernel/kernel.h"

namespace furrow {
namespace {

double size_of(const TouchBlock& c, int k) {
  return c.kind == disc_disc ? std::min(c.radius_a[k], c.radius_b[k]) : c.radius_a[k];
}

void find_deepest(const TouchBlock& c, ContactExtremes& seen) {
  for (int k = 0; k < c.count; ++k) {
    if (c.touching[k] == 0 || c.overlap[k] / size_of(c, k) != seen.overlap) continue;
    seen.deepest = {c.kind, c.a[k], c.b[k]};
    return;
  }
}

}  // namespace

void Kernel::survey_block(const TouchBlock& c, int chunk) {
  ContactExtremes& seen = chunk_seen_[chunk];
  if (c.kind != disc_disc && c.kind != disc_wall) {  // few, and only those that touch
    for (int k = 0; k < c.count; ++k) survey_.see(*parts_, contact_of(c, k), seen);
    return;
  }
  const BlockExtremes block = extremes(c);
  seen.contacts += block.contacts;
  if (block.overlap > seen.overlap) {
    seen.overlap = block.overlap;
    if (block.overlap > survey_.known_overlap) find_deepest(c, seen);
  }
  if (block.approach > survey_.fast) {
    for (int k = 0; k < c.count; ++k) {
      if (c.touching[k] != 0) survey_.see_impact(*parts_, contact_of(c, k), seen);
    }
  }
  if (c.kind == disc_wall && block.overlap > 1) {
    for (int k = 0; k < c.count; ++k) seen.behind_walls += c.overlap[k] > c.radius_a[k] ? 1 : 0;
  }
}

void Kernel::begin_survey() {
  std::fill(chunk_seen_.begin(), chunk_seen_.end(), ContactExtremes{});
  survey_.begin(*parts_);
}

void Kernel::finish_survey() {
  for (const ContactExtremes& seen : chunk_seen_) survey_.seen.join(seen);
}

}  // namespace furrow
