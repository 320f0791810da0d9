// How each key of a scene goes to LAMMPS where nothing in the scene is in the way.
#include "scene/keys.h"

#include <algorithm>

#include "export/export.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr auto exact = Fidelity::exact, to_the_step = Fidelity::to_the_step, of_furrow = Fidelity::of_furrow;

struct Usual {
  const char* keys;  // of one table: "disc: position radius"
  Fidelity fidelity;
  const char* text;
};

constexpr const char* in_law = "a number of pair_coeff and of each wall, for every pair of materials";
constexpr const char* in_links =
    "bonds: bond_style harmonic with k/2 and the length at rest; one type for each sort of link";

const Usual usual[] = {
    {"title", exact, "the first line"},
    {"model: gravity", exact, "fix gravity"},
    {"model: disc_mass", exact, "density of a sphere of the same mass; fix nve/sphere with or without disc"},
    {"model: disc_depth", exact, "in the mass"},
    {"model: moment_arm", exact, "R at walls and plates; nothing else has an arm in this scene"},
    {"model: law", exact, "hertz with mindlin, hertz with mindlin_rescale/force, or hooke with linear_history"},
    {"model: slip_damping", exact, "the third number of the tangential model"},
    {"model: after_slip", exact, "no contact slides against a tangential damper with the elastic rule"},
    {"model: rolling", exact, "no contact has rolling friction"},
    {"model: pull", exact, "with or without limit_damping"},
    {"model: tight_plates", exact, "without effect: no plate, or no faces are kept"},
    {"model: new_faces", of_furrow, "of discs that touch a lattice: there is no such scene in LAMMPS"},
    {"model: rolling_smoothing", exact, "without effect: no contact has rolling friction"},
    {"time: end step", exact, "steps of the scene's length up to the end; -var refine N divides them"},
    {"time: method", to_the_step, "velocity Verlet, the only one there"},
    {"time: relative_tolerance absolute_tolerance max_step", to_the_step, "the step is fixed: time.step"},
    {"time: locate", to_the_step, "events are seen at the ends of steps"},
    {"time: solver", of_furrow, "of the comparison alone"},
    {"search: skin cell_size threads", of_furrow, "LAMMPS searches by itself; mpirun -np N"},
    {"contact: damping_factor restitution tsuji_alpha", exact,
     "the number for which Tsuji's polynomial is sqrt(5) beta (2 beta of the linear law); from 17 Apr 2024 on "
     "coeff_restitution. Versions from 28 Mar 2023 on refuse beta >= 1, those before 17 Apr 2024 beta > 0.569"},
    {"contact: damping tangential_damping", exact, "damping velocity, and the ratio of the two"},
    {"contact: friction normal_stiffness tangential_stiffness", exact, in_law},
    {"contact: rolling_friction rolling_stiffness rolling_damping", exact,
     "without effect: nothing has rolling friction"},
    {"contact.pair: materials damping_factor restitution tsuji_alpha damping tangential_damping friction "
     "normal_stiffness tangential_stiffness",
     exact, in_law},
    {"contact.pair: rolling_friction rolling_stiffness rolling_damping", exact,
     "without effect: nothing has rolling friction"},
    {"material: name", exact, "a type"},
    {"material: density", exact, "in the masses"},
    {"material: young poisson shear rigid", exact,
     "4/3 E* and 8 G* as numbers, for every pair of types and every wall"},
    {"disc: position radius velocity spin material", exact, "data.lammps"},
    {"packing: count radius_min radius_max lower_left upper_right material seed", exact,
     "placed by furrow: data.lammps"},
    {"settle: speed hold step limit loose", exact, "settled by furrow: data.lammps"},
    {"wall: name", exact, "a comment"},
    {"wall: point normal material", exact, "fix wall/gran, of a wall that leans with a region plane"},
    {"plate: name", exact, "a comment"},
    {"plate: left_edge lower_edge width height material", exact,
     "fix wall/gran/region with a region block, as long as no centre enters it"},
    {"plate: working_depth", exact, "as furrow found it: data.lammps has the settled bed"},
    {"plate: velocity ramp", to_the_step,
     "the region moves by a variable of time; LAMMPS takes its speed from the last step"},
    {"lattice: name", exact, "a comment"},
    {"lattice: origin rows columns spacing node_mass material", exact,
     "data.lammps: a node is an atom that does not turn"},
    {"lattice: gravity", exact, "fix gravity, of these types"},
    {"lattice: fixed_rows fixed_columns", exact, "types that are not integrated and touch nothing"},
    {"lattice: damper", exact, "without effect: no link has a damper"},
    {"lattice: tear", to_the_step, "fix bond/break"},
    {"lattice: auxiliary_points", of_furrow, "of discs that touch a lattice"},
    {"lattice: contact_radius", exact, "of a wall by a sphere of this radius at a wall that stands as far back"},
    {"lattice.stem: young poisson diameter length", exact, in_links},
    {"lattice.stem: strength", to_the_step, "fix bond/break"},
    {"lattice.stem: damping_ratio", exact, "none"},
    {"lattice.structural: stiffness", exact, in_links},
    {"lattice.structural: damping", exact, "none"},
    {"lattice.structural: strength", to_the_step,
     "fix bond/break at the length at which the spring reaches it; a node loses one link a step"},
    {"lattice.shear: stiffness", exact, in_links},
    {"lattice.shear: damping", exact, "none"},
    {"lattice.shear: strength", to_the_step, "as lattice.structural.strength"},
    {"lattice.bending: stiffness", exact, in_links},
    {"lattice.bending: damping", exact, "none"},
    {"lattice.bending: strength", to_the_step, "as lattice.structural.strength"},
    {"lattice.node: row column displacement velocity", exact, "data.lammps"},
    {"lattice.node: force", exact, "fix addforce with a load of each atom"},
    {"lattice.node: fixed_x fixed_y", exact, "fix setforce"},
    {"lattice.drive: rows columns velocity ramp", exact, "fix move variable"},
    {"lattice.link: kind rows columns from to cut_from cut_to", exact, "which links"},
    {"lattice.link: stiffness stiffness_factor", exact, in_links},
    {"lattice.link: damping", exact, "none"},
    {"lattice.link: strength strength_factor", to_the_step, "as lattice.structural.strength"},
    {"lattice.link: torn", exact, "no bond"},
    {"output: interval", exact, "rows of force.1.txt"},
    {"output: frames energy angles checkpoint", of_furrow, "not in the deck"},
    {"allow: energy_made energy_lost overlap step through_lattices crossing_lattices", of_furrow,
     "LAMMPS does not watch"},
    {"allow: behind_walls through_plates", exact, "the scene promises that no centre goes there"},
};

