// Stabilised explicit Runge-Kutta-Chebyshev method RKC with error control: for systems whose stiffness is damping.
//
//   Y_0     = y_n
//   Y_1     = Y_0 + mu'_1 h F_0
//   Y_j     = (1 - mu_j - nu_j) Y_0 + mu_j Y_(j-1) + nu_j Y_(j-2) + mu'_j h F_(j-1) + gamma_j h F_0,  j = 2 ... s
//   F_j     = f(t_n + c_j h, Y_j)
//   y_(n+1) = Y_s
//   e       = 0.8 (y_n - y_(n+1)) + 0.4 h (F_0 + f(t_(n+1), y_(n+1)))
//
//   w0      = 1 + epsilon/s^2
//   w1      = T'_s(w0) / T''_s(w0)
//   b_j     = T''_j / T'_j^2,             b_0 = b_1 = b_2
//   a_j     = 1 - b_j T_j
//   mu_j    = 2 b_j w0 / b_(j-1)
//   mu'_j   = 2 b_j w1 / b_(j-1),         mu'_1 = b_1 w1
//   nu_j    = -b_j / b_(j-2)
//   gamma_j = -a_(j-1) mu'_j
//   c_j     = w1 T''_j / T'_j,            c_1 = c_2 / T'_2
//
// with Chebyshev's polynomials T_j, all taken at w0, and damping epsilon = 2/13. Order 2. Stable on the real axis for
// -0.65 (s^2 - 1) < h lambda < 0: a step ten times beyond the limit of an ordinary method costs three times as much,
// not ten. Not for undamped oscillations: the imaginary axis is left outside. Evaluations a step: s, one more after a
// jump, and those of the power iteration.
//
// s follows from the spectral radius, by a nonlinear power iteration whose vector is kept. It is a lower bound that has
// nearly converged, so a margin is added; an estimate that was too low shows as a large error, and is made again.
//
// Rejected: Ros2 as a W-method with the damping matrix of contacts and links, factorised by sparse LDL^T. In scenes 2
// and 3 it takes a third to an eighth of the evaluations at equal error, but an evaluation is so cheap that its solves
// make it 4 to 10 times as slow. Sources: Sommeijer, Shampine and Verwer 1997 (J. Comput. Appl. Math. 88, 315); van der
// Houwen and Sommeijer 1980.
#include <algorithm>
#include <cmath>

#include "methods/controlled.h"

namespace furrow {
namespace {

constexpr double epsilon = 2.0 / 13.0;
constexpr int most_stages = 1000;
constexpr int most_iterations = 12;
constexpr int steps_between_estimates = 25;
constexpr double margin = 1.2;                // of the estimated spectral radius
constexpr double relative_difference = 1e-7;  // of the power iteration's displacement to the state,
constexpr double least_norm = 1e-6;           // if the state is zero

// T_j, T'_j and T''_j at w0, one after the other.
struct Chebyshev {
  double w0;
  double t = 1, dt = 0, ddt = 0;
  double t_before = 0, dt_before = 0, ddt_before = 0;
  int j = 0;

  void next() {
    const double factor = j == 0 ? 1 : 2;
    const double t_next = factor * w0 * t - t_before;
    const double dt_next = factor * (t + w0 * dt) - dt_before;
    const double ddt_next = factor * (2 * dt + w0 * ddt) - ddt_before;
    t_before = t, dt_before = dt, ddt_before = ddt;
    t = t_next, dt = dt_next, ddt = ddt_next;
    ++j;
  }
  double b() const { return ddt / (dt * dt); }
};

double norm(const State& y) {
  double sum = 0;
  for (const double v : y) sum += v * v;
  return std::sqrt(sum);
}

class RungeKuttaChebyshev final : public ControlledMethod {
 public:
  explicit RungeKuttaChebyshev(const Tolerances& tolerances)
      : ControlledMethod({"rkc", "Runge-Kutta-Chebyshev, stages by the stiffness, controlled", 2, 0, true},
                         tolerances) {}

  void restart() override {
    ControlledMethod::restart();
    fresh_ = false;
    age_ = stale;
    vector_.clear();
  }
  void state_changed() override { fresh_ = false; }

 protected:
  void prepare(const OdeSystem& system, double t, const State& y) override {
    if (!fresh_) evaluate_start(system, t, y, now_);
    fresh_ = true;
  }

  void attempt(const OdeSystem& system, double t, const State& y, double h) override {
    if (age_ >= steps_between_estimates) estimate_radius(system, t, y);
    age_ = stale;  // until the step is accepted
    const int stages =
        1 + static_cast<int>(std::sqrt(std::min(1 + 1.54 * h * radius_, 4.0 * most_stages * most_stages)));
    if (stages > most_stages) throw Divergence("too stiff");
    run_stages(system, t, y, h, std::max(stages, 2));
    evaluate(system, t + h, next_, ahead_);
    for (std::size_t i = 0; i < y.size(); ++i) error_[i] = 0.8 * (y[i] - next_[i]) + 0.4 * h * (now_[i] + ahead_[i]);
  }

