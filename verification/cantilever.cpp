// A lattice clamped at its left end and loaded at its right one: rest state, refinement, frequencies.
//
//   equilibrium: sum over links of k (L - l) e = P, by Newton's method with the tangent of each link
//     k (e e^T + (1 - l/L) (1 - e e^T))
//   small deflection:
//     K u = P,  K = sum of k e e^T
//   frequencies; set off from rest with the velocities of mode j:
//     K u = w^2 m u
//     u(t) = A sin(w_j t)
//   Timoshenko, per unit of thickness, with ks = 2 kd and no skip-one springs (isotropic, nu = 1/3), height H = n s:
//     d = P L^3/(3 E I) + P L/(kappa G H)
//     E = 8 kd/3,  G = kd,  I = H^3/12,  kappa = 5/6
//   Rows on the edge have a whole spring where half of one belongs to the material, 2 (ks s/2) (H/2)^2 more in E I:
//     Timoshenko / d = 1 + 9/(4 n) + O(1/n^2), first order in the spacing
//
// Source: Timoshenko 1921; the lattice's constants as in lattice_waves.cpp.
#include <numbers>

#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/own_lattice.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double pi = std::numbers::pi;

Scene scene_of(const Beam& beam, double damping) {
  Scene scene = bare_lattice(beam.rows, beam.columns, beam.spacing, beam.mass);
  scene.output.energy = false;
  Lattice& lattice = scene.lattice[0];
  for (int row = 0; row < beam.clamped_rows; ++row) lattice.fixed_rows.push_back(row);
  for (int column = 0; column < beam.clamped_columns; ++column) lattice.fixed_columns.push_back(column);
  lattice.structural = {.stiffness = beam.ks, .damping = beam.ks * damping};
  lattice.shear = {.stiffness = beam.kd, .damping = beam.kd * damping};
  lattice.bending = {.stiffness = beam.kb, .damping = beam.kb * damping};
  lattice.node = {{.row = beam.loaded_row(), .column = beam.loaded_column(), .force = {beam.load_x, beam.load_y}}};
  return scene;
}

// The paper's lattice, ten rows of three, its two lowest rows held, pushed at its upper end; and a short beam.
constexpr Beam paper{
    .rows = 10, .columns = 3, .clamped_rows = 2, .ks = 1e4, .kd = 1e4, .kb = 1e4, .load_x = 2, .load_y = 0.5};
constexpr Beam beam{.rows = 3, .columns = 6, .clamped_columns = 1, .ks = 1e4, .kd = 5e3, .load_y = -2};

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
    const double slowest = 0.5 * damping * own.modes().eigenvalues()[0] / b.mass;  // 1/s
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

// Deflection of the solver's own equilibrium: ours, and one Newton step with the solver's forces there.
double solver_deflection(const Beam& b, const Assembly& own, const Vector& rest) {
  const System system(scene_of(b, 0));
  State y = system.initial_state();
  for (int i = 0; i < rest.size() / 2; ++i) {
    y[system.x_of(i)] += rest[2 * i];
    y[system.y_of(i)] += rest[2 * i + 1];
  }
  State rates(y.size());
  system.rhs(0, y, rates);
  Vector left(rest.size());  // N
  for (int i = 0; i < rest.size() / 2; ++i)
    left.segment<2>(2 * i) << b.mass * rates[system.vx_of(i)], b.mass * rates[system.vy_of(i)];
  const Vector step = Eigen::SimplicialLDLT<Sparse>(own.stiffness(rest)).solve(left);
  return rest[own.tip + 1] + step[own.tip + 1];
}

TEST(Cantilever, TendsToTimoshenkoAsTheLatticeIsRefined) {
  requirement("lattice.cantilever_beam");
  constexpr double load = -1e-3, kd = 1e4;  // N, N/m
  for (const int slenderness : {10, 20}) {
    const double length = slenderness;  // m; the height is 1 m
    const double theory = load * (length * length * length / (3 * 8 * kd / 3 / 12) + length / (5.0 / 6 * kd));
    const std::string beam_name = ", L/H = " + std::to_string(slenderness);
    Eigen::Vector3d excess;  // Timoshenko / deflection - 1
    for (int level = 0; level < 3; ++level) {
      const int n = 4 << level;
      const Beam b{.rows = n + 1,
                   .columns = slenderness * n + 1,
                   .clamped_columns = 1,
                   .ks = 2 * kd,
                   .kd = kd,
                   .load_y = load,
                   .spacing = 1.0 / n};
      const Assembly own(b);
      const Vector rest = own.equilibrium();
      const double deflection = solver_deflection(b, own, rest);
      expect("tip deflection [m], " + std::to_string(n) + " cells" + beam_name, deflection, rest[own.tip + 1],
             relative(slenderness * 1e-12, "round-off: half an ulp of the length against the deflection"));
      excess[level] = theory / deflection - 1;
    }
    // excess = limit + first/n + second/n^2 through n = 4, 8, 16
    const Eigen::Matrix3d powers{{1, 1.0 / 4, 1.0 / 16}, {1, 1.0 / 8, 1.0 / 64}, {1, 1.0 / 16, 1.0 / 256}};
    const Eigen::Vector3d terms = powers.partialPivLu().solve(excess);
    expect("Timoshenko / deflection for endless refinement" + beam_name, 1 + terms[0], 1,
           absolute(0.033 / slenderness,
                    "Timoshenko's clamp lets the section contract, ours does not: C H/L, C = 0.0165 "
                    "measured once at L/H = 10 and doubled"));
    expect("factor of 1/n: whole springs on the edges" + beam_name, terms[1], 9.0 / 4,
           absolute(4e-3, "term 1/n^3 of the series at n = 4 to 16, measured once and doubled"));
    expect("observed order from 8 to 16 cells" + beam_name, std::log2(excess[1] / excess[2]), 1,
           absolute(0.05, "next terms of the series: log2((1 + 1.2/18)/(1 + 1.2/36))"));
  }
}

TEST(Cantilever, SwingsAtTheFrequenciesOfItsStiffnessAndMass) {
  requirement("lattice.cantilever_frequencies");
  constexpr double amplitude = 1e-6;  // m
  for (Beam b : {paper, beam}) {
    b.load_x = b.load_y = 0;
    b.mass = 5;  // kg
    const Assembly own(b);
    const auto modes = own.modes();
    for (int j = 0; j < 3; ++j) {
      const double omega = std::sqrt(modes.eigenvalues()[j] / b.mass);
      const Vector shape = modes.eigenvectors().col(j) / modes.eigenvectors().col(j).cwiseAbs().maxCoeff();
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
      Sparse shifted = own.stiffness(Vector::Zero(own.load.size()));
      for (const double side : {-1e-9, 1e-9}) {
        Sparse k = shifted;
        for (int i = 0; i < k.rows(); ++i) k.coeffRef(i, i) -= modes.eigenvalues()[j] * (1 + side);
        const Vector pivots = Eigen::SimplicialLDLT<Sparse>(k).vectorD();
        expect("frequencies below it " + std::string(side < 0 ? "less" : "plus") + " 1e-9" + name,
               static_cast<double>((pivots.array() < 0).count()), side < 0 ? j : j + 1, exact("a count"));
      }
    }
  }
}

}  // namespace
}  // namespace furrow::verification
