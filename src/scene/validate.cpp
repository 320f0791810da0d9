// Faults of a scene as a whole. The accepted range of each single key stands in schema.h.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "scene/findings.h"
#include "scene/lattice_parts.h"
#include "scene/read.h"
#include "scene/stem.h"
#include "scene/unit_vector.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double most_looked_at = 1e6;  // nodes: no larger lattice is held node by node

bool all_fixed(const Lattice& l) {
  const auto all_in = [](const std::vector<int>& list, int count) {
    return std::set<int>(list.begin(), list.end()).size() >= static_cast<std::size_t>(count);
  };
  if (all_in(l.fixed_rows, l.rows) || all_in(l.fixed_columns, l.columns)) return true;
  if (static_cast<double>(l.rows) * l.columns > most_looked_at) return false;
  const std::vector<Held> held = held_nodes(l);
  return std::all_of(held.begin(), held.end(), [](const Held& node) { return node.fixed(); });
}

enum Kind { disc, plate, wall, fixed_lattice, lattice };

Kind kind_of(const Disc&) { return disc; }
Kind kind_of(const Packing&) { return disc; }
Kind kind_of(const Plate&) { return plate; }
Kind kind_of(const Wall&) { return wall; }
Kind kind_of(const Lattice& l) { return all_fixed(l) ? fixed_lattice : lattice; }

// For a before b in the order of Kind: discs touch everything, plates touch lattices, walls nodes that can move.
bool can_meet(Kind a, Kind b) { return a == disc || (a == plate && b >= fixed_lattice) || (a == wall && b == lattice); }

class Validator {
 public:
  Validator(const Scene& scene, Findings& found) : scene_(scene), found_(found) {
    for (const Material& material : scene.material) materials_.push_back(material.name);
  }

  void judge() {
    check_timing();
    check_contact();
    check_all("material", scene_.material);
    check_all("disc", scene_.disc);
    check_all("packing", scene_.packing);
    check_all("plate", scene_.plate);
    check_all("wall", scene_.wall);
    check_all("lattice", scene_.lattice);
    judge_lattices(scene_, found_);
    check_motion();
  }

 private:
  void fault(const std::string& path, const std::string& message, const std::vector<std::string>& others = {}) {
    found_.error(path, message, others);
  }

  template <class T, class Action>
  static void each(std::string_view list, const std::vector<T>& items, const Action& action) {
    for (std::size_t i = 0; i < items.size(); ++i) action(item(list, i), items[i]);
  }

  // Each thing may be said once; `said` remembers where.
  template <class Key>
  void once(std::map<Key, std::string>& said, const Key& key, const std::string& path) {
    const auto [first, fresh] = said.try_emplace(key, path);
    if (!fresh) fault(path, "the same as " + first->second, {first->second});
  }

  using Number = std::optional<double>;

  void not_both(const std::string& path, const char* a, const Number& a_given, const char* b, const Number& b_given) {
    if (a_given && b_given) fault(path + '.' + b, std::string(a) + " is given too; give one of them", {path + '.' + a});
  }

  void check_timing() {
    const double step = scene_.time.step, end = scene_.time.end;
    if (step > end) fault("time.step", "longer than the whole run, whose end is " + shortest(end) + " s", {"time.end"});
    if (scene_.output.interval < step)
      fault("output.interval", "shorter than time.step, " + shortest(step) + " s", {"time.step"});
    double last = -1;
    each("output.frames", scene_.output.frames, [&](const std::string& path, double frame) {
      if (frame > end) fault(path, "after the end of the run, " + shortest(end) + " s", {"time.end"});
      if (frame <= last) fault(path, "not later than the frame before it");
      last = frame;
    });
  }

