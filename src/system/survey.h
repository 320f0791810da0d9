// What the watch over a run needs to know of the contacts at every step, collected in the pass over them that a jump
// makes anyway.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "system/contact.h"

namespace furrow {

// Of the contacts of one block, or of all.
struct ContactExtremes {
  double contacts = 0;   // how many touch
  double overlap = 0;    // -, greatest, of the smaller radius; of a node of its contact radius
  double impact = 0;     // -, greatest energy of a contact, over the energy that carries one part through the other
  int behind_walls = 0;  // discs whose centres are behind a wall
  ContactId deepest{};   // only if deeper than Survey::known_overlap
  ContactId hardest{};   // of `impact`
  void join(const ContactExtremes& other);
};

struct Survey {
  // Set by the watch: contacts below these need not be examined one by one.
  double known_overlap = 0;  // -
  double fast = infinity;    // m/s, an approach
  double reach = 0;          // m, from a centre to a plate

  ContactExtremes seen{};
  std::vector<ContactId> near{};               // centres inside a plate or closer to it than `reach`
  std::vector<double> plate_fx{}, plate_fy{};  // N, on each plate

  // At each jump: forgets the last one, then sees contact after contact, and counts them in `sum`.
  void begin(const Parts& parts);
  void see(const Parts& parts, const Contact& contact, ContactExtremes& sum);
  void see_impact(const Parts& parts, const Contact& contact, ContactExtremes& sum) const;
};

// J: the energy that carries disc or node `a` through `b`, or infinity: the work of the elastic force up to where the
// centres of two discs pass, or a centre the middle of a plate or the border of a lattice. No one passes through a
// wall, or a plate whose faces are kept.
double passing_work(const Parts& parts, const ContactId& contact, const ContactLaw& law, double reduced_radius);

// m/s: no contact of these parts whose two approach more slowly has the energy to pass.
double least_passing_speed(const Parts& parts);

}  // namespace furrow
