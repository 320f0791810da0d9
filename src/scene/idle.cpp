// Keys that are not at their defaults in a scene that has no use for them.
#include <algorithm>
#include <string>
#include <vector>

#include "scene/findings.h"
#include "scene/lattice_parts.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double most_compared = 1e8;  // links, of all settings without one: no more are looked at

class IdleJudge {
 public:
  IdleJudge(const Scene& scene, Findings& found) : scene_(scene), found_(found) {}

  void judge() {
    const bool tears = std::any_of(scene_.lattice.begin(), scene_.lattice.end(), may_tear);
    if (scene_.time.locate == Locate::tears) unless(tears, "time.locate", "no lattice can tear");
    if (scene_.output.angles && has_discs())
      unless(!scene_.output.frames.empty(), "output.angles", "there are no frames (output.frames)");
    for (std::size_t k = 0; k < scene_.lattice.size(); ++k) judge(item("lattice", k), scene_.lattice[k]);
    if (scene_.allow) judge(*scene_.allow);
  }

 private:
  void unless(bool used, const std::string& path, const std::string& why) {
    if (!used) found_.warning(path, "has no effect: " + why);
  }
  bool has_discs() const { return !scene_.disc.empty() || !scene_.packing.empty(); }

  void judge(const std::string& path, const Lattice& l) {
    const Lattice defaults;
    if (l.auxiliary_points != defaults.auxiliary_points)
      unless(has_discs(), path + ".auxiliary_points", "there are no discs");
    if (l.contact_radius != defaults.contact_radius)
      unless(!scene_.plate.empty() || !scene_.wall.empty(), path + ".contact_radius",
             "there is neither a plate nor a wall");
    const std::vector<LatticeLink> links = links_of(l);
    const auto any = [&](const auto& is) { return std::any_of(links.begin(), links.end(), is); };
    if (l.tear != defaults.tear)
      unless(any([](const LatticeLink& k) { return k.strength < infinity; }), path + ".tear", "no link has a strength");
    if (l.damper != defaults.damper)
      unless(any([](const LatticeLink& k) { return k.damping > 0; }), path + ".damper", "no link is damped");
    judge_links(path, l, links);
  }

  static bool same(const std::vector<LatticeLink>& a, const std::vector<LatticeLink>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const LatticeLink& p, const LatticeLink& q) {
      return p.stiffness == q.stiffness && p.damping == q.damping && p.strength == q.strength && p.torn == q.torn;
    });
  }

  // What chooses no link, or says nothing of those that it chooses, is found elsewhere.
  void judge_links(const std::string& path, const Lattice& l, const std::vector<LatticeLink>& links) {
    const auto settings = static_cast<double>(l.link.size());
    if (settings * settings * static_cast<double>(links.size()) > most_compared) return;
    for (std::size_t k = 0; k < l.link.size(); ++k) {
      const LinkSetting& s = l.link[k];
      const bool says =
          s.torn || s.stiffness || s.damping || s.strength || s.stiffness_factor != 1 || s.strength_factor != 1;
      const auto chosen = [&](const LatticeLink& link) { return chooses(s, l, link); };
      if (!says || std::none_of(links.begin(), links.end(), chosen)) continue;
      Lattice without = l;
      without.link.erase(without.link.begin() + static_cast<std::ptrdiff_t>(k));
      unless(!same(links, links_of(without)), path + '.' + item("link", k),
             "without it all links would be the same; of two that choose one link the later holds");
    }
  }

  void judge(const Allow& a) {
    const bool discs = has_discs(), lattices = !scene_.lattice.empty();
    const std::string no_ledger = "output.energy is false", no_discs = "there are no discs";
    if (a.energy_made) unless(scene_.output.energy, "allow.energy_made", no_ledger);
    if (a.energy_lost) unless(scene_.output.energy, "allow.energy_lost", no_ledger);
    if (a.behind_walls)
      unless(discs && !scene_.wall.empty(), "allow.behind_walls", discs ? "there is no wall" : no_discs);
    if (a.through_plates) unless(!scene_.plate.empty(), "allow.through_plates", "there is no plate");
    if (a.through_lattices)
      unless(discs && lattices, "allow.through_lattices", discs ? "there is no lattice" : no_discs);
    if (a.crossing_lattices.value_or(false)) unless(lattices, "allow.crossing_lattices", "there is no lattice");
  }

  const Scene& scene_;
  Findings& found_;
};

}  // namespace

bool may_tear(const Lattice& l) {
  const std::vector<LatticeLink> links = links_of(l);
  return std::any_of(links.begin(), links.end(), [](const LatticeLink& k) { return k.torn || k.strength < infinity; });
}

void judge_idle(const Scene& scene, Findings& found) {
  if (found.sound()) IdleJudge(scene, found).judge();
}

}  // namespace furrow
