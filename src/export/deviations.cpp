// Where a scene cannot be exported exactly, and how far it is off.
#include <algorithm>
#include <cmath>

#include "export/export.h"
#include "run/observe.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr auto another_law = Fidelity::another_law, refused = Fidelity::refused;

// What discs feel of each other and of what is flat, at t = 0.
struct Start {
  int slipping = 0;           // contacts with a stretched spring
  double held = 0, push = 0;  // N, sums of tangential and normal forces of these
  double overlap = 0;         // -, the greatest of two discs, of the smaller radius
};

Start start_of(const Prepared& prepared) {
  Start start;
  const DiscArrays& disc = prepared.system.parts().disc;
  prepared.system.for_each_contact(0, prepared.y, [&](const Contact& c) {
    if (c.id.kind == disc_disc)
      start.overlap = std::max(start.overlap, c.touch.overlap / std::min(disc.radius[c.id.a], disc.radius[c.id.b]));
    if (c.touch.spring == 0 && c.touch.turn == 0) return;
    ++start.slipping;
    start.held += std::fabs(c.force.tangential);
    start.push += std::max(0.0, c.force.normal);
  });
  return start;
}

class Deviations {
 public:
  explicit Deviations(const Prepared& prepared)
      : scene_(prepared.scene), parts_(prepared.system.parts()), start_(start_of(prepared)) {
    judge_laws();
    judge_start();
    judge_faces();
    judge_lattices();
  }
  std::vector<KeyRow> rows;

 private:
  void add(const std::string& key, Fidelity fidelity, const std::string& text) {
    const bool there = std::any_of(rows.begin(), rows.end(), [&](const KeyRow& r) { return r.key == key; });
    if (!there) rows.push_back({key, fidelity, text});
  }
  bool discs() const { return parts_.disc.count() > 0; }

  bool some_law(const auto& holds) const { return std::any_of(parts_.law.begin(), parts_.law.end(), holds); }

  void judge_laws() {
    if (discs() && parts_.friction) judge_arm();
    if (some_law([](const ContactLaw& law) {
          const bool damped = law.options.tangential_dashpot > 0 || law.viscosity * law.shear_ratio > 0;
          return law.friction > 0 && damped && law.options.after_slip == AfterSlip::elastic;
        }))
      add("model.after_slip", another_law,
          "after a slip LAMMPS keeps what leaves the limit together with the damper, as \"less_viscous\" does. How far "
          "that is off in this scene is not known before it runs: furrow run with model.after_slip = \"less_viscous\" "
          "says it. Measured in others: a sphere that falls spinning runs off .105 slower (furrow judge, case "
          "spinning_impact); the push on a plate through 230 discs of friction 0.5 (benchmarks/rivals/scene.toml) is 1 "
          "to 2 % another");
    if (some_law([](const ContactLaw& law) {
          const bool damped = law.viscosity > 0 || law.options.dashpot > 0;
          return law.friction > 0 && damped && law.options.force == ForceLaw::rescaled_mindlin;
        }))
      add("model.law", another_law,
          "LAMMPS rescales the whole tangential force, also what only the damper's part of the normal force holds; "
          "furrow as "
          "much as the elastic part holds: .007 of the force of a sphere that rebounds with 0.8 from a wall with "
          "friction 0.3");
    if (parts_.rolling && discs())
      add("model.rolling", another_law,
          "rolling sds, a spring with a limit: a disc alone on a floor is slowed as furrow does to 7e-4, but swings "
          "where it comes to rest "
          "and "
          "holds it on a slope");
    if (some_law([](const ContactLaw& law) {
          return law.friction > 0 && law.options.tangential_dashpot > 0 && !(law.options.dashpot > 0);
        }))
      add("contact.tangential_damping", refused, "LAMMPS gives it as a multiple of the normal one, which is 0");
  }

  void judge_arm() {
    const bool pairs = parts_.disc.count() > 1;
    if (!pairs && scene_.model.moment_arm == MomentArm::radius) return;
    add("model.moment_arm", another_law,
        "LAMMPS takes the slip at the radius R of a disc and the torque at R - d/2 between discs, at R on walls and "
        "plates: "
        "off by the overlap d over R or half of it, " +
            (start_.overlap > 0 ? rounded(start_.overlap, 2) + " of R at the most between discs at t = 0"
                                : std::string("not known before they touch: no two discs do at t = 0")));
  }

  void judge_start() {
    if (start_.slipping == 0) return;
    Sentence text;
    text.precision(3);
    text << "LAMMPS takes no tangential springs with a bed: those of " << start_.slipping
         << " contacts begin at zero. They carry " << start_.held << " N in all, of " << start_.push
         << " N of normal forces; scene.toml begins without them too";
    add("settle", another_law, text.str());
  }

  void judge_faces() {
    const Allow allow = scene_.allow.value_or(Allow{});
    const char* lost = "LAMMPS does not push out a centre that is there";
    if (allow.behind_walls && !parts_.wall.empty()) add("allow.behind_walls", another_law, lost);
    if (allow.through_plates && !parts_.plate.empty()) add("allow.through_plates", another_law, lost);
    if (parts_.tight_plates && !parts_.plate.empty())
      add("model.tight_plates", another_law, "LAMMPS loses the face of a disc whose centre is inside of the plate");
  }

  void judge_lattices() {
    if (parts_.lattice.empty()) return;
    if (discs()) add("lattice.auxiliary_points", refused, "LAMMPS has no contact of a disc with the edge of a lattice");
    if (!parts_.plate.empty())
      add("lattice.contact_radius", another_law,
          "against a plate a node is a sphere and the plate as much smaller: the same law at its faces as long as no "
          "node "
          "is deeper than .45 of its width, but within as much of a corner the corner is round");
    for (const Lattice& l : scene_.lattice) judge_links(l);
  }

  void judge_links(const Lattice& l) {
    const std::string lost =
        "bonds have no dampers in LAMMPS before May 2022 (later bpm/spring has, with another rule of tearing): they "
        "are left "
        "out";
    const auto judge = [&](const std::string& key, double damping) {
      if (damping > 0) add(key, another_law, lost);
    };
    if (l.stem)
      judge("lattice.stem.damping_ratio", l.stem->damping_ratio);
    else {
      judge("lattice.structural.damping", l.structural.damping);
      judge("lattice.shear.damping", l.shear.damping);
      judge("lattice.bending.damping", l.bending.damping);
    }
    for (const LinkSetting& one : l.link) judge("lattice.link.damping", one.damping.value_or(0));
    const auto& strengths = parts_.link.strength;
    if (l.tear == TearRule::magnitude &&
        std::any_of(strengths.begin(), strengths.end(), [](double s) { return std::isfinite(s); }))
      add("lattice.tear", another_law, "fix bond/break sees the length of a bond alone: pressure does not tear it");
  }

  const Scene& scene_;
  const Parts& parts_;
  const Start start_;
};

}  // namespace

std::vector<KeyRow> lammps_deviations(const Prepared& prepared) { return Deviations(prepared).rows; }

}  // namespace furrow
