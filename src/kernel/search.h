// Which parts may touch: neighbour lists with a reach larger than any contact, renewed before anything can have moved
// through that reach. The lists never change a result: a pair on a list that does not touch adds nothing, forces are
// summed in the order of the pairs, and what a contact remembers (its slot) is decided by distances alone, not by when
// a list was made.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/size_classes.h"
#include "system/discrete.h"
#include "system/order.h"
#include "system/surface.h"

namespace furrow {

// Whether a candidate should take a slot or give it back.
// Without a branch, for loops over all pairs: 1 or 0.
inline std::uint32_t slot_changes(int slot, std::uint32_t near_at, std::uint32_t now) {
  const std::uint32_t unheld = slot < 0 ? 1 : 0, near = near_at == now ? 1 : 0;
  const std::uint32_t quiet = now - near_at > quiet_jumps ? 1 : 0;
  return (unheld & near) | ((unheld ^ 1) & quiet);
}

// Pairs of one kind that may touch, sorted by (a, b). a: disc or node; b: disc, wall, plate or lattice.
struct Candidates {
  std::vector<int> a, b;
  std::vector<int> slot;               // of the tangential spring in the state; -1: none
  std::vector<std::uint32_t> near_at;  // jump at which the pair was last near; see NeighbourSearch::margin
  std::vector<double> reduced_radius;  // m
  std::vector<double> reduced_mass;    // kg; of disc and lattice: not used, it depends on the contact point
  std::vector<int> law;                // index into Parts::law
  std::vector<int> first_segment;      // disc-lattice: candidate k may touch segment[first_segment[k] ...]
  std::vector<int> segment;
  int count() const { return static_cast<int>(a.size()); }
  void resize(int count);  // all but the segments
};

// Discs that follow each other, and the pairs that have one of them as the first. What a pair does to a disc of a later
// chunk is a spill: kept apart until all chunks are done, then added in the order of the pairs.
struct Chunk {
  int first_disc, last_disc, first_pair, last_pair, first_spill, last_spill;
};

class NeighbourSearch {
 public:
  NeighbourSearch() = default;
  NeighbourSearch(const Parts& parts, const Search& settings);

  // Makes sure that every pair closer than `margin` is on a list. Throws Divergence where a position is not finite.
  void update(const Parts& parts, const Placement& now, int threads = 1);

  // Forgets the lists but for those of these pairs, all with a slot and sorted.
  void keep_only(const std::array<Candidates, contact_kinds>& held, int discs);

  double margin = 0;  // m, Parts::margin
  std::array<Candidates, contact_kinds> candidates;
  std::vector<Chunk> chunks;
  struct Spill {
    int number, disc;
  };
  std::vector<std::vector<Spill>> spilled;  // into each chunk, ascending
  int spills = 0;
  long rebuilds = 0;
  long looks = 0;  // at distances and at rows of cells, for all lists so far: what they cost

 private:
  struct Pair {
    int a, b;
    bool operator==(const Pair& other) const { return a == other.a && b == other.b; }
    bool operator<(const Pair& other) const { return a < other.a || (a == other.a && b < other.b); }
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
    long looks = 0;
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
  void cut_into_chunks(int discs);

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
