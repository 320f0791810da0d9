#include "system/parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "physics/disc.h"
#include "scene/lattice_parts.h"
#include "scene/stem.h"
#include "scene/unit_vector.h"
#include "system/border.h"
#include "system/floating_point.h"
#include "system/held_faces.h"
#include "system/place.h"

namespace furrow {
namespace {

int index_of_material(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.material.size(); ++i) {
    if (scene.material[i].name == name) return static_cast<int>(i);
  }
  throw std::invalid_argument("material '" + name + "' is not defined");
}

void add_discs(const Scene& scene, Parts& parts) {
  std::vector<double> x, y;
  for (const Disc& d : scene.disc) {
    x.push_back(d.position.x);
    y.push_back(d.position.y);
  }
  parts.disc.number = order_of_storage(x, y);
  for (const int number : parts.disc.number) {
    const Disc& d = scene.disc[number];
    const int material = index_of_material(scene, d.material);
    const bool flat = scene.model.disc_mass == DiscMass::disc;
    const double volume = flat ? disc_volume(d.radius, scene.model.disc_depth) : sphere_volume(d.radius);
    const double mass = scene.material[material].density * volume;
    parts.disc.x.push_back(d.position.x);
    parts.disc.y.push_back(d.position.y);
    parts.disc.vx.push_back(d.velocity.x);
    parts.disc.vy.push_back(d.velocity.y);
    parts.disc.spin.push_back(d.spin);
    parts.disc.radius.push_back(d.radius);
    parts.disc.mass.push_back(mass);
    parts.disc.inertia.push_back(flat ? disc_inertia(mass, d.radius) : sphere_inertia(mass, d.radius));
    parts.disc.volume.push_back(volume);
    parts.disc.material.push_back(material);
  }
}

constexpr double margin_of_radius = 0.1;  // times the least radius

double least_radius(const Parts& parts) {
  double least = infinity;
  for (const double r : parts.disc.radius) least = std::min(least, r);
  for (const double r : parts.node.contact_radius) least = std::min(least, r);
  return std::isfinite(least) ? least : 1;
}

// Only what matters: a spring of rolling where there are discs to roll, a spin where some disc can be turned, a spring
// where some contact has friction.
void set_options(const Scene& scene, Parts& parts) {
  parts.gravity = scene.model.gravity;
  const MomentArm arm = scene.model.moment_arm;
  parts.pair_arm_shortening = arm == MomentArm::radius ? 0 : 0.5;
  parts.flat_arm_shortening = arm == MomentArm::radius ? 0 : arm == MomentArm::half_overlap ? 0.5 : 1;
  parts.rolling_smoothing = scene.model.rolling_smoothing;
  for (ContactLaw& law : parts.law) {
    law.options.rolling_spring = law.options.rolling_spring && parts.disc.count() > 0;
    parts.rolling = parts.rolling || (law.rolling > 0 && parts.disc.count() > 0);
    parts.rolling_spring = parts.rolling_spring || law.options.rolling_spring;
    parts.friction = parts.friction || law.friction > 0;
    parts.options = parts.options || !law.options.none();
  }
  parts.friction = parts.friction || parts.rolling;
  parts.keeps_ledger = scene.output.energy;
  parts.keeps_angles = scene.output.angles;
  parts.margin = margin_of_radius * least_radius(parts);
  parts.tight_plates = scene.model.tight_plates.value_or(false);
  parts.new_faces = scene.model.new_faces.value_or(false);
}

// Adds one lattice; node (row, column) gets index first + row * columns + column.
class LatticeBuilder {
 public:
  LatticeBuilder(const Scene& scene, const Lattice& lattice, Parts& parts)
      : scene_(scene), lattice_(lattice), parts_(parts), first_(parts.node.count()) {}

  void build() {
    add_nodes();
    add_links();
    add_border();
    parts_.lattice.push_back({lattice_.auxiliary_points, index_of_material(scene_, lattice_.material), lattice_.name});
  }

 private:
  int node(int row, int column) const { return first_ + row * lattice_.columns + column; }

  void add_nodes() {
    const Lattice& l = lattice_;
    NodeArrays& n = parts_.node;
    const std::vector<Held> held = held_nodes(l);
    const int first_drive = static_cast<int>(parts_.drive.size());
    for (const Drive& d : l.drive)
      parts_.drive.push_back({d.velocity.x, d.velocity.y, d.ramp, static_cast<int>(parts_.lattice.size())});
    for (int row = 0; row < l.rows; ++row) {
      for (int column = 0; column < l.columns; ++column) {
        const Held& here = held[node(row, column) - first_];
        n.x.push_back(l.origin.x + column * l.spacing);
        n.y.push_back(l.origin.y + row * l.spacing);
        for (auto* field : {&n.vx, &n.vy, &n.load_x, &n.load_y}) field->push_back(0);
        n.mass.push_back(mass_of(l, row, column));
        n.gravity.push_back(l.gravity ? scene_.model.gravity : 0);
        n.contact_radius.push_back(l.contact_radius);
        n.spacing.push_back(l.spacing);
        n.drive.push_back(here.drive < 0 ? -1 : first_drive + here.drive);
        if (here.drive >= 0) parts_.driven.push_back(node(row, column));
        n.body.push_back(here.fixed() ? -1 : parts_.disc.count() + parts_.free_nodes++);
        if (here.x && !here.y) parts_.held_x.push_back(n.body.back());
        if (here.y && !here.x) parts_.held_y.push_back(n.body.back());
        n.material.push_back(index_of_material(scene_, l.material));
        n.lattice.push_back(static_cast<int>(parts_.lattice.size()));
        n.row.push_back(row);
        n.column.push_back(column);
      }
    }
    for (const NodeSetting& s : l.node) {
      const int k = node(s.row, s.column);
      n.x[k] += s.displacement.x;
      n.y[k] += s.displacement.y;
      n.vx[k] = s.velocity.x;
      n.vy[k] = s.velocity.y;
      n.load_x[k] = s.force.x;
      n.load_y[k] = s.force.y;
    }
  }

