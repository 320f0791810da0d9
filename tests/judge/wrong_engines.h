// Engines that are wrong on purpose, each by one thing: the independent one given another case than was asked for, carried
// by another method than it claims, or with another rule for its springs.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "verification/engines/independent.h"
#include "verification/engines/judge.h"

namespace furrow::test {

using verification::AfterSlip;
using verification::Engine;
using verification::Json;
using verification::Stepper;

struct WrongEngine {
  std::string name, found_by;  // the case that tells it from the right one
  Engine answer;
};

inline const Stepper& stepper_named(const std::string& name) {
  for (const Stepper& stepper : verification::odeint_steppers()) {
    if (stepper.name == name) return stepper;
  }
  throw std::invalid_argument(name);
}

inline Json independent(const Json& request) { return independent_answer(request, stepper_named("rk4")); }

using Edit = std::function<void(Json& whole)>;

inline WrongEngine with_another_case(const std::string& name, const std::string& found_by, const Edit& edit) {
  return {name, found_by, [edit](const Json& request) {
            Json other = request;
            edit(other["case"]);
            return independent(other);
          }};
}

inline WrongEngine with_another_rule(const std::string& name, const std::string& found_by, AfterSlip rule) {
  return {name, found_by,
          [rule](const Json& request) { return independent_answer(request, stepper_named("rk4"), rule); }};
}

inline WrongEngine claiming(const std::string& name, const std::string& found_by, int order,
                            const std::string& method) {
  return {name, found_by, [order, method](const Json& request) {
            Json answer = independent_answer(request, stepper_named(method));
            answer["order"] = order;
            return answer;
          }};
}

// Velocity Verlet whose forces are those of the step before.
inline WrongEngine one_step_late() {
  return {"forces one step late", "spring", [](const Json& request) {
            auto before = std::make_shared<verification::Numbers>();
            const Stepper late{"late", 2, [before](const auto& rates, verification::Numbers& y, double t, double h) {
                                 verification::Numbers old(y.size()), now(y.size());
                                 rates(before->empty() ? y : *before, old, t);
                                 *before = y;
                                 for (std::size_t i = 0; i < y.size(); ++i) {
                                   if (i % 5 > 1) y[i] += h * old[i];
                                 }
                                 rates(y, now, t + h);
                                 for (std::size_t i = 0; i < y.size(); ++i) {
                                   if (i % 5 < 2) y[i] += h * now[i];
                                 }
                               }};
            return independent_answer(request, late);
          }};
}

inline Edit scale(const char* list, const char* key, double factor) {
  return [=](Json& c) {
    for (Json& one : c[list]) one[key] = one[key].get<double>() * factor;
  };
}
inline Edit set_contact(const char* key, const Json& value) {
  return [=](Json& c) { c["contact"][key] = value; };
}
inline Edit only_at_walls(const Edit& edit) {
  return [=](Json& c) {
    if (!c["wall"].empty()) edit(c);
  };
}
inline Edit without_springs(const char* kind) {
  return [=](Json& c) {
    Json left = Json::array();
    for (const Json& spring : c["spring"]) {
      if (spring["kind"] != kind) left.push_back(spring);
    }
    c["spring"] = left;
  };
}
inline void diagonals_too_stiff(Json& c) {
  for (Json& spring : c["spring"]) {
    if (spring["kind"] == "shear") spring["stiffness"] = spring["stiffness"].get<double>() * 1.01;
  }
}
inline void spheres_for_discs(Json& c) {
  for (Json& body : c["body"])
    body["inertia"] = 0.4 * body["mass"].get<double>() * std::pow(body["radius"].get<double>(), 2);
}
inline void bending_as_strong(Json& c) {
  for (Json& spring : c["spring"]) {
    if (spring["kind"] == "bending" && spring.contains("strength")) spring["strength"] = 3.0;  // N, of own_strength
  }
}
inline void nothing_tears(Json& c) {
  for (Json& spring : c["spring"]) spring.erase("strength");
}

inline std::vector<WrongEngine> wrong_engines() {
  return {
      with_another_case("E* of walls too high by 1 + nu", "hertz_wall_of_the_same",
                        only_at_walls(scale("pair", "modulus", 1.3))),
      with_another_case("R* of walls half as great", "hertz_wall",
                        only_at_walls(scale("pair", "modulus", std::sqrt(0.5)))),
      with_another_case("shear modulus of an incompressible body", "sticking_sphere",
                        scale("pair", "shear_modulus", 1.1)),
      with_another_rule("spring kept after slip", "partial_slip_elastic", AfterSlip::stays),
      with_another_rule("spring of limit less damper", "partial_slip_10", AfterSlip::holds),
      with_another_case("torque at R", "slide_to_roll_short_arm", set_contact("moment_arm", "radius")),
      with_another_case("torque at R - d", "sticking_sphere", set_contact("moment_arm", "contact_point")),
      one_step_late(),
      claiming("Euler that claims order 2", "spring", 2, "euler"),
      with_another_case("damping without sqrt(5/6)", "restitution_70_clipped",
                        [](Json& c) { c["contact"]["beta"] = c["contact"]["beta"].get<double>() * std::sqrt(1.2); }),
      with_another_case("always pulls", "restitution_30_clipped", set_contact("pull", true)),
      with_another_case("never pulls", "restitution_30_pull", set_contact("pull", false)),
      with_another_case("always damps the slip", "partial_slip_10_undamped_tangent",
                        set_contact("tangential_damping", true)),
      with_another_case("never damps the slip", "partial_slip_10", set_contact("tangential_damping", false)),
      with_another_case("friction one per cent too high", "gross_slip_elastic",
                        [](Json& c) { c["contact"]["friction"] = c["contact"]["friction"].get<double>() * 1.01; }),
      with_another_case("spheres for discs", "sticking_disc", spheres_for_discs),
      with_another_case("no rolling friction", "rolling_decay", set_contact("rolling_friction", 0.0)),
      with_another_case("springs one per mille too long", "spring", scale("spring", "length", 1.001)),
      with_another_case("no bending springs", "cantilever", without_springs("bending")),
      with_another_case("no diagonal springs", "own_strength", without_springs("shear")),
      with_another_case("diagonal springs one per cent too stiff", "lattice_dispersion", diagonals_too_stiff),
      with_another_case("bending springs as strong as structural ones", "own_strength", bending_as_strong),
      with_another_case("a bed without friction", "bed_pushed_far", set_contact("friction", 0.0)),
      with_another_case("no damping along springs", "damped_spring", scale("spring", "damping", 0)),
      with_another_case("nothing tears", "tear_by_impulse", nothing_tears)};
}

}  // namespace furrow::test
