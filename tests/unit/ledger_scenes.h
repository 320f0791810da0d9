// Options of the model for tests of the energy ledger, and what a run leaves over of it.
#pragma once

#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "run/observe.h"
#include "scenes.h"

namespace furrow::test {

struct Option {
  const char* name;
  std::function<void(Scene&)> choose;
};

inline void PrintTo(const Option& option, std::ostream* out) { *out << option.name; }

inline void make_linear(Scene& scene) {
  scene.model.law = ForceLaw::linear;
  scene.contact.normal_stiffness = 2e4;      // N/m
  scene.contact.tangential_stiffness = 1e4;  // N/m
}

inline const std::vector<Option>& of_contacts() {
  const auto damped_by = [](auto set) {
    return [set](Scene& s) {
      s.contact.damping_factor.reset();
      set(s.contact);
    };
  };
  static const std::vector<Option> all{
      {"Hertz-Mindlin", [](Scene&) {}},
      {"rescaled Mindlin", [](Scene& s) { s.model.law = ForceLaw::rescaled_mindlin; }},
      {"linear", make_linear},
      {"restitution", damped_by([](auto& contact) { contact.restitution = 0.7; })},
      {"Tsuji's alpha", damped_by([](auto& contact) { contact.tsuji_alpha = 0.3; })},
      {"a dashpot", damped_by([](auto& contact) { contact.damping = 40; })},
      {"a dashpot, another along the tangent",
       damped_by([](auto& contact) { contact.damping = 40, contact.tangential_damping = 15; })},
      {"contacts that pull", [](Scene& s) { s.model.pull = true; }},
      {"no damping along the tangent", [](Scene& s) { s.model.slip_damping = false; }},
      {"less viscous after slip", [](Scene& s) { s.model.after_slip = AfterSlip::less_viscous; }},
      {"arm to half the overlap", [](Scene& s) { s.model.moment_arm = MomentArm::half_overlap; }},
      {"arm of the radius", [](Scene& s) { s.model.moment_arm = MomentArm::radius; }},
      {"no rolling friction", [](Scene& s) { s.model.rolling = Rolling::none; }},
      {"a rolling spring", [](Scene& s) { s.model.rolling = Rolling::spring; }},
      {"tight plates", [](Scene& s) { s.model.tight_plates = true; }},
      {"a plate on its ramp", [](Scene& s) { s.plate[0].ramp = 1; }},
  };
  return all;
}

inline const std::vector<Option>& of_lattices() {
  static const std::vector<Option> all{
      {"as it is", [](Scene&) {}},
      {"dampers on the whole velocity", [](Scene& s) { s.lattice[0].damper = Damper::full; }},
      {"new faces", [](Scene& s) { s.model.new_faces = true; }},
      {"weight", [](Scene& s) { s.model.gravity = 9.81, s.lattice[0].gravity = true; }},
      {"a driven row",
       [](Scene& s) {
         s.lattice[0].drive = {{.rows = {3}, .velocity = {0.01, 0.005}}};
       }},
      {"a driven row on its ramp",
       [](Scene& s) {
         s.lattice[0].drive = {{.rows = {3}, .velocity = {0.01, 0.005}, .ramp = 1}};
       }},
      {"rollers",
       [](Scene& s) {
         for (int column = 0; column < 3; ++column)
           s.lattice[0].node.push_back({.row = 1, .column = column, .fixed_x = true});
       }},
      {"a stem",
       [](Scene& s) {
         Lattice& l = s.lattice[0];
         l.structural = l.shear = l.bending = {};
         l.stem = Stem{.young = 1e6, .diameter = 0.2, .length = 0.4, .strength = 1e4, .damping_ratio = 0.02};
       }},
      {"links of their own",
       [](Scene& s) {
         s.lattice[0].link = {{.rows = {1, 2}, .stiffness_factor = 0.5}, {.columns = {0}, .damping = 5.0}};
       }},
      {"a notch",
       [](Scene& s) {
         s.lattice[0].link = {{.from = {1, 0}, .to = {2, 0}, .torn = true}};
       }},
      {"a load",
       [](Scene& s) {
         s.lattice[0].node[0].force = {3, 1};
       }},
  };
  return all;
}

// Discs are thrown at a wall, at each other and at a plate that comes; they turn, so they slide.
inline Scene thrown() {
  constexpr double radius = 0.1;  // m
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.3;
  scene.contact.friction = 0.3;
  scene.contact.rolling_friction = 0.1;
  scene.model.rolling_smoothing = 1;
  scene.wall = {wall({0, 0}, {1, 0})};
  scene.disc = {disc({1.05 * radius, 0}, radius, {-0.4, 0.1}, 5), disc({3.2 * radius, 0.01}, radius, {-0.5, 0.02}, -4)};
  scene.plate = {plate({4.25 * radius, -1}, 1, 2, {-0.05, 0.1})};
  return scene;
}

struct Left {
  double residual = 0, turned_over = 0;  // J
  Energies lost;                         // by the end
  int torn = 0;                          // links
};

inline Left left_over(const Scene& scene, const std::string& method, double step, double end) {
  System system(scene);
  State y = system.initial_state();
  const Energies start = observe(system, 0, y).energy;
  Left left;
  run(system, *make_method(method), y, {.start = 0, .end = end, .step = step, .stop = {}},
      [&](double, const State&, const JumpReport& jump) {
        left.torn += static_cast<int>(jump.torn.size());
        return true;
      });
  left.lost = observe(system, end, y).energy;
  left.residual = left.lost.residual(start);
  left.turned_over = start.live() + left.lost.lost() + std::fabs(left.lost.plate_work);
  return left;
}

}  // namespace furrow::test
