#include "verification/studies/published_schemes.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>

namespace furrow::verification {
namespace {

using Memory = std::vector<Matrix>;
using Numbers = std::vector<double>;

Matrix positions_of(const LinearSystem& s, const Matrix& y) {
  Matrix part = Matrix::Zero(y.rows(), y.cols());
  part.topRows(s.positions) = y.topRows(s.positions);
  return part;
}

Matrix others_of(const LinearSystem& s, const Matrix& y) { return y - positions_of(s, y); }

// y_(n+1) = sum over k of c_k (h J)^k y_n; c_k = 1/k! up to the order, `beyond` from there on.
Scheme polynomial(int order, const Numbers& beyond = {}) {
  Numbers c{1};
  for (int k = 1; k <= order; ++k) c.push_back(c.back() / k);
  c.insert(c.end(), beyond.begin(), beyond.end());
  return {1, true, [c](const LinearSystem& s, Memory& memory) {
            Matrix power = memory[0];
            for (std::size_t k = 1; k < c.size(); ++k) {
              power = s.rate(power);
              memory[0] += c[k] * power;
            }
          }};
}

enum class Mode { predict_only, pec, pece, pecece };

// f_n, f_(n-1), ... times a; Hairer, Norsett and Wanner I, III.1.
const std::map<int, Numbers> bashforth{{1, {1}},
                                       {2, {3.0 / 2, -1.0 / 2}},
                                       {3, {23.0 / 12, -16.0 / 12, 5.0 / 12}},
                                       {4, {55.0 / 24, -59.0 / 24, 37.0 / 24, -9.0 / 24}},
                                       {5, {1901.0 / 720, -2774.0 / 720, 2616.0 / 720, -1274.0 / 720, 251.0 / 720}}};
// f_(n+1), f_n, ... times b.
const std::map<int, Numbers> moulton{{1, {1}},
                                     {2, {1.0 / 2, 1.0 / 2}},
                                     {3, {5.0 / 12, 8.0 / 12, -1.0 / 12}},
                                     {4, {9.0 / 24, 19.0 / 24, -5.0 / 24, 1.0 / 24}},
                                     {5, {251.0 / 720, 646.0 / 720, -264.0 / 720, 106.0 / 720, -19.0 / 720}}};

// Memory: y_n and the rates before f_n; in PEC f_n too, since it is never that of y_n.
Scheme adams(int order, Mode mode) {
  const Numbers& a = bashforth.at(order);  // copied into the step
  const Numbers& b = moulton.at(order);
  const int kept = mode == Mode::pec ? order : order - 1;
  return {1 + kept, true, [=](const LinearSystem& s, Memory& memory) {
            const Matrix y = memory[0];
            Memory f(memory.begin() + 1, memory.end());  // f_n, f_(n-1), ...
            if (mode != Mode::pec) f.insert(f.begin(), s.rate(y));
            Matrix next = y;
            for (int j = 0; j < order; ++j) next += a[j] * f[j];
            const int corrections = mode == Mode::predict_only ? 0 : mode == Mode::pecece ? 2 : 1;
            Matrix predicted_rate;
            for (int m = 0; m < corrections; ++m) {
              predicted_rate = s.rate(next);
              next = y + b[0] * predicted_rate;
              for (int j = 1; j < order; ++j) next += b[j] * f[j - 1];
            }
            if (mode == Mode::pec) f.insert(f.begin(), predicted_rate);
            memory[0] = next;
            for (int j = 0; j < kept; ++j) memory[1 + j] = f[j];
          }};
}

// q' = q + h v + h^2/2 a, w* = w + h w', then the rates there, averaged; Swope et al. 1982 with predicted velocity. The
// rate at the end is that of the prediction, and serves the next step.
Scheme verlet() {
  return {2, false, [](const LinearSystem& s, Memory& memory) {
            const Matrix y = memory[0];
            const Matrix f = memory[1];
            const Matrix q = positions_of(s, y + s.rate(y) + 0.5 * s.rate(others_of(s, f)));
            const Matrix there = s.rate(q + others_of(s, y + f));
            memory = {q + others_of(s, y + 0.5 * (f + there)), there};
          }};
}

Scheme symplectic_euler() {
  return {1, false, [](const LinearSystem& s, Memory& memory) {
            const Matrix w = others_of(s, memory[0] + s.rate(memory[0]));
            memory[0] = w + positions_of(s, memory[0] + s.rate(w));
          }};
}

// Powers of z beyond the order: of Dormand and Prince 1980, Cash and Karp 1990, Fehlberg 1968 (the eighth-order
// result), each from its tableau, b^T A^(k-1) 1.
const Numbers beyond_dopri5{1.0 / 600};
const Numbers beyond_cash_karp{1.0 / 800};
const Numbers beyond_fehlberg78{491.0 / 209018880, 1333.0 / 5643509760, -13.0 / 501645312, -65.0 / 4514807808};

// Positions first: q += a_i h v, v += b_i h a(q), stage by stage; of systems without damping.
Scheme composition(const Numbers& a, const Numbers& b) {
  return {1, false,
          [a, b](const LinearSystem& s, Memory& memory) {
            Matrix& y = memory[0];
            for (std::size_t i = 0; i < a.size(); ++i) {
              y += a[i] * positions_of(s, s.rate(y));
              y += b[i] * others_of(s, s.rate(y));
            }
          },
          true};
}

// y_(n+1) = (I - h J)^-1 y_n; small systems only.
Scheme implicit_euler() {
  return {1, true, [](const LinearSystem& s, Memory& memory) {
            const Matrix identity = Matrix::Identity(s.size, s.size);
            memory[0] = (identity - s.rate(identity)).partialPivLu().solve(memory[0]);
          }};
}

// McLachlan 1995 (SIAM J. Sci. Comput. 16, 151), symmetric compositions of order 4 for Runge-Kutta-Nystroem systems, of
// six stages and of five.
constexpr double a0 = 0.40518861839525227722, a1 = -0.28714404081652408900, b0 = -3.0 / 73, b1 = 17.0 / 59;
const Numbers six_a{a0, a1, 0.5 - (a0 + a1), 0.5 - (a0 + a1), a1, a0};
const Numbers six_b{b0, b1, 1 - 2 * (b0 + b1), b1, b0, 0};
const double mclachlan_root = std::sqrt(7.0 / 8) / 3;
const Numbers five_a{0.5 - mclachlan_root, mclachlan_root - 1.0 / 3, 2.0 / 3, mclachlan_root - 1.0 / 3,
                     0.5 - mclachlan_root};
const Numbers five_b{1, -0.5, -0.5, 1, 0};

// One entry a scheme, with the names under which the catalogue has it.
std::map<std::string, Scheme> make_schemes() {
  std::map<std::string, Scheme> all;
  const auto add = [&all](const std::vector<std::string>& names, const Scheme& scheme) {
    for (const std::string& name : names) all[name] = scheme;
  };
  add({"pece", "odeint_abm2"}, adams(2, Mode::pece));
  add({"pec"}, adams(2, Mode::pec));
  add({"pecece"}, adams(2, Mode::pecece));
  add({"odeint_euler", "odeint_ab1"}, adams(1, Mode::predict_only));
  add({"ab2", "odeint_ab2"}, adams(2, Mode::predict_only));
  add({"odeint_ab3"}, adams(3, Mode::predict_only));
  add({"odeint_ab4"}, adams(4, Mode::predict_only));
  add({"odeint_ab5"}, adams(5, Mode::predict_only));
  add({"odeint_abm1"}, adams(1, Mode::pece));
  add({"odeint_abm3"}, adams(3, Mode::pece));
  add({"odeint_abm4"}, adams(4, Mode::pece));
  add({"odeint_abm5"}, adams(5, Mode::pece));
  add({"odeint_modified_midpoint"}, polynomial(2, {1.0 / 8}));  // two substeps
  add({"rk4", "odeint_rk4"}, polynomial(4));
  add({"odeint_cash_karp54_fixed"}, polynomial(5, beyond_cash_karp));
  add({"odeint_dopri5_fixed"}, polynomial(5, beyond_dopri5));
  add({"odeint_fehlberg78_fixed"}, polynomial(8, beyond_fehlberg78));
  add({"verlet", "odeint_velocity_verlet"}, verlet());
  add({"symplectic_euler"}, symplectic_euler());
  add({"odeint_symplectic_euler"}, composition({1}, {1}));
  add({"odeint_symplectic_rkn_sb3a_mclachlan"}, composition(six_a, six_b));
  add({"odeint_symplectic_rkn_sb3a_m4_mclachlan"}, composition(five_a, five_b));
  add({"odeint_implicit_euler"}, implicit_euler());
  return all;
}

}  // namespace

const Scheme* scheme_of(const std::string& method) {
  static const std::map<std::string, Scheme> schemes = make_schemes();
  const auto found = schemes.find(method);
  return found == schemes.end() ? nullptr : &found->second;
}

double amplification(const Scheme& scheme, const LinearSystem& system) {
  const Eigen::Index n = system.size;
  const Eigen::Index all = n * scheme.blocks;
  const Matrix identity = Matrix::Identity(all, all);
  Memory memory;
  for (int k = 0; k < scheme.blocks; ++k) memory.push_back(identity.middleRows(k * n, n));
  scheme.step(system, memory);
  Matrix m(all, all);
  for (int k = 0; k < scheme.blocks; ++k) m.middleRows(k * n, n) = memory[k];
  if (all == 1) return std::abs(m(0, 0));
  return Eigen::ComplexEigenSolver<Matrix>(m, false).eigenvalues().cwiseAbs().maxCoeff();
}

double amplification(const Scheme& scheme, std::complex<double> z) {
  return amplification(scheme, {[z](const Matrix& y) -> Matrix { return z * y; }, 1, 0});
}

double amplification(const Scheme& scheme, double zeta, double angle) {
  Matrix j(2, 2);  // of (x, v/omega)
  j << 0, angle, -angle, -2 * zeta * angle;
  return amplification(scheme, {[&j](const Matrix& y) -> Matrix { return j * y; }, 2, 1});
}

}  // namespace furrow::verification
