// How far apart links tear in an engine and in furrow's own run: link by link, and by their number.
#pragma once

#include <vector>

#include "export/engine_output.h"

namespace furrow {

struct TearsApart {
  int furrow = 0, engine = 0, both = 0;    // links torn by the last row of the run
  int furrow_early = 0, engine_early = 0;  // tears up to the early time
  double steps = 0;                        // of the scene: the greatest distance of a tear that is early in either
};

// The engine's outputs tell the step of each tear, and between which two rows which link tore. A tear that the other has
// not at all is at least as far apart as the end of the run.
TearsApart tears_apart(const DeckRun& run, const std::vector<Tear>& own, const EngineOutput& engine, double early);

}  // namespace furrow
