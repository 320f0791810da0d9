// Scenes at random, with every option of the model, for properties that hold of all scenes. RapidCheck shrinks them.
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "scene/scene.h"

namespace furrow::test {

inline double part(int of_thousand) { return 1e-3 * of_thousand; }

// All of them alike from the first scene on: by itself RapidCheck begins with the least.
inline int up_to(int most) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, most + 1)); }

inline bool either() { return *rc::gen::arbitrary<bool>(); }

struct Thrown {
  int x, y, radius, vx, vy, spin, hard;
};

inline void showValue(const Thrown& t, std::ostream& out) {
  out << "x " << t.x << " y " << t.y << " radius " << t.radius << " vx " << t.vx << " vy " << t.vy << " spin " << t.spin
      << (t.hard != 0 ? " hard" : " soft");
}

inline std::vector<Thrown> some_discs() {
  const auto any = rc::gen::inRange(0, 1001);
  const auto both = rc::gen::inRange(-1000, 1001);
  return *rc::gen::container<std::vector<Thrown>>(
      rc::gen::map(rc::gen::tuple(any, any, any, both, both, both, rc::gen::inRange(0, 2)),
                   [](const auto& t) { return std::apply([](auto... each) { return Thrown{each...}; }, t); }));
}

inline std::vector<Material> materials() {
  Material soft, hard;
  soft.name = "soft";
  soft.young = 1e5;
  soft.poisson = 0.25;
  hard.name = "hard";
  hard.young = 4e5;
  hard.shear = 4e5;
  hard.density = 2300;
  return {soft, hard};
}

// What the kernel does not run in vectors: half of the scenes have none of it.
inline void add_law_options(Scene& s) {
  s.model.law = *rc::gen::element(ForceLaw::hertz_mindlin, ForceLaw::rescaled_mindlin, ForceLaw::linear);
  s.model.after_slip = either() ? AfterSlip::less_viscous : AfterSlip::elastic;
  s.model.rolling = *rc::gen::element(Rolling::none, Rolling::smoothed, Rolling::spring);
  s.contact.normal_stiffness = 100.0 * (1 + up_to(1000));
  s.contact.tangential_stiffness = 50.0 * (1 + up_to(1000));
  if (either()) s.contact.rolling_stiffness = part(1 + up_to(999));
  if (either()) s.contact.rolling_damping = part(up_to(1000));
  if (either()) {
    s.contact.damping_factor = s.contact.restitution = {};
    s.contact.damping = part(up_to(3000));
    if (either()) s.contact.tangential_damping = part(up_to(3000));
  }
  for (ContactPair& pair : s.contact.pair) {
    pair.tangential_stiffness = 40.0 * (1 + up_to(1000));
    if (either()) pair.rolling_stiffness = part(1 + up_to(999));
  }
}

inline void add_options(Scene& s) {
  s.model.gravity = either() ? 9.81 : 0;
  if (either()) s.model.disc_depth = 0.1 + part(up_to(2000));
  if (either()) s.model.rolling_smoothing = 0.01 * (1 + up_to(1000));
  s.model.disc_mass = either() ? DiscMass::sphere : DiscMass::disc;
  s.model.moment_arm = *rc::gen::element(MomentArm::contact_point, MomentArm::half_overlap, MomentArm::radius);
  s.model.pull = either();
  s.model.tight_plates = either();
  s.model.new_faces = either();
  s.model.slip_damping = either();
  (either() ? s.contact.damping_factor : s.contact.restitution) = part(1 + up_to(999));
  s.contact.friction = either() ? part(up_to(1000)) : 0;
  s.contact.rolling_friction = either() ? part(up_to(1000)) : 0;
  if (either()) {
    s.contact.pair = {{.materials = {"soft", "hard"},
                       .restitution = 0.5,
                       .friction = part(up_to(900)),
                       .rolling_friction = part(up_to(900))}};
  }
  if (either()) add_law_options(s);
  s.output.energy = either();
  s.output.angles = either();
  s.search.threads = 1 + up_to(3);  // one works unless the bed is large
  s.search.skin = either() ? 1e-5 * up_to(1000) : 0;
  s.search.cell_size = either() ? 1e-4 * (1 + up_to(1000)) : 0;
}

inline void add_walls(Scene& s) {
  const std::vector<Wall> box{
      {"", {0, 0}, {0, 1}, "hard"}, {"", {0, 0}, {1, 0.1}, "soft"}, {"", {0.2, 0}, {-1, 0}, "hard"}};
  for (const Wall& w : box) {
    if (either()) s.wall.push_back(w);
  }
}

