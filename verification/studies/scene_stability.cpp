#include "verification/studies/scene_stability.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <random>

#include "run/observe.h"
#include "run/prepare.h"
#include "run/run.h"
#include "verification/studies/amplification.h"
#include "verification/studies/growth.h"

namespace furrow::verification {
namespace {

constexpr double still = 1e-6;  // of the largest eigenvalue: below it, rigid motion
constexpr double hair = 1e-11;  // m: small against overlaps, large against round-off
constexpr double fine = 2e-3;   // of a limit found by bisection
constexpr int frozen_steps = 2000;

// The largest h that is not bad: near the guess, or outwards from it. 0 and infinity if there is none.
double by_bisection(const std::function<bool(double)>& bad, double guess) {
  constexpr double nearby = 1.1, stride = 1.5, far = 1e3;
  double good = guess / nearby;
  double worse = guess * nearby;
  while (bad(good)) {
    worse = good;
    good /= stride;
    if (good < guess / far) return 0;
  }
  while (worse > guess && !bad(worse)) {  // below the guess it is known to be bad
    good = worse;
    worse *= stride;
    if (worse > guess * far) return infinity;
  }
  while (worse - good > fine * worse) {
    const double middle = 0.5 * (good + worse);
    (bad(middle) ? worse : good) = middle;
  }
  return 0.5 * (good + worse);
}

// Deviations from a state that does not move: y0 + e, at t0 for ever.
class Frozen final : public OdeSystem {
 public:
  Frozen(const System& system, double t, const State& y) : system_(system), t_(t), y_(y), moved_(y), still_(y.size()) {
    system.rhs(t, y, still_);
  }
  std::size_t size() const override { return y_.size(); }
  std::size_t positions() const override { return system_.positions(); }
  std::size_t controlled() const override { return system_.controlled(); }
  void rhs(double /*t*/, const State& e, State& dedt) const override {
    for (std::size_t i = 0; i < e.size(); ++i) moved_[i] = y_[i] + e[i];
    system_.rhs(t_, moved_, dedt);
    for (std::size_t i = 0; i < e.size(); ++i) dedt[i] -= still_[i];
  }

 private:
  const System& system_;
  double t_;
  const State& y_;
  mutable State moved_;
  State still_;
};

// Displacements, and velocities as the displacements of one time scale of the fastest motion.
double size_of(const Standing& s, const State& e) {
  const double rate = std::abs(s.fastest);
  const auto n = static_cast<std::size_t>(s.linearised.positions);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += e[i] * e[i] + e[n + i] * e[n + i] / (rate * rate);
  return std::sqrt(sum);
}

// Displacements and spins alone: a velocity would carry slow modes far before they turn, which looks like growth.
State random_hair(const Standing& s) {
  State e(s.y.size(), 0.0);
  std::mt19937_64 random(2);
  for (const int place : s.linearised.acting) e[place] = hair * std::uniform_real_distribution(-1.0, 1.0)(random);
  const auto n = static_cast<std::ptrdiff_t>(s.linearised.positions);
  std::fill(e.begin() + n, e.begin() + 2 * n, 0.0);
  return e;
}

// Sizes of the change in a step, not of the deviation itself: in that, slow motions of the scene hide what grows. Less
// the growth that is the scene's own.
template <class Watch>
void watch_frozen(const Standing& s, const std::string& name, double h, const Watch& go_on) {
  const Frozen frozen(s.system, s.t, s.y);
  const auto method = make_method(name);
  State e = random_hair(s);
  State change = e;
  for (int n = 0; n < frozen_steps; ++n) {
    change = e;
    method->step(frozen, 0, e, h);
    for (std::size_t i = 0; i < e.size(); ++i) change[i] = e[i] - change[i];
    if (!go_on(n, size_of(s, change) * std::exp(-s.own_growth * h * n))) break;
  }
}

// A bed whose weight hangs on a few contacts may give way: what grows so, at steps that resolve everything, is motion.
double own_growth(const Standing& s) {
  const double h = 0.5 / std::abs(s.fastest);
  constexpr int quarter = frozen_steps / 4;
  double third = 0, last = 0;
  watch_frozen(s, "rk4", h, [&](int n, double size) {
    if (n >= 2 * quarter) (n < 3 * quarter ? third : last) = std::max(n < 3 * quarter ? third : last, size);
    return true;
  });
  const double growth = std::log(last / third) / quarter;
  return growth > growth_in_scenes ? growth / h : 0;
}

// e' = J e, of the numbers that act.
class Linear final : public OdeSystem {
 public:
  explicit Linear(const Linearised& l) : l_(l) {}
  std::size_t size() const override { return static_cast<std::size_t>(l_.rates.rows()); }
  std::size_t positions() const override { return static_cast<std::size_t>(l_.positions); }
  void rhs(double /*t*/, const State& e, State& dedt) const override {
    const auto n = static_cast<Eigen::Index>(e.size());
    Eigen::Map<Eigen::VectorXd>(dedt.data(), n) = l_.rates * Eigen::Map<const Eigen::VectorXd>(e.data(), n);
  }

