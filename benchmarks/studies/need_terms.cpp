#include "benchmarks/studies/need_terms.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/studies/need_lattice_terms.h"

namespace furrow::benchmarks {
namespace {

void for_each_kind(Scene& scene, const std::function<void(LinkKind&)>& change) {
  for (Lattice& l : scene.lattice) {
    for (LinkKind* kind : {&l.structural, &l.shear, &l.bending}) change(*kind);
  }
}

bool any_kind(const Scene& scene, const std::function<bool(const LinkKind&)>& is) {
  return std::any_of(scene.lattice.begin(), scene.lattice.end(),
                     [&](const Lattice& l) { return is(l.structural) || is(l.shear) || is(l.bending); });
}

bool has_links(const Scene& scene, LinkKind Lattice::*kind) {
  return std::any_of(scene.lattice.begin(), scene.lattice.end(),
                     [&](const Lattice& l) { return (l.*kind).stiffness > 0 || (l.*kind).damping > 0; });
}

bool has_bed(const Scene& scene) { return !scene.packing.empty(); }
bool has_discs(const Scene& scene) { return has_bed(scene) || !scene.disc.empty(); }

// Whether some contact slides: its law is chosen by the scene.
bool rubs(const Scene& scene) {
  return scene.contact.friction > 0 && (has_discs(scene) || !scene.plate.empty() || !scene.wall.empty());
}

// m: of the packing, the first disc, or a node of the first lattice.
double radius_of(const Scene& scene) {
  return has_bed(scene)        ? scene.packing[0].radius_min
         : !scene.disc.empty() ? scene.disc[0].radius
                               : scene.lattice[0].contact_radius;
}

// Of two of these that overlap by a tenth of a radius.
struct TypicalContact {
  ContactLaw law;
  double width, mass;  // m, kg: sqrt(R* d), m*
};

TypicalContact typical_contact(const Scene& scene) {
  const System system = unsettled(scene);
  const Parts& parts = system.parts();
  return {parts.law[0], std::sqrt(radius_of(scene) / 2 * 0.1 * radius_of(scene)),
          (parts.disc.count() > 0 ? parts.disc.mass[0] : parts.node.mass[0]) / 2};
}

// Springs as stiff as Hertz's are there.
void make_linear(Scene& scene) {
  const TypicalContact c = typical_contact(scene);
  scene.model.law = ForceLaw::linear;
  scene.contact.normal_stiffness = 2 * c.law.modulus * c.width;
  scene.contact.tangential_stiffness = 8 * c.law.shear_modulus * c.width;
}

// A damper as strong as that of the damping factor is there.
void make_dashpot(Scene& scene) {
  const TypicalContact c = typical_contact(scene);
  scene.contact.damping_factor.reset();
  scene.contact.damping = c.law.viscosity * std::sqrt(2 * c.law.modulus * c.width * c.mass);
}

std::function<Scene()> scene_of_case(const std::string& name) {
  return std::find_if(cases().begin(), cases().end(), [&](const CaseInfo& c) { return c.name == name; })->scene;
}

std::vector<Term> every_term() {
  std::vector<Term> all{
      {"friction, and with it spins and tangential springs",
       [](const Scene& s) { return s.contact.friction > 0 || s.contact.rolling_friction > 0; },
       [](Scene& s) { s.contact.friction = s.contact.rolling_friction = 0; }},
      {"sliding friction alone",
       [](const Scene& s) { return has_discs(s) && s.contact.friction > 0 && s.contact.rolling_friction > 0; },
       [](Scene& s) { s.contact.friction = 0; }},
      {"rolling friction", [](const Scene& s) { return s.contact.rolling_friction > 0; },
       [](Scene& s) { s.contact.rolling_friction = 0; }},
      {"damping of contacts", [](const Scene& s) { return !has_bed(s) && s.contact.damping_factor.value_or(0) > 0; },
       [](Scene& s) { s.contact.damping_factor = 0; }},
      {"damping of links", [](const Scene& s) { return any_kind(s, [](const LinkKind& k) { return k.damping > 0; }); },
       [](Scene& s) { for_each_kind(s, [](LinkKind& k) { k.damping = 0; }); }},
      {"shear links", [](const Scene& s) { return has_links(s, &Lattice::shear); },
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.shear = {};
       }},
      {"bending links", [](const Scene& s) { return has_links(s, &Lattice::bending); },
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.bending = {};
       }},
      {"tearing", [](const Scene& s) { return any_kind(s, [](const LinkKind& k) { return k.strength < infinity; }); },
       [](Scene& s) { for_each_kind(s, [](LinkKind& k) { k.strength = infinity; }); }},
      {"auxiliary points (the exact nearest point instead)",
       [](const Scene& s) {
         return has_discs(s) && std::any_of(s.lattice.begin(), s.lattice.end(),
                                            [](const Lattice& l) { return l.auxiliary_points > 0; });
       },
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.auxiliary_points = 0;
       }},
      {"tight plates (the nearest face instead)", [](const Scene& s) { return s.model.tight_plates.value_or(false); },
       [](Scene& s) { s.model.tight_plates = false; }},
      {"new faces of a torn lattice", [](const Scene& s) { return s.model.new_faces.value_or(false); },
       [](Scene& s) { s.model.new_faces = false; }},
      {"damping of the tangential force", [](const Scene& s) { return rubs(s) && s.model.slip_damping; },
       [](Scene& s) { s.model.slip_damping = false; }},
      {"what a spring holds after slip (the limit less the damper's force instead)", rubs,
       [](Scene& s) { s.model.after_slip = AfterSlip::less_viscous; }},
      {"stiffness that grows with the overlap (a linear spring instead)", rubs, make_linear},
      {"unloading at a constant spring (Thornton's rescaling instead)", rubs,
       [](Scene& s) { s.model.law = ForceLaw::rescaled_mindlin; }},
      {"moment arm to the contact point (the whole radius instead)",
       [](const Scene& s) { return rubs(s) && has_discs(s); },
       [](Scene& s) { s.model.moment_arm = MomentArm::radius; }},
      {"moment arm to the contact point (half the overlap short of the surface instead)",
       [](const Scene& s) { return rubs(s) && has_discs(s); },
       [](Scene& s) { s.model.moment_arm = MomentArm::half_overlap; }},
      {"damping that grows with the overlap (a dashpot in N s/m instead)",
       [](const Scene& s) { return s.contact.damping_factor.value_or(0) > 0; }, make_dashpot},
      {"rolling friction that fades with the spin (a rolling spring instead)",
       [](const Scene& s) { return has_discs(s) && s.contact.rolling_friction > 0; },
       [](Scene& s) { s.model.rolling = Rolling::spring; }},
      {"plates that start at full speed (in a tenth of the time instead)",
       [](const Scene& s) {
         return std::any_of(s.plate.begin(), s.plate.end(), [](const Plate& p) { return p.ramp == 0; });
       },
       [](Scene& s) {
         for (Plate& p : s.plate) p.ramp = 0.1 * s.time.end;
       }},
      {"gravity", [](const Scene& s) { return !has_bed(s) && s.model.gravity > 0; },
       [](Scene& s) { s.model.gravity = 0; }},
      {"list of the contacts in each frame", [](const Scene& s) { return !s.output.frames.empty(); },
       [](Scene& s) { s.output.frames.clear(); }},
      {"energy ledger", [](const Scene& s) { return s.output.energy; }, [](Scene& s) { s.output.energy = false; }},
  };
  const std::vector<Term> of_lattices = lattice_terms();
  all.insert(all.end() - 2, of_lattices.begin(), of_lattices.end());
  return all;
}

}  // namespace

