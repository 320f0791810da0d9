#include "run/system.h"

#include <algorithm>
#include <bit>

#include "kernel/kernel.h"
#include "reference/reference.h"
#include "scene/hash.h"
#include "scene/interrupt.h"
#include "system/floating_point.h"

namespace furrow {
namespace {

std::unique_ptr<Solver> make_solver(const Scene& scene) {
  const DefaultFloatingPoint environment;
  auto parts = std::make_shared<const Parts>(make_parts(scene));
  if (scene.time.solver == SolverKind::reference) return std::make_unique<reference::Reference>(std::move(parts));
  return std::make_unique<Kernel>(std::move(parts), scene.search);
}

}  // namespace

System::System(const Scene& scene) : solver_(make_solver(scene)) {}

System::System(const System& other) : OdeSystem(other), solver_(other.solver_->clone()), own_(other.own_) {}

System& System::operator=(const System& other) {
  solver_ = other.solver_->clone();
  own_ = other.own_;
  return *this;
}

void System::rhs(double t, const State& y, State& dydt) const {
  throw_if_interrupt_is_urgent();
  solver_->flow(t, y, dydt);
  add_own(t, y, dydt);
}

// The rates that a solver hands over, for the next step to begin with, are its own.
JumpReport System::jump(double t, State& y) {
  JumpReport report = solver_->jump(t, y);
  if (report.rates) add_own(t, y, *report.rates);
  return report;
}

State System::initial_state() const { return furrow::initial_state(parts(), layout()); }

void System::fit(State& y) const {
  Growth{size() - y.size(), static_cast<std::size_t>(layout().size() - layout().first_dummy())}.apply(y);
}

NodeMotion System::nodes(double t, const State& y) const {
  NodeMotion nodes = nodes_at_rest(parts());
  move_nodes(parts(), layout(), t, solver_->preparing(), y, nodes);
  return nodes;
}

std::string System::velocity_dependence() const {
  const Parts& p = parts();
  std::string what;
  const auto add = [&what](bool depends, const std::string& name) {
    if (depends) what += (what.empty() ? "" : ", ") + name;
  };
  const bool touchable = p.disc.count() > 0 || !p.wall.empty() || !p.plate.empty();
  const auto damped = [](const ContactLaw& law) { return law.viscosity > 0 || law.options.dashpot > 0; };
  add(touchable && std::any_of(p.law.begin(), p.law.end(), damped), "damping of contacts");
  add(touchable && p.friction, "friction of contacts");
  for (std::size_t k = 0; k < p.lattice.size(); ++k) {
    bool any = false;
    for (int link = 0; link < p.link.count(); ++link)
      any = any || (p.link.damping[link] > 0 && p.node.lattice[p.link.a[link]] == static_cast<int>(k));
    add(any, "damping of the links of lattice " + p.lattice[k].name);
  }
  for (const OwnForce& force : own_) add(!force.velocity_dependence.empty(), force.velocity_dependence);
  return what;
}

std::uint64_t System::state_hash(const State& y) const {
  Fnv1a hash;
  const int springs = layout().first_spring;
  for (int k = 0; k < springs; ++k) hash.add_word(std::bit_cast<std::uint64_t>(y[k]));
  for (int k = 0; k < layout().first_dummy() - springs; ++k) {  // how much room there is for more does not count
    if (y[springs + k] == 0) continue;
    hash.add_word(static_cast<std::uint64_t>(k));
    hash.add_word(std::bit_cast<std::uint64_t>(y[springs + k]));
  }
  for (int k = 0; k < parts().link.count(); ++k) hash.add_word(torn(k) ? 1 : 0);
  if (!parts().tight_plates) return hash.value();
  for (const HeldFace& f : discrete_state().faces) {
    for (const int number : {f.kind, f.a, f.b, static_cast<int>(f.face)})
      hash.add_word(static_cast<std::uint64_t>(number));
  }
  return hash.value();
}

}  // namespace furrow
