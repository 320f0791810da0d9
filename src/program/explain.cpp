// What is modelled in a scene, what is left out, and what follows from its numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "methods/method.h"
#include "output/warnings.h"
#include "physics/impact.h"
#include "program/commands.h"
#include "program/explain_law.h"
#include "program/explain_line.h"
#include "program/explain_stems.h"
#include "program/explain_validity.h"
#include "program/progress.h"
#include "run/observe.h"
#include "run/prepare.h"
#include "run/stiffness.h"
#include "scene/labels.h"
#include "system/order.h"

namespace furrow {
namespace {

std::string count(std::size_t n, const std::string& one) { return std::to_string(n) + " " + one + (n == 1 ? "" : "s"); }

void print_modelled(const Scene& scene, const System& system) {
  const Parts& parts = system.parts();
  const bool spins = system.has_friction() && parts.disc.count() > 0;
  std::printf("\nmodelled (%s of state)\n", count(system.size(), "number").c_str());
  if (parts.disc.count() > 0) {
    line("discs", "%d, %d numbers each: x, y, vx, vy%s; masses as %s", parts.disc.count(), spins ? 5 : 4,
         spins ? ", spin" : "",
         scene.model.disc_mass == DiscMass::disc ? "discs (m = rho pi R^2 b)" : "spheres (m = 4/3 pi rho R^3)");
  }
  if (parts.node.count() > 0) {
    const auto of = [&](LinkClass kind) { return std::count(parts.link.kind.begin(), parts.link.kind.end(), kind); };
    const int driven = static_cast<int>(parts.driven.size());
    line("lattice nodes", "%d free, 4 numbers each; %d fixed, none", parts.free_nodes,
         parts.node.count() - parts.free_nodes - driven);
    if (driven > 0) line("driven nodes", "%d, no numbers: they move as %zu drives say", driven, parts.drive.size());
    line("links", "%d: %td structural, %td shear, %td bending; no numbers of their own", parts.link.count(),
         of(LinkClass::structural), of(LinkClass::shear), of(LinkClass::bending));
    if (!parts.link.notched.empty()) line("notches", "%zu links are torn from the start", parts.link.notched.size());
    if (const std::size_t rollers = parts.held_x.size() + parts.held_y.size(); rollers > 0)
      line("rollers", "%zu nodes keep their x or their y", rollers);
  }
  line("walls, plates", "%s, %s; no numbers: they do not react", count(parts.wall.size(), "wall").c_str(),
       count(parts.plate.size(), "plate").c_str());
  if (parts.tight_plates && !parts.plate.empty())
    line("faces of plates", "bodies keep the one that they met, however deep; %s",
         parts.flush_plates ? "flush plates are one surface" : "no plates are flush");
  if (parts.new_faces && parts.link.count() > 0)
    line("new faces", "the border of a lattice is found again after each tear");
  if (system.spring_count() > 0)
    line(system.layout().slot_width > 1 ? "springs, rolling too" : "tangential springs",
         "room for %d contacts with friction", system.spring_count());
  if (scene.time.solver == SolverKind::kernel && parts.disc.count() + parts.node.count() > 0)
    line("contacts evaluated", "%s",
         parts.options ? "one by one, by the reference's law: its options are not in the vectors" : "in vectors");
  if (parts.disc.count() + parts.node.count() > 0) print_options(scene, parts);
  if (parts.keeps_angles) line("angles of discs", "one number each (output.angles)");
  if (system.threads() > 1) line("threads", "%d share a step; they change no bit", system.threads());
  if (system.keeps_ledger()) line("energy ledger", "%d numbers (output.energy = false saves them)", ledger_entries);
}

void print_left_out(const Scene& scene, const System& system) {
  const Parts& parts = system.parts();
  std::printf("\nleft out\n");
  if (!system.has_friction()) line("friction", "every friction coefficient is zero: no spins, no tangential springs");
  if (!system.has_friction()) print_spins(scene);
  if (system.has_rolling() && !parts.rolling_spring && parts.disc.count() > 0)
    line("rest by rolling", "rolling friction is smoothed below %g rad/s: it slows, but holds nothing still",
         system.rolling_smoothing());
  if (system.has_friction() && !system.has_rolling() && parts.disc.count() > 0)
    line("rolling resistance", "every rolling friction coefficient is zero");
  if (parts.disc.count() == 0) line("neighbour search", "no discs");
  if (scene.search.threads > system.threads())
    line("threads", "search.threads = %d is for beds of more than %d discs", scene.search.threads, discs_per_block);
  if (scene.model.gravity == 0) line("gravity", "model.gravity = 0");
  const std::vector<std::string> names = labels(scene.lattice);
  for (std::size_t k = 0; k < scene.lattice.size(); ++k) {
    const Lattice& l = scene.lattice[k];
    const std::string name = "lattice " + names[k];
    if (!l.gravity && scene.model.gravity != 0) line(name, "has no weight (gravity = false)");
    if (l.stem) continue;
    for (const auto& [kind, links] :
         {std::pair("structural", l.structural), {"shear", l.shear}, {"bending", l.bending}}) {
      if (links.stiffness == 0 && links.damping == 0)
        line(name, "has no %s links (stiffness and damping 0)", kind);
      else if (std::isinf(links.strength))
        line(name, "its %s links never tear (no strength given)", kind);
    }
  }
  if (parts.link.count() > 0 && scene.time.locate == Locate::none)
    line("tears within a step", "are seen at its end (time.locate = \"tears\" ends it there)");
  if (!parts.tight_plates && !parts.plate.empty())
    line("faces of plates",
         "are not kept: a centre past the middle of a plate comes out behind it (model.tight_plates)");
  if (!parts.lattice.empty())
    line("lattices", "do not touch each other or themselves; run.json says where they cross or turn inside out");
  print_borders(scene, parts);
  if (parts.node.count() > parts.free_nodes)
    line(parts.driven.empty() ? "fixed nodes" : "fixed, driven nodes", "touch discs, but neither plates nor walls");
}

double characteristic_speed(const Scene& scene) {
  double speed = 0;
  for (const Plate& p : scene.plate) speed = std::max(speed, std::hypot(p.velocity.x, p.velocity.y));
  for (const Lattice& l : scene.lattice)
    for (const Drive& d : l.drive) speed = std::max(speed, std::hypot(d.velocity.x, d.velocity.y));
  for (const Disc& d : scene.disc) speed = std::max(speed, std::hypot(d.velocity.x, d.velocity.y));
  return speed > 0 ? speed : 1;
}

void print_contacts(const Scene& scene, const System& system) {
  const Parts& parts = system.parts();
  std::printf("\ncontacts, by pair of materials\n");
  for (int a = 0; a < parts.materials; ++a) {
    for (int b = a; b < parts.materials; ++b) {
      const ContactLaw& law = parts.law[parts.law_of(a, b)];
      const std::string pair = scene.material[a].name + " - " + scene.material[b].name;
      if (std::isinf(law.modulus) && !is_linear(law)) {
        line(pair, "both rigid: they must not meet");
        continue;
      }
      print_law(pair, law);
    }
  }
}

// Two of the smallest discs against each other: their effective radius and mass are half of one's.
void print_smallest_disc(const Scene& scene, const Parts& parts) {
  const DiscArrays& disc = parts.disc;
  if (disc.count() == 0) return;
  const auto least = std::min_element(disc.radius.begin(), disc.radius.end()) - disc.radius.begin();
  const ContactLaw& law = parts.law[parts.law_of(disc.material[least], disc.material[least])];
  if (std::isinf(law.modulus) && !is_linear(law)) return;
  const double speed = characteristic_speed(scene);
  const double radius = disc.radius[least] / 2, mass = disc.mass[least] / 2;
  const double overlap = impact_overlap(law, radius, mass, speed);
  const Touch touch{overlap, 0, 0, 0, 0, radius, mass};
  const TouchForce deepest = contact_force(law, touch, parts.rolling_smoothing);
  line("smallest disc", "R = %g m, m = %.6g kg, I = %.6g kg m^2", disc.radius[least], disc.mass[least],
       disc.inertia[least]);
  line("two of them, elastic", "closing at %g m/s: overlap %.3g m (%.3g R), force %.4g N, contact time %.4g s", speed,
       overlap, overlap / disc.radius[least], deepest.elastic, impact_duration(law, overlap, speed));
  line("critical damping", "at that overlap: %.4g N s/m; the scene has %.4g N s/m",
       2 * std::sqrt(deepest.stiffness * mass), normal_viscosity(law, touch, deepest));
}

void print_start(const Prepared& prepared) {
  const Observation seen = observe(prepared.system, 0, prepared.y);
  std::printf("\nwhere it stands at t = 0\n");
  if (prepared.surface) {
    line("settled", "after %.3g s; surface at %.4g m", prepared.settling_time, *prepared.surface);
    const std::vector<std::string> names = labels(prepared.scene.plate);
    for (std::size_t k = 0; k < names.size(); ++k)
      line("plate " + names[k], "lower edge at %.4g m", *prepared.scene.plate[k].lower_edge);
  }
  line("contacts", "%d", seen.contacts);
  if (seen.contacts > 0) {
    line("greatest overlap", "%.3g m, %.3g of the radius, between %s", seen.overlap.depth, seen.overlap.relative,
         seen.overlap.between.c_str());
  }
}

void print_step(const Scene& scene, const Prepared& prepared) {
  const Timing& time = scene.time;
  const StiffPart part = stiffest_part(prepared.system, 0, prepared.y);
  std::printf("\nstable step\n");
  const double of_impacts = print_arrival(scene, prepared);
  const auto weigh = [&](bool warned) {
    line("the scene's step", "%g s: %s", time.step,
         warned                       ? "NOT safely inside"
         : time.step > of_impacts / 2 ? "inside at t = 0, NOT safely in an impact to come"
                                      : "well inside");
  };
  if (part.name.empty()) {
    line("stiffest part", "nothing acts on anything at t = 0; contacts that come later do");
    if (std::isfinite(of_impacts)) weigh(false);
    return;
  }
  // Nodes do not spin, nothing turns a disc without friction, and without damping the motion is not told apart.
  const bool spins =
      part.spins && part.name.starts_with("disc") && prepared.system.has_friction() && part.oscillator.zeta > 0;
  line("stiffest part", "%s, %d contacts, its neighbours held%s", part.name.c_str(), part.contacts,
       spins ? ", its fastest motion a spin" : "");
  line("", "omega = %.4g rad/s, damping ratio %.4g", part.oscillator.omega, part.oscillator.zeta);
  for (const MethodInfo& m : method_catalogue()) {
    if (m.family != "own" && m.name != time.method) continue;
    const double limit = largest_stable_step(m.name, part.oscillator);
    const char* chosen = m.name == time.method ? "   <- the scene's method" : "";
    if (std::isinf(limit))
      line(m.name, "%s%s", m.controlled ? "chooses its own step" : "stable at any step", chosen);
    else
      line(m.name, "%.3g s; %.3g s when all neighbours move against it%s", limit, limit / 2, chosen);
  }
  const std::vector<std::string> warnings = step_warnings(prepared.system, 0, prepared.y, time.method, time.step);
  weigh(!warnings.empty());
  for (const std::string& text : warnings) line("", "warning: %s", text.c_str());
}

}  // namespace

int explain_command(const RunOptions& options) {
  const Scene scene = requested_scene(options);
  Progress progress;
  progress.begin(options.scene, "placing");
  const System system = unsettled(scene);
  progress.end();
  std::printf("%s\n%s\n", options.scene.c_str(), scene.title.c_str());
  for (const std::string& text : warnings_before(scene)) std::printf("warning: %s\n", text.c_str());
  print_modelled(scene, system);
  print_left_out(scene, system);
  print_stems(scene);
  print_contacts(scene, system);
  print_smallest_disc(scene, system.parts());
  print_passing(system.parts());
  print_allowed(scene);
  std::fflush(stdout);
  progress.begin(options.scene, "placing");
  const Prepared prepared = prepare(
      scene, [&](double t, double) { return progress.show(options.scene, "settling", t, scene.settle->limit); });
  progress.end();
  print_start(prepared);
  print_step(scene, prepared);
  return good;
}

}  // namespace furrow
