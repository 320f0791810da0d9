// A lattice clamped at its left end and loaded at its right one comes to rest where the loads balance.
//
//   equilibrium: sum over links of k (L - l) e = P, by Newton's method with the tangent of each link
//     k (e e^T + (1 - l/L) (1 - e e^T))
//   small deflection:
//     K u = P,  K = sum of k e e^T
//
// Source: statics; the lattice's constants as in lattice_waves.cpp.
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "verification/cantilever_scenes.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification::cantilever {
namespace {

TEST(Cantilever, OraclesAgreeWithTheirOwnOracles) {
  requirement("lattice.cantilever_statics");
  for (const Beam& b : {paper, beam}) {
    const Assembly own(b);
    const std::string name = b.name();
    // Conjugate gradients in long double, against sparse Cholesky.
    using Long = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
    const auto k = own.stiffness(Vector::Zero(own.load.size())).cast<long double>().eval();
    Long u = Long::Zero(own.load.size());
    Long residual = own.load.cast<long double>();
    Long direction = residual;
    for (int n = 0; n < 3 * own.load.size(); ++n) {
      const Long image = k * direction;
      const long double before = residual.squaredNorm();
      const long double length = before / direction.dot(image);
      u += length * direction;
      residual -= length * image;
      direction = residual + residual.squaredNorm() / before * direction;
    }
    const double tip = static_cast<double>(u.segment<2>(own.tip).norm());
    expect("linear tip deflection [m]" + name, own.linear().segment<2>(own.tip).norm(), tip,
           relative(2e-13, "round-off times the condition of K, 1e-16 times 1e3"));
    // The gradient of the energy by complex steps, at Newton's equilibrium.
    const Vector rest = own.equilibrium();
    double worst = 0;
    for (int i = 0; i < rest.size(); ++i) {
      Eigen::VectorXcd probe = rest.cast<std::complex<double>>();
      probe[i] += std::complex<double>(0, 1e-30);
      worst = std::max(worst, std::fabs(own.energy(probe).imag() / 1e-30));
    }
    expect("greatest gradient of the energy at rest [N]" + name, worst, 0,
           absolute(2e-13, "round-off: an ulp of 0.1 m, 1.4e-17, times 1e4 N/m, over up to 12 links"));
  }
}

TEST(Cantilever, ComesToRestWhereNewtonSays) {
  requirement("lattice.cantilever_statics");
  constexpr double damping = 1e-3;  // s, of the stiffness: the fastest mode, 3e3 rad/s, decays in 5e-4 s
  for (const Beam& b : {paper, beam}) {
    const Assembly own(b);
    const Vector rest = own.equilibrium();
    const double slowest = 0.5 * damping * own.modes().values[0] / b.mass;  // 1/s
    const Ran ran = run_scene(scene_of(b, damping), "pece", 1e-4, 36 / slowest);
    double worst = 0;
    for (int n = 0; n < rest.size() / 2; ++n) {
      worst = std::max(worst, std::fabs(ran.y[ran.system.x_of(n)] - own.place[2 * n] - rest[2 * n]));
      worst = std::max(worst, std::fabs(ran.y[ran.system.y_of(n)] - own.place[2 * n + 1] - rest[2 * n + 1]));
    }
    const double size = rest.segment<2>(own.tip).norm();
    const char* reason =
        "round-off of the place, 1e-17 m in 4e-3 m, a random walk against the load; of the motion e^-36 is left, 2e-16";
    const int tip = own.tip / 2;
    const std::string name = b.name();
    expect("tip x, of the deflection" + name, (ran.y[ran.system.x_of(tip)] - own.place[own.tip]) / size,
           rest[own.tip] / size, absolute(3e-14, reason));
    expect("tip y, of the deflection" + name, (ran.y[ran.system.y_of(tip)] - own.place[own.tip + 1]) / size,
           rest[own.tip + 1] / size, absolute(3e-14, reason));
    expect("worst of all nodes, of the deflection" + name, worst / size, 0, absolute(3e-14, reason));
  }
}

}  // namespace
}  // namespace furrow::verification::cantilever
