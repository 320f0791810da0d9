// How stiff a scene is in its present state, estimated part by part.
#pragma once

#include <string>
#include <vector>

#include "methods/stability.h"
#include "run/system.h"

namespace furrow {

struct StiffPart {
  Oscillator oscillator;  // the part's fastest motion, its neighbours held
  std::string name;
  int contacts = 0;    // of a disc
  bool spins = false;  // the fastest motion is mainly a spin
  void history(HistoryVisitor& visit);
};

// The disc or node with the fastest motion by contacts and links, each alone among held neighbours: the greatest
// eigenvalues of its mass-weighted stiffness and damping (2 x 2 for a node; 3 x 3, with the spin, for a disc), contacts
// taken as sticking and rolling as at rest. Neighbours that move against it can make it up to twice as stiff, never
// more (Gershgorin). The name is empty if no force acts.
StiffPart stiffest_part(const System& system, double t, const State& y);

// The stiffest contact or link on one body, or of all if that has none or is negative, each alone between its two
// parts: where a run that has blown up most likely began. `contacts` and `spins` are not set.
StiffPart stiffest_bond(const System& system, double t, const State& y, int body);

// The stiffest contact that two parts of the scene make when they meet at this speed (m/s), elastic and head-on: the
// lightest disc of each material with each other (with itself only if there are more), with walls, plates and nodes;
// nodes with plates and walls. Zero if no two can meet.
// omega = sqrt(15/8) v / d at the greatest overlap d; the damping ratio is the same at any overlap.
Oscillator stiffest_impact(const Parts& parts, double speed);

// Warnings about a run with this method and step, one text each.
std::vector<std::string> step_warnings(const System& system, double t, const State& y, const std::string& method,
                                       double step);

}  // namespace furrow
