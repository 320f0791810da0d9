// A scene made ready: its parts, where its numbers stand in the flat state, and the solver that carries it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "system/ode.h"
#include "system/solver.h"
#include "system/surface.h"
#include "system/survey.h"

namespace furrow {

class System;

// A force of the caller's own. It adds accelerations to the rates of a state, [m/s^2] at vx_of and vy_of, [rad/s^2] at
// spin_of, and like rhs it is pure. Discs stand there as they are stored: parts().disc.number says which of the scene each
// is. The energy ledger does not know the force: its work stands in the residual.
struct OwnForce {
  std::function<void(const System& system, double t, const State& y, State& rates)> add;
  std::string velocity_dependence{};  // its name in messages if it depends on velocity; empty: it does not
};

// A value: a copy has a discrete state of its own. Several threads may call its const functions at once. rhs and jump
// are for the default floating-point environment: rounding to nearest, no traps (see floating_point.h); run() and
// prepare() see to it themselves.
class System : public OdeSystem {
 public:
  // With the scene's solver.
  explicit System(const Scene& scene);
  System(const System& other);
  System& operator=(const System& other);
  System(System&&) noexcept = default;
  System& operator=(System&&) noexcept = default;
  ~System() override = default;

  std::size_t size() const override { return static_cast<std::size_t>(layout().size()); }
  std::size_t positions() const override { return 2 * static_cast<std::size_t>(layout().bodies); }
  std::size_t lasting() const override { return static_cast<std::size_t>(layout().first_spring); }
  std::size_t controlled() const override { return static_cast<std::size_t>(layout().first_dummy()); }
  int threads() const override { return solver_->threads(); }
  std::string velocity_dependence() const override;
  void rhs(double t, const State& y, State& dydt) const override;

  // Acts from now on, in copies too. Before the first step.
  void add_force(OwnForce force) { own_.push_back(std::move(force)); }

  State initial_state() const;
  JumpReport jump(double t, State& y);

  DiscreteState discrete_state() const { return solver_->discrete_state(); }
  // Throws std::invalid_argument if it is not one of this scene's.
  void restore(const DiscreteState& discrete) { solver_->restore(discrete); }

  // Makes the room that a jump made in its state also in a state from before the jump.
  void fit(State& y) const;

  // While a scene is prepared its plates stand still and its links do not tear.
  void prepare(bool preparing) { solver_->prepare(preparing); }

  // From now on each jump surveys its contacts, see solver.h.
  void watch(bool watched) { solver_->watch(watched); }
  Survey& survey() { return solver_->survey(); }

  // Of each contact that touches, kind by kind, sorted by (a, b).
  void for_each_contact(double t, const State& y, const Solver::Visit& visit) const {
    solver_->for_each_contact(t, y, visit);
  }

  const Parts& parts() const { return solver_->parts(); }
  const Layout& layout() const { return solver_->layout(); }
  const Solver& solver() const { return *solver_; }
  bool torn(int link) const { return solver_->torn(link); }
  Face held_face(const ContactId& contact) const { return solver_->held_face(contact); }
  const std::vector<int>& border() const { return solver_->border(); }
  bool has_friction() const { return parts().friction; }
  bool has_rolling() const { return parts().rolling; }
  bool keeps_ledger() const { return parts().keeps_ledger; }
  double gravity() const { return parts().gravity; }
  double rolling_smoothing() const { return parts().rolling_smoothing; }

  int x_of(int body) const { return layout().x_of(body); }
  int y_of(int body) const { return layout().y_of(body); }
  int vx_of(int body) const { return layout().vx_of(body); }
  int vy_of(int body) const { return layout().vy_of(body); }
  int spin_of(int disc) const { return layout().spin_of(disc); }
  int first_spring() const { return layout().first_spring; }
  int spring_count() const { return layout().spring_count; }
  int ledger_of(Ledger entry) const { return layout().ledger_of(entry); }

  // rad/s. Where no contact has friction nothing turns a disc: it keeps the spin that the scene gave it, outside the
  // state.
  double spin(const State& y, int disc) const { return has_friction() ? y[spin_of(disc)] : parts().disc.spin[disc]; }
  PlateAt plate_at(int plate, double t) const {
    return furrow::plate_at(parts().plate[plate], t, solver_->preparing());
  }
  NodeMotion nodes(double t, const State& y) const;

  // 64-bit FNV-1a of the bits of positions, velocities, spins, springs and of which links are torn, and of the
  // faces of plates that bodies keep.
  std::uint64_t state_hash(const State& y) const;

 private:
  void add_own(double t, const State& y, State& rates) const {
    for (const OwnForce& force : own_) force.add(*this, t, y, rates);
  }

  std::unique_ptr<Solver> solver_;
  std::vector<OwnForce> own_;
};

}  // namespace furrow
