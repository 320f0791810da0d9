// The order of the sums: part of what is specified, because sums of floating-point numbers depend on it. It follows
// from the scene alone, and is the same for every solver, number of threads and setting of the search.
//
//   contacts   kind by kind, in the order of ContactKind; of one kind sorted by (a, b), a < b between discs
//   discs      are cut into blocks by their numbers
//   of a disc  first its pairs with discs of its own block, and those of which it is the first disc, in order; then its
//              boundary contributions: pairs whose first disc is of an earlier block, in order; then walls, plates,
//              lattices
//   of a node  its load, then contacts in order, then links in order
//   powers     of pairs block by block, by the block of the first disc, the blocks added in turn; then all others
//   springs returned by a jump: as powers, but all others are added to the first block before the blocks are
#pragma once

namespace furrow {

// So many at least fit the second-level cache.
inline constexpr int discs_per_block = 4096;

inline int block_of(int disc) { return disc / discs_per_block; }
inline int blocks_of(int discs) { return discs == 0 ? 1 : 1 + block_of(discs - 1); }

// Of a pair a < b: whether the second disc gets its force after all blocks are done.
inline bool across_blocks(int a, int b) { return block_of(a) != block_of(b); }

}  // namespace furrow