  void check_contact() {
    std::map<std::vector<std::string>, std::string> said;
    each("contact.pair", scene_.contact.pair, [&](const std::string& path, const ContactPair& pair) {
      std::vector<std::string> names = pair.materials;
      each(path + ".materials", names, [&](const std::string& one, auto& name) { check_material(one, name); });
      if (names.size() != 2) fault(path + ".materials", "must be two names, not " + std::to_string(names.size()));
      std::sort(names.begin(), names.end());
      once(said, names, path + ".materials");
    });
  }

  void check_material(const std::string& path, const std::string& name) {
    if (std::find(materials_.begin(), materials_.end(), name) != materials_.end()) return;
    std::vector<std::string> names;  // not judged if one of them could not be read
    for (std::size_t i = 0; i < materials_.size(); ++i) names.push_back(item("material", i) + ".name");
    if (names.empty()) names.emplace_back("material");
    fault(path, "no material is named " + in_quotes(name) + nearest_or_all(name, materials_), names);
  }

  // Where two rigid parts touch, nothing could deform and there would be no force.
  void check_rigid(Kind kind, const std::string& material, const std::string& path) {
    if (scene_.model.law == ForceLaw::linear) return;  // its springs are not the materials'
    const auto is_its = [&](const Material& m) { return m.rigid && m.name == material; };
    if (std::none_of(scene_.material.begin(), scene_.material.end(), is_its)) return;
    for (const auto& [other, place] : rigid_)
      if (can_meet(other.first, kind) && rigid_pairs_.insert(std::minmax(material, other.second)).second)
        fault(path,
              "rigid " + in_quotes(material) + " can meet rigid " + in_quotes(other.second) + " of " + place +
                  ", where nothing would deform",
              {place});
    rigid_.try_emplace({kind, material}, path);
  }

  template <class Part>
  void check_all(std::string_view list, const std::vector<Part>& parts) {
    std::map<std::string, std::string> said;
    each(list, parts, [&](const std::string& path, const Part& part) {
      if constexpr (requires { kind_of(part); }) {
        check_material(path + ".material", part.material);
        check_rigid(kind_of(part), part.material, path);
      }
      if constexpr (requires { part.name; })
        if (!part.name.empty()) once(said, part.name, path + ".name");
      if constexpr (requires { check(path, part); }) check(path, part);
    });
  }

  void check(const std::string& path, const Material& m) {
    if (m.name.empty()) fault(path + ".name", "must not be empty");
    if (m.rigid) {
      for (const auto& [key, given] : {std::pair{".young", m.young}, {".poisson", m.poisson}, {".shear", m.shear}})
        if (given) fault(path + key, "a rigid material has no elastic constants");
      return;
    }
    if (!m.young) fault(path, "young [Pa] is required unless rigid = true");
    if (!m.poisson && !m.shear) fault(path, "one of poisson and shear [Pa] is required unless rigid = true");
    not_both(path, "poisson", m.poisson, "shear", m.shear);
    if (!m.young || !m.shear) return;
    const double nu = *m.young / (2 * *m.shear) - 1;
    if (nu <= -1 || nu > 0.5 + 1e-15)  // E = 3 G, an incompressible material, is 0.5 but for the rounding
      fault(path + ".shear", "young / (2 shear) - 1 = " + shortest(nu) + " is outside -1 < poisson <= 0.5");
  }

  void check(const std::string& path, const Disc& disc) {
    const double x = disc.position.x, y = disc.position.y;
    once(places_, std::pair(x, y), path + ".position");
    each("wall", scene_.wall, [&](const std::string& its_path, const Wall& w) {
      if (w.normal == Vec2{} || (scene_.allow && scene_.allow->behind_walls)) return;
      const Vec2 normal = unit_vector(w.normal);
      if ((x - w.point.x) * normal.x + (y - w.point.y) * normal.y < 0)
        fault(path + ".position", "the centre is behind " + its_path, {its_path});
    });
  }

