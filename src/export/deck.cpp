// The deck for LAMMPS: the bodies at t = 0, and what acts on them.
#include <algorithm>
#include <cmath>
#include <map>

#include "export/data_file.h"
#include "export/deck_run.h"
#include "export/deck_text.h"
#include "export/export.h"
#include "export/lammps_law.h"
#include "scene/hash.h"
#include "scene/read.h"
#include "scene/wording.h"

namespace furrow {
namespace {

class Deck : DeckText {
 public:
  explicit Deck(const Prepared& prepared)
      : prepared_(prepared), scene_(prepared.scene), parts_(prepared.system.parts()) {
    kinds_ = atom_kinds(parts_);
  }

  LammpsDeck write() {
    head();
    interactions();
    motion();
    outside();
    output();
    return {input_, data_file(prepared_, kinds_)};
  }

 private:
  bool net() const { return parts_.disc.count() == 0; }

  void head() {
    input_ += "# " + one_line(scene_.title) + "\n";
    input_ += "# Written by furrow export; keys.md says how each key of the scene went in. Run by\n";
    input_ += "#   lmp -in in.lammps                    or   mpirun -np 2 lmp -in in.lammps\n";
    input_ += "#   lmp -in in.lammps -var refine 10     steps of a tenth; then furrow export --compare here\n";
    say({"units si"});
    say({"dimension 2"});
    say({"processors * * 1"});
    say({"boundary m m p"});  // grows with what leaves it, and is never less than data.lammps has
    say({"newton off"});
    say({"atom_style", net() ? "hybrid sphere bond" : "sphere"});
    say({"comm_modify vel yes"});
    say({"variable refine index 1"});
    say({"variable h equal", shortest(scene_.time.step) + "/v_refine"});
    if (loaded()) say({"fix loads all property/atom d_load_x d_load_y"});
    if (net()) say({"bond_style", kinds_.bond.empty() ? "zero" : "harmonic"}), say({"special_bonds lj/coul 1 1 1"});
    say({"read_data data.lammps", loaded() ? "fix loads NULL Loads" : ""});
    say({"neighbor", shortest(0.4 * least_radius()), "bin"});
    say({"neigh_modify delay 0 every 1 check yes"});
    say({"timestep ${h}"});
    for (std::size_t k = 0; k < kinds_.kind.size(); ++k) say({"group", group(k), "type", std::to_string(k + 1)});
  }

  double least_radius() const {
    double least = infinity;
    for (const AtomKind& kind : kinds_.kind) least = std::min(least, kind.radius);
    if (net()) return least;
    return *std::min_element(parts_.disc.radius.begin(), parts_.disc.radius.end());
  }

  bool loaded() const { return has_loads(parts_); }

  // ---- laws ----

  // Of the pseudo-force against rolling: as stiff as a contact whose overlap is half a hundredth of R.
  RollingWords rolling(const ContactLaw& law) const {
    if (!(law.rolling > 0) || net()) return {};
    const double radius = least_radius();
    const double stiffness =
        law.options.force == ForceLaw::linear ? law.options.normal_stiffness : 0.1 * law.modulus * radius;
    return {stiffness, 0};
  }

  // Sets the variable `name` to the words of the law, by the version of LAMMPS.
  void law(const std::string& name, int index, double ratio) {
    const ContactLaw& all = parts_.law[static_cast<std::size_t>(index)];
    const LammpsLaw words = lammps_law(all, ratio, rolling(all));
    say({"variable", name, "string '" + words.tsuji + "'"});
    if (words.restitution && *words.restitution != words.tsuji)
      say({"if \"${release} >= 20240417\" then \"variable", name, "string '" + *words.restitution + "'\""});
    if (words.number >= 0) return;
    const std::string until = words.restitution ? " && ${release} < 20240417" : "";
    say({"if \"${release} >= 20230328" + until +
         "\" then \"print 'This version of LAMMPS cannot damp so much'\" \"quit 1\""});
  }

  bool meets(int law) const {
    const ContactLaw& l = parts_.law[static_cast<std::size_t>(law)];
    return l.options.force == ForceLaw::linear || std::isfinite(l.modulus);
  }

  void interactions() {
    say({"variable release equal version"});
    if (net()) return bonds();
    say({"pair_style granular"});
    for (std::size_t i = 0; i < kinds_.kind.size(); ++i) {
      for (std::size_t j = i; j < kinds_.kind.size(); ++j) pair(i, j);
    }
  }