 private:
  const Linearised& l_;
};

// Growth of the method's own steps on the whole Jacobian, by iteration.
bool linear_form_grows(const Standing& s, const std::string& name, double h) {
  const Linear linear(s.linearised);
  const State all = random_hair(s);
  State e;
  for (const int place : s.linearised.acting) e.push_back(all[place]);
  const auto method = make_method(name);
  const auto motion = static_cast<Eigen::Index>(2 * linear.positions());
  Growth growth(frozen_steps, growth_in_scenes);
  for (int step = 0; step < frozen_steps; ++step) {
    const State before = e;
    method->step(linear, step * h, e, h);
    const double size =
        (Eigen::Map<const Eigen::VectorXd>(e.data(), motion) - Eigen::Map<const Eigen::VectorXd>(before.data(), motion))
            .norm();
    if (!growth.add(size * std::exp(-s.own_growth * h * step))) break;
  }
  return growth.seen();
}

// The rim of the stable region, by direction from the imaginary axis to the negative real one; of a method once.
constexpr int directions = 90;
const std::vector<double>& rim_of(const std::string& method, double growth) {
  static std::mutex mutex;
  static std::map<std::pair<std::string, double>, std::vector<double>> known;
  const std::scoped_lock lock(mutex);
  const auto [found, fresh] = known.try_emplace({method, growth});
  for (int k = 0; fresh && k <= directions; ++k) {
    const double angle = std::numbers::pi * (0.5 + 0.5 * k / directions);
    found->second.push_back(largest_stable_radius(method, std::polar(1.0, angle), growth, 1e3));
  }
  return found->second;
}

// s, the least of r(arg lambda)/|lambda|; which eigenvalue. The rim is tabulated to sort the eigenvalues, then computed
// at those that come first.
std::pair<double, std::complex<double>> limit_by_spectrum(const Eigen::VectorXcd& values, const std::string& method,
                                                          double growth = growth_in_scenes) {
  const std::vector<double>& rim = rim_of(method, growth);
  const double largest = values.cwiseAbs().maxCoeff();
  std::vector<std::pair<double, std::complex<double>>> limits;
  for (const std::complex<double>& value : values) {
    if (std::abs(value) <= still * largest) continue;
    const double place = (std::arg(std::complex(value.real(), std::fabs(value.imag()))) / std::numbers::pi - 0.5) * 2;
    const int k = std::clamp(static_cast<int>(std::lround(place * directions)), 0, directions);
    limits.emplace_back(rim[k] / std::abs(value), value);
  }
  const auto sooner = [](const auto& a, const auto& b) { return a.first < b.first; };
  const std::size_t first = std::min<std::size_t>(limits.size(), 12);
  std::partial_sort(limits.begin(), limits.begin() + static_cast<std::ptrdiff_t>(first), limits.end(), sooner);
  limits.resize(first);
  if (limits.empty()) return {infinity, 0};
  for (auto& [limit, value] : limits) limit = largest_stable_radius(method, value, growth, 1e3) / std::abs(value);
  return *std::min_element(limits.begin(), limits.end(), sooner);
}

}  // namespace

Standing standing(System system, double t, State y, Eigen::Index dense) {
  Standing s{std::move(system), t, std::move(y)};
  s.linearised = linearise(s.system, t, s.y);
  s.values = spectrum(s.linearised, dense);
  s.fastest = limit_by_spectrum(s.values, "pece").second;
  if (s.fastest == 0.0) return s;
  s.driver = driver_of(s.system, t, s.y, s.linearised, eigenvector(s.linearised, s.fastest), s.fastest);
  if (s.driver.name.empty()) {  // contacts that begin just here: a stiffness of differences alone
    s.fastest = 0;
    return s;
  }
  s.own_growth = own_growth(s);
  return s;
}

Standing standing_at(Scene scene, double t, const std::function<bool(double, double)>& progress) {
  scene.output.energy = true;
  Prepared p = prepare(scene, [&](double done, double) { return !progress || progress(done, scene.settle->limit); });
  if (t > 0) {
    Validity validity(p.system, scene, [](const std::string&) {});
    const RunPlan plan{.start = 0, .end = t, .step = scene.time.step, .stop = {}, .validity = &validity};
    const auto method = make_method(scene.time.method, {scene.time.relative_tolerance, scene.time.absolute_tolerance});
    const RunEnd end = run(p.system, *method, p.y, plan,
                           [&](double now, const State&, const JumpReport&) { return !progress || progress(now, t); });
    if (end.ending == Ending::stopped) throw Interrupted("interrupted");
    if (end.ending != Ending::finished) throw Divergence(end.reason);  // or the run is no scene to be linearised
  }
  return standing(std::move(p.system), t, std::move(p.y));
}

double predicted_step(const Standing& s, const std::string& method, double growth) {
  if (make_method(method)->info().controlled) return NAN;
  if (s.fastest == 0.0) return infinity;
  if (acts_by_eigenvalue(method)) return limit_by_spectrum(s.values, method, growth).first;
  return by_bisection([&](double h) { return linear_form_grows(s, method, h); }, 1 / std::abs(s.fastest));
}

bool grows(const Standing& s, const std::string& name, double h) {
  Growth growth(frozen_steps, growth_in_scenes);
  try {
    watch_frozen(s, name, h, [&](int, double size) { return growth.add(size); });
  } catch (const Divergence&) {
    return true;
  }
  return growth.seen();
}

double measured_step(const Standing& s, const std::string& method, double guess) {
  return by_bisection([&](double h) { return grows(s, method, h); }, guess);
}

namespace {

// J: round-off of a scene in which nothing has happened yet, and what a plate that has just met something has given it.
double as_good_as_nothing(const Standing& s) {
  const Parts& parts = s.system.parts();
  double speed = greatest_speed(s.system, s.y), lightest = infinity;
  for (const PlatePart& p : parts.plate) speed = std::max(speed, std::hypot(p.vx, p.vy));
  for (const double mass : parts.disc.mass) lightest = std::min(lightest, mass);
  for (const double mass : parts.node.mass) lightest = std::min(lightest, mass);
  return 1e-6 * 0.5 * lightest * speed * speed;
}

}  // namespace

EnergyBalance run_on(const Standing& s, const std::string& method, double h, int steps) {
  System system = s.system;
  State y = s.y;
  const Energies start = observe(system, s.t, y).energy;
  const RunPlan plan{.start = s.t, .end = s.t + (steps + 0.5) * h, .step = h, .stop = {}};
  int n = 0;
  const RunEnd end =
      run(system, *make_method(method), y, plan, [&](double, const State&, const JumpReport&) { return ++n <= steps; });
  const Energies now = observe(system, end.time, y).energy;
  const double supplied = now.supplied(start);
  return {end.reason, now.residual(start),
          std::fabs(now.plate_work - start.plate_work) + std::fabs(now.lost() - start.lost()),
          supplied > as_good_as_nothing(s) ? supplied : 0};
}

double EnergyBalance::made() const { return supplied > 0 ? residual / supplied : NAN; }

bool has_stable_step(const Standing& s, const MethodInfo& method) {
  return !method.controlled && !method.dense_jacobian && refusal(method, s.system).empty();
}

StableStep stable_step(const Standing& s, const std::string& method) {
  if (s.fastest == 0.0) return {method, infinity, infinity, infinity};
  const double predicted = predicted_step(s, method);
  const double guess = std::isfinite(predicted) && predicted > 0 ? predicted : 1 / std::abs(s.fastest);
  return {method, predicted, measured_step(s, method, guess), predicted_step(s, method, growth_seen)};
}

}  // namespace furrow::verification