  void check(const std::string& path, const Packing& p) {
    const double side = std::min(p.upper_right.x - p.lower_left.x, p.upper_right.y - p.lower_left.y);
    if (p.radius_min > p.radius_max)
      fault(path + ".radius_min", "above radius_max, " + shortest(p.radius_max) + " m", {path + ".radius_max"});
    if (p.seed > INT64_MAX) fault(path + ".seed", "above 2^63 - 1, the largest integer of TOML");
    if (p.count > 1) check_rigid(disc, p.material, path);  // its discs meet each other
    const std::vector<std::string> hangs_on{path + ".lower_left", path + ".radius_max"};
    if (side <= 0) return fault(path + ".upper_right", "must be above lower_left and to the right of it", hangs_on);
    if (side < 2 * p.radius_max)
      fault(path + ".upper_right", "the rectangle is too small for a disc of radius_max", hangs_on);
  }

  void check(const std::string& path, const Wall& wall) {
    if (wall.normal == Vec2{}) fault(path + ".normal", "must not be zero");
  }

  void check(const std::string& path, const Plate& plate) {
    const bool deep = plate.working_depth.has_value();
    not_both(path, "lower_edge", plate.lower_edge, "working_depth", plate.working_depth);
    if (!deep && !plate.lower_edge) fault(path, "one of lower_edge [m] and working_depth [m] is required");
    if (deep && !has_discs())
      fault(path + ".working_depth", "needs a [[disc]] or [[packing]]; or give lower_edge", {"disc", "packing"});
    if (deep && !scene_.settle) fault(path + ".working_depth", "needs [settle]; or give lower_edge", {"settle"});
  }

  bool has_discs() const { return !scene_.disc.empty() || !scene_.packing.empty(); }

  void check_motion() {
    if (scene_.settle && scene_.model.gravity <= 0) fault("settle", "needs model.gravity > 0", {"model.gravity"});
    if (scene_.settle && !has_discs())
      fault("settle", "there is no [[disc]] or [[packing]] to settle", {"disc", "packing"});
    if (!has_discs() && std::all_of(scene_.lattice.begin(), scene_.lattice.end(), all_fixed))
      fault("", "nothing moves: there is no [[disc]], no [[packing]] and no [[lattice]] with a node that is not fixed");
  }

  const Scene& scene_;
  std::vector<std::string> materials_;
  std::map<std::pair<Kind, std::string>, std::string> rigid_;  // kind and rigid material -> first such part
  std::set<std::pair<std::string, std::string>> rigid_pairs_;  // reported
  std::map<std::pair<double, double>, std::string> places_;    // of discs
  Findings& found_;
};

}  // namespace

void judge_whole(const Scene& scene, Findings& found) { Validator(scene, found).judge(); }

std::vector<Finding> findings_of(const Scene& given, const Unread& unread) {
  Scene scene = given;
  fill_stems(scene);
  Findings found(unread);
  judge_ranges(scene, found);
  judge_whole(scene, found);
  judge_damping(scene, found);
  judge_sizes(scene, found);
  judge_numbers(scene, found);
  judge_start(scene, found);
  judge_effects(scene, found);
  judge_idle(scene, found);
  judge_gaps(scene, found);
  judge_cells(scene, found);
  return found.list();
}

std::vector<Problem> problems_of(const Scene& scene) {
  std::vector<Problem> problems;
  for (const Finding& f : findings_of(scene))
    if (!f.warning) problems.push_back({f.path, f.message});
  return problems;
}

std::vector<Problem> start_problems(const Scene& scene) {
  Findings found;
  judge_start(scene, found);
  std::vector<Problem> problems;
  for (const Finding& f : found.list())
    if (!f.warning) problems.push_back({f.path, f.message});
  return problems;
}

std::vector<std::string> scene_warnings(const Scene& scene) {
  std::vector<std::string> lines;
  for (const Finding& f : findings_of(scene))
    if (f.warning) lines.push_back(f.path + (f.path.empty() ? "" : ": ") + f.message);
  return lines;
}

}  // namespace furrow
