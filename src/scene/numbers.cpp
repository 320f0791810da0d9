// What is derived from a scene's numbers must be finite, positive and resolved: squares and quotients of numbers that
// are sound by themselves may over- and underflow.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "physics/contact.h"
#include "physics/disc.h"
#include "scene/findings.h"
#include "scene/lattice_parts.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double resolution = 1e-12;  // a place is known to a thousandth of a length if it is at most 1e12 of them away

bool sound(double derived) { return derived >= std::numeric_limits<double>::min() && std::isfinite(derived); }

class NumberJudge {
 public:
  NumberJudge(const Scene& scene, Findings& found) : scene_(scene), found_(found) {
    for (const Material& m : scene.material) material_.try_emplace(m.name, &m);
  }

  void judge() {
    judge_model();
    each("material", scene_.material);
    each("disc", scene_.disc);
    each("packing", scene_.packing);
    each("wall", scene_.wall);
    each("plate", scene_.plate);
    each("lattice", scene_.lattice);
  }

 private:
  template <class T>
  void each(const char* list, const std::vector<T>& items) {
    for (index_ = 0; index_ < items.size(); ++index_) {
      list_ = list;
      judge(items[index_]);
    }
  }

  // The path is made only where something is wrong.
  std::string at(const char* key) const { return item(list_, index_) + (*key ? "." : "") + key; }

  // Of keys out of their own ranges that is said, not what would follow from them.
  bool known(std::initializer_list<const char*> keys) const {
    return found_.all_known() ||
           std::all_of(keys.begin(), keys.end(), [&](const char* key) { return found_.known(at(key)); });
  }

  void positive(const char* key, const char* what, double derived) {
    if (!sound(derived)) found_.error(at(key), wrong(what, derived));
  }
  void finite(const char* key, const char* what, double derived) {
    if (!std::isfinite(derived)) found_.error(at(key), wrong(what, derived));
  }
  static std::string wrong(const std::string& what, double derived) {
    return what + " = " + shortest(derived) + ", which cannot be computed with";
  }

  void resolved(const char* key, Vec2 place, double length, const std::vector<std::string>& others = {}) {
    const double farthest = std::fmax(std::fabs(place.x), std::fabs(place.y));
    if (!(farthest * resolution <= length))
      found_.error(at(key),
                   "so far out that a length of " + shortest(length) + " m is not resolved; at most " +
                       shortest(1 / resolution) + " times that length",
                   others);
  }

  void judge_model() {
    const double smoothing = scene_.model.rolling_smoothing;
    if (!sound(smoothing * smoothing))
      found_.error("model.rolling_smoothing", wrong("its square", smoothing * smoothing));
    if (!std::isfinite(scene_.model.gravity * scene_.time.end))
      found_.error("model.gravity", wrong("the speed after a fall until time.end", INFINITY), {"time.end"});
    judge_damping("contact", scene_.contact);
    for (std::size_t i = 0; i < scene_.contact.pair.size(); ++i)
      judge_damping(item("contact.pair", i), scene_.contact.pair[i]);
    if (!std::isfinite(scene_.search.skin * scene_.search.skin))
      found_.error("search.skin", wrong("its square", INFINITY));
  }

  void judge_damping(const std::string& path, const auto& given) {
    for (const auto& [key, factor] : {std::pair{".damping_factor", given.damping_factor},
                                      {".tsuji_alpha", given.tsuji_alpha},
                                      {".damping", given.damping},
                                      {".tangential_damping", given.tangential_damping},
                                      {".normal_stiffness", given.normal_stiffness},
                                      {".tangential_stiffness", given.tangential_stiffness},
                                      {".rolling_friction", std::optional<double>(given.rolling_friction)},
                                      {".rolling_stiffness", given.rolling_stiffness},
                                      {".rolling_damping", given.rolling_damping}})
      if (factor && !std::isfinite(4 * *factor * *factor)) found_.error(path + key, wrong("its square", INFINITY));
  }

