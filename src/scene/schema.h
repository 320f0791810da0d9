// Every key of a scene file, once: its name, field, unit and accepted range. The reader, the canonical writer and the
// list of keys all walk these functions, so a key cannot be known to one of them and not to another.
//
// A visitor is called as  v(key, field, unit, range)  for a key that may be left out (the struct's default holds),
// v.required(key, field, unit, range)  for one that may not, and  v.choice(key, field, {{"word", value}, ...})  for an
// enum.
#pragma once

#include "scene/scene.h"

namespace furrow {

struct Range {
  double low = -infinity;
  double high = infinity;
  bool low_open = false;  // low itself is not accepted
  bool high_open = false;
};

inline constexpr Range any{};
inline constexpr Range finite{-infinity, infinity, true, true};
inline constexpr Range positive{0, infinity, true, true};
inline constexpr Range not_negative{0, infinity, false, true};

template <class Visitor>
void describe(Visitor& v, Model& m) {
  v("gravity", m.gravity, "m/s^2", finite);
  v.choice("disc_mass", m.disc_mass, {{"disc", DiscMass::disc}, {"sphere", DiscMass::sphere}});
  v("disc_depth", m.disc_depth, "m", positive);
  v.choice("lever", m.lever, {{"overlap", Lever::overlap}, {"radius", Lever::radius}});
  v("pull", m.pull, "", any);
  v("rolling_smoothing", m.rolling_smoothing, "rad/s", positive);
}

template <class Visitor>
void describe(Visitor& v, Timing& t) {
  v.required("end", t.end, "s", positive);
  v.required("step", t.step, "s", positive);
  v("method", t.method, "", any);
  v("relative_tolerance", t.relative_tolerance, "-", positive);
  v("absolute_tolerance", t.absolute_tolerance, "m, m/s, rad/s", positive);
  v("max_step", t.max_step, "s", positive);
}

template <class Visitor>
void describe(Visitor& v, Search& s) {
  v.choice("mode", s.mode, {{"cells", SearchMode::cells}, {"brute_force", SearchMode::brute_force}});
  v("skin", s.skin, "m", not_negative);
  v("cell_size", s.cell_size, "m", not_negative);
}

template <class Visitor>
void describe(Visitor& v, Material& m) {
  v.required("name", m.name, "", any);
  v("density", m.density, "kg/m^3", positive);
  v("young", m.young, "Pa", positive);
  v("poisson", m.poisson, "-", Range{-1, 0.5, true, false});
  v("shear", m.shear, "Pa", positive);
  v("rigid", m.rigid, "", any);
}

template <class Visitor>
void describe(Visitor& v, ContactPair& p) {
  v.required("materials", p.materials, "", any);
  v("damping_factor", p.damping_factor, "-", not_negative);
  v("restitution", p.restitution, "-", Range{0, 1, true, false});
  v("friction", p.friction, "-", not_negative);
  v("rolling_friction", p.rolling_friction, "-", not_negative);
}

template <class Visitor>
void describe(Visitor& v, Contact& c) {
  v("damping_factor", c.damping_factor, "-", not_negative);
  v("restitution", c.restitution, "-", Range{0, 1, true, false});
  v("friction", c.friction, "-", not_negative);
  v("rolling_friction", c.rolling_friction, "-", not_negative);
  v("pair", c.pair, "", any);
}

template <class Visitor>
void describe(Visitor& v, Disc& d) {
  v.required("position", d.position, "m", finite);
  v.required("radius", d.radius, "m", positive);
  v("velocity", d.velocity, "m/s", finite);
  v("spin", d.spin, "rad/s", finite);
  v.required("material", d.material, "", any);
}

template <class Visitor>
void describe(Visitor& v, Packing& p) {
  v.required("count", p.count, "", Range{1, 10'000'000});
  v.required("radius_min", p.radius_min, "m", positive);
  v.required("radius_max", p.radius_max, "m", positive);
  v.required("lower_left", p.lower_left, "m", finite);
  v.required("upper_right", p.upper_right, "m", finite);
  v.required("material", p.material, "", any);
  v("seed", p.seed, "", not_negative);
}

template <class Visitor>
void describe(Visitor& v, Settle& s) {
  v("speed", s.speed, "m/s", positive);
  v("hold", s.hold, "s", not_negative);
  v("step", s.step, "s", positive);
  v("limit", s.limit, "s", positive);
}

template <class Visitor>
void describe(Visitor& v, Wall& w) {
  v("name", w.name, "", any);
  v.required("point", w.point, "m", finite);
  v.required("normal", w.normal, "-", finite);
  v.required("material", w.material, "", any);
}

template <class Visitor>
void describe(Visitor& v, Plate& p) {
  v("name", p.name, "", any);
  v.required("left_edge", p.left_edge, "m", finite);
  v("lower_edge", p.lower_edge, "m", finite);
  v("working_depth", p.working_depth, "m", finite);
  v.required("width", p.width, "m", positive);
  v.required("height", p.height, "m", positive);
  v.required("velocity", p.velocity, "m/s", finite);
  v.required("material", p.material, "", any);
}

template <class Visitor>
void describe(Visitor& v, LinkKind& k) {
  v.required("stiffness", k.stiffness, "N/m", not_negative);
  v.required("damping", k.damping, "N s/m", not_negative);
  v("strength", k.strength, "N", Range{0, infinity, true, false});
}

template <class Visitor>
void describe(Visitor& v, NodeSetting& n) {
  v.required("row", n.row, "", Range{0, 1'000'000});
  v.required("column", n.column, "", Range{0, 1'000'000});
  v("displacement", n.displacement, "m", finite);
  v("velocity", n.velocity, "m/s", finite);
  v("force", n.force, "N", finite);
}

template <class Visitor>
void describe(Visitor& v, Lattice& l) {
  v("name", l.name, "", any);
  v.required("origin", l.origin, "m", finite);
  v.required("rows", l.rows, "", Range{1, 100'000});
  v.required("columns", l.columns, "", Range{1, 100'000});
  v.required("spacing", l.spacing, "m", positive);
  v.required("node_mass", l.node_mass, "kg", positive);
  v.required("material", l.material, "", any);
  v("gravity", l.gravity, "", any);
  v("fixed_rows", l.fixed_rows, "", not_negative);
  v("fixed_columns", l.fixed_columns, "", not_negative);
  v.choice("damper", l.damper, {{"axial", Damper::axial}, {"full", Damper::full}});
  v.choice("tear", l.tear, {{"tension", TearRule::tension}, {"magnitude", TearRule::magnitude}});
  v("auxiliary_points", l.auxiliary_points, "", Range{0, 1000});
  v("contact_radius", l.contact_radius, "m", positive);
  v("structural", l.structural, "", any);
  v("shear", l.shear, "", any);
  v("bending", l.bending, "", any);
  v("node", l.node, "", any);
}

template <class Visitor>
void describe(Visitor& v, Output& o) {
  v("interval", o.interval, "s", positive);
  v("frames", o.frames, "s", not_negative);
  v("energy", o.energy, "", any);
}

template <class Visitor>
void describe(Visitor& v, Scene& s) {
  v.required("title", s.title, "", any);
  v("model", s.model, "", any);
  v.required("time", s.time, "", any);
  v("search", s.search, "", any);
  v("contact", s.contact, "", any);
  v("material", s.material, "", any);
  v("disc", s.disc, "", any);
  v("packing", s.packing, "", any);
  v("settle", s.settle, "", any);
  v("wall", s.wall, "", any);
  v("plate", s.plate, "", any);
  v("lattice", s.lattice, "", any);
  v("output", s.output, "", any);
}

}  // namespace furrow