  void accept(double /*h*/) override {
    now_.swap(ahead_);
    age_ = ++steps_since_estimate_;
  }

 private:
  static constexpr int stale = steps_between_estimates;

  void remember(HistoryVisitor& visit) override {
    ControlledMethod::remember(visit);
    visit("fresh", fresh_);
    visit("rates", now_);
    visit("radius", radius_);
    visit("age", age_);
    visit("steps since estimate", steps_since_estimate_);
    visit("vector", vector_);
  }

  // Leaves Y_s in next_.
  void run_stages(const OdeSystem& system, double t, const State& y, double h, int s) {
    const double w0 = 1 + epsilon / (static_cast<double>(s) * s);
    Chebyshev last{w0};
    while (last.j < s) last.next();
    const double w1 = last.dt / last.ddt;
    Chebyshev p{w0};
    p.next();
    p.next();
    double b_1 = p.b(), b_2 = p.b();  // b_(j-1), b_(j-2)
    double a_1 = 1 - b_1 * w0;        // a_(j-1)
    double c = w1 * p.ddt / p.dt / p.dt;
    const std::size_t n = y.size();
    for (State* room : {&before_, &rate_, &ahead_}) room->resize(n);
    before_ = y;
    for (std::size_t i = 0; i < n; ++i) next_[i] = y[i] + b_1 * w1 * h * now_[i];
    for (int j = 2; j <= s; ++j, p.next()) {
      evaluate(system, t + c * h, next_, rate_);
      const double b = p.b();
      const double mu = 2 * b * w0 / b_1, nu = -b / b_2;
      const double on_rate = 2 * b * w1 / b_1 * h, on_first = -a_1 * on_rate;
      for (std::size_t i = 0; i < n; ++i) {
        const double stage =
            (1 - mu - nu) * y[i] + mu * next_[i] + nu * before_[i] + on_rate * rate_[i] + on_first * now_[i];
        before_[i] = next_[i];
        next_[i] = stage;
      }
      b_2 = b_1;
      b_1 = b;
      a_1 = 1 - b * p.t;
      c = w1 * p.ddt / p.dt;
    }
  }

  // v <- f(y + v) - f(y), kept short, turns into the direction that f stretches most. The geometric mean of two
  // successive stretchings is the modulus of the eigenvalue also where an oscillation makes them swing.
  void estimate_radius(const OdeSystem& system, double t, const State& y) {
    const std::size_t counted = system.controlled();
    if (vector_.size() != y.size()) vector_ = now_;
    for (State* room : {&stage_, &rate_}) room->resize(y.size());
    const double length = relative_difference * std::max(norm(y), least_norm);
    double stretch = 0;
    radius_ = 0;
    for (int k = 0; k < most_iterations; ++k) {
      std::fill(vector_.begin() + static_cast<std::ptrdiff_t>(counted), vector_.end(), 0.0);
      double size = norm(vector_);
      if (size == 0) {  // nothing moves, or f does not depend on this direction
        std::fill_n(vector_.begin(), system.lasting(), 1.0);
        size = norm(vector_);
      }
      for (std::size_t i = 0; i < y.size(); ++i) stage_[i] = y[i] + vector_[i] * (length / size);
      evaluate(system, t, stage_, rate_);
      for (std::size_t i = 0; i < counted; ++i) vector_[i] = rate_[i] - now_[i];
      const double stretch_before = stretch;
      stretch = norm(vector_) / length;
      const double before = radius_;
      radius_ = margin * std::sqrt(stretch * (k > 0 ? stretch_before : stretch));
      if (!std::isfinite(radius_)) throw Divergence("a rate is not finite");
      if (k > 1 && std::fabs(radius_ - before) <= 0.05 * radius_) break;
    }
    steps_since_estimate_ = 0;
  }

  bool fresh_ = false;  // now_ is f at the present state
  double radius_ = 0;   // 1/s
  int age_ = stale;     // accepted steps since the estimate
  int steps_since_estimate_ = 0;
  State ahead_, before_, stage_, rate_, vector_;
};

std::unique_ptr<Method> make_runge_kutta_chebyshev(const Tolerances& tolerances) {
  return std::make_unique<RungeKuttaChebyshev>(tolerances);
}

}  // namespace

FURROW_METHODS(runge_kutta_chebyshev) { add_method(catalogue, make_runge_kutta_chebyshev); }

}  // namespace furrow
