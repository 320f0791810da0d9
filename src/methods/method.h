// An integration method as the rest of furrow sees it, and the catalogue of methods by name.
#pragma once

#include <cmath>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "system/history.h"
#include "system/ode.h"

namespace furrow {

struct MethodInfo {
  std::string name;  // as in `furrow run --method NAME`
  std::string title;
  int order = 0;        // for a smooth right-hand side
  int evaluations = 0;  // of f a step, started and without rejections
  bool controlled = false;
  std::string family = "own";
  bool conservative = false;    // only for systems without forces that depend on velocity
  bool dense_jacobian = false;  // by differences: one more evaluation for each number of the state
};

// Why the method cannot integrate the system, and what to do; empty if it can.
std::string refusal(const MethodInfo& method, const OdeSystem& system);

struct Tolerances {
  double relative = 1e-6;
  double absolute = 1e-9;    // m, m/s, rad/s
  double first_step = 1e-4;  // s
};

class Method {
 public:
  virtual ~Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  // Carries y from t over h, or, for a controlled method, over the step that it chooses, at most h; returns it (s).
  // Throws Divergence if no step could be made; y is then as before.
  virtual double step(const OdeSystem& system, double t, State& y, double h) = 0;

  // The right-hand side has jumped: the method must forget its history.
  virtual void restart() {}

  // Only the state has changed: tangential or rolling springs were shortened to their limits. Where a contact slides
  // its force stays the same; where its damper still held it, the force changes by what the damper held, which shrinks
  // with the step. The rates of the ledger change too.
  virtual void state_changed() {}

  // Hands over the rates at the start of the next step, once for each step, if the caller knows them; the method saves
  // that evaluation, but counts it. `rates` gets other contents.
  void know(double t, State& rates) {
    known_at_ = t;
    known_.swap(rates);
  }
  void know_nothing() { known_at_ = NAN; }

  // The state that the last step started from, if the method keeps it: then y changes only when a step succeeds.
  virtual const State* start() const { return nullptr; }

  // All that is carried from one step to the next.
  void history(HistoryVisitor& visit) {
    visit("evaluations", evaluations_);
    visit("rejections", rejections_);
    visit("known at", known_at_);
    if (!std::isnan(known_at_)) visit("known rates", known_);
    remember(visit);
  }

  const MethodInfo& info() const { return info_; }
  long evaluations() const { return evaluations_; }
  long rejections() const { return rejections_; }

 protected:
  explicit Method(MethodInfo info) : info_(std::move(info)) {}
  void evaluate(const OdeSystem& system, double t, const State& y, State& dydt) {
    ++evaluations_;
    system.rhs(t, y, dydt);
  }

  // The same, for the state that a step starts from.
  void evaluate_start(const OdeSystem& system, double t, const State& y, State& dydt) {
    if (t != known_at_ || known_.size() != y.size()) return evaluate(system, t, y, dydt);
    ++evaluations_;
    dydt.swap(known_);
    know_nothing();
  }

  MethodInfo info_;
  long evaluations_ = 0;
  long rejections_ = 0;

 private:
  // The method's own part of its history, without what each step overwrites before it is read.
  virtual void remember(HistoryVisitor& /*visit*/) {}

  State known_;
  double known_at_ = NAN;  // s
};

struct MethodEntry {
  MethodInfo info;
  std::function<std::unique_ptr<Method>(const Tolerances&)> make;
};

// All methods, own ones first: those of each file of this folder, and what has been registered from outside.
// References into it stay valid, also when a method is registered.
const std::deque<MethodInfo>& method_catalogue();

// Throws std::invalid_argument that names the nearest one if there is no such method.
std::unique_ptr<Method> make_method(const std::string& name, const Tolerances& tolerances = {});

// Registers a method from outside; must be called before other threads ask for methods. Throws
// std::invalid_argument if its name is taken.
void register_method(const MethodEntry& entry);

// A method of this folder enters the catalogue at the end of its file; the build finds it there.
//   FURROW_METHODS(name_of_the_file) { add_method(catalogue, make_my_method); }
#define FURROW_METHODS(file) void methods_of_##file(std::vector<MethodEntry>& catalogue)

// make: std::unique_ptr<Method>(const Tolerances&). A fixed-step method takes no notice of the tolerances.
template <class Make>
void add_method(std::vector<MethodEntry>& catalogue, Make make) {
  catalogue.push_back({make({})->info(), make});
}

}  // namespace furrow