  static Elastic elastic_of(const Material& m) {
    if (m.rigid) return {.rigid = true};
    return {.young = *m.young, .poisson = m.poisson ? *m.poisson : *m.young / (2 * *m.shear) - 1};
  }

  // Whether its constants are given and allowed; if not, that is reported elsewhere.
  static bool complete(const Material& m) {
    if (m.rigid) return true;
    if (!m.young || (!m.poisson && !m.shear)) return false;
    const double nu = elastic_of(m).poisson;
    return nu > -1 && nu <= 0.5 + 1e-15;
  }

  // Its law with the materials before it and with itself, for the dampings that the scene gives.
  void judge(const Material& m) {
    if (!complete(m)) return;
    for (std::size_t j = 0; j <= index_; ++j) {
      const Material& other = scene_.material[j];
      if (!complete(other) || (m.rigid && other.rigid)) continue;
      const ContactLaw law = contact_law(elastic_of(m), elastic_of(other), 0, 0, 0);
      if (sound(law.modulus) && sound(law.shear_modulus) && sound(law.shear_ratio)) continue;
      found_.error(at(""), "in contact with " + in_quotes(other.name) + ": E* = " + shortest(law.modulus) +
                               " Pa, G* = " + shortest(law.shear_modulus) + " Pa, which cannot be computed with");
    }
  }

  void judge_disc(const char* key, double radius, const std::string& material, double speed2, double spin) {
    const auto found = material_.find(material);
    if (found == material_.end()) return;
    const Material& m = *found->second;
    if (!known({key}) || !known_density(m) || !found_.known("model.disc_depth")) return;
    const bool flat = scene_.model.disc_mass == DiscMass::disc;
    const double volume = flat ? disc_volume(radius, scene_.model.disc_depth) : sphere_volume(radius);
    const double mass = m.density * volume;
    const double inertia = flat ? disc_inertia(mass, radius) : sphere_inertia(mass, radius);
    if (!sound(mass)) return positive(key, "mass [kg]", mass);
    if (!sound(inertia)) return positive(key, "moment of inertia [kg m^2]", inertia);
    finite(key, "1 / mass", 1 / mass);
    finite(key, "1 / moment of inertia", 1 / inertia);
    finite("velocity", "kinetic energy [J]", 0.5 * mass * speed2);
    finite("spin", "energy of the spin [J]", 0.5 * inertia * spin * spin);
    if (m.rigid || !complete(m)) return;
    const double modulus = contact_law(elastic_of(m), elastic_of(m), 0, 0, 0).modulus;
    if (sound(modulus)) positive(key, "E* R^2 [N]", modulus * radius * radius);
  }

  bool known_density(const Material& m) const {
    return found_.all_known() ||
           found_.known(item("material", static_cast<std::size_t>(&m - scene_.material.data())) + ".density");
  }

  void judge(const Disc& d) {
    judge_disc("radius", d.radius, d.material, d.velocity.x * d.velocity.x + d.velocity.y * d.velocity.y, d.spin);
    if (known({"radius"})) resolved("position", d.position, d.radius);
  }

  void judge(const Packing& p) {
    judge_disc("radius_min", p.radius_min, p.material, 0, 0);
    if (p.radius_max != p.radius_min) judge_disc("radius_max", p.radius_max, p.material, 0, 0);
    if (!known({"radius_min"})) return;
    resolved("lower_left", p.lower_left, p.radius_min);
    resolved("upper_right", p.upper_right, p.radius_min);
  }

  // Of the walls only what lies far off along its own normal would lose the discs in front of it.
  void judge(const Wall& w) {
    for (const char* list : {"disc", "packing", "lattice"})
      if (!found_.known(list)) return;
    double least = infinity;
    for (const Disc& d : scene_.disc) least = std::fmin(least, d.radius);
    for (const Packing& p : scene_.packing) least = std::fmin(least, p.radius_min);
    for (const Lattice& l : scene_.lattice) least = std::fmin(least, l.spacing);
    if (least < infinity) resolved("point", w.point, least);
  }

