// A scene's parts as arrays, one array a field: what never changes while the scene runs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "physics/contact.h"
#include "physics/geometry.h"
#include "scene/scene.h"

namespace furrow {

std::string to_string(LinkClass kind);

// In the order of storage, see system/place.h.
struct DiscArrays {
  std::vector<int> number;                            // in the scene
  std::vector<double> x, y, vx, vy, spin;             // m, m/s, rad/s at t = 0
  std::vector<double> radius, mass, inertia, volume;  // m, kg, kg m^2, m^3
  std::vector<int> material;
  int count() const { return static_cast<int>(radius.size()); }
};

// Nodes of all lattices, one after the other, row by row.
struct NodeArrays {
  std::vector<double> x, y, vx, vy;             // m, m/s at t = 0; fixed nodes stay there
  std::vector<double> mass, gravity;            // kg; m/s^2, 0 for lattices without gravity
  std::vector<double> load_x, load_y;           // N
  std::vector<double> contact_radius, spacing;  // m
  std::vector<int> body;                        // index among the moving bodies, -1 if fixed or driven
  std::vector<int> drive;                       // index into Parts::drive, -1 if not driven
  std::vector<int> material, lattice, row, column;
  int count() const { return static_cast<int>(x.size()); }
};

struct LinkArrays {
  std::vector<int> a, b;                                   // nodes, a < b
  std::vector<double> rest, stiffness, damping, strength;  // m, N/m, N s/m, N
  std::vector<LinkClass> kind;
  std::vector<char> axial, in_magnitude;  // damper and tear rule
  Damper damper(int link) const { return axial[link] != 0 ? Damper::axial : Damper::full; }
  TearRule tear_rule(int link) const { return in_magnitude[link] != 0 ? TearRule::magnitude : TearRule::tension; }
  std::vector<int> notched;  // torn from the start, ascending
  int count() const { return static_cast<int>(a.size()); }
};

// The border of the lattices: segments between neighbouring border nodes. A lattice of one row or column is its own
// border.
struct BorderArrays {
  std::vector<int> a, b;  // nodes
  std::vector<int> link;  // structural link along the segment, -1 if there is none
  std::vector<int> lattice;
  // Where torn lattices have new faces also the segments that may come, and what opens them, see system/border.h:
  using Four = std::array<int, 4>;
  std::vector<Four> cell{};  // of a segment: what lies beside it, cells; -1: nothing
  std::vector<Four> side{};  // of a cell: links along its sides; -1: none
  int count() const { return static_cast<int>(a.size()); }
};

struct WallPart {
  double px, py;  // m, a point of it
  double nx, ny;  // unit normal, towards the discs
  int material;
  std::string name{};
};

struct PlatePart {
  double left, lower, width, height;  // m, at t = 0
  double vx, vy;                      // m/s
  double ramp;                        // s, in which it reaches them
  int material;
  std::string name{};
  // Where plates are tight, see system/held_faces.h:
  Rectangle goes_on{};       // m, how far behind each of its edges
  std::vector<int> flush{};  // plates
  double flush_within = 0;   // m
};

struct DrivePart {
  double vx, vy;  // m/s
  double ramp;    // s
  int lattice;
};

struct LatticePart {
  int auxiliary_points;
  int material;
  std::string name;
};

struct Parts {
  DiscArrays disc;
  NodeArrays node;
  LinkArrays link;
  BorderArrays border;
  std::vector<WallPart> wall;
  std::vector<PlatePart> plate;
  std::vector<LatticePart> lattice;
  std::vector<DrivePart> drive;
  std::vector<int> driven;      // nodes, ascending
  std::vector<ContactLaw> law;  // materials x materials
  int materials = 0;
  int free_nodes = 0;
  std::vector<int> held_x, held_y;  // bodies that keep their x, their y: nodes on rollers

  double gravity = 0;  // m/s^2, positive down
  // -, moment arm = radius - shortening * overlap, between discs and on what is flat
  double pair_arm_shortening = 0.5, flat_arm_shortening = 1;
  double rolling_smoothing = 0;  // rad/s
  bool friction = false;         // of some contact, sliding or rolling: discs spin and contacts hold a spring
  bool rolling = false;          // friction of some contact
  bool rolling_spring = false;   // of some contact: two numbers a slot
  bool options = false;          // of some law: see physics/options.h
  bool keeps_ledger = false;
  bool keeps_angles = false;
  bool tight_plates = false;  // bodies keep the face of a plate that they met, see system/held_faces.h
  bool flush_plates = false;  // some are tight and flush
  bool new_faces = false;     // torn lattices have them, see system/border.h
  double margin = 0;          // m: a contact holds a slot for its spring while its gap is below this, see discrete.h

  int bodies() const { return disc.count() + free_nodes; }
  int law_of(int material_a, int material_b) const { return material_a * materials + material_b; }
  std::string body_name(
      int body) const;  // with the scene's number: "disc 12", "node (row 3, column 1) of lattice stem"
  std::string node_name(int node) const;
  std::string link_name(int link) const;
};

// Of each pair of materials, at Parts::law_of.
std::vector<ContactLaw> laws_of(const Scene& scene);

// The scene's packings must have been placed (its `disc` lists all discs) and its plates have a lower edge.
Parts make_parts(const Scene& scene);

}  // namespace furrow
