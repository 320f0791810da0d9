#include "report/linearise.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "run/observe.h"

namespace furrow {
namespace {

using Vector = Eigen::VectorXd;
using ComplexVector = Eigen::VectorXcd;

// Widths of the differences: far below the overlaps and speeds that forces change over, far above round-off.
constexpr double width_of_positions = 1e-9;   // m
constexpr double width_of_velocities = 1e-8;  // m/s
constexpr double width_of_spins = 1e-6;       // rad/s
constexpr double width_of_springs = 1e-9;     // m

std::vector<int> slots_in_use(const System& system, double t, const State& y) {
  std::vector<int> used;
  system.for_each_contact(t, y, [&](const Contact& c) {
    for (int k = 0; c.slot >= 0 && k < system.layout().slot_width; ++k)
      used.push_back(system.layout().spring_of(c.slot) + k);
  });
  std::sort(used.begin(), used.end());
  return used;
}

double width(const System& system, int place) {
  const int positions = static_cast<int>(system.positions());
  if (place < positions) return width_of_positions;
  if (place < 2 * positions) return width_of_velocities;
  return place < system.first_spring() ? width_of_spins : width_of_springs;
}

// Difference of two rates over the difference of the numbers they belong to. Parts at one place have no rates, and far
// from the origin so small a difference is lost in round-off: the eigenvalue solver would crash on the result.
double slope(double difference, double across, int place) {
  const double of = difference / across;
  if (std::isfinite(of)) return of;
  throw Divergence("the rates of change of number " + std::to_string(place) +
                   " of the state are not finite: parts on one spot, or too far from the origin");
}

// Eigenvalues of a matrix, which are all of them there.
ComplexVector eigenvalues(const Eigen::MatrixXd& of) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(of, false);
  if (solver.info() != Eigen::Success) throw Divergence("the eigenvalues of the rates of change are not found");
  return solver.eigenvalues();
}

}  // namespace

Linearised linearise(const System& system, double t, const State& y) {
  Linearised l;
  l.positions = static_cast<Eigen::Index>(system.positions());
  for (int k = 0; k < system.first_spring(); ++k) l.acting.push_back(k);
  const std::vector<int> springs = slots_in_use(system, t, y);
  l.acting.insert(l.acting.end(), springs.begin(), springs.end());
  const int n = static_cast<int>(l.acting.size());
  std::vector<Eigen::Triplet<double>> entries;
  State moved = y;
  State above(y.size());
  State below(y.size());
  for (int column = 0; column < n; ++column) {
    const int place = l.acting[column];
    const double d = width(system, place);
    moved[place] = y[place] + d;
    system.rhs(t, moved, above);
    const double up = moved[place];
    moved[place] = y[place] - d;
    system.rhs(t, moved, below);
    const double across = up - moved[place];
    moved[place] = y[place];
    for (int row = 0; row < n; ++row) {
      const double difference = above[l.acting[row]] - below[l.acting[row]];
      if (difference != 0) entries.emplace_back(row, column, slope(difference, across, l.acting[row]));
    }
  }
  l.rates.resize(n, n);
  l.rates.setFromTriplets(entries.begin(), entries.end());
  return l;
}

ComplexVector spectrum(const Linearised& l, Eigen::Index dense) {
  const Eigen::Index n = l.rates.rows();
  if (n <= dense) return eigenvalues(Eigen::MatrixXd(l.rates));
  Eigen::MatrixXd basis(n, dense + 1);
  Eigen::MatrixXd reduced = Eigen::MatrixXd::Zero(dense, dense);
  std::mt19937_64 random(1);
  basis.col(0) =
      Vector::NullaryExpr(n, [&](Eigen::Index) { return std::uniform_real_distribution(-1.0, 1.0)(random); });
  basis.col(0).normalize();
  for (Eigen::Index k = 0; k < dense; ++k) {
    Vector next = l.rates * basis.col(k);
    for (int twice = 0; twice < 2; ++twice) {  // orthogonal to round-off
      const Vector part = basis.leftCols(k + 1).transpose() * next;
      reduced.col(k).head(k + 1) += part;
      next -= basis.leftCols(k + 1) * part;
    }
    const double size = next.norm();
    if (k + 1 < dense) reduced(k + 1, k) = size;
    if (size == 0) return eigenvalues(reduced.topLeftCorner(k + 1, k + 1));
    basis.col(k + 1) = next / size;
  }
  return eigenvalues(reduced);
}

ComplexVector eigenvector(const Linearised& l, std::complex<double> value) {
  using Sparse = Eigen::SparseMatrix<std::complex<double>>;
  const Eigen::Index n = l.rates.rows();
  Sparse shifted = l.rates.cast<std::complex<double>>();
  Sparse identity(n, n);
  identity.setIdentity();
  shifted -= (value * (1 + 1e-6)) * identity;  // beside the eigenvalue, where the matrix is not quite singular
  Eigen::SparseLU<Sparse> solver(shifted);
  if (solver.info() != Eigen::Success)
    throw Divergence("the fastest motion is not found: " + solver.lastErrorMessage());
  ComplexVector v = ComplexVector::Ones(n);
  for (int k = 0; k < 4; ++k) v = solver.solve(v).normalized();
  return v;
}

