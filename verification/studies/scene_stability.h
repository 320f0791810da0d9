// How long a step a scene allows where it stands: predicted from its spectrum and each method's amplification factor,
// and found on the scene itself.
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "methods/method.h"
#include "report/linearise.h"

namespace furrow::verification {

// A scene at one moment, and its linearisation.
struct Standing {
  System system;
  double t = 0;  // s
  State y;
  Linearised linearised{};
  Eigen::VectorXcd values{};       // 1/s, see spectrum()
  std::complex<double> fastest{};  // the eigenvalue that limits the paper's method
  Driver driver{};                 // of its motion
  double own_growth = 0;           // 1/s, at which small changes of the scene grow by themselves; 0 if they do not
};

// `dense`: see spectrum().
Standing standing(System system, double t, State y, Eigen::Index dense = 300);

// The scene prepared and, if t > 0, run up to t by `method` with `step`. Throws as prepare() and Divergence.
Standing standing_at(Scene scene, double t, const std::function<bool(double done, double total)>& progress = {});

// A step counts as unstable where something gains more than this a step, beyond what it does by itself.
inline constexpr double growth_in_scenes = 1e-3;

struct StableStep {
  std::string method;
  double predicted = 0;  // s, infinity: any step
  double measured = 0;   // s, small changes of the scene held still grow above it
  double slow = 0;       // s, predicted for the growth that `furrow explain` judges by, growth_seen
};

// By theory. Methods that act on each eigenvalue alone: the least over the spectrum of the distance from zero to the
// rim of the stability region. Others: growth of their linear form on the whole Jacobian. Eigenvalues within 1e-6 of
// zero, of the largest, are those of rigid motion and left out. NaN of a controlled method.
double predicted_step(const Standing& s, const std::string& method, double growth = growth_in_scenes);

// The solver's right-hand side and the method itself, time held still:  e' = f(t0, y0 + e) - f(t0, y0)  from a small
// random e. The step counts as unstable if the change in a step grows over two thousand steps beyond the scene's own
// growth, see growth.h. No jump takes part.
double measured_step(const Standing& s, const std::string& method, double guess);
// Whether what deviates grows at this step.
bool grows(const Standing& s, const std::string& method, double step);

// What becomes of the scene as it runs, with all jumps, for `steps` steps of h from here. Friction and clipping bound
// what grows: such a run does not diverge but chatters, and the energy that the method makes or loses shows it.
struct EnergyBalance {
  std::string diverged;  // why, or empty
  double residual = 0;   // J
  double handled = 0;    // J, work of the plates and losses, without sign
  double supplied = 0;   // J, what the scene had and was given, see Energies::supplied; 0 if that is round-off
  // -, of what was supplied; NaN if that is nothing
  double made() const;
  double share() const { return handled > 0 ? std::fabs(residual) / handled : 0; }
};
EnergyBalance run_on(const Standing& s, const std::string& method, double h, int steps = 200);

// Whether `method` can run the scene by fixed steps.
bool has_stable_step(const Standing& s, const MethodInfo& method);

// Predicted and measured.
StableStep stable_step(const Standing& s, const std::string& method);

}  // namespace furrow::verification
