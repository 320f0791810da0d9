#include "program/explain_validity.h"

#include <algorithm>
#include <cmath>

#include "physics/impact.h"
#include "program/explain_line.h"
#include "run/observe.h"
#include "run/stiffness.h"
#include "scene/gaps.h"
#include "scene/labels.h"
#include "scene/wording.h"
#include "system/place.h"

namespace furrow {
namespace {

// What an impact needs at the least to carry one through the other, elastic and with the contact's damping.
void print_speed(const std::string& pair, const Parts& parts, const ContactId& contact, double radius, double mass,
                 const ContactLaw& law) {
  const double elastic = std::sqrt(2 * passing_work(parts, contact, law, radius) / mass);
  if (std::isfinite(elastic))
    line(pair, "from %.3g m/s on; with its damping from %.3g m/s", elastic, elastic / impact_factor(law));
}

// One disc of each radius, mass and material, at most so many, as the scene lists them.
std::vector<int> kinds_of_discs(const DiscArrays& disc) {
  constexpr std::size_t most = 8;
  std::vector<int> kinds;
  for (const int i : places_in(disc.number)) {
    if (kinds.size() == most) break;
    const auto same = [&](int k) {
      return disc.radius[k] == disc.radius[i] && disc.mass[k] == disc.mass[i] && disc.material[k] == disc.material[i];
    };
    if (std::none_of(kinds.begin(), kinds.end(), same)) kinds.push_back(i);
  }
  return kinds;
}

void print_disc(const Parts& parts, int i) {
  const DiscArrays& disc = parts.disc;
  const std::string name = "disc of " + shortest(disc.radius[i]) + " m";
  const auto law = [&](int material) { return parts.law[parts.law_of(disc.material[i], material)]; };
  print_speed(name + ", its like", parts, {disc_disc, i, i}, disc.radius[i] / 2, disc.mass[i] / 2,
              law(disc.material[i]));
  for (int k = 0; k < static_cast<int>(parts.plate.size()); ++k)
    print_speed(name + ", plate " + std::to_string(k), parts, {disc_plate, i, k}, disc.radius[i], disc.mass[i],
                law(parts.plate[k].material));
  for (int k = 0; k < static_cast<int>(parts.lattice.size()); ++k)
    print_speed(name + ", lattice " + std::to_string(k), parts, {disc_lattice, i, k}, disc.radius[i], disc.mass[i],
                law(parts.lattice[k].material));
}

}  // namespace

// What a disc on the border of a lattice feels of it. The points are 1/n of the spacing apart: the nearest one lies up
// to half of that beside the foot of the perpendicular.
void print_borders(const Scene& scene, const Parts& parts) {
  if (parts.node.count() == 0 || parts.disc.count() == 0) return;
  line("inner nodes", "touch no disc%s",
       parts.new_faces ? " as long as no link around them tears"
                       : "; a link that tears opens the border, and no new border is found (model.new_faces)");
  const double least = *std::min_element(parts.disc.radius.begin(), parts.disc.radius.end());
  const std::vector<std::string> names = labels(scene.lattice);
  for (std::size_t k = 0; k < scene.lattice.size(); ++k) {
    const Lattice& l = scene.lattice[k];
    if (l.auxiliary_points == 0) continue;
    const std::string name = "border of " + (l.name.empty() ? "lattice " : std::string()) + names[k];
    if (const std::string through = way_through(l, least); !through.empty()) {
      line(name, "%d points on each segment: %s", l.auxiliary_points, through.c_str());
      continue;
    }
    const double half = half_gap(l);
    line(name, "%d points on each segment: %.3g m rough, the normal up to %.2g degrees off for a disc of %g m",
         l.auxiliary_points, least - std::sqrt(least * least - half * half), std::asin(half / least) * 180 / pi, least);
    line("", "a disc that rolls or slides along loses energy to that; auxiliary_points = 0 is smooth");
  }
}

void print_spins(const Scene& scene) {
  const auto spins = [](const Disc& d) { return d.spin != 0; };
  if (std::any_of(scene.disc.begin(), scene.disc.end(), spins))
    line("spins", "stay as the scene gives them: without friction nothing turns a disc");
}

void print_passing(const Parts& parts) {
  if (parts.disc.count() == 0 && (parts.node.count() == 0 || parts.plate.empty())) return;
  std::printf("\nhow fast one must meet the other, head-on, to pass through it\n");
  for (const int i : kinds_of_discs(parts.disc)) print_disc(parts, i);
  for (int k = 0; k < static_cast<int>(parts.plate.size()) && parts.node.count() > 0; ++k)
    print_speed("node, plate " + std::to_string(k), parts, {node_plate, 0, k}, parts.node.contact_radius[0],
                parts.node.mass[0], parts.law[parts.law_of(parts.node.material[0], parts.plate[k].material)]);
  line("", "pushed slowly, with that work, it passes too");
}

void print_allowed(const Scene& scene) {
  if (!scene.allow) return;
  std::printf("\nallowed beyond the validity of the laws\n");
  const Allow& a = *scene.allow;
  if (a.energy_made) line("energy made", "up to %g of what the scene is given", *a.energy_made);
  if (a.energy_lost) line("energy lost", "up to %g of what the scene is given", *a.energy_lost);
  if (a.overlap) line("overlap", "up to %g of the smaller radius", *a.overlap);
  if (a.step) line("step", "up to %g times the largest stable one", *a.step);
  if (a.behind_walls) line("walls", "centres of discs may lie behind them");
  if (a.through_plates) line("plates", "centres may cross them");
  if (a.through_lattices) line("lattices", "centres may cross their borders");
  if (a.crossing_lattices.value_or(false))
    line("lattices", "they may cross each other or themselves, plates and, where they are torn, bodies");
}

namespace {

// Whether something below its centre touches a disc, by its number in the system: it is pressed, and falls no further.
std::vector<bool> held_from_below(const Prepared& prepared) {
  std::vector<bool> held(prepared.system.parts().disc.radius.size());
  prepared.system.for_each_contact(0, prepared.y, [&](const Contact& c) {
    if (!of_disc(c.id.kind)) return;
    if (c.ny < 0) held[c.id.a] = true;
    if (c.id.kind == disc_disc && c.ny > 0) held[c.id.b] = true;
  });
  return held;
}

// m: the highest place straight below a disc, of walls that slope by less than 80 degrees, plates and nodes; -infinity: none,
// it falls past all. Other discs that it does not touch are left out: they are in the way at most.
double place_below(const Prepared& prepared, int disc) {
  const Parts& parts = prepared.system.parts();
  const State& y = prepared.y;
  const double radius = parts.disc.radius[disc], bottom = y[prepared.system.y_of(disc)] - radius;
  const double x = y[prepared.system.x_of(disc)];
  double highest = -infinity;
  const auto see = [&](double place) {
    if (place <= bottom) highest = std::max(highest, place);
  };
  for (const WallPart& w : parts.wall)
    if (w.ny > 0.17) see(w.py - w.nx / w.ny * (x - w.px));
  for (const PlatePart& p : parts.plate)
    if (x + radius > p.left && x - radius < p.left + p.width) see(p.lower + p.height);
  for (int n = 0; n < parts.node.count(); ++n)
    if (std::fabs(parts.node.x[n] - x) < radius + parts.node.contact_radius[n])
      see(parts.node.y[n] + parts.node.contact_radius[n]);
  return highest;
}

// m/s: the greatest with which a disc comes to what is below it.
double falling_speed(const Prepared& prepared) {
  const System& system = prepared.system;
  const std::vector<bool> held = held_from_below(prepared);
  double fastest = 0;
  for (int i = 0; i < system.parts().disc.count(); ++i) {
    if (held[i]) continue;
    const double below = place_below(prepared, i);
    if (!std::isfinite(below)) continue;
    const double drop = prepared.y[system.y_of(i)] - system.parts().disc.radius[i] - below;
    const double vx = prepared.y[system.vx_of(i)], vy = prepared.y[system.vy_of(i)];
    fastest = std::max(fastest, std::sqrt(vx * vx + vy * vy + 2 * system.gravity() * drop));
  }
  return fastest;
}

// m/s: what a disc at rest that just touches reaches by its weight, which presses it in by d: v^2 = 2 g d(v). As d
// grows less than v^2, the iteration comes to it from either side.
double loading_speed(const Parts& parts) {
  double speed = 0;
  for (int i = 0; i < parts.disc.count(); ++i) {
    const ContactLaw& law = parts.law[parts.law_of(parts.disc.material[i], parts.disc.material[i])];
    double v = 0.1;  // m/s
    for (int k = 0; k < 40; ++k)
      v = std::sqrt(2 * parts.gravity * impact_overlap(law, parts.disc.radius[i], parts.disc.mass[i], v));
    speed = std::max(speed, v);
  }
  return speed;
}

}  // namespace

double print_arrival(const Scene& scene, const Prepared& prepared) {
  const Parts& parts = prepared.system.parts();
  const Timing& time = scene.time;
  double speed = greatest_speed(prepared.system, prepared.y);
  for (const PlatePart& p : parts.plate) speed = std::max(speed, std::hypot(p.vx, p.vy));
  const char* why = "";
  // What has settled carries its weight, and falls no more.
  if (parts.gravity > 0 && parts.disc.count() > 0 && !scene.settle) {
    const double falls = falling_speed(prepared), pressed = loading_speed(parts);
    if (falls > speed && falls >= pressed) why = ", that of a fall to what is below,";
    if (pressed > speed && pressed > falls) why = ", which its weight gives a disc that just touches,";
    speed = std::max({speed, falls, pressed});
  }
  const Oscillator impact = stiffest_impact(parts, speed);
  if (!(impact.omega > 0)) return infinity;
  const double limit = largest_stable_step(time.method, impact);
  if (!std::isfinite(limit)) return infinity;
  line("an impact to come", "at %.3g m/s%s allows %s %.3g s%s", speed, why, time.method.c_str(), limit,
       time.step > limit ? ": NOT the scene's step" : "");
  return limit;
}

}  // namespace furrow