  void add_links() {
    LinkArrays& links = parts_.link;
    for (const LatticeLink& link : links_of(lattice_)) {
      const int a = first_ + link.a, b = first_ + link.b;
      if (link.kind == LinkClass::structural) structural_[{a, b}] = links.count();
      if (link.torn) links.notched.push_back(links.count());
      links.a.push_back(a);
      links.b.push_back(b);
      links.rest.push_back(link.rest);
      links.stiffness.push_back(link.stiffness);
      links.damping.push_back(link.damping);
      links.strength.push_back(link.strength);
      links.kind.push_back(link.kind);
      links.axial.push_back(lattice_.damper == Damper::axial);
      links.in_magnitude.push_back(lattice_.tear == TearRule::magnitude);
    }
  }

  int structural_link(int a, int b) const {
    const auto found = structural_.find(std::minmax(a, b));
    return found == structural_.end() ? -1 : found->second;
  }

  void add_segment(int a, int b) {
    parts_.border.a.push_back(a);
    parts_.border.b.push_back(b);
    parts_.border.link.push_back(structural_link(a, b));
    parts_.border.lattice.push_back(static_cast<int>(parts_.lattice.size()));
  }

  // Counter-clockwise from the lower left corner; for one row or column just along it; for one node the node itself.
  void add_border() {
    const int top = lattice_.rows - 1;
    const int right = lattice_.columns - 1;
    if (top == 0 && right == 0) add_segment(first_, first_);
    for (int c = 0; c < right; ++c) add_segment(node(0, c), node(0, c + 1));
    for (int r = 0; r < top; ++r) add_segment(node(r, right), node(r + 1, right));
    if (top == 0 || right == 0) return;
    for (int c = right; c > 0; --c) add_segment(node(top, c), node(top, c - 1));
    for (int r = top; r > 0; --r) add_segment(node(r, 0), node(r - 1, 0));
  }

  const Scene& scene_;
  const Lattice& lattice_;
  Parts& parts_;
  int first_;
  std::map<std::pair<int, int>, int> structural_;  // link by its nodes
};

}  // namespace

std::string to_string(LinkClass kind) {
  return kind == LinkClass::structural ? "structural" : kind == LinkClass::shear ? "shear" : "bending";
}

std::string Parts::node_name(int i) const {
  const LatticePart& owner = lattice[node.lattice[i]];
  return "node (row " + std::to_string(node.row[i]) + ", column " + std::to_string(node.column[i]) + ") of lattice " +
         (owner.name.empty() ? std::to_string(node.lattice[i]) : owner.name);
}

std::string Parts::body_name(int body) const {
  if (body < disc.count()) return "disc " + std::to_string(disc.number[body]);
  const auto found = std::find(node.body.begin(), node.body.end(), body);
  return node_name(static_cast<int>(found - node.body.begin()));
}

std::string Parts::link_name(int i) const {
  return to_string(link.kind[i]) + " link from " + node_name(link.a[i]) + " to " + node_name(link.b[i]);
}

Parts make_parts(const Scene& scene) {
  const DefaultFloatingPoint environment;
  std::vector<Lattice> lattices = scene.lattice;
  fill_stems(lattices, scene.material);
  Parts parts;
  parts.materials = static_cast<int>(scene.material.size());
  parts.law = laws_of(scene);
  add_discs(scene, parts);
  for (const Lattice& l : lattices) LatticeBuilder(scene, l, parts).build();
  for (const Wall& w : scene.wall) {
    const Vec2 normal = unit_vector(w.normal);
    parts.wall.push_back({w.point.x, w.point.y, normal.x, normal.y, index_of_material(scene, w.material), w.name});
  }
  for (const Plate& p : scene.plate) {
    if (!p.lower_edge)
      throw std::invalid_argument("plate '" + p.name + "' has no lower edge yet: prepare the scene first");
    parts.plate.push_back({p.left_edge, *p.lower_edge, p.width, p.height, p.velocity.x, p.velocity.y, p.ramp,
                           index_of_material(scene, p.material), p.name});
  }
  set_options(scene, parts);
  if (parts.tight_plates) join_plates(parts);
  if (parts.new_faces) add_inner_segments(parts);
  return parts;
}

}  // namespace furrow
