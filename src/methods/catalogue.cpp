#include <stdexcept>

#include "methods/method.h"
#include "methods/odeint.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr std::size_t most_unknowns = 200;  // above it a dense Jacobian costs more than it gains

using Maker = std::unique_ptr<Method> (*)(const Tolerances&);

// One a line, so that additions do not meet.
// clang-format off
constexpr Maker own[] = {
    make_pece,
    make_pec,
    make_pecece,
    make_pece_adaptive,
    make_adams_bashforth_2,
    make_symplectic_euler,
    make_verlet,
    make_runge_kutta_4,
    make_runge_kutta_chebyshev,
};
// clang-format on

std::vector<MethodEntry> all_entries() {
  std::vector<MethodEntry> list;
  for (const Maker make : own) list.push_back({make({})->info(), make});
  for (const auto& part : {odeint_fixed_methods(), odeint_controlled_methods(), odeint_implicit_methods()})
    list.insert(list.end(), part.begin(), part.end());
  return list;
}

const std::vector<MethodEntry>& entries() {
  static const std::vector<MethodEntry> all = all_entries();
  return all;
}

}  // namespace

const std::vector<MethodInfo>& method_catalogue() {
  static const std::vector<MethodInfo> all = [] {
    std::vector<MethodInfo> list;
    for (const MethodEntry& entry : entries()) list.push_back(entry.info);
    return list;
  }();
  return all;
}

std::unique_ptr<Method> make_method(const std::string& name, const Tolerances& tolerances) {
  std::vector<std::string> known;
  for (const MethodEntry& entry : entries()) {
    if (entry.info.name == name) return entry.make(tolerances);
    known.push_back(entry.info.name);
  }
  throw std::invalid_argument("no method '" + name + "'" + did_you_mean(name, known) + "; see furrow methods");
}

std::string refusal(const MethodInfo& method, const OdeSystem& system) {
  if (const std::string what = system.velocity_dependence(); method.conservative && !what.empty())
    return "the method " + method.name + " cannot carry forces that depend on velocity; here these do: " + what +
           ". Take another method, or set their coefficients to zero";
  if (method.dense_jacobian && system.controlled() > most_unknowns)
    return "the method " + method.name + " solves a dense system and takes at most " + std::to_string(most_unknowns) +
           " numbers of state; the scene has " + std::to_string(system.controlled()) + ". Take another method";
  return {};
}

}  // namespace furrow
