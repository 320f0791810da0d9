// The keys of the parts of a scene: materials, contacts, discs, walls, plates, lattices. How it is read: schema.h.
#pragma once

#include "scene/key.h"
#include "scene/scene.h"

namespace furrow {

void describe(auto& v, Material& m) {
  v.required("name", m.name, plain("\"soil\"", "By which the parts refer to it."));
  v("density", m.density, {"kg/m^3", positive, "1600.0", "Used for discs and stems."});
  v("young", m.young, {"Pa", positive, "2e5", "Young's modulus. Required unless the material is rigid."});
  v("poisson", m.poisson,
    {"-", Range{-1, 0.5, true, false}, "0.3", "Poisson's ratio. Give this or shear, unless the material is rigid."});
  v("shear", m.shear, {"Pa", positive, "7.7e4", "Shear modulus. Give this or poisson, unless the material is rigid."});
  v("rigid", m.rigid,
    plain("true", "It does not deform and has no elastic constants. Two rigid parts must not be able to meet."));
}

// What [contact] says for all materials, and a pair for itself.
void describe_coefficients(auto& v, auto& c, bool of_pair) {
  const auto text = [&](std::string_view all, std::string_view pair) { return of_pair ? pair : all; };
  v("damping_factor", c.damping_factor,
    {"-", not_negative, "0.3",
     text("beta of the viscous force. Give this, restitution, tsuji_alpha or damping. Left out, all four: no damping.",
          "beta of the viscous force. Give this, restitution, tsuji_alpha or damping. Left out, all four: as in "
          "[contact].")});
  v("restitution", c.restitution,
    {"-", Range{0, 1, true, false}, "0.8",
     "Speed after an impact, of the speed before, where the contact may pull; beta follows from it."});
  v("tsuji_alpha", c.tsuji_alpha,
    {"-", not_negative, "0.7",
     "alpha of the viscous force as Tsuji, Tanaka and Ishida (1992) write it: beta = alpha / sqrt(5)."});
  v("damping", c.damping, {"N s/m", not_negative, "20.0", "Of a dashpot, the same at any overlap, in place of beta."});
  v("tangential_damping", c.tangential_damping,
    {"N s/m", not_negative, "10.0", "The same along the tangent. Left out: that of damping."});
  v("friction", c.friction,
    {"-", not_negative, "0.5",
     text("mu of sliding: the tangential force is at most mu times the normal one.",
          "mu of sliding. Left out: that of [contact].")});
  v("rolling_friction", c.rolling_friction,
    {"-", not_negative, "0.1",
     text("mu_r of rolling: the moment is at most mu_r R* times the normal force.",
          "mu_r of rolling. Left out: that of [contact].")});
  v("normal_stiffness", c.normal_stiffness, {"N/m", positive, "1e5", "kn, where model.law is linear."});
  v("tangential_stiffness", c.tangential_stiffness,
    {"N/m", not_negative, "3e4", "kt, where model.law is linear; required if there is friction."});
  v("rolling_stiffness", c.rolling_stiffness,
    {"N m", positive, "0.5",
     "kr, where model.rolling is spring. Left out: 3 Sn mu_r^2 R*^2 of the normal stiffness Sn, as in Ai et al."});
  v("rolling_damping", c.rolling_damping,
    {"-", not_negative, "0.5", "eta_r, of critical damping, where model.rolling is spring. Left out: 0.3."});
}

void describe(auto& v, ContactPair& p) {
  v.required("materials", p.materials, plain("[\"soil\", \"steel\"]", "The two names; they may be equal."));
  describe_coefficients(v, p, true);
}

void describe(auto& v, ContactParameters& c) {
  describe_coefficients(v, c, false);
  v("pair", c.pair, table("What is different between two materials."));
}

void describe(auto& v, Disc& d) {
  v.required("position", d.position, {"m", finite, "[0.0, 0.5]", "Its centre at the start."});
  v.required("radius", d.radius, {"m", positive, "0.01", "Its radius."});
  v("velocity", d.velocity, {"m/s", finite, "[0.0, -1.0]", "At the start."});
  v("spin", d.spin, {"rad/s", finite, "2.0", "At the start, counter-clockwise."});
  v.required("material", d.material, plain("\"soil\"", "Name of its material."));
}

void describe(auto& v, Packing& p) {
  v.required("count", p.count, {"", Range{1, 10'000'000}, "20", "Number of discs."});
  v.required("radius_min", p.radius_min, {"m", positive, "0.01", "Smallest radius."});
  v.required("radius_max", p.radius_max, {"m", positive, "0.012", "Largest radius."});
  v.required("lower_left", p.lower_left, {"m", finite, "[2.0, 0.1]", "Corner of the rectangle."});
  v.required("upper_right", p.upper_right, {"m", finite, "[2.5, 0.4]", "Corner of the rectangle."});
  v.required("material", p.material, plain("\"soil\"", "Name of their material."));
  v("seed", p.seed, {"", not_negative, "7", "The same seed gives the same discs."});
}

void describe(auto& v, Wall& w) {
  v("name", w.name, plain("\"floor\"", "By which messages name it."));
  v.required("point", w.point, {"m", finite, "[0.0, 0.0]", "A point of its surface."});
  v.required("normal", w.normal,
             {"-", finite, "[0.0, 1.0]", "Out of the wall, to the free side; of any length but 0."});
  v.required("material", w.material, plain("\"steel\"", "Name of its material."));
}

void describe(auto& v, Plate& p) {
  v("name", p.name, plain("\"tool\"", "By which files and messages name it. Left out: its index."));
  v.required("left_edge", p.left_edge, {"m", finite, "3.0", "x of its left edge at t = 0."});
  v("lower_edge", p.lower_edge, {"m", finite, "0.2", "y of its lower edge at t = 0. Give this or working_depth."});
  v("working_depth", p.working_depth,
    {"m", finite, "0.05", "Depth of its lower edge below the surface of the settled discs. Give this or lower_edge."});
  v.required("width", p.width, {"m", positive, "0.01", "Along x."});
  v.required("height", p.height, {"m", positive, "0.1", "Along y."});
  v.required("velocity", p.velocity, {"m/s", finite, "[0.1, 0.0]", "Constant from t = 0 on, or from the end of ramp."});
  v("ramp", p.ramp, {"s", not_negative, "0.05", "Time in which it reaches its velocity, from rest, at a steady rate."});
  v.required("material", p.material, plain("\"steel\"", "Name of its material."));
}

void describe(auto& v, LinkKind& k) {
  v.required("stiffness", k.stiffness,
             {"N/m", not_negative, "1e4", "Of the spring. Where it and the damping are 0 there are no such links."});
  v.required("damping", k.damping, {"N s/m", not_negative, "50.0", "Of the damper."});
  v("strength", k.strength, {"N", Range{0, infinity, true, false}, "40.0", "Spring force above which the link tears."});
}

void describe(auto& v, LinkSetting& l) {
  v.choice("kind", l.kind,
           {{"any", LinkChoice::any, "of every kind"},
            {"structural", LinkChoice::structural, "between neighbours"},
            {"shear", LinkChoice::shear, "across the cells"},
            {"bending", LinkChoice::bending, "to the next but one"}},
           "Of which links it is said.");
  v("rows", l.rows, {"", not_negative, "[2, 3]", "Links whose two ends lie in these rows. Left out: any."});
  v("columns", l.columns, {"", not_negative, "[0]", "Links whose two ends lie in these columns. Left out: any."});
  v("from", l.from, {"", not_negative, "[2, 0]", "The link from this node, row and column, to the node `to`."});
  v("to", l.to, {"", not_negative, "[3, 0]", "See from."});
  v("cut_from", l.cut_from,
    {"m", finite, "[-0.005, 0.035]",
     "Links that the straight line from here to cut_to cuts; measured from the node of row 0 and column 0."});
  v("cut_to", l.cut_to, {"m", finite, "[0.015, 0.035]", "See cut_from."});
  v("stiffness", l.stiffness, {"N/m", not_negative, "5e3", "Left out: that of their kind."});
  v("damping", l.damping, {"N s/m", not_negative, "10.0", "Left out: that of their kind."});
  v("strength", l.strength, {"N", Range{0, infinity, true, false}, "20.0", "Left out: that of their kind."});
  v("stiffness_factor", l.stiffness_factor, {"-", not_negative, "0.5", "By which the stiffness is multiplied."});
  v("strength_factor", l.strength_factor,
    {"-", Range{0, infinity, true, false}, "0.5", "By which the strength is multiplied."});
  v("torn", l.torn,
    plain("true", "Whether they are torn from the start, as a notch is. What an earlier setting has torn stays torn."));
}

void describe(auto& v, Stem& s) {
  v.required("young", s.young, {"Pa", positive, "5e8", "Young's modulus of the rod."});
  v.required("poisson", s.poisson,
             {"-", Range{0.05, 0.5}, "0.3", "Poisson's ratio of the rod. Below 0.05 its cross springs are too stiff."});
  v.required("diameter", s.diameter,
             {"m", positive, "0.006", "The columns of the lattice are as far from edge to edge."});
  v.required("length", s.length,
             {"m", positive, "0.12", "From the lowest row to the highest; at least two diameters."});
  v("strength", s.strength,
    {"Pa", Range{0, infinity, true, false}, "2e7", "Tensile stress at which it tears. Left out: it does not."});
  v("damping_ratio", s.damping_ratio,
    {"-", not_negative, "0.02",
     "Of its first bending motion when it is held at one end. The dampers of the links follow from it, and faster "
     "motions are damped more."});
}

void describe(auto& v, NodeSetting& n) {
  v.required("row", n.row, {"", Range{0, 1'000'000}, "1", "Row of the node, from 0, the lowest."});
  v.required("column", n.column, {"", Range{0, 1'000'000}, "1", "Column of the node, from 0, the leftmost."});
  v("displacement", n.displacement, {"m", finite, "[0.001, 0.0]", "From its place in the grid, at t = 0."});
  v("velocity", n.velocity, {"m/s", finite, "[0.0, 0.1]", "At t = 0."});
  v("force", n.force, {"N", finite, "[0.0, -2.0]", "Constant load."});
  v("fixed_x", n.fixed_x, plain("true", "Whether it keeps its x: a roller, free along y."));
  v("fixed_y", n.fixed_y, plain("true", "Whether it keeps its y: a roller, free along x."));
}

void describe(auto& v, Drive& d) {
  v("rows", d.rows, {"", not_negative, "[3]", "Rows whose nodes are driven, fixed columns or not."});
  v("columns", d.columns, {"", not_negative, "[2]", "Columns whose nodes are driven, fixed rows or not."});
  v.required("velocity", d.velocity, {"m/s", finite, "[0.1, 0.0]", "Of these nodes, whatever acts on them."});
  v("ramp", d.ramp,
    {"s", not_negative, "0.1", "Time in which they reach it from rest, at a constant acceleration. 0: at once."});
}

void describe(auto& v, Lattice& l) {
  v("name", l.name, plain("\"root\"", "By which files and messages name it. Left out: its index."));
  v.required("origin", l.origin, {"m", finite, "[4.0, 0.1]", "Node of row 0 and column 0."});
  v("stem", l.stem,
    table("A round rod, upright, given by what one measures. rows, spacing, node_mass, structural, shear and bending "
          "follow from it and are left out; columns is 3, 4 or 5."));
  if (l.stem)
    for (const char* key : {"rows", "spacing", "node_mass", "structural", "shear", "bending"}) v.follows(key, "stem");
  else
    v.required("rows", l.rows, {"", Range{1, 100'000}, "4", "Number of rows."});
  v.required("columns", l.columns, {"", Range{1, 100'000}, "3", "Number of columns."});
  if (!l.stem) {
    v.required("spacing", l.spacing, {"m", positive, "0.01", "Between neighbours in a row and in a column."});
    v.required("node_mass", l.node_mass, {"kg", positive, "0.02", "Of each node."});
  }
  v.required("material", l.material, plain("\"soil\"", "Name of the material of its contacts."));
  v("gravity", l.gravity, plain("true", "Whether its nodes have weight."));
  v("fixed_rows", l.fixed_rows, {"", not_negative, "[0]", "Rows whose nodes do not move."});
  v("fixed_columns", l.fixed_columns, {"", not_negative, "[0]", "Columns whose nodes do not move."});
  v.choice("damper", l.damper,
           {{"axial", Damper::axial, "along the link"}, {"full", Damper::full, "on the whole relative velocity"}},
           "How the damper of a link acts.");
  v.choice(
      "tear", l.tear,
      {{"tension", TearRule::tension, "tension alone"}, {"magnitude", TearRule::magnitude, "tension and compression"}},
      "What of the spring force is compared with the strength.");
  v("auxiliary_points", l.auxiliary_points,
    {"", Range{0, 1000}, "4",
     "Points on each border segment, from which the one nearest to a disc is taken. 0: the exact nearest point."});
  v("contact_radius", l.contact_radius, {"m", positive, "0.005", "R* of a node against a plate or a wall."});
  if (!l.stem) {
    v("structural", l.structural, table("Links between neighbours in a row or a column."));
    v("shear", l.shear, table("Links across the cells."));
    v("bending", l.bending, table("Links to the next but one in a row or a column."));
  }
  v("node", l.node, table("What is different about one node."));
  v("drive", l.drive, table("Rows and columns that move with a given velocity: a tool that bends. Give either."));
  v("link", l.link, table("What is different about some links. Of two that choose one link the later holds."));
}

}  // namespace furrow
