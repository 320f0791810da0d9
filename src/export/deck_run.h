// What the run of a deck writes: how many rows, columns and bodies, and which links.
#pragma once

#include <map>
#include <utility>

#include "run/prepare.h"

namespace furrow {

struct DeckRun {
  double step = 0;            // s, of the scene
  long every = 1, steps = 1;  // of these steps: between two rows, in the whole run
  std::size_t parts = 0;      // plates and walls, each with two columns of forces
  int bodies = 0;
  std::map<std::pair<int, int>, int> bonds;  // two bodies, from 1, the lesser first; the link between them
  bool tears = false;                        // some bond can tear

  double interval() const { return static_cast<double>(every) * step; }  // s, between two rows
  long rows() const { return steps / every + 1; }
  long last_row() const { return steps / every * every; }  // in steps
};

DeckRun deck_run(const Prepared& prepared);

}  // namespace furrow
