#include "scene/lattice_parts.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "scene/border.h"
#include "scene/stem.h"

namespace furrow {
namespace {

bool has(const std::vector<int>& list, int value) { return std::find(list.begin(), list.end(), value) != list.end(); }

Vec2 place_of(const Lattice& l, int node) {
  const int row = node / l.columns, column = node % l.columns;
  return {l.spacing * column, l.spacing * row};  // m, from the first node
}

struct Step {
  int rows, columns;
};

// What a link has before single links are looked at; nothing where there is none.
class Springs {
 public:
  explicit Springs(const Lattice& l) : lattice_(l) {
    if (l.stem) stem_ = springs_of(*l.stem, l);
  }

  std::optional<LinkKind> of(LinkClass kind, int row, int column, Step step) const {
    if (stem_) return of_stem(kind, row, column, step);
    const LinkKind& k = kind == LinkClass::structural ? lattice_.structural
                        : kind == LinkClass::shear    ? lattice_.shear
                                                      : lattice_.bending;
    if (k.stiffness == 0 && k.damping == 0) return {};
    return k;
  }

 private:
  std::optional<LinkKind> of_stem(LinkClass kind, int row, int column, Step step) const {
    if (kind == LinkClass::bending) return {};
    const bool edge = column == 0 || column == lattice_.columns - 1;
    const bool end = row == 0 || row == lattice_.rows - 1;
    const double k = kind == LinkClass::shear ? stem_->diagonal
                     : step.rows == 0         ? stem_->across * (end ? 0.5 : 1)
                     : edge                   ? stem_->edge
                                              : stem_->inner;
    const double rest = lattice_.spacing * std::sqrt(kind == LinkClass::shear ? 2.0 : 1.0);
    return LinkKind{k, k * stem_->relaxation, k * rest * stem_->tear_strain};
  }

  const Lattice& lattice_;
  std::optional<StemSprings> stem_;
};

void add_links(const Lattice& l, const Springs& springs, LinkClass kind, std::initializer_list<Step> steps, double rest,
               std::vector<LatticeLink>& links) {
  for (int row = 0; row < l.rows; ++row) {
    for (int column = 0; column < l.columns; ++column) {
      for (const Step& step : steps) {
        const int other_row = row + step.rows, other = column + step.columns;
        if (other_row >= l.rows || other < 0 || other >= l.columns) continue;
        const auto k = springs.of(kind, row, column, step);
        if (!k) continue;
        links.push_back({row * l.columns + column, other_row * l.columns + other, kind, rest, k->stiffness, k->damping,
                         k->strength, false});
      }
    }
  }
}

void apply(const LinkSetting& s, LatticeLink& link) {
  link.stiffness = s.stiffness.value_or(link.stiffness) * s.stiffness_factor;
  link.damping = s.damping.value_or(link.damping);
  link.strength = s.strength.value_or(link.strength) * s.strength_factor;
  link.torn = link.torn || s.torn;  // what another setting changes of a notch does not mend it
}

}  // namespace

bool chooses(const LinkSetting& s, const Lattice& l, const LatticeLink& link) {
  const int row_a = link.a / l.columns, column_a = link.a % l.columns;
  const int row_b = link.b / l.columns, column_b = link.b % l.columns;
  const auto in = [](const std::vector<int>& lines, int a, int b) {
    return lines.empty() || (has(lines, a) && has(lines, b));
  };
  const auto ends_at = [](const std::vector<int>& node, int row, int column) {
    return node == std::vector<int>{row, column};
  };
  if (s.kind != LinkChoice::any && static_cast<int>(s.kind) != static_cast<int>(link.kind) + 1) return false;
  if (!in(s.rows, row_a, row_b) || !in(s.columns, column_a, column_b)) return false;
  if (!s.from.empty() && !(ends_at(s.from, row_a, column_a) && ends_at(s.to, row_b, column_b)) &&
      !(ends_at(s.to, row_a, column_a) && ends_at(s.from, row_b, column_b)))
    return false;
  return !s.cut_from || segments_cross(*s.cut_from, *s.cut_to, place_of(l, link.a), place_of(l, link.b));
}

std::vector<LatticeLink> links_of(const Lattice& l) {
  std::vector<LatticeLink> links;
  const Springs springs(l);
  add_links(l, springs, LinkClass::structural, {{0, 1}, {1, 0}}, l.spacing, links);
  add_links(l, springs, LinkClass::shear, {{1, 1}, {1, -1}}, std::sqrt(2.0) * l.spacing, links);
  add_links(l, springs, LinkClass::bending, {{0, 2}, {2, 0}}, 2 * l.spacing, links);
  for (const LinkSetting& s : l.link)
    for (LatticeLink& link : links)
      if (chooses(s, l, link)) apply(s, link);
  return links;
}

std::vector<Held> held_nodes(const Lattice& l) {
  std::vector<Held> held;
  for (int row = 0; row < l.rows; ++row) {
    const bool fixed_row = has(l.fixed_rows, row);
    for (int column = 0; column < l.columns; ++column) {
      const bool fixed = fixed_row || has(l.fixed_columns, column);
      held.push_back({fixed, fixed});
      for (int d = 0; d < std::ssize(l.drive); ++d)
        if (has(l.drive[d].rows, row) || has(l.drive[d].columns, column)) held.back() = {true, true, d};
    }
  }
  for (const NodeSetting& n : l.node) {
    if (n.row >= l.rows || n.column >= l.columns) continue;  // that is judged elsewhere
    Held& here = held[static_cast<std::size_t>(n.row) * static_cast<std::size_t>(l.columns) +
                      static_cast<std::size_t>(n.column)];
    here.x = here.x || n.fixed_x;
    here.y = here.y || n.fixed_y;
  }
  return held;
}

double mass_of(const Lattice& l, int row, int column) {
  if (!l.stem) return l.node_mass;
  const bool edge = column == 0 || column == l.columns - 1, end = row == 0 || row == l.rows - 1;
  return l.node_mass * (edge ? 0.5 : 1) * (end ? 0.5 : 1);
}

}  // namespace furrow
