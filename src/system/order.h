// The order of the sums: part of what is specified, because sums of floating-point numbers depend on it. It follows
// from the scene alone, and is the same for every solver, number of threads and setting of the search.
//
//   contacts   kind by kind, in the order of ContactKind; of one kind sorted by (a, b), a < b between discs
//   discs      are numbered as they are stored (system/place.h), and cut into blocks by these numbers
//   of a disc  first its pairs with discs of its own block, and those of which it is the first disc, in order; then its
//              boundary contributions: pairs whose first disc is of an earlier block, in order; then walls, plates,
//              lattices
//   of a node  its load, then contacts in order (of a border segment node a before b), then links in order
//   rates      the sum, times 1/m or 1/I; gravity is taken off last
//   powers     of disc pairs block by block, by the block of the first disc, the blocks added in turn; then all others
//   heat of springs returned by a jump: as powers, but the first block starts from the ledger's value, and all others
//              are added to it before the other blocks are
//   plate work, link damping, tears: one after the other; the work of driven nodes after that of plates
//
// The functions below say it, to the reference and to the kernel: which contact comes before which, how discs are cut
// into blocks, whose force is a boundary contribution, and how what blocks summed up is joined.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace furrow {

// 4096 discs and their contacts fit in a second-level cache.
inline constexpr int discs_per_block = 4096;

// Of two contacts of one kind; a, b as in ContactId.
inline bool comes_before(int a, int b, int other_a, int other_b) {
  return a < other_a || (a == other_a && b < other_b);
}

// Of two contacts, or of what is kept of them: whatever has kind, a and b.
inline bool comes_before(const auto& one, const auto& other) {
  return one.kind < other.kind || (one.kind == other.kind && comes_before(one.a, one.b, other.a, other.b));
}

inline int block_of(int disc) { return disc / discs_per_block; }
inline int blocks_of(int discs) { return discs == 0 ? 1 : 1 + block_of(discs - 1); }

// The discs of a block, [first, last).
struct BlockOfDiscs {
  int first, last;
};
inline BlockOfDiscs discs_of_block(int block, int discs) {
  return {block * discs_per_block, std::min(discs, (block + 1) * discs_per_block)};
}

// Of a pair a < b: whether the second disc gets its force after all blocks are done.
inline bool across_blocks(int a, int b) { return block_of(a) != block_of(b); }

// Adds to what the first block summed up what the others did, in turn; `add` adds one to it.
template <class Sum, class Add>
void join_blocks(std::vector<Sum>& of_block, const Add& add) {
  for (std::size_t k = 1; k < of_block.size(); ++k) add(of_block[0], of_block[k]);
}

}  // namespace furrow