  void judge(const Plate& p) {
    if (!known({"width", "height"})) return;
    const double end = scene_.time.end, side = std::fmin(p.width, p.height);
    resolved("left_edge", {p.left_edge, p.lower_edge.value_or(0)}, side);
    resolved("width", {p.width, p.height}, side);
    resolved("velocity", {p.velocity.x * end, p.velocity.y * end}, side, {"time.end"});
  }

  void judge(const Lattice& l) {
    if (!known({"spacing", "node_mass", "rows", "columns", "stem"})) return;
    resolved("origin", l.origin, l.spacing);
    resolved("spacing", {l.spacing * l.columns, l.spacing * l.rows}, l.spacing);
    positive("spacing", "its square [m^2]", l.spacing * l.spacing);
    positive("contact_radius", "its square [m^2]", l.contact_radius * l.contact_radius);
    finite("node_mass", "1 / mass", 1 / l.node_mass);
    for (const auto& [kind, k] : {std::pair{"structural", &l.structural}, {"shear", &l.shear}, {"bending", &l.bending}})
      judge(kind, *k, l);
    judge_links(l);
    for (const Drive& d : l.drive)
      resolved("drive", {d.velocity.x * scene_.time.end, d.velocity.y * scene_.time.end}, l.spacing, {"time.end"});
    for (std::size_t n = 0; n < l.node.size(); ++n) judge(l.node[n], n, l);
  }

  void judge(const char* kind, const LinkKind& k, const Lattice& l) {
    if (k.stiffness > 0) positive(kind, "stiffness / node_mass [1/s^2]", k.stiffness / l.node_mass);
    if (k.stiffness > 0) positive(kind, "stiffness spacing^2 [J]", k.stiffness * l.spacing * l.spacing);
    finite(kind, "damping / node_mass [1/s]", k.damping / l.node_mass);
  }

  // Links that are not as their kinds say.
  void judge_links(const Lattice& l) {
    if ((!l.stem && l.link.empty()) || !found_.sound(at(""))) return;  // what is wrong may choose no links
    for (const LatticeLink& link : links_of(l)) {
      const double per_mass = link.stiffness / l.node_mass, energy = link.stiffness * l.spacing * l.spacing;
      const bool good = link.stiffness == 0 || (sound(per_mass) && sound(energy));
      if (good && std::isfinite(link.damping / l.node_mass)) continue;
      return found_.error(at(l.stem ? "stem" : "link"), "makes a link that cannot be computed with");
    }
  }

  void judge(const NodeSetting& s, std::size_t n, const Lattice& l) {
    const auto wrong_if = [&](bool is_wrong, const char* what) {
      if (is_wrong) found_.error(at("") + '.' + item("node", n), std::string(what) + " cannot be computed with");
    };
    const Vec2 d = s.displacement, v = s.velocity, f = s.force;
    const double far = std::fmax(std::fabs(d.x), std::fabs(d.y));
    wrong_if(far * resolution > l.spacing, "a displacement beyond 1e12 times the spacing");
    wrong_if(!std::isfinite(0.5 * l.node_mass * (v.x * v.x + v.y * v.y)), "a kinetic energy beyond all numbers");
    wrong_if(!std::isfinite(f.x / l.node_mass) || !std::isfinite(f.y / l.node_mass),
             "an acceleration beyond all numbers");
  }

  const Scene& scene_;
  Findings& found_;
  std::map<std::string, const Material*> material_;
  const char* list_ = "";
  std::size_t index_ = 0;
};

}  // namespace

void judge_numbers(const Scene& scene, Findings& found) { NumberJudge(scene, found).judge(); }

}  // namespace furrow
