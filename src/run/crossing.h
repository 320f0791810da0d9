// Whether a centre passes through something in a step: straight paths between two states, seen from what it passes.
#pragma once

#include <string>

#include "run/path.h"

namespace furrow {

// m, of a node, whether it moves, is held or driven.
Vec2 node_place(const System& system, double t, const State& y, int node);

// As in the scene, else its number.
std::string lattice_name(const System& system, int lattice);

// Whether disc or node `contact.a` crossed the middle of the plate contact.b, between its two larger faces; where faces
// are kept, in a step that began too far away to be on one.
bool crosses_plate(const System& system, const Step& step, const ContactId& contact);

// Whether a point crossed the border segment, be it torn or whole.
bool crosses_segment(const System& system, const Step& s, const Path& point, int segment);

// Pairs of border segments that cross each other, of two lattices or of one, and of what the first are.
struct CrossingBorders {
  int pairs = 0;
  std::string where{};
};
CrossingBorders crossing_borders(const System& system, double t, const State& y);

// Cells of which all four sides are whole and go round the wrong way or cross each other.
CrossingBorders cells_inside_out(const System& system, double t, const State& y);

// Nodes that crossed a border segment of another lattice in the step, or of their own one too.
CrossingBorders passed_borders(const System& system, const Step& step, bool of_their_own);

// The first disc or node that in this step came from one side of a plate to another and no longer touches it: the plate
// stepped over it. a = -1: none.
ContactId stepped_over(const System& system, const Step& step);

}  // namespace furrow
