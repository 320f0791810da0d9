// A scene as plain data. The fields here are the keys of a scene file; schema.h says what each means, with its range.
// SI units; x to the right, y up, gravity along -y.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/constants.h"
#include "physics/link.h"
#include "physics/options.h"
#include "physics/vec2.h"

namespace furrow {

enum class DiscMass { disc, sphere };  // m = rho pi R^2 b, I = m R^2 / 2;  m = 4/3 pi rho R^3, I = 2/5 m R^2
// Of the contact force: to the contact point, half the overlap short of the surface, or the whole radius.
enum class MomentArm { contact_point, half_overlap, radius };
// The fast solver, or the one made to be read: the same bits, at least ten times slower, and more so in larger beds.
enum class SolverKind { kernel, reference };
// Events at which a step ends early: none (as in the paper: links tear at the end of a step), tears, or also touches
// and slips, for scenes with few of them. See events.h.
enum class Locate { none, tears, all };

struct Model {
  double gravity = 9.81;  // m/s^2
  DiscMass disc_mass = DiscMass::disc;
  double disc_depth = 1;  // m, b in the disc reading of the mass
  MomentArm moment_arm = MomentArm::contact_point;
  ForceLaw law = ForceLaw::hertz_mindlin;
  bool slip_damping = true;  // the tangential force is damped too
  AfterSlip after_slip = AfterSlip::elastic;
  Rolling rolling = Rolling::smoothed;
  bool pull = false;                   // a contact's viscous force may exceed the elastic one and pull
  std::optional<bool> tight_plates{};  // bodies keep the face of a plate that they met; left out: no
  std::optional<bool> new_faces{};     // a torn lattice has new ones; left out: no
  double rolling_smoothing = 1;  // rad/s, w0 in w / sqrt(w^2 + w0^2); 1e-2 would be too stiff for the paper's step
};

struct Timing {
  double end = 1;      // s
  double step = 1e-4;  // s; for a controlled method the first step it tries
  std::string method = "pece";
  double relative_tolerance = 1e-6;
  double absolute_tolerance = 1e-9;  // m, m/s, rad/s
  double max_step = 1e-3;            // s, for controlled methods
  Locate locate = Locate::none;
  SolverKind solver = SolverKind::kernel;
};

struct Search {
  double skin = 0;       // m, added to the reach of the neighbour list; 0: chosen from the radii
  double cell_size = 0;  // m; 0: the reach of the neighbour list
  int threads = 1;       // in one step, for beds of more than discs_per_block discs
};

// Young's modulus and one of Poisson's ratio and shear modulus. A rigid material does not deform at all.
struct Material {
  std::string name{};
  double density = 1000;            // kg/m^3, used for discs
  std::optional<double> young{};    // Pa
  std::optional<double> poisson{};  // -
  std::optional<double> shear{};    // Pa
  bool rigid = false;
};

// Contact parameters of one pair of materials; what is not given is taken from the scene's [contact].
struct ContactPair {
  std::vector<std::string> materials{};          // the two names; may be equal
  std::optional<double> damping_factor{};        // beta, -
  std::optional<double> restitution{};           // -, another way to give beta
  std::optional<double> tsuji_alpha{};           // -, a third
  std::optional<double> damping{};               // N s/m, in place of beta
  std::optional<double> tangential_damping{};    // N s/m; left out: `damping`
  std::optional<double> friction{};              // mu, -
  std::optional<double> rolling_friction{};      // mu_r, -
  std::optional<double> normal_stiffness{};      // N/m, of the linear law
  std::optional<double> tangential_stiffness{};  // N/m, of the linear law
  std::optional<double> rolling_stiffness{};     // N m, of a rolling spring
  std::optional<double> rolling_damping{};       // -, of a rolling spring
};

// Of critical damping, eta_r of a rolling spring that says nothing else.
inline constexpr double default_rolling_damping = 0.3;

struct ContactParameters {
  std::optional<double> damping_factor{};        // beta, -
  std::optional<double> restitution{};           // -
  std::optional<double> tsuji_alpha{};           // -, the coefficient of Tsuji's damping, sqrt(5) beta
  std::optional<double> damping{};               // N s/m
  std::optional<double> tangential_damping{};    // N s/m
  double friction = 0;                           // mu, -
  double rolling_friction = 0;                   // mu_r, -
  std::optional<double> normal_stiffness{};      // N/m
  std::optional<double> tangential_stiffness{};  // N/m
  std::optional<double> rolling_stiffness{};     // N m
  std::optional<double> rolling_damping{};       // -
  std::vector<ContactPair> pair{};
};

struct Disc {
  Vec2 position{};       // m
  double radius = 0.01;  // m
  Vec2 velocity{};       // m/s
  double spin = 0;       // rad/s, counter-clockwise
  std::string material{};
};

// Discs put at random, without overlap, into a rectangle. Radii are uniform between radius_min and radius_max.
struct Packing {
  int count = 1;
  double radius_min = 0.01;  // m
  double radius_max = 0.01;  // m
  Vec2 lower_left{};         // m
  Vec2 upper_right{};        // m
  std::string material{};
  std::uint64_t seed = 1;
};

// Before t = 0 the scene runs with plates at rest and links that do not tear, until nothing moves.
struct Settle {
  double speed = 5e-3;           // m/s: settled when for a time `hold` no disc and no node is faster
  double hold = 0.5;             // s
  std::optional<double> step{};  // s; left out: time.step
  double limit = 20;             // s: it is an error if the scene has not settled by then
  // Share of discs and nodes that may be faster: of very many some always are. Left out: none.
  std::optional<double> loose{};
};

// A half-plane that discs and nodes stay out of: the line through `point`; `normal` points to where they are.
struct Wall {
  std::string name{};
  Vec2 point{};       // m
  Vec2 normal{0, 1};  // any length but zero
  std::string material{};
};

// A rigid rectangle with prescribed motion. Its height is given by `lower_edge`, or by `working_depth` below the
// surface of the settled discs.
struct Plate {
  std::string name{};
  double left_edge = 0;                   // m, at t = 0
  std::optional<double> lower_edge{};     // m, at t = 0
  std::optional<double> working_depth{};  // m
  double width = 0.01;                    // m
  double height = 0.1;                    // m
  Vec2 velocity{};                        // m/s
  double ramp = 0;                        // s, in which it reaches its velocity
  std::string material{};
};

struct LinkKind {
  double stiffness = 0;        // N/m; no links of a kind whose stiffness and damping are zero
  double damping = 0;          // N s/m
  double strength = infinity;  // N
};

enum class LinkClass { structural, shear, bending };
enum class LinkChoice { any, structural, shear, bending };

// What is different about some links of a lattice: those that meet everything that is said here.
struct LinkSetting {
  LinkChoice kind = LinkChoice::any;
  std::vector<int> rows{}, columns{};            // that both ends lie in; none: any
  std::vector<int> from{}, to{};                 // row and column of the two ends of one link
  std::optional<Vec2> cut_from{}, cut_to{};      // m, from the node of row 0 and column 0: links that this line cuts
  std::optional<double> stiffness{}, damping{};  // N/m, N s/m
  std::optional<double> strength{};              // N
  double stiffness_factor = 1;                   // -
  double strength_factor = 1;                    // -
  bool torn = false;                             // from the start
};

// A straight round rod, upright, of whose density the material is. Spacing, rows, masses and links of the lattice
// follow from it: see stem.h.
struct Stem {
  double young = 1e9;          // Pa
  double poisson = 0.3;        // -
  double diameter = 0.01;      // m
  double length = 0.1;         // m
  double strength = infinity;  // Pa, in tension
  double damping_ratio = 0;    // -, of its first bending motion, held at one end
};

// What is special about one node of a lattice.
struct NodeSetting {
  int row = 0;
  int column = 0;
  Vec2 displacement{};  // m, from its place in the grid, at t = 0
  Vec2 velocity{};      // m/s, at t = 0
  Vec2 force{};         // N, constant load
  bool fixed_x = false;
  bool fixed_y = false;
};

// Nodes that move as they are told: a lattice with some is a tool that bends.
struct Drive {
  std::vector<int> rows{}, columns{};  // of the lattice; all nodes of each
  Vec2 velocity{};                     // m/s
  double ramp = 0;                     // s, in which it is reached from rest
};

// Rows by columns of point masses; row 0 is the lowest, column 0 the leftmost.
struct Lattice {
  std::string name{};
  Vec2 origin{};  // m, node of row 0 and column 0
  std::optional<Stem> stem{};
  int rows = 1;
  int columns = 1;
  double spacing = 0.01;  // m
  double node_mass = 1;   // kg
  std::string material{};
  bool gravity = false;  // whether its nodes have weight
  std::vector<int> fixed_rows{};
  std::vector<int> fixed_columns{};
  Damper damper = Damper::axial;
  TearRule tear = TearRule::tension;
  int auxiliary_points = 9;      // on each border segment; 0: the exact nearest point
  double contact_radius = 0.01;  // m, R* of a node against a plate or wall
  LinkKind structural{};
  LinkKind shear{};
  LinkKind bending{};
  std::vector<NodeSetting> node{};
  std::vector<LinkSetting> link{};
  std::vector<Drive> drive{};
};

struct Output {
  double interval = 1e-3;              // s, between rows of plate_force.csv, energy.csv and their like
  std::vector<double> frames{};        // s, times of the pictures
  bool energy = true;                  // keep the energy ledger
  bool angles = false;                 // keep how far each disc has turned, for the frames
  std::optional<double> checkpoint{};  // s, between checkpoints; left out: only at the start and at the end
};

// What this scene is known to do beyond the validity of its laws: it then neither warns nor ends the run. See
// validity.h.
struct Allow {
  std::optional<double> energy_made{};      // -, of the energy that the scene was given
  std::optional<double> energy_lost{};      // -, the same
  std::optional<double> overlap{};          // -, of the smaller radius
  std::optional<double> step{};             // -, times the largest stable step
  bool behind_walls = false;                // centres of discs behind a wall
  bool through_plates = false;              // centres that cross the middle of a plate
  bool through_lattices = false;            // centres that cross the border of a lattice
  std::optional<bool> crossing_lattices{};  // that cross each other or themselves, cells inside out
};

struct Scene {
  std::string title{};
  Model model{};
  Timing time{};
  Search search{};
  ContactParameters contact{};
  std::vector<Material> material{};
  std::vector<Disc> disc{};
  std::vector<Packing> packing{};
  std::optional<Settle> settle{};
  std::optional<Allow> allow{};
  std::vector<Wall> wall{};
  std::vector<Plate> plate{};
  std::vector<Lattice> lattice{};
  Output output{};
};

}  // namespace furrow
