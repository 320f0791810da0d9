// A scene with a discrete state as two functions: the flow between events, and the jump that is applied once after each
// accepted step. There are two solvers, and they give the same bits: the reference, written to be read, and the kernel,
// written to be fast.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "system/contact.h"
#include "system/discrete.h"
#include "system/layout.h"

namespace furrow {

class Solver {
 public:
  virtual ~Solver() = default;
  virtual std::unique_ptr<Solver> clone() const = 0;

  // The rates of the state: pure for a fixed discrete state. dydt has the size of y already.
  virtual void flow(double t, const State& y, State& dydt) const = 0;

  virtual JumpReport jump(double t, State& y) = 0;

  // Of each contact that touches, kind by kind, sorted by (a, b).
  using Visit = std::function<void(const Contact&)>;
  virtual void for_each_contact(double t, const State& y, const Visit& visit) const = 0;

  virtual DiscreteState discrete_state() const = 0;
  // Throws std::invalid_argument if it is not one of this scene's.
  virtual void restore(const DiscreteState& discrete) = 0;

  virtual bool torn(int link) const = 0;
  virtual Face held_face(const ContactId& contact) const = 0;
  virtual const std::vector<int>& border() const = 0;  // segments that discs touch, see system/border.h
  virtual bool preparing() const = 0;
  virtual void prepare(bool preparing) = 0;

  // From now on each jump surveys its contacts. Without friction it has to evaluate them for that, at the state where
  // most methods begin their next step and do so anyway.
  virtual void watch(bool watched) = 0;
  virtual Survey& survey() = 0;

  virtual int threads() const { return 1; }
  const Layout& layout() const { return layout_; }
  const Parts& parts() const { return *parts_; }

 protected:
  Solver(std::shared_ptr<const Parts> parts, const Layout& layout) : parts_(std::move(parts)), layout_(layout) {}
  Solver(const Solver&) = default;
  Solver& operator=(const Solver&) = default;
  Solver(Solver&&) = default;
  Solver& operator=(Solver&&) = default;

  std::shared_ptr<const Parts> parts_;
  Layout layout_;
};

}  // namespace furrow
