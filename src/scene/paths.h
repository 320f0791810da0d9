// Where plates and driven nodes go until the end of the run.
#pragma once

#include "scene/findings.h"

namespace furrow {

// Warns of what they pass through without being felt. The scene has no faults.
void judge_paths(const Scene& scene, Findings& found);

}  // namespace furrow