const std::vector<Term>& terms() {
  static const std::vector<Term> all = every_term();
  return all;
}

std::vector<Subject> subjects(bool quick) {
  const auto file = [](const std::string& name) { return [name] { return scene_file(name); }; };
  std::vector<Subject> all{
      {"single_spring", {0, 0.01, 200}, "rk4", 1e-3, 1, file("single_spring")},
      {"disc_on_wall", {0, 1e-5, 100}, "rk4", 1e-6, 1, file("disc_on_wall")},
      {"damped_hertz_impact", {0, 1e-3, 100}, "rk4", 1e-5, 1, scene_of_case("damped_hertz_impact")},
      {"cantilever", {0, 0.01, 300}, "rk4", 5e-4, 1, file("cantilever")},
      {"tearing_lattice", {0, 1e-3, 500}, "rk4", 1e-4, 1, scene_of_case("tearing_lattice")},
      {"scenario_1", {0, 1e-3, 1200}, "rk4", 2e-5, 1, file("scenario_1")},
  };
  if (!quick) {
    all.push_back({"scenario_2", {0, 1e-3, 4500}, "rk4", 1e-4, 4, file("scenario_2")});
    all.push_back({"scenario_3", {0, 1e-3, 4500}, "rk4", 1e-4, 4, file("scenario_3")});
  }
  return all;
}

}  // namespace furrow::benchmarks
