// Which parts are near each other: the entries of neighbour lists.
#include <algorithm>
#include <iterator>

#include "kernel/parallel.h"
#include "kernel/search.h"

namespace furrow {

// Discs or nodes near the walls or plates.
void NeighbourSearch::find_flat(const Parts& parts, const Placement& now, ContactKind kind, Piece& piece) {
  const double reach = margin + skin_;
  const SizeClasses& bodies = of_disc(kind) ? discs_ : nodes_;
  const bool walls = kind == disc_wall || kind == node_wall;
  piece.near.clear();
  for (int b = 0; b < static_cast<int>(walls ? parts.wall.size() : parts.plate.size()); ++b) {
    const auto look = [&](int a) {
      ++checks;
      const Vec2 at = of_disc(kind) ? now.disc(a) : now.node(a);
      const ContactId pair{kind, a, b};
      const Gap gap = parts.tight_plates ? held_gap(parts, {}, pair, at, now.t) : flat_gap(parts, pair, at, now.t);
      if (gap.gap < reach) piece.near.push_back({a, b});
    };
    if (walls) {
      checks += bodies.near_wall(parts.wall[b], reach, look);
    } else {
      const Rectangle plate = whole_at(parts.plate[b], now.t);
      checks += bodies.near_box({plate.left, plate.right}, {plate.lower, plate.upper}, reach, look);
    }
  }
  for (const HeldFace& held : faces) {
    if (held.kind == kind) piece.near.push_back({held.a, held.b});
  }
  std::sort(piece.near.begin(), piece.near.end());
  piece.near.erase(std::unique(piece.near.begin(), piece.near.end()), piece.near.end());
}

// Discs near the border segments, and the lattices that these are of.
void NeighbourSearch::find_segments(const Parts& parts, const Placement& now, Piece& piece) {
  const double reach = margin + skin_;
  near_border_.clear();
  for (const int s : border) {
    const Vec2 a = now.node(parts.border.a[s]), b = now.node(parts.border.b[s]);
    const auto look = [&](int disc) {
      const double within = parts.disc.radius[disc] + reach;
      ++checks;
      if (nearest_on_segment(now.disc(disc), a, b, 0).distance2 < within * within) near_border_.push_back({disc, s});
    };
    checks += discs_.near_segment(a, b, reach, look);
  }
  std::sort(near_border_.begin(), near_border_.end());
  piece.near.clear();
  for (const Pair& p : near_border_) {
    const Pair pair{p.a, parts.border.lattice[p.b]};
    if (piece.near.empty() || piece.near.back() != pair) piece.near.push_back(pair);
  }
}

// The discs near disc i: those after it in its own class, and all of the larger classes. A large disc does not search
// among smaller ones: each pair is found once.
void NeighbourSearch::near_disc(const Parts& parts, const Placement& now, int i, Piece& piece) const {
  const double* radius = parts.disc.radius.data();
  const double reach = radius[i] + margin + skin_;
  const auto look = [&](int j, std::vector<Pair>& into) {
    const double dx = now.disc_x[j] - now.disc_x[i];
    const double dy = now.disc_y[j] - now.disc_y[i];
    const double within = radius[j] + reach;
    ++piece.checks;
    if (dx * dx + dy * dy < within * within) into.push_back({std::min(i, j), std::max(i, j)});
  };
  const int own = discs_.class_of(i);
  piece.checks += discs_.near_disc(own, now.disc_x[i], now.disc_y[i], reach, [&](int j) {
    if (j > i) look(j, piece.near);
  });
  for (int larger = own + 1; larger < discs_.count(); ++larger) {
    piece.checks +=
        discs_.near_disc(larger, now.disc_x[i], now.disc_y[i], reach, [&](int j) { look(j, piece.across); });
  }
}

// The pairs that discs of [first, last) find.
void NeighbourSearch::near_discs(const Parts& parts, const Placement& now, int first, int last, Piece& piece) const {
  piece.near.clear();
  piece.across.clear();
  piece.checks = 0;
  for (int i = first; i < last; ++i) {
    const auto start = static_cast<std::ptrdiff_t>(piece.near.size());
    near_disc(parts, now, i, piece);
    std::sort(piece.near.begin() + start, piece.near.end(), [](const Pair& p, const Pair& q) { return p.b < q.b; });
  }
}

void NeighbourSearch::find_discs(const Parts& parts, const Placement& now, int threads, int pieces) {
  in_parallel(threads, pieces, [&](int k, int /*thread*/) {
    const auto [first, last] = discs_of_block(k, parts.disc.count());
    near_discs(parts, now, first, last, pieces_[k]);
  });
  for (int k = 0; k < pieces; ++k) checks += pieces_[k].checks;
  if (discs_.count() > 1) share_across(pieces);
}

// Moves pairs of two classes to the piece of their first disc.
void NeighbourSearch::share_across(int pieces) {
  for (int k = 0; k < pieces; ++k) pieces_[k].from_others.clear();
  for (int k = 0; k < pieces; ++k) {
    for (const Pair& p : pieces_[k].across) pieces_[block_of(p.a)].from_others.push_back(p);
  }
  for (int k = 0; k < pieces; ++k) {
    auto& [near, across, from_others, merged, member, start, count] = pieces_[k];
    std::sort(from_others.begin(), from_others.end());
    merged.clear();
    std::merge(near.begin(), near.end(), from_others.begin(), from_others.end(), std::back_inserter(merged));
    near.swap(merged);
  }
}

// The segments of its lattice that each candidate may touch.
void NeighbourSearch::list_segments(const Parts& parts) {
  Candidates& list = candidates[disc_lattice];
  list.first_segment.assign(1, 0);
  list.segment.clear();
  auto near = near_border_.begin();
  for (int k = 0; k < list.count(); ++k) {
    const auto of_this = [&] { return near->a == list.a[k] && parts.border.lattice[near->b] == list.b[k]; };
    for (; near != near_border_.end() && of_this(); ++near) list.segment.push_back(near->b);
    list.first_segment.push_back(static_cast<int>(list.segment.size()));
  }
}

}  // namespace furrow
