// A scene as the input of another engine, and what that engine's output says beside furrow's own run.
//
//   in.lammps    the deck: lmp -in in.lammps, also under mpirun; -var refine 10 takes steps of a tenth
//   data.lammps  the bodies at t = 0, settled, and the links
//   scene.toml   the same start as a scene of furrow, with which the comparison runs
//   keys.md      of every key of scenes how it went into the deck
//   export.json  what deviates, and the hashes of the other files
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "run/prepare.h"
#include "scene/scene.h"

namespace furrow {

enum class Fidelity { exact, to_the_step, another_law, refused, of_furrow };
std::string to_string(Fidelity fidelity);  // "exact", "exact to the order of the step", ...

struct KeyRow {
  std::string key;
  Fidelity fidelity = Fidelity::exact;
  std::string text;
};

// One row for each key of scenes, in the order of the schema: how LAMMPS gets it in this scene.
std::vector<KeyRow> lammps_keys(const Prepared& prepared);

// As it is where nothing in the scene is in the way.
std::vector<KeyRow> usual_lammps_keys();

// Where this scene cannot be exported exactly: keys with another law, or refused.
std::vector<KeyRow> lammps_deviations(const Prepared& prepared);

// Throws std::invalid_argument that names each deviation that is not in `allowed`, why, and the flag; and of an allowed
// key that is none.
void refuse_deviations(const std::vector<KeyRow>& deviations, const std::vector<std::string>& allowed);

// Allowed keys that do not deviate in this scene: nothing is exported otherwise for them.
std::vector<std::string> needless(const std::vector<std::string>& allowed, const std::vector<KeyRow>& deviations);

// The same start as a scene: settled, every disc listed, nodes where they are. Tangential springs are not in it.
Scene started_scene(const Prepared& prepared);

struct LammpsDeck {
  std::string input, data;
};
LammpsDeck lammps_deck(const Prepared& prepared);

// What a deck writes, by its step over that of the scene.
std::string forces_file(int refine);  // "force.10.txt": step, then Fx and Fy on each plate and each wall
std::string ends_file(int refine);    // "end.10.txt": id x y vx vy at the end
std::string links_file(int refine);   // "links.10.txt": pairs of nodes whose links are intact, row by row
std::string tears_file(int refine);   // "torn.10.txt": step, number of torn links

// What stands in such a name; 0: it is none of them.
constexpr int most_refine = 1'000'000;
int refine_of(const std::string& name);

// The first line of the outputs that have one: of which deck they are.
inline std::string output_title(const std::string& scene_hash) { return "# furrow export, scene " + scene_hash; }

}  // namespace furrow
