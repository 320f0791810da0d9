// Symplectic (semi-implicit) Euler, the usual method of discrete element programs.
//
//   v_(n+1) = v_n + h a(t_n, q_n, v_n),  z likewise
//   q_(n+1) = q_n + h v_(n+1)
//
// Order 1, one evaluation a step. Symplectic without damping, and stable to h omega = 2; with the damping ratio zeta to
// h omega = 2 (sqrt(1 + zeta^2) - zeta); on the real axis, of z, to 2. Source: de Vogelaere 1956; Hairer, Lubich and
// Wanner, Geometric Numerical Integration, I.1.2.
#include "kernel/passes.h"
#include "methods/method.h"

namespace furrow {
namespace {

class SymplecticEuler final : public Method {
 public:
  SymplecticEuler() : Method({"symplectic_euler", "velocities first, then positions with them", 1, 1, false}) {}

  double step(const OdeSystem& system, double t, State& y, double h) override {
    const std::size_t q = system.positions();
    const int threads = system.threads();
    now_.resize(y.size());
    next_.resize(y.size());
    evaluate_start(system, t, y, now_);
    advance(threads, y.data() + q, h, now_.data() + q, next_.data() + q, y.size() - q);
    advance(threads, y.data(), h, next_.data() + q, next_.data(), q);
    y.swap(next_);
    return h;
  }

  const State* start() const override { return &next_; }

 private:
  State now_, next_;
};

std::unique_ptr<Method> make_symplectic_euler(const Tolerances& /*tolerances*/) {
  return std::make_unique<SymplecticEuler>();
}

}  // namespace

FURROW_METHODS(symplectic_euler) { add_method(catalogue, make_symplectic_euler); }

}  // namespace furrow
