// Every key of a scene file, once: its name, field, unit and accepted range. The reader, the canonical writer and the
// list of keys all walk these functions, so a key cannot be known to one of them and not to another.
//
// A visitor is called as  v(key, field, unit, range)  for a key that may be left out (the struct's default holds),
// v.required(key, field, unit, range)  for one that may not, both without unit and range where any value will do, and
// v.choice(key, field, {{"word", value}, ...})  for an enum.
#pragma once

#include "scene/range.h"
#include "scene/scene.h"

namespace furrow {

inline constexpr Range finite{-infinity, infinity, true, true};
inline constexpr Range positive{0, infinity, true, true};
inline constexpr Range not_negative{0, infinity, false, true};

void describe(auto& v, Model& m) {
  v("gravity", m.gravity, "m/s^2", finite);
  v.choice("disc_mass", m.disc_mass, {{"disc", DiscMass::disc}, {"sphere", DiscMass::sphere}});
  v("disc_depth", m.disc_depth, "m", positive);
  v.choice("lever", m.lever, {{"overlap", Lever::overlap}, {"radius", Lever::radius}});
  v("pull", m.pull);
  v("rolling_smoothing", m.rolling_smoothing, "rad/s", positive);
}

void describe(auto& v, Timing& t) {
  v.required("end", t.end, "s", positive);
  v.required("step", t.step, "s", positive);
  v("method", t.method);
  v("relative_tolerance", t.relative_tolerance, "-", Range{1e-14, 0.1});  // below it round-off is all that is left
  v("absolute_tolerance", t.absolute_tolerance, "m, m/s, rad/s", Range{1e-18, 1});
  v("max_step", t.max_step, "s", positive);
  v.choice("locate", t.locate, {{"none", Locate::none}, {"tears", Locate::tears}, {"all", Locate::all}});
  v.choice("solver", t.solver, {{"kernel", SolverKind::kernel}, {"reference", SolverKind::reference}});
}

void describe(auto& v, Search& s) {
  v("skin", s.skin, "m", not_negative);
  v("cell_size", s.cell_size, "m", not_negative);
  v("threads", s.threads, "", Range{1, 64});
}

void describe(auto& v, Material& m) {
  v.required("name", m.name);
  v("density", m.density, "kg/m^3", positive);
  v("young", m.young, "Pa", positive);
  v("poisson", m.poisson, "-", Range{-1, 0.5, true, false});
  v("shear", m.shear, "Pa", positive);
  v("rigid", m.rigid);
}

// What a pair of materials may say for itself, and [contact] for all others.
void describe_coefficients(auto& v, auto& c) {
  v("damping_factor", c.damping_factor, "-", not_negative);
  v("restitution", c.restitution, "-", Range{0, 1, true, false});
  v("friction", c.friction, "-", not_negative);
  v("rolling_friction", c.rolling_friction, "-", not_negative);
}

void describe(auto& v, ContactPair& p) {
  v.required("materials", p.materials);
  describe_coefficients(v, p);
}

void describe(auto& v, ContactParameters& c) {
  describe_coefficients(v, c);
  v("pair", c.pair);
}

void describe(auto& v, Disc& d) {
  v.required("position", d.position, "m", finite);
  v.required("radius", d.radius, "m", positive);
  v("velocity", d.velocity, "m/s", finite);
  v("spin", d.spin, "rad/s", finite);
  v.required("material", d.material);
}

void describe(auto& v, Packing& p) {
  v.required("count", p.count, "", Range{1, 10'000'000});
  v.required("radius_min", p.radius_min, "m", positive);
  v.required("radius_max", p.radius_max, "m", positive);
  v.required("lower_left", p.lower_left, "m", finite);
  v.required("upper_right", p.upper_right, "m", finite);
  v.required("material", p.material);
  v("seed", p.seed, "", not_negative);
}

void describe(auto& v, Settle& s) {
  v("speed", s.speed, "m/s", positive);
  v("hold", s.hold, "s", not_negative);
  v("step", s.step, "s", positive);
  v("limit", s.limit, "s", positive);
  v("loose", s.loose, "-", Range{0, 1, false, true});
}

void describe(auto& v, Wall& w) {
  v("name", w.name);
  v.required("point", w.point, "m", finite);
  v.required("normal", w.normal, "-", finite);
  v.required("material", w.material);
}

void describe(auto& v, Plate& p) {
  v("name", p.name);
  v.required("left_edge", p.left_edge, "m", finite);
  v("lower_edge", p.lower_edge, "m", finite);
  v("working_depth", p.working_depth, "m", finite);
  v.required("width", p.width, "m", positive);
  v.required("height", p.height, "m", positive);
  v.required("velocity", p.velocity, "m/s", finite);
  v.required("material", p.material);
}

void describe(auto& v, LinkKind& k) {
  v.required("stiffness", k.stiffness, "N/m", not_negative);
  v.required("damping", k.damping, "N s/m", not_negative);
  v("strength", k.strength, "N", Range{0, infinity, true, false});
}

void describe(auto& v, NodeSetting& n) {
  v.required("row", n.row, "", Range{0, 1'000'000});
  v.required("column", n.column, "", Range{0, 1'000'000});
  v("displacement", n.displacement, "m", finite);
  v("velocity", n.velocity, "m/s", finite);
  v("force", n.force, "N", finite);
}

void describe(auto& v, Lattice& l) {
  v("name", l.name);
  v.required("origin", l.origin, "m", finite);
  v.required("rows", l.rows, "", Range{1, 100'000});
  v.required("columns", l.columns, "", Range{1, 100'000});
  v.required("spacing", l.spacing, "m", positive);
  v.required("node_mass", l.node_mass, "kg", positive);
  v.required("material", l.material);
  v("gravity", l.gravity);
  v("fixed_rows", l.fixed_rows, "", not_negative);
  v("fixed_columns", l.fixed_columns, "", not_negative);
  v.choice("damper", l.damper, {{"axial", Damper::axial}, {"full", Damper::full}});
  v.choice("tear", l.tear, {{"tension", TearRule::tension}, {"magnitude", TearRule::magnitude}});
  v("auxiliary_points", l.auxiliary_points, "", Range{0, 1000});
  v("contact_radius", l.contact_radius, "m", positive);
  v("structural", l.structural);
  v("shear", l.shear);
  v("bending", l.bending);
  v("node", l.node);
}

void describe(auto& v, Output& o) {
  v("interval", o.interval, "s", positive);
  v("frames", o.frames, "s", not_negative);
  v("energy", o.energy);
  v("checkpoint", o.checkpoint, "s", positive);
}

void describe(auto& v, Allow& a) {
  v("energy_made", a.energy_made, "-", positive);
  v("energy_lost", a.energy_lost, "-", positive);
  v("overlap", a.overlap, "-", positive);
  v("step", a.step, "-", positive);
  v("behind_walls", a.behind_walls);
  v("through_plates", a.through_plates);
  v("through_lattices", a.through_lattices);
}

void describe(auto& v, Scene& s) {
  v.required("title", s.title);
  v("model", s.model);
  v.required("time", s.time);
  v("search", s.search);
  v("contact", s.contact);
  v("material", s.material);
  v("disc", s.disc);
  v("packing", s.packing);
  v("settle", s.settle);
  v("wall", s.wall);
  v("plate", s.plate);
  v("lattice", s.lattice);
  v("output", s.output);
  v("allow", s.allow);
}

}  // namespace furrow
