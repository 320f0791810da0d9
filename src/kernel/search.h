// Which parts may touch: neighbour lists of all pairs within a reach beyond the contact, renewed before a pair that is
// not listed can have come into contact. The lists never change a result: a listed pair that does not touch adds
// nothing, forces are summed in the order of the pairs, and whether a contact holds a slot depends on distances alone,
// not on when a list was made.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/size_classes.h"
#include "system/discrete.h"
#include "system/held_faces.h"
#include "system/order.h"
#include "system/surface.h"

namespace furrow {

// 1 if a candidate should take a slot or give it back, else 0; without a branch, for loops over all pairs.
inline std::uint32_t slot_changes(int slot, std::uint32_t near_at, std::uint32_t now) {
  const std::uint32_t unheld = slot < 0 ? 1 : 0, near = near_at == now ? 1 : 0;
  const std::uint32_t quiet = now - near_at > quiet_jumps ? 1 : 0;
  return (unheld & near) | ((unheld ^ 1) & quiet);
}

// Where everything is. Arrays of discs and of nodes (fixed ones too).
struct Placement {
  double t;                                         // s; 0 while the scene is prepared
  const double *disc_x, *disc_y, *node_x, *node_y;  // m
  Vec2 disc(int i) const { return {disc_x[i], disc_y[i]}; }
  Vec2 node(int n) const { return {node_x[n], node_y[n]}; }
  Vec2 of(const ContactId& pair) const { return of_disc(pair.kind) ? disc(pair.a) : node(pair.a); }
};

// Pairs of one kind that may touch, sorted by (a, b). a: disc or node; b: disc, wall, plate or lattice.
struct Candidates {
  std::vector<int> a, b;
  std::vector<int> slot;               // of the tangential spring in the state; -1: none
  std::vector<std::uint32_t> near_at;  // jump at which the pair was last near; see NeighbourSearch::margin
  std::vector<double> reduced_radius;  // m
  std::vector<double> reduced_mass;    // kg; of disc and lattice: not used, it depends on the contact point
  std::vector<int> law;                // index into Parts::law
  std::vector<int> first_segment;      // disc-lattice: candidate k may touch segment[first_segment[k]] ...
  std::vector<int> segment;
  int count() const { return static_cast<int>(a.size()); }
  void resize(int count);  // does not touch the segments
};

// A block of consecutive discs, and the pairs whose first disc is in it. What such a pair does to a disc of a later
// block is a boundary contribution: stored until all blocks are done, then added in the order of the pairs.
struct DiscBlock {
  int first_disc, last_disc, first_pair, last_pair, first_contribution, last_contribution;
};

class NeighbourSearch {
 public:
  NeighbourSearch() = default;
  NeighbourSearch(const Parts& parts, const Search& settings);

  // Makes sure that every pair closer than `margin` is on a list. Throws Divergence where a position is not finite.
  void update(const Parts& parts, const Placement& now, int threads = 1);

  // Replaces the lists by these pairs, which all hold a slot and are sorted.
  void keep_only(const std::array<Candidates, contact_kinds>& held, int discs);

  // The lists are no longer good.
  void forget() { made_ = false; }

  double margin = 0;        // m, Parts::margin
  HeldFaces faces;          // of plates, that bodies keep: listed as long as they do
  std::vector<int> border;  // segments that discs touch
  std::array<Candidates, contact_kinds> candidates;
  std::vector<DiscBlock> blocks;
  struct Contribution {
    int number, disc;
  };
  std::vector<std::vector<Contribution>> boundary;  // to the discs of each block, ascending
  int contributions = 0;                            // of all blocks
  long rebuilds = 0;
  long checks = 0;  // distances and rows of cells looked at for all lists so far: what they cost

 private:
  struct Pair {
    int a, b;
    bool operator==(const Pair& other) const { return a == other.a && b == other.b; }
    bool operator<(const Pair& other) const { return comes_before(a, b, other.a, other.b); }
  };
  struct Member {
    Pair pair;
    int slot;
    std::uint32_t near_at;
  };
  struct Piece {             // of a new list
    std::vector<Pair> near;  // sorted
    std::vector<Pair> across, from_others, merged;
    std::vector<Member> member;
    int start = 0;
    long checks = 0;
  };

  bool current(const Parts& parts, const Placement& now, int threads) const;
  void remember(const Parts& parts, const Placement& now);
  void check_finite(const Parts& parts, const Placement& now) const;
  void sort(const Parts& parts, const Placement& now);
  void renew(const Parts& parts, const Placement& now, ContactKind kind, int threads);
  void find_flat(const Parts& parts, const Placement& now, ContactKind kind, Piece& piece);
  void find_segments(const Parts& parts, const Placement& now, Piece& piece);
  void find_discs(const Parts& parts, const Placement& now, int threads, int pieces);
  void near_discs(const Parts& parts, const Placement& now, int first, int last, Piece& piece) const;
  void near_disc(const Parts& parts, const Placement& now, int i, Piece& piece) const;
  void share_across(int pieces);
  static void keep_held(const Candidates& old, int first, int last, Piece& piece);
  void write_out(const Parts& parts, ContactKind kind, const Piece& piece);
  void list_segments(const Parts& parts);
  void cut_into_blocks(int discs);

  bool idle_ = true;      // nothing can ever touch
  double skin_ = 0;       // m
  double cell_size_ = 0;  // m; 0: the reach
  bool made_ = false;
  double made_at_ = 0;  // s
  std::vector<double> disc_x_, disc_y_, node_x_, node_y_;
  SizeClasses discs_, nodes_;
  double node_cell_ = 0;           // m
  std::vector<Pair> near_border_;  // disc and segment, sorted
  std::vector<Piece> pieces_;
};

}  // namespace furrow
