#include "kernel/search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "kernel/parallel.h"
#include "kernel/wide.h"
#include "system/ode.h"

namespace furrow {
namespace {

constexpr double skin_of_radius = 0.15;  // times a small radius; measured: flat between 0.1 and 0.2
// The radius of rank sqrt(n) among n, from the smallest. The sqrt(n) smaller discs may be as small as they like: a skin
// that is wide for them adds less than n / 2 pairs among them, and a skin made for them would make all lists
// short-lived.
double small_radius(std::vector<double> radius) {
  if (radius.empty()) return 1;
  const auto rank = static_cast<std::ptrdiff_t>(std::sqrt(static_cast<double>(radius.size() - 1)));
  std::nth_element(radius.begin(), radius.begin() + rank, radius.end());
  return radius[rank];
}

std::vector<int> all_discs(const Parts& parts) {
  std::vector<int> all(parts.disc.radius.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// A fixed node needs no contact with a plate or wall: neither of them can yield.
std::vector<int> moving_nodes(const Parts& parts) {
  std::vector<int> moving;
  for (int n = 0; n < parts.node.count(); ++n) {
    if (parts.node.body[n] >= 0) moving.push_back(n);
  }
  return moving;
}

double mean(const std::vector<double>& of) {
  return of.empty() ? 0 : std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
}

FURROW_WIDE bool all_within_lanes(const double* x, const double* y, const double* x0, const double* y0, double limit,
                                  std::size_t n) {
  std::int64_t far = 0;  // counted without an early exit, so that the loop is vectorised
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = x[i] - x0[i];
    const double dy = y[i] - y0[i];
    far += dx * dx + dy * dy <= limit * limit ? 0 : 1;
  }
  return far == 0;
}
FURROW_WIDTHS(bool, all_within,
              (const double* x, const double* y, const double* x0, const double* y0, double limit, std::size_t n),
              (x, y, x0, y0, limit, n))

// Whether a point has moved further than `limit` (m) or is not finite.
bool moved(const double* x, const double* y, const std::vector<double>& x0, const std::vector<double>& y0, double limit,
           int threads) {
  std::atomic<bool> any = false;
  in_ranges(threads, x0.size(), [&](std::size_t first, std::size_t last) {
    if (!all_within(x + first, y + first, x0.data() + first, y0.data() + first, limit, last - first)) any = true;
  });
  return any;
}

}  // namespace

NeighbourSearch::NeighbourSearch(const Parts& parts, const Search& settings)
    : margin(parts.margin),
      idle_(parts.disc.count() + static_cast<int>(parts.wall.size() + parts.plate.size()) == 0),
      skin_(settings.skin > 0 ? settings.skin
                              : skin_of_radius * small_radius(parts.disc.count() > 0 ? parts.disc.radius
                                                                                     : parts.node.contact_radius)),
      cell_size_(settings.cell_size),
      discs_(all_discs(parts), parts.disc.radius),
      nodes_(moving_nodes(parts), {}),
      node_cell_(std::max(mean(parts.node.spacing), margin + skin_)) {}

void NeighbourSearch::update(const Parts& parts, const Placement& now, int threads) {
  if (idle_ || (made_ && current(parts, now, threads))) return;
  check_finite(parts, now);
  sort(parts, now);
  for (int kind = 0; kind < contact_kinds; ++kind) renew(parts, now, static_cast<ContactKind>(kind), threads);
  list_segments(parts);
  cut_into_blocks(parts.disc.count());
  remember(parts, now);
  ++rebuilds;
}

void NeighbourSearch::sort(const Parts& parts, const Placement& now) {
  discs_.sort(now.disc_x, now.disc_y, margin + skin_, cell_size_);
  if (parts.wall.size() + parts.plate.size() > 0) nodes_.sort(now.node_x, now.node_y, margin + skin_, node_cell_);
}

// Two bodies, or a body and a plate, have come closer by no more than the skin.
bool NeighbourSearch::current(const Parts& parts, const Placement& now, int threads) const {
  double speed = 0;
  for (const PlatePart& p : parts.plate) speed = std::max(speed, std::sqrt(p.vx * p.vx + p.vy * p.vy));
  const double limit = std::min(0.5 * skin_, skin_ - speed * std::fabs(now.t - made_at_));
  return limit >= 0 && !moved(now.disc_x, now.disc_y, disc_x_, disc_y_, limit, threads) &&
         !moved(now.node_x, now.node_y, node_x_, node_y_, limit, 1);
}

void NeighbourSearch::remember(const Parts& parts, const Placement& now) {
  made_ = true;
  made_at_ = now.t;
  disc_x_.assign(now.disc_x, now.disc_x + parts.disc.count());
  disc_y_.assign(now.disc_y, now.disc_y + parts.disc.count());
  node_x_.assign(now.node_x, now.node_x + parts.node.count());
  node_y_.assign(now.node_y, now.node_y + parts.node.count());
}

void NeighbourSearch::check_finite(const Parts& parts, const Placement& now) const {
  for (int i = 0; i < parts.disc.count(); ++i) {
    if (!std::isfinite(now.disc_x[i] + now.disc_y[i]))
      throw Divergence("the position of disc " + std::to_string(i) + " is not finite");
  }
  for (int i = 0; i < parts.node.count(); ++i) {
    if (!std::isfinite(now.node_x[i] + now.node_y[i]))
      throw Divergence("the position of " + parts.node_name(i) + " is not finite");
  }
}

// A new list; that of the discs is made block by block. Its memory is kept for the next list: large beds would spend
// most of their time on allocating it again.
void NeighbourSearch::renew(const Parts& parts, const Placement& now, ContactKind kind, int threads) {
  const bool pairs = kind == disc_disc;
  const int pieces = pairs ? blocks_of(parts.disc.count()) : 1;
  pieces_.resize(static_cast<std::size_t>(std::max(pieces, static_cast<int>(pieces_.size()))));
  if (pairs)
    find_discs(parts, now, threads, pieces);
  else if (kind == disc_lattice)
    find_segments(parts, now, pieces_[0]);
  else
    find_flat(parts, now, kind, pieces_[0]);
  in_parallel(threads, pieces, [&](int k, int /*thread*/) {
    const bool block = pairs && !blocks.empty();
    keep_held(candidates[kind], block ? blocks[k].first_pair : 0,
              block ? blocks[k].last_pair : candidates[kind].count(), pieces_[k]);
  });
  int count = 0;
  for (int k = 0; k < pieces; ++k) {
    pieces_[k].start = count;
    count += static_cast<int>(pieces_[k].member.size());
  }
  candidates[kind].resize(count);
  in_parallel(threads, pieces, [&](int k, int /*thread*/) { write_out(parts, kind, pieces_[k]); });
}

// Merges the near pairs with those pairs of the old list that still hold a slot. Both are sorted.
void NeighbourSearch::keep_held(const Candidates& old, int first, int last, Piece& piece) {
  const std::vector<Pair>& near = piece.near;
  piece.member.clear();
  std::size_t n = 0;
  for (int k = first; k < last; ++k) {
    if (old.slot[k] < 0) continue;
    const Pair kept{old.a[k], old.b[k]};
    for (; n < near.size() && near[n] < kept; ++n) piece.member.push_back({near[n], -1, 0});
    if (n < near.size() && !(kept < near[n])) ++n;
    piece.member.push_back({kept, old.slot[k], old.near_at[k]});
  }
  for (; n < near.size(); ++n) piece.member.push_back({near[n], -1, 0});
}

void NeighbourSearch::write_out(const Parts& parts, ContactKind kind, const Piece& piece) {
  Candidates& list = candidates[kind];
  int k = piece.start;
  for (const Member& m : piece.member) {
    const auto [a, b] = m.pair;
    const int own = of_disc(kind) ? parts.disc.material[a] : parts.node.material[a];
    const double radius = of_disc(kind) ? parts.disc.radius[a] : parts.node.contact_radius[a];
    const double mass = of_disc(kind) ? parts.disc.mass[a] : parts.node.mass[a];
    list.a[k] = a;
    list.b[k] = b;
    list.slot[k] = m.slot;
    list.near_at[k] = m.near_at;
    if (kind == disc_disc) {
      const double other = parts.disc.radius[b];
      const double other_mass = parts.disc.mass[b];
      list.reduced_radius[k] = radius * other / (radius + other);
      list.reduced_mass[k] = mass * other_mass / (mass + other_mass);
      list.law[k] = parts.law_of(own, parts.disc.material[b]);
    } else {
      list.reduced_radius[k] = radius;
      list.reduced_mass[k] = mass;
      const int other = kind == disc_lattice                     ? parts.lattice[b].material
                        : kind == disc_wall || kind == node_wall ? parts.wall[b].material
                                                                 : parts.plate[b].material;
      list.law[k] = parts.law_of(own, other);
    }
    ++k;
  }
}

void Candidates::resize(int count) {
  const auto n = static_cast<std::size_t>(count);
  for (auto* whole : {&a, &b, &slot, &law}) whole->resize(n);
  near_at.resize(n);
  reduced_radius.resize(n);
  reduced_mass.resize(n);
}

void NeighbourSearch::cut_into_blocks(int discs) {
  const Candidates& list = candidates[disc_disc];
  blocks.clear();
  boundary.resize(static_cast<std::size_t>(blocks_of(discs)));
  for (std::vector<Contribution>& into : boundary) into.clear();
  contributions = 0;
  int pair = 0;
  for (int k = 0; k < (discs > 0 ? blocks_of(discs) : 0); ++k) {
    const auto [first, last] = discs_of_block(k, discs);
    DiscBlock block{first, last, pair, pair, contributions, contributions};
    for (; pair < list.count() && list.a[pair] < block.last_disc; ++pair) {
      const int b = list.b[pair];
      if (b >= block.last_disc) boundary[block_of(b)].push_back({contributions++, b});  // across blocks
    }
    block.last_pair = pair;
    block.last_contribution = contributions;
    blocks.push_back(block);
  }
}

void NeighbourSearch::keep_only(const std::array<Candidates, contact_kinds>& held, int discs) {
  candidates = held;
  cut_into_blocks(discs);
  made_ = false;
}

}  // namespace furrow