  void pair(std::size_t i, std::size_t j) {
    const std::string types = std::to_string(i + 1) + " " + std::to_string(j + 1);
    const std::string name = "law_" + std::to_string(i + 1) + "_" + std::to_string(j + 1);
    const int index = parts_.law_of(kinds_.kind[i].material, kinds_.kind[j].material);
    if (!meets(index)) {
      input_ += "# Two that are rigid; they never meet.\n";
      return say({"pair_coeff", types, "hooke 0 0 tangential linear_nohistory 0 0 damping velocity"});
    }
    law(name, index, 1);
    say({"pair_coeff", types, "${" + name + "}"});
  }

  void bonds() {
    double longest = 0;
    const auto all = kinds_.bond;
    for (std::size_t k = 0; k < all.size(); ++k) {
      longest = std::max(longest, all[k].length);
      say({"bond_coeff", std::to_string(k + 1), words(all[k].stiffness / 2, all[k].length)});
    }
    if (all.empty()) say({"bond_coeff", "*", "1"});  // of bond_style zero: a length, without a force
    for (const std::size_t k : tearing())
      say({"fix tear" + std::to_string(k + 1), "all bond/break 1", std::to_string(k + 1),
           shortest(all[k].length + all[k].strength / all[k].stiffness)});
    say({"comm_modify cutoff", shortest(std::max(20 * longest, 10 * least_radius()))});
  }

  std::vector<std::size_t> tearing() const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < kinds_.bond.size(); ++k) {
      if (can_tear(kinds_.bond[k])) found.push_back(k);
    }
    return found;
  }

  // ---- motion ----

  void motion() {
    if (net()) {
      if (!together("free", [](const AtomKind& k) { return k.free; }).empty()) say({"fix move free nve"});
      for (std::size_t d = 0; d < parts_.drive.size(); ++d) drive(d);
    } else {
      say({"fix move all nve/sphere", scene_.model.disc_mass == DiscMass::disc ? "disc" : ""});
    }
    if (parts_.gravity == 0) return;
    const std::string heavy = together("heavy", [](const AtomKind& k) { return k.heavy && k.free; });
    if (!heavy.empty()) say({"fix weight", heavy, "gravity", shortest(parts_.gravity), "vector 0 -1 0"});
  }

  void drive(std::size_t d) {
    const std::string name = "drive" + std::to_string(d);
    const DrivePart& part = parts_.drive[d];
    if (together(name, [&](const AtomKind& k) { return k.drive == static_cast<int>(d); }).empty()) return;
    moving(name + "_x", part.vx, part.ramp);
    moving(name + "_y", part.vy, part.ramp);
    say({"fix", name, name, "move variable", "v_" + name + "_x", "v_" + name + "_y", "NULL", "v_" + name + "_x_speed",
         "v_" + name + "_y_speed", "NULL"});
  }

  // ---- walls, plates, loads ----

  void outside() {
    for (std::size_t w = 0; w < parts_.wall.size(); ++w) {
      input_ += "# wall " + one_line(scene_.wall[w].name) + "\n";
      for (std::size_t k = 0; k < kinds_.kind.size(); ++k) wall(w, k);
    }
    for (std::size_t p = 0; p < parts_.plate.size(); ++p) {
      input_ += "# plate " + one_line(scene_.plate[p].name) + "\n";
      const std::string name = "plate" + std::to_string(p);
      moving(name + "_x", parts_.plate[p].vx, parts_.plate[p].ramp);
      moving(name + "_y", parts_.plate[p].vy, parts_.plate[p].ramp);
      for (std::size_t k = 0; k < kinds_.kind.size(); ++k) plate(p, k);
    }
    if (loaded()) {
      for (const std::string axis : {"x", "y"})
        say({"compute load_" + axis, "all property/atom d_load_" + axis}),
            say({"variable load_" + axis, "atom c_load_" + axis});
      say({"fix load free addforce v_load_x v_load_y 0"});
    }
    if (!together("held_x", [](const AtomKind& k) { return k.held_x; }).empty())
      say({"fix hold_x held_x setforce 0 NULL NULL"});
    if (!together("held_y", [](const AtomKind& k) { return k.held_y; }).empty())
      say({"fix hold_y held_y setforce NULL 0 NULL"});
    say({"fix flat all enforce2d"});
  }

  // A fix of atoms of one kind against one flat part, and the sum of the forces of the part's fixes.
  void flat(const std::string& part, std::size_t k, int material, const std::string& place) {
    const AtomKind& kind = kinds_.kind[k];
    const int index = parts_.law_of(kind.material, material);
    if (!kind.free || !meets(index)) return;
    const std::string name = part + "_" + std::to_string(k + 1);
    law("law_" + name, index, kind.contact_radius > 0 ? kind.contact_radius / kind.radius : 1);
    const bool region = place.starts_with("region");
    say({"fix", name, group(k), region ? "wall/gran/region" : "wall/gran", "granular ${law_" + name + "}", place,
         "contacts"});
    say({"compute", name, group(k), "reduce sum f_" + name + "[2] f_" + name + "[3]"});
    touched_[part].push_back(name);
  }

