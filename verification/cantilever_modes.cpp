// A clamped lattice swings at the frequencies of its stiffness and mass.
//
//   set off from rest with the velocities of mode j:
//     K u = w^2 m u,  K = sum of k e e^T
//     u(t) = A sin(w_j t)
//
// Source: linear vibrations; the number of frequencies below w by Sylvester's law of inertia.
#include <cmath>
#include <numbers>
#include <string>

#include "verification/cantilever_scenes.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification::cantilever {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Cantilever, SwingsAtTheFrequenciesOfItsStiffnessAndMass) {
  requirement("lattice.cantilever_frequencies");
  constexpr double amplitude = 1e-6;  // m
  for (Beam b : {paper, beam}) {
    b.load_x = b.load_y = 0;
    b.mass = 5;  // kg
    const Assembly own(b);
    const auto modes = own.modes();
    for (int j = 0; j < 3; ++j) {
      const double omega = std::sqrt(modes.values[j] / b.mass);
      const Vector shape = modes.vectors.col(j) / modes.vectors.col(j).cwiseAbs().maxCoeff();
      System system(scene_of(b, 0));
      State y = system.initial_state();
      for (int i = 0; i < shape.size() / 2; ++i) {
        y[system.vx_of(i)] = amplitude * omega * shape[2 * i];
        y[system.vy_of(i)] = amplitude * omega * shape[2 * i + 1];
      }
      run(system, *make_method("rk4"), y, {.start = 0, .end = 2 * pi / omega, .step = 0.02 / omega, .stop = {}},
          [](double, const State&, const JumpReport&) { return true; });
      double phase = 0;  // rad, beyond one period
      for (int i = 0; i < shape.size() / 2; ++i) {
        phase += shape[2 * i] * (y[system.x_of(i)] - own.place[2 * i]) / amplitude;
        phase += shape[2 * i + 1] * (y[system.y_of(i)] - own.place[2 * i + 1]) / amplitude;
      }
      phase /= shape.squaredNorm();
      const std::string name = ", mode " + std::to_string(j + 1) + b.name();
      expect("frequency [rad/s]" + name, omega * (1 + phase / (2 * pi)), omega,
             relative(2.7e-9,
                      "truncation of rk4: (omega h)^4/120 = 1.3e-9, doubled; the amplitude of 1 um adds "
                      "(1 um/0.08 m)^2 = 2e-10"));
      // Sylvester: K - w^2 m has as many negative pivots as there are frequencies below w.
      const Sparse k = own.stiffness(Vector::Zero(own.load.size()));
      for (const double side : {-1e-9, 1e-9}) {
        expect("frequencies below it " + std::string(side < 0 ? "less" : "plus") + " 1e-9" + name,
               eigenvalues_below(k, modes.values[j] * (1 + side)), side < 0 ? j : j + 1, exact("a count"));
      }
    }
  }
}

}  // namespace
}  // namespace furrow::verification::cantilever