namespace {

// Velocities and spins of a motion, by body; fixed nodes, walls and plates do not move.
class Motion {
 public:
  Motion(const System& system, const ComplexVector& v) : system_(system), v_(v) {}

  std::array<std::complex<double>, 2> body(int i) const {
    if (i < 0) return {0, 0};
    return {v_[system_.vx_of(i)], v_[system_.vy_of(i)]};
  }
  std::array<std::complex<double>, 2> node(int n) const { return body(system_.parts().node.body[n]); }
  std::complex<double> spin(int disc) const { return system_.has_friction() ? v_[system_.spin_of(disc)] : 0; }

 private:
  const System& system_;
  const ComplexVector& v_;
};

struct Powers {
  double normal = 0, shear = 0, rolling = 0;
  double sum() const { return normal + shear + rolling; }
  std::string how() const {
    return normal >= std::max(shear, rolling) ? "normal" : shear >= rolling ? "shear" : "rolling";
  }
};

// N m s and N m: how the rolling moment answers to a change of spin and of turn.
struct RollingResponse {
  double viscosity = 0, stiffness = 0;
};

RollingResponse rolling_response(const ContactLaw& law, const Contact& c, double rolling_smoothing) {
  if (!(law.rolling > 0)) return {};
  if (!rolls_on_spring(law)) return {rolling_viscosity(law, c.touch, c.force.normal, rolling_smoothing)};
  if (std::fabs(c.force.moment) >= rolling_limit(law, c.touch, c.force)) return {};  // it turns at its limit
  const double kr = rolling_stiffness(law, c.touch, c.force);
  return {rolling_spring_viscosity(law, c.touch, kr), kr};
}

Powers powers_of(const System& system, const Contact& c, const Motion& motion, double rate) {
  const Parts& parts = system.parts();
  auto v = of_disc(c.id.kind) ? motion.body(c.id.a) : motion.node(c.id.a);
  std::complex<double> spin_a = of_disc(c.id.kind) ? motion.spin(c.id.a) : 0;
  std::complex<double> spin_b = 0;
  if (c.id.kind == disc_disc) {
    const auto other = motion.body(c.id.b);
    for (int i = 0; i < 2; ++i) v[i] -= other[i];
    spin_b = motion.spin(c.id.b);
  } else if (c.id.kind == disc_lattice) {
    const auto i = motion.node(parts.border.a[c.segment]);
    const auto j = motion.node(parts.border.b[c.segment]);
    for (int x = 0; x < 2; ++x) v[x] -= (1 - c.share) * i[x] + c.share * j[x];
  }
  const double approach = std::norm(v[0] * c.nx + v[1] * c.ny);
  const double slip = std::norm(v[1] * c.nx - v[0] * c.ny + spin_a * c.arm_a + spin_b * c.arm_b);
  const ContactLaw& law = parts.law[c.law];
  const double viscosity = normal_viscosity(law, c.touch, c.force);
  const double held = -c.force.shear_stiffness * c.touch.spring - c.force.shear_viscosity * c.touch.slip;
  Powers p;
  if (c.force.normal > law.floor) p.normal = (viscosity + c.force.stiffness / rate) * approach;
  if (law.friction > 0 && held == c.force.tangential)
    p.shear = (c.force.shear_viscosity + c.force.shear_stiffness / rate) * slip;
  const RollingResponse rolling = rolling_response(law, c, system.rolling_smoothing());
  p.rolling = (rolling.viscosity + rolling.stiffness / rate) * std::norm(spin_a - spin_b);
  return p;
}

}  // namespace

Driver driver_of(const System& system, double t, const State& y, const Linearised& l, const ComplexVector& motion,
                 std::complex<double> value) {
  const Parts& parts = system.parts();
  const double rate = std::abs(value);
  ComplexVector in_state = ComplexVector::Zero(static_cast<Eigen::Index>(y.size()));
  for (std::size_t k = 0; k < l.acting.size(); ++k) in_state[l.acting[k]] = motion[static_cast<Eigen::Index>(k)];
  const Motion moves(system, in_state);
  Driver driver;
  double most = 0;
  double all = 0;
  const auto take = [&](double power, const std::string& how, const auto& name) {
    all += power;
    if (power <= most) return;
    most = power;
    driver.name = name();
    driver.how = how;
  };
  system.for_each_contact(t, y, [&](const Contact& c) {
    const Powers p = powers_of(system, c, moves, rate);
    take(p.sum(), p.how(), [&] { return "contact of " + contact_name(system.parts(), c.id); });
  });
  const NodeMotion nodes = system.nodes(t, y);
  for (int k = 0; k < parts.link.count(); ++k) {
    if (system.torn(k)) continue;
    const int a = parts.link.a[k];
    const int b = parts.link.b[k];
    const double rx = nodes.x[a] - nodes.x[b];
    const double ry = nodes.y[a] - nodes.y[b];
    const auto va = moves.node(a);
    const auto vb = moves.node(b);
    const double stretching = std::norm(((va[0] - vb[0]) * rx + (va[1] - vb[1]) * ry) / std::hypot(rx, ry));
    take((parts.link.damping[k] + parts.link.stiffness[k] / rate) * stretching, "link",
         [&] { return parts.link_name(k); });
  }
  driver.share = all > 0 ? most / all : 0;
  return driver;
}

}  // namespace furrow