void add(std::vector<KeyRow>& rows, const Usual& some) {
  std::istringstream words{std::string(some.keys)};
  std::string word, table;
  while (words >> word) {
    if (word.back() == ':')
      table = word.substr(0, word.size() - 1) + ".";
    else
      rows.push_back({table + word, some.fidelity, some.text});
  }
}

}  // namespace

std::string to_string(Fidelity fidelity) {
  switch (fidelity) {
    case Fidelity::exact:
      return "exact";
    case Fidelity::to_the_step:
      return "exact to the order of the step";
    case Fidelity::another_law:
      return "another law";
    case Fidelity::refused:
      return "refused";
    case Fidelity::of_furrow:
      break;
  }
  return "of furrow alone";
}

std::vector<KeyRow> usual_lammps_keys() {
  std::vector<KeyRow> rows;
  for (const Usual& some : usual) add(rows, some);
  return rows;
}

std::vector<KeyRow> lammps_keys(const Prepared& prepared) {
  std::vector<KeyRow> rows = usual_lammps_keys();
  for (const KeyRow& deviation : lammps_deviations(prepared)) {
    const auto at = std::find_if(rows.begin(), rows.end(), [&](const KeyRow& r) { return r.key == deviation.key; });
    if (at == rows.end())
      rows.push_back(deviation);
    else
      *at = deviation;
  }
  return rows;
}

void refuse_deviations(const std::vector<KeyRow>& deviations, const std::vector<std::string>& allowed) {
  std::vector<std::string> known;
  for (const SceneKey& key : scene_keys()) known.push_back(key.path);
  for (const std::string& key : allowed) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw std::invalid_argument("--allow: no key is named " + in_quotes(key) + nearest_or_all(key, known));
  }
  std::string refused;
  for (const KeyRow& row : deviations) {
    const bool possible = row.fidelity != Fidelity::refused;
    if (possible && std::find(allowed.begin(), allowed.end(), row.key) != allowed.end()) continue;
    refused += "\n  " + row.key + ": " + row.text +
               (possible ? "; --allow " + row.key + " exports it so" : "; no flag allows it");
  }
  if (!refused.empty()) throw std::invalid_argument("LAMMPS cannot run this scene as it stands:" + refused);
}

std::vector<std::string> needless(const std::vector<std::string>& allowed, const std::vector<KeyRow>& deviations) {
  std::vector<std::string> all;
  for (const std::string& key : allowed) {
    const auto is_it = [&](const KeyRow& row) { return row.key == key; };
    if (std::none_of(deviations.begin(), deviations.end(), is_it)) all.push_back(key);
  }
  return all;
}

}  // namespace furrow
