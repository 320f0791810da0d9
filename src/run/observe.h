// What observers compute from a state. Nothing here affects the run.
#pragma once

#include <string>
#include <vector>

#include "physics/stress.h"
#include "run/system.h"

namespace furrow {

struct Force {
  double x = 0, y = 0;  // N
};

// J. Stored energies are those of the moment; the others are sums since t = 0.
struct Energies {
  double kinetic = 0, gravity = 0, load = 0, springs = 0, contact_elastic = 0;
  double link_damping = 0, contact_viscous = 0, friction = 0, rolling = 0, tear = 0;
  double plate_work = 0, stiffening = 0;

  double live() const { return kinetic + springs + contact_elastic; }
  double stored() const { return kinetic + gravity + load + springs + contact_elastic; }
  double lost() const { return link_damping + contact_viscous + friction + rolling + tear; }
  // Zero but for the error of the method, if `start` was taken from the same run.
  double residual(const Energies& start) const;
  // No less than `live` can be: what it was, and what plates, gravity and loads have given since.
  double supplied(const Energies& start) const;
  void history(HistoryVisitor& visit);
};

struct Momentum {
  double x = 0, y = 0;  // kg m/s
  double angular = 0;   // kg m^2/s, about the origin, spins included
};

struct Overlap {
  double depth = 0;     // m
  double relative = 0;  // of the disc's radius, or of the node's contact radius
  std::string between;  // the two parts; empty if nothing touches
};

struct Observation {
  std::vector<Force> plate, wall;  // on each
  std::vector<Force> drive;        // on the nodes of each drive, from links and contacts
  Energies energy;                 // without a ledger only the stored ones
  Momentum momentum;
  Overlap overlap;  // the greatest relative one
  int contacts = 0;
};

Observation observe(const System& system, double t, const State& y);

// Pa, by disc.
std::vector<Stress> disc_stresses(const System& system, double t, const State& y);

// N, tension positive, by link; 0 for torn ones.
std::vector<double> link_forces(const System& system, double t, const State& y);

// m/s, of the fastest disc or node, when the fastest of all, this share of them, are left out.
double greatest_speed(const System& system, const State& y, double left_out = 0);

// m: mean height of the upper outline of the discs, in strips as wide as the mean disc, over the span of the discs.
double surface_height(const System& system, const State& y);

}  // namespace furrow
