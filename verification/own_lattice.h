// The equilibrium and the vibrations of a clamped lattice, assembled without the solver: links found by the distance
// of the nodes, unknowns x and y of the free nodes in turn, solved with Eigen.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <string>
#include <tuple>
#include <vector>

#include "verification/studies/algebra.h"

namespace furrow::verification {

struct Beam {
  int rows, columns, clamped_rows = 0, clamped_columns = 0;
  double ks, kd, kb = 0;          // N/m
  double load_x = 0, load_y = 0;  // N, on the middle node of the end
  double spacing = 0.01;          // m
  double mass = 0.01;             // kg

  bool clamped(int row, int column) const { return row < clamped_rows || column < clamped_columns; }
  int loaded_row() const { return clamped_rows > 0 ? rows - 1 : rows / 2; }
  int loaded_column() const { return clamped_rows > 0 ? columns / 2 : columns - 1; }
  std::string name() const { return clamped_rows > 0 ? ", the paper's lattice" : ", beam"; }
};

struct Assembly {
  struct Link {
    int a, b;  // first unknown of each end, -1 if clamped
    double xa, ya, xb, yb, rest, k;
  };
  std::vector<Link> links;
  std::vector<double> place;  // m, by unknown
  Vector load;                // N
  int tip = 0;

  explicit Assembly(const Beam& beam) {
    std::vector<int> unknown;
    for (int row = 0; row < beam.rows; ++row) {
      for (int column = 0; column < beam.columns; ++column) {
        const bool clamped = beam.clamped(row, column);
        unknown.push_back(clamped ? -1 : static_cast<int>(place.size()));
        if (row == beam.loaded_row() && column == beam.loaded_column()) tip = unknown.back();
        if (!clamped) place.insert(place.end(), {column * beam.spacing, row * beam.spacing});
      }
    }
    load = Vector::Zero(static_cast<Eigen::Index>(place.size()));
    load[tip] = beam.load_x;
    load[tip + 1] = beam.load_y;
    const int count = beam.rows * beam.columns;
    const double s = beam.spacing;
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < std::min(count, i + 2 * beam.columns + 1); ++j) {
        const int column = i % beam.columns, row = i / beam.columns;
        const int right = j % beam.columns - column, up = j / beam.columns - row;
        const int square = right * right + up * up;
        const double k = square == 1 ? beam.ks : square == 2 ? beam.kd : square == 4 ? beam.kb : 0;
        if (k == 0) continue;
        links.push_back({unknown[i], unknown[j], column * s, row * s, (column + right) * s, (row + up) * s,
                         s * std::sqrt(square), k});
      }
    }
  }

  // Pull of the links on the unknowns, displaced by u; and the tangent, if asked for.
  Vector pull(const Vector& u, Sparse* tangent) const {
    Vector force = Vector::Zero(u.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (const Link& l : links) {
      const auto moved = [&](int first) {
        return first < 0 ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(u[first], u[first + 1]);
      };
      const Eigen::Vector2d r = Eigen::Vector2d(l.xb - l.xa, l.yb - l.ya) + moved(l.b) - moved(l.a);
      const double length = r.norm();
      const Eigen::Vector2d e = r / length;
      const Eigen::Matrix2d along = e * e.transpose();
      const Eigen::Matrix2d stiff = l.k * (along + (1 - l.rest / length) * (Eigen::Matrix2d::Identity() - along));
      for (const auto& [own, other, sign] : {std::tuple(l.a, l.b, 1.0), std::tuple(l.b, l.a, -1.0)}) {
        if (own < 0) continue;
        force.segment<2>(own) += sign * l.k * (length - l.rest) * e;
        if (tangent == nullptr) continue;
        for (int i = 0; i < 2; ++i) {
          for (int j = 0; j < 2; ++j) {
            entries.emplace_back(own + i, own + j, stiff(i, j));
            if (other >= 0) entries.emplace_back(own + i, other + j, -stiff(i, j));
          }
        }
      }
    }
    if (tangent != nullptr) tangent->setFromTriplets(entries.begin(), entries.end());
    return force;
  }

  Sparse stiffness(const Vector& u) const {
    Sparse k(u.size(), u.size());
    pull(u, &k);
    return k;
  }

  Vector linear() const { return solved(stiffness(Vector::Zero(load.size())), load); }

  Vector equilibrium() const {
    Vector u = Vector::Zero(load.size());
    for (int iteration = 0; iteration < 6; ++iteration) u += solved(stiffness(u), load + pull(u, nullptr));
    return u;
  }

  // Eigenvalues of K are w^2 m.
  Modes modes() const { return modes_of(Eigen::MatrixXd(stiffness(Vector::Zero(load.size())))); }

  // Energy of springs and load for complex displacements.
  std::complex<double> energy(const Eigen::VectorXcd& u) const {
    std::complex<double> sum = 0;
    for (const Link& l : links) {
      std::complex<double> x = l.xb - l.xa, y = l.yb - l.ya;
      if (l.b >= 0) x += u[l.b], y += u[l.b + 1];
      if (l.a >= 0) x -= u[l.a], y -= u[l.a + 1];
      const std::complex<double> stretch = std::sqrt(x * x + y * y) - l.rest;
      sum += 0.5 * l.k * stretch * stretch;
    }
    return sum - (load.cast<std::complex<double>>().array() * u.array()).sum();
  }
};

}  // namespace furrow::verification
