// What each watch of run/validity.h lets pass, and the words of its messages.
#pragma once

#include <array>
#include <string>

#include "run/validity.h"

namespace furrow {

struct Rule {
  WatchKind kind;
  const char* name;
  double warns_above, ends_above;
  const char *before, *after;  // what a message says around the number
};
inline constexpr std::array<Rule, watch_kinds> rules{{
    {WatchKind::energy_made, "energy_made", 0.01, 0.1, "the method or a law has made ",
     " of the energy that the scene was given"},
    {WatchKind::energy_lost, "energy_lost", 0.01, 1, "the method has lost ", " of the energy that the scene was given"},
    {WatchKind::overlap, "overlap", 0.1, 1, "the overlap is ", " of the smaller radius"},
    {WatchKind::behind_walls, "behind_walls", 0, 0, "discs whose centres are behind a wall: ", ""},
    {WatchKind::through_plates, "through_plates", 0, 0, "centres that have crossed the middle of a plate: ", ""},
    {WatchKind::through_lattices, "through_lattices", 0, 0, "centres that have crossed the border of a lattice: ", ""},
    {WatchKind::crossing_lattices, "crossing_lattices", 0, infinity,
     "borders of lattices are passed, by each other, by a plate, or by a disc where they are torn; crossings and cells "
     "inside out: ",
     ""},
    {WatchKind::impact, "impact", 1, infinity, "a contact has ",
     " times the energy that carries the one through the other"},
    {WatchKind::step, "step", 0.5, infinity, "the step is ", " times the largest stable one"},
    {WatchKind::arrival, "arrival", 1, infinity, "the step is ",
     " times the largest stable one of an impact that may come"},
}};

// What a message advises.
inline std::string what_helps(WatchKind kind, const Scene& scene) {
  // The spring of a contact that begins by sliding has no bound then, and its growing stiffness makes energy.
  const bool by_law = kind == WatchKind::energy_made && scene.contact.friction > 0 &&
                      scene.model.after_slip == AfterSlip::less_viscous && !has_constant_stiffness(scene.model.law);
  if (by_law) return "the law makes it, at any step: take model.after_slip = \"elastic\"";
  return kind <= WatchKind::energy_lost ? "take a shorter step" : "take a shorter step or stiffer parts";
}

}  // namespace furrow
