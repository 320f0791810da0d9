// What a scene gives and what changes nothing in it, and lattices that cannot do what their links say.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "scene/findings.h"
#include "scene/lattice_parts.h"
#include "scene/mechanism.h"
#include "scene/wording.h"

namespace furrow {
namespace {

using Number = std::optional<double>;

constexpr int threaded_discs = 4096;  // a smaller bed is no work for two threads

// Of [contact] or of a pair: what no option of [model] asks for.
void judge_contact(const std::string& path, const auto& c, const Model& model, Findings& found) {
  const auto idle = [&](const std::optional<double>& given, bool used, const char* key, const char* why) {
    if (given && !used) found.warning(path + key, std::string("has no effect: ") + why);
  };
  const bool linear = model.law == ForceLaw::linear, spring = model.rolling == Rolling::spring;
  idle(c.normal_stiffness, linear, ".normal_stiffness", "model.law is not linear");
  idle(c.tangential_stiffness, linear, ".tangential_stiffness", "model.law is not linear");
  const std::optional<double> friction = c.friction;
  if (linear && friction.value_or(0) > 0 && c.tangential_stiffness.value_or(1) == 0)
    idle(friction, model.slip_damping && c.tangential_damping.value_or(c.damping.value_or(0)) > 0, ".friction",
         "tangential_stiffness is 0, and the tangent is not damped");
  idle(c.tangential_damping, model.slip_damping, ".tangential_damping", "model.slip_damping is false");
  idle(c.rolling_stiffness, spring, ".rolling_stiffness", "model.rolling is not spring");
  idle(c.rolling_damping, spring, ".rolling_damping", "model.rolling is not spring");
  const std::optional<double> rolling = c.rolling_friction;
  if (rolling.value_or(0) > 0)
    idle(rolling, model.rolling != Rolling::none, ".rolling_friction", "model.rolling is none");
}

template <class Has>
bool any_contact(const Scene& s, const Has& has) {
  return has(s.contact) || std::any_of(s.contact.pair.begin(), s.contact.pair.end(), has);
}

void judge_ramp(const std::string& path, double ramp, Vec2 velocity, const Scene& s, Findings& found) {
  if (ramp > 0 && velocity == Vec2{}) found.warning(path, "has no effect: the velocity is 0");
  if (ramp > s.time.end && velocity != Vec2{})
    found.warning(path, "is longer than the run: the velocity is never reached");
}

// Options of [model] for which the scene has no use.
void judge_options(const Scene& s, bool rolls, Findings& found) {
  const Model& m = s.model;
  const Model defaults;
  const bool slides = any_contact(s, [](const auto& c) { return Number(c.friction).value_or(0) > 0; });
  const bool damped = any_contact(s, [](const auto& c) {
    return c.damping_factor.value_or(0) > 0 || c.restitution.value_or(1) < 1 || c.tsuji_alpha.value_or(0) > 0 ||
           c.damping.value_or(0) > 0;
  });
  const auto idle = [&](bool given, bool used, const char* path, const char* why) {
    if (given && !used) found.warning(path, std::string("has no effect: ") + why);
  };
  constexpr const char* smooth = "nothing has friction";
  idle(m.moment_arm != defaults.moment_arm, slides, "model.moment_arm", smooth);
  idle(m.after_slip != defaults.after_slip, slides, "model.after_slip", smooth);
  idle(m.law == ForceLaw::rescaled_mindlin, slides, "model.law", smooth);
  idle(!m.slip_damping, slides && damped, "model.slip_damping", slides ? "nothing is damped" : smooth);
  idle(any_contact(s, [](const auto& c) { return c.tangential_damping.has_value(); }), slides,
       "contact.tangential_damping", smooth);
  idle(m.rolling == Rolling::spring, rolls, "model.rolling", "nothing has rolling friction");
  idle(m.pull, damped, "model.pull", "nothing is damped");
  idle(m.tight_plates.value_or(false), !s.plate.empty(), "model.tight_plates", "there is no plate");
  if (m.new_faces.value_or(false))
    idle(true, std::any_of(s.lattice.begin(), s.lattice.end(), may_tear), "model.new_faces", "no lattice can tear");
  for (std::size_t k = 0; k < s.plate.size(); ++k)
    judge_ramp(item("plate", k) + ".ramp", s.plate[k].ramp, s.plate[k].velocity, s, found);
}

// A bed settles when nothing in it is faster than settle.speed: than what a disc gains as it falls by its radius, say.
void judge_settling(const Scene& s, Findings& found) {
  double radius = 0;
  for (const Disc& d : s.disc) radius = std::max(radius, d.radius);
  for (const Packing& p : s.packing) radius = std::max(radius, p.radius_max);
  const double falling = std::sqrt(2 * s.model.gravity * radius);
  if (radius > 0 && s.settle->speed > falling)
    found.warning("settle.speed", "a disc that falls by its radius is no faster than " + rounded(falling, 3) +
                                      " m/s: what counts as settled may still fall");
}

void judge_keys(const Scene& s, Findings& found) {
  const Scene defaults;
  double discs = static_cast<double>(s.disc.size());
  for (const Packing& p : s.packing) discs += p.count;
  const auto idle = [&](bool given, bool without, const char* path, const char* why) {
    if (given && without) found.warning(path, std::string("has no effect: ") + why);
  };
  idle(s.model.disc_depth != defaults.model.disc_depth, s.model.disc_mass == DiscMass::sphere, "model.disc_depth",
       "the masses are those of spheres");
  idle(s.search.threads > 1, discs <= threaded_discs, "search.threads", "it is for beds of more than 4096 discs");
  const bool searched = s.time.solver == SolverKind::kernel;
  idle(s.search.cell_size > 0, !searched, "search.cell_size", "time.solver is reference");
  idle(s.search.skin > 0, !searched, "search.skin", "time.solver is reference");
  idle(s.search.threads > 1, !searched, "search.threads", "time.solver is reference");
  const bool rolls = any_contact(s, [](const auto& c) { return Number(c.rolling_friction).value_or(0) > 0; });
  idle(s.model.rolling_smoothing != defaults.model.rolling_smoothing, !rolls, "model.rolling_smoothing",
       "nothing has rolling friction");
  idle(s.model.rolling_smoothing != defaults.model.rolling_smoothing, rolls && s.model.rolling != Rolling::smoothed,
       "model.rolling_smoothing", "model.rolling is not smoothed");
  idle(s.output.angles, discs == 0, "output.angles", "there are no discs");
  idle(s.output.checkpoint.value_or(0) > s.time.end, true, "output.checkpoint", "it is longer than the run");
  judge_options(s, rolls, found);
  if (s.settle) judge_settling(s, found);
  judge_contact("contact", s.contact, s.model, found);
  for (std::size_t i = 0; i < s.contact.pair.size(); ++i)
    judge_contact(item("contact.pair", i), s.contact.pair[i], s.model, found);
}

void judge_materials(const Scene& s, Findings& found) {
  std::set<std::string> used;
  for (const Disc& d : s.disc) used.insert(d.material);
  for (const Packing& p : s.packing) used.insert(p.material);
  for (const Wall& w : s.wall) used.insert(w.material);
  for (const Plate& p : s.plate) used.insert(p.material);
  for (const Lattice& l : s.lattice) used.insert(l.material);
  for (std::size_t i = 0; i < s.material.size(); ++i)
    if (!used.contains(s.material[i].name)) found.warning(item("material", i), "no part is of it");
}

// Of a large lattice only the rule is known: without shear links its cells fold up.
void judge_mechanism(const std::string& path, const Lattice& l, Findings& found) {
  const double nodes = static_cast<double>(l.rows) * l.columns;
  if (nodes <= most_nodes_of_a_mechanism) {
    if (const int free = free_motions(l); free > 0)
      found.warning(path, std::to_string(free) + (free == 1 ? " of its motions meets" : " of its motions meet") +
                              " no stiffness: it folds up freely");
  } else if (!l.stem && l.structural.stiffness > 0 && l.shear.stiffness == 0) {
    found.warning(path, "without stiffness of its shear links it folds up freely");
  }
}

void judge_nodes(const std::string& path, const Lattice& l, Findings& found) {
  for (std::size_t k = 0; k < l.node.size(); ++k) {
    const NodeSetting& n = l.node[k];
    if (n.displacement == Vec2{} && n.velocity == Vec2{} && n.force == Vec2{} && !n.fixed_x && !n.fixed_y)
      found.warning(path + '.' + item("node", k), "has no effect: it changes nothing");
  }
}

void judge_links(const std::string& path, const Lattice& l, Findings& found) {
  const std::vector<LatticeLink> links = links_of(l);
  const std::vector<Held> nodes = held_nodes(l);
  const auto moves = [](const Held& node) { return !node.fixed(); };
  const auto stiff = [](const LatticeLink& link) { return link.stiffness > 0; };
  if (nodes.size() > 1 && std::any_of(nodes.begin(), nodes.end(), moves) &&
      std::none_of(links.begin(), links.end(), stiff))
    found.warning(path, "no link of it has a stiffness: its nodes do not hold each other");
  for (std::size_t k = 0; k < l.link.size(); ++k) {
    const auto chosen = [&](const LatticeLink& link) { return chooses(l.link[k], l, link); };
    const LinkSetting& s = l.link[k];
    const std::string where = path + '.' + item("link", k);
    const bool other = s.stiffness || s.damping || s.strength || s.stiffness_factor != 1 || s.strength_factor != 1;
    if (std::none_of(links.begin(), links.end(), chosen))
      found.warning(where, "has no effect: it chooses no link");
    else if (!other && !s.torn)
      found.warning(where, "has no effect: it changes nothing of the links that it chooses");
    else if (other && s.torn)
      found.warning(where, "its links are torn: their stiffness, damping and strength have no effect");
  }
}

void judge_lattice(const std::string& path, const Lattice& l, const Scene& s, Findings& found) {
  const auto acts = [](const LinkKind& k) { return k.stiffness > 0 || k.damping > 0; };
  const bool strand = l.rows == 1 || l.columns == 1;
  if (l.gravity && s.model.gravity == 0) found.warning(path + ".gravity", "has no effect: model.gravity is 0");
  if (acts(l.bending) && l.rows < 3 && l.columns < 3)
    found.warning(path + ".bending", "makes no links: there are fewer than 3 rows and fewer than 3 columns");
  else if (acts(l.bending) && strand)
    found.warning(path + ".bending",
                  "a strand of one row has no stiffness across itself: its bending links lie along it");
  if (acts(l.shear) && strand) found.warning(path + ".shear", "makes no links: there is one row or one column");
  if (acts(l.structural) && l.rows * l.columns == 1) found.warning(path + ".structural", "makes no links of one node");
  if (!strand) judge_mechanism(path, l, found);
  judge_nodes(path, l, found);
  judge_links(path, l, found);
  for (std::size_t k = 0; k < l.drive.size(); ++k)
    judge_ramp(path + '.' + item("drive", k) + ".ramp", l.drive[k].ramp, l.drive[k].velocity, s, found);
  for (const auto& [kind, k] :
       {std::pair{".structural", &l.structural}, {".shear", &l.shear}, {".bending", &l.bending}})
    if (k->stiffness == 0 && k->strength < infinity)
      found.warning(path + kind + ".strength", "has no effect: there is no spring force without stiffness");
}

}  // namespace

void judge_effects(const Scene& scene, Findings& found) {
  if (!found.sound()) return;
  judge_keys(scene, found);
  judge_materials(scene, found);
  for (std::size_t i = 0; i < scene.lattice.size(); ++i)
    judge_lattice(item("lattice", i), scene.lattice[i], scene, found);
}

}  // namespace furrow