inline void add_plates(Scene& s) {
  for (int k = up_to(2); k > 0; --k) {
    Plate p;
    p.name = "plate " + std::to_string(k);
    p.left_edge = 0.2 * part(up_to(1000));
    p.lower_edge = 0.2 * part(up_to(1000));
    p.width = either() ? 0.01 : 0.001;  // so thin that discs are pressed through
    p.height = 0.06;
    p.velocity = {part(up_to(1000)), part(up_to(200))};
    if (either()) p.velocity = {part(up_to(1000)), 0}, p.lower_edge = 0;  // on the floor, if there is one
    p.ramp = either() ? 1e-4 * up_to(60) : 0;
    p.material = "hard";
    s.plate.push_back(p);
    if (either()) continue;
    Plate flush = p;  // beside or on top of it
    flush.name += " flush";
    (either() ? flush.left_edge : *flush.lower_edge) += either() ? p.width : p.height;
    s.plate.push_back(flush);
  }
}

// Rollers, notches, weak regions, driven rows, and soft stems in the place of what the keys say.
inline void add_lattice_options(Lattice& l) {
  for (NodeSetting& n : l.node) n.fixed_x = either(), n.fixed_y = either();
  if (either()) l.link.push_back({.rows = {0, 1}, .stiffness_factor = 0.5, .strength_factor = 0.1});
  if (either()) l.link.push_back({.cut_from = Vec2{-0.01, 0.031}, .cut_to = Vec2{0.025, 0.031}, .torn = true});
  if (either()) l.contact_radius = 0.002 + part(up_to(20));
  if (either()) l.drive = {{.rows = {l.rows - 1}, .velocity = {0.5, 0.1 * up_to(3)}, .ramp = either() ? 2e-3 : 0}};
  if (l.drive.empty() && either()) l.fixed_columns = {up_to(l.columns - 1)};
  if (!either()) return;
  l.columns = 3;
  l.fixed_columns.clear();
  l.stem = Stem{1e4, 0.3, 0.04, 0.08 + part(up_to(20)), 50.0 * up_to(9), part(up_to(9))};  // five rows or six
  for (NodeSetting& n : l.node) n.row = std::min(n.row, 4);
}

inline void add_lattices(Scene& s) {
  for (int k = up_to(2); k > 0; --k) {
    Lattice l;
    l.name = "lattice " + std::to_string(k);
    l.origin = {0.05 + 0.09 * k, 0.02};
    l.rows = 1 + up_to(5);
    l.columns = 1 + up_to(5);
    l.spacing = 0.02;
    l.node_mass = 0.2;
    l.material = either() ? "soft" : "hard";
    l.gravity = either();
    if (either()) l.fixed_rows = {0};
    l.damper = either() ? Damper::full : Damper::axial;
    l.tear = either() ? TearRule::magnitude : TearRule::tension;
    l.auxiliary_points = either() ? 9 : 0;
    // Weak ones tear where they start, several links of a node at once.
    const double strength = either() ? 0.5 + 0.2 * up_to(30) : infinity;
    if (up_to(3) > 0) l.structural = {2000, 1, strength};
    if (either()) l.shear = {2000, 0, strength};
    if (either()) l.bending = {500, 1, strength};
    const Vec2 off{1e-3 * (up_to(8) - 4), 1e-3 * (up_to(8) - 4)};
    if (either()) l.node = {{l.rows - 1, 0, off, {0.1 * up_to(9), 0}, {1.0 * up_to(5), 0}}};
    if (either()) add_lattice_options(l);
    s.lattice.push_back(l);
  }
}

// Of walls and plates alone: of two rigid parts neither would give way.
inline void use_rigid_material(Scene& s) {
  Material rigid;
  rigid.name = "rigid";
  rigid.rigid = true;
  s.material.push_back(rigid);
  for (Wall& w : s.wall) w.material = either() ? "rigid" : w.material;
  for (Plate& p : s.plate) p.material = either() ? "rigid" : p.material;
}

inline Scene some_scene() {
  Scene s;
  s.material = materials();
  add_options(s);
  add_walls(s);
  add_plates(s);
  add_lattices(s);
  if (either()) use_rigid_material(s);
  for (const Thrown& t : some_discs()) {
    s.disc.push_back({{0.2 * part(t.x), 0.2 * part(t.y)},
                      0.005 + 0.015 * part(t.radius),
                      {part(t.vx), part(t.vy)},
                      0.01 * t.spin,
                      t.hard != 0 ? "hard" : "soft"});
  }
  RC_PRE(!s.disc.empty() || !s.lattice.empty());
  return s;
}

}  // namespace furrow::test
