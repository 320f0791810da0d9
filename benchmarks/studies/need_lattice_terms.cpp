#include "benchmarks/studies/need_lattice_terms.h"

#include <algorithm>
#include <cmath>

#include "scene/stem.h"
#include "scene/strip.h"

namespace furrow::benchmarks {
namespace {

bool any_lattice(const Scene& scene, bool (*is)(const Lattice&)) {
  return std::any_of(scene.lattice.begin(), scene.lattice.end(), is);
}

bool has_fixed_lines(const Lattice& l) { return !l.fixed_rows.empty() || !l.fixed_columns.empty(); }

bool tears(const Lattice& l) {
  return std::min({l.structural.strength, l.shear.strength, l.bending.strength}) < infinity;
}

// The last fixed line and the first free one: rows if some are fixed, else columns.
std::vector<int> lines_at_the_foot(const Lattice& l) {
  const std::vector<int>& fixed = l.fixed_rows.empty() ? l.fixed_columns : l.fixed_rows;
  const int last = *std::max_element(fixed.begin(), fixed.end());
  return {last, last + 1};
}

// ---- driven nodes ----

void drive_at_rest(Lattice& l) {
  if (!l.fixed_rows.empty()) l.drive.push_back({.rows = l.fixed_rows});
  if (!l.fixed_columns.empty()) l.drive.push_back({.columns = l.fixed_columns});
  l.fixed_rows.clear();
  l.fixed_columns.clear();
}

// ---- links of their own ----

void weaken_the_foot(Lattice& l) {
  LinkSetting weak{.strength_factor = 0.5};
  (l.fixed_rows.empty() ? weak.columns : weak.rows) = lines_at_the_foot(l);
  l.link.push_back(weak);
}

void notch_the_foot(Lattice& l) {
  const std::vector<int> line = lines_at_the_foot(l);
  l.link.push_back(l.fixed_rows.empty() ? LinkSetting{.from = {0, line[0]}, .to = {0, line[1]}, .torn = true}
                                        : LinkSetting{.from = {line[0], 0}, .to = {line[1], 0}, .torn = true});
}

// ---- rollers ----

bool is_held_by_two_rows(const Lattice& l) { return l.fixed_rows.size() > 1 && l.node.empty(); }

void put_on_rollers(Lattice& l) {
  const int row = lines_at_the_foot(l)[0];
  std::erase(l.fixed_rows, row);
  for (int column = 0; column < l.columns; ++column) l.node.push_back({.row = row, .column = column, .fixed_x = true});
}

// ---- a stem ----

// As wide, long and heavy, and as hard to bend and to tear by a pull; its first bending motion damped as much.
Stem stem_like(const Lattice& l, const Beam& beam) {
  Stem stem{.diameter = (l.columns - 1) * l.spacing, .length = (l.rows - 1) * l.spacing};
  const double area = pi * stem.diameter * stem.diameter / 4;               // m^2
  const double wave = first_bending / stem.length;                          // 1/m
  const double rate = wave * wave * std::sqrt(beam.bending / beam.mass);    // rad/s
  const double relaxation = l.structural.damping / l.structural.stiffness;  // s
  stem.young = beam.bending / (area * stem.diameter * stem.diameter / 16);
  stem.strength = beam.tearing_tension() / area;
  stem.damping_ratio = 0.5 * relaxation * rate;
  return stem;
}

bool can_be_a_stem(const Lattice& l) {
  if (l.stem || l.columns < least_stem_columns || l.columns > most_stem_columns || !(l.structural.stiffness > 0))
    return false;
  const auto beam = beam_of(l);
  return beam && l.rows > 2 * (l.columns - 1) && has_springs(stem_like(l, *beam), l);
}

void make_a_stem(Scene& scene, Lattice& l) {
  const Beam beam = *beam_of(l);
  const Stem stem = stem_like(l, beam);
  Material wood = *std::find_if(scene.material.begin(), scene.material.end(),
                                [&](const Material& m) { return m.name == l.material; });
  wood.name = "of the stem";
  wood.density = beam.mass / (pi * stem.diameter * stem.diameter / 4);
  scene.material.push_back(wood);
  l.material = wood.name;
  l.stem = stem;
  l.structural = l.shear = l.bending = {};
}

}  // namespace

std::vector<Term> lattice_terms() {
  return {
      {"fixed rows and columns (driven nodes at rest instead)",
       [](const Scene& s) { return any_lattice(s, has_fixed_lines); },
       [](Scene& s) {
         for (Lattice& l : s.lattice) drive_at_rest(l);
       }},
      {"nodes fixed both ways (the upper fixed row on rollers that let it rise instead)",
       [](const Scene& s) { return any_lattice(s, is_held_by_two_rows); },
       [](Scene& s) {
         for (Lattice& l : s.lattice)
           if (is_held_by_two_rows(l)) put_on_rollers(l);
       }},
      {"springs kind by kind (a stem as wide, heavy and hard to bend instead)",
       [](const Scene& s) { return any_lattice(s, can_be_a_stem); },
       [](Scene& s) {
         for (Lattice& l : s.lattice)
           if (can_be_a_stem(l)) make_a_stem(s, l);
       }},
      {"one strength for all links (half of it at the fixed nodes instead)",
       [](const Scene& s) { return any_lattice(s, [](const Lattice& l) { return has_fixed_lines(l) && tears(l); }); },
       [](Scene& s) {
         for (Lattice& l : s.lattice)
           if (has_fixed_lines(l)) weaken_the_foot(l);
       }},
      {"links that are all whole at first (a notch at the fixed nodes instead)",
       [](const Scene& s) { return any_lattice(s, [](const Lattice& l) { return has_fixed_lines(l) && tears(l); }); },
       [](Scene& s) {
         for (Lattice& l : s.lattice)
           if (has_fixed_lines(l)) notch_the_foot(l);
       }},
  };
}

}  // namespace furrow::benchmarks