  // For nodes, whose radius stands for a point, walls and plates stand back by it.
  static double back(const AtomKind& kind) { return kind.contact_radius > 0 ? kind.radius : 0; }

  void wall(std::size_t w, std::size_t k) {
    const WallPart& wall = parts_.wall[w];
    const double by = back(kinds_.kind[k]);
    const double x = wall.px - by * wall.nx, y = wall.py - by * wall.ny;
    const std::string part = "wall" + std::to_string(w);
    if (std::fabs(wall.nx) == 1) return flat(part, k, wall.material, "xplane " + side(x, wall.nx));
    if (std::fabs(wall.ny) == 1) return flat(part, k, wall.material, "yplane " + side(y, wall.ny));
    const std::string region = part + "_" + std::to_string(k + 1) + "_region";
    say({"region", region, "plane", words(x, y), "0", words(wall.nx, wall.ny), "0"});
    flat(part, k, wall.material, "region " + region);
  }

  static std::string side(double place, double normal) {
    return normal > 0 ? shortest(place) + " NULL" : "NULL " + shortest(place);
  }

  void plate(std::size_t p, std::size_t k) {
    const PlatePart& plate = parts_.plate[p];
    const double by = back(kinds_.kind[k]);
    const std::string part = "plate" + std::to_string(p), region = part + "_" + std::to_string(k + 1) + "_region";
    say({"region", region, "block", words(plate.left + by, plate.left + plate.width - by),
         words(plate.lower + by, plate.lower + plate.height - by),
         "EDGE EDGE side out move v_" + part + "_x v_" + part + "_y NULL"});
    flat(part, k, plate.material, "region " + region);
  }

  // ---- output ----

  std::string sum_of(const std::string& part, int axis) const {
    const auto at = touched_.find(part);
    if (at == touched_.end()) return "0";
    std::string sum;
    for (const std::string& name : at->second) sum += "-c_" + name + "[" + std::to_string(axis) + "]";
    return sum;
  }

  void output() {
    const DeckRun run = deck_run(prepared_);
    const std::string title = "title1 \"" + output_title(hexadecimal(scene_hash(started_scene(prepared_)))) + "\"";
    std::string columns, names;
    for (const auto& [word, count] : {std::pair{"plate", parts_.plate.size()}, {"wall", parts_.wall.size()}}) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::string part = word + std::to_string(i);
        for (const int axis : {1, 2}) {
          const std::string name = part + (axis == 1 ? "_Fx" : "_Fy");
          say({"variable", name, "equal", sum_of(part, axis)});
          columns += " v_" + name;
          names += " " + name;
        }
      }
    }
    say({"variable every equal", std::to_string(run.every) + "*v_refine"});
    say({"variable steps equal", std::to_string(run.steps) + "*v_refine"});
    if (!columns.empty())
      say({"fix forces all ave/time ${every} 1 ${every}" + columns,
           "mode scalar format \" %.17g\" " + title + " title2 \"# step" + names + "\" file force.${refine}.txt"});
    torn(title);
    if (!kinds_.bonds.empty()) {
      say({"compute links all property/local batom1 batom2"});
      say({"dump links all local ${every} links.${refine}.txt index c_links[1] c_links[2]"});
      say({"dump_modify links format float %.0f"});
    }
    say({"thermo_modify lost error norm no"});
    say({"thermo ${every}"});
    say({"run ${steps}"});
    say({"write_dump all custom end.${refine}.txt id x y vx vy modify sort id format float %.17g"});
  }

  void torn(const std::string& title) {
    std::string sum;
    for (const std::size_t k : tearing()) sum += (sum.empty() ? "f_tear" : "+f_tear") + std::to_string(k + 1) + "[2]";
    if (sum.empty()) return;
    say({"variable torn equal", sum});
    say({"fix torn all ave/time ${refine} 1 ${refine} v_torn mode scalar", title, "file torn.${refine}.txt"});
  }

  const Prepared& prepared_;
  const Scene& scene_;
  const Parts& parts_;
  std::map<std::string, std::vector<std::string>> touched_;
};

}  // namespace

LammpsDeck lammps_deck(const Prepared& prepared) { return Deck(prepared).write(); }

}  // namespace furrow
