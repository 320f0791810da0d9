// Oracles of two bodies that meet.
#include <numbers>

#include "verification/coupling_scenes.h"
#include "verification/damped_hertz.h"
#include "verification/engines/oracle_parts.h"
#include "verification/hertz_law.h"
#include "verification/oblique_oracle.h"
#include "verification/plate_oracle.h"
#include "verification/three_bodies.h"

namespace furrow::verification {
namespace {

// Speed after over speed before, and the greatest overlap and contact time in units of the impact.
struct Rebound {
  double restitution, overlap, time;
};

Rebound rebound_of(double beta, bool pulls) {
  const DampedHertz exact(beta);
  const long double end = pulls ? exact.release() : exact.letting_go();
  return {static_cast<double>(-exact.speed(end)), static_cast<double>(exact.overlap(exact.turning())),
          beta < 1 ? static_cast<double>(exact.contact_time()) : NAN};
}

double velocity_after(const Json& c, const Json& seen, const Meeting& m, double restitution) {
  const Json& body = named(c, "body", seen["of"][0]);
  const double impulse = (1 + restitution) * m.mass * m.closing;
  const bool first = body["name"] == c["body"][0]["name"];
  const bool shared = !c["edge"].empty() && c["lattice"][0]["columns"] == 2;
  const double share = first ? -1 : shared ? 0.5 : 1;
  return dot(vec(body["velocity"]), vec(seen["direction"])) +
         share * impulse / body["mass"].get<double>() * dot(m.normal, vec(seen["direction"]));
}

Expected normal_impact(const Json& c) {
  const Meeting m = meeting_of(c);
  const Hertz elastic{m.mass, m.stiffness(), m.closing};
  const Rebound damped = rebound_of(m.beta, c["contact"]["pull"]);
  const double length = std::pow(m.mass * m.closing * m.closing / m.stiffness(), 0.4);
  Expected all;
  fill(all, c, [&](const Json& seen) {
    const std::string what = seen["what"];
    if (what == "greatest overlap") return m.beta == 0 ? elastic.peak_overlap() : damped.overlap * length;
    if (what == "greatest force") return elastic.peak_force();
    if (what == "contact time") return m.beta == 0 ? elastic.contact_time() : damped.time * length / m.closing;
    return velocity_after(c, seen, m, m.beta == 0 ? 1 : damped.restitution);
  });
  return all;
}

// The tangent is (-ny, nx); spin turns the surface of the first body along it, that of the second too.
Expected oblique_impact(const Json& c) {
  const Meeting m = meeting_of(c);
  const Json& a = c["body"][0];
  const Vec tangent{-m.normal[1], m.normal[0]};
  double slip = dot(vec(a["velocity"]), tangent) + a["spin"].get<double>() * a["radius"].get<double>();
  if (c["wall"].empty()) {
    const Json& b = c["body"][1];
    slip += b["spin"].get<double>() * b["radius"].get<double>() - dot(vec(b["velocity"]), tangent);
  }
  const double r = a["radius"], kappa = 1 + a["mass"].get<double>() * r * r / a["inertia"].get<double>();
  const bool sticks = m.friction > 1e6;
  const ObliqueOutcome out =
      oblique_outcome({m.modulus, m.shear, m.radius, m.mass, kappa, m.beta, sticks ? HUGE_VALL : m.friction, m.closing,
                       slip, c["contact"]["tangential_damping"]},
                      sticks ? 100000 : 200000);
  const double along = (out.slip - slip) * m.mass / kappa;  // N s, on the first body
  const double across = -(m.closing + out.separation) * m.mass;
  Expected all;
  fill(all, c, [&](const Json& seen) {
    const double start =
        seen["what"] == "spin" ? a["spin"].get<double>() : dot(vec(a["velocity"]), vec(seen["direction"]));
    if (seen["what"] == "spin") return start + along * r / a["inertia"].get<double>();
    return start + (along * dot(tangent, vec(seen["direction"])) + across * dot(m.normal, vec(seen["direction"]))) /
                       a["mass"].get<double>();
  });
  return all;
}

Expected opposite_spins(const Json& c) {
  Expected all;
  fill(all, c, [&](const Json& seen) {
    return seen["what"] == "spin" ? named(c, "body", seen["of"][0])["spin"].get<double>() : 0.0;
  });
  return all;
}

Expected three_bodies_in_line(const Json& c) {
  const coupling::Line line =
      coupling::three_bodies(c["lattice"][0]["structural"]["stiffness"].get<double>(), c["end"].get<double>(), 40000);
  Expected all;
  fill(all, c, [&](const Json& seen) {
    return static_cast<double>(seen["of"][0] == "disc"      ? line.disc
                               : seen["of"][0] == "web.1.0" ? line.upper
                                                            : line.lower);
  });
  return all;
}

// Of two contacts and a spring under the same force.
Expected series(const Json& c) {
  const double spring = c["lattice"][0]["structural"]["stiffness"];
  const double k = 4.0 / 3 * c["pair"][0]["modulus"].get<double>() * std::sqrt(c["body"][0]["radius"].get<double>());
  const double room = c["wall"][0]["point"][1].get<double>() - c["lattice"][0]["spacing"].get<double>();
  const double squeeze = 2 * c["body"][0]["radius"].get<double>() - room;
  long double low = 0, high = spring * squeeze;
  for (int n = 0; n < 100; ++n) {
    const long double force = (low + high) / 2;
    (2 * std::cbrt(force * force / (k * k)) + force / spring < squeeze ? low : high) = force;
  }
  const double force = static_cast<double>(low);
  Expected all;
  fill(all, c, [&](const Json& seen) {
    return seen["what"] == "overlap" ? std::cbrt(force * force / (k * k)) : -force / spring;
  });
  return all;
}

Expected plate_meets_node(const Json& c) {
  const plate_meets_lattice::Impact impact =
      plate_meets_lattice::Oracle(plate_meets_lattice::one_node).run(c["end"].get<double>(), 16000);
  return {{c["observe"][0]["name"], impact.force}};
}

// Two discs that stick to each other, by the classical Runge-Kutta method on a clock that stands still at both ends of
// the contact, so that the roots there do no harm. The end is found by Newton's method.
class StickingPair {
 public:
  explicit StickingPair(const Json& c) : m_(meeting_of(c)) {
    for (int i = 0; i < 2; ++i) {
      const Json& b = c["body"][i];
      radius_[i] = b["radius"], mass_[i] = b["mass"], inertia_[i] = b["inertia"];
      start_.x[i] = b["position"][0], start_.y[i] = b["position"][1];
      start_.vx[i] = b["velocity"][0], start_.vy[i] = b["velocity"][1], start_.spin[i] = b["spin"];
    }
  }
  struct State {
    long double x[2], y[2], vx[2], vy[2], spin[2], xi;
  };
  State after() const {
    long double end = Hertz{m_.mass, m_.stiffness(), m_.closing}.contact_time();
    State y{};
    for (int k = 0; k < 8; ++k) {
      y = run(end, 20000);
      const long double dx = y.x[1] - y.x[0], dy = y.y[1] - y.y[0], distance = std::hypot(dx, dy);
      const long double parting = ((y.vx[1] - y.vx[0]) * dx + (y.vy[1] - y.vy[0]) * dy) / distance;
      end += (radius_[0] + radius_[1] - distance) / parting;
    }
    return y;
  }

 private:
  State rates(const State& s, long double pace) const {
    const long double dx = s.x[1] - s.x[0], dy = s.y[1] - s.y[0], distance = std::hypot(dx, dy);
    const long double nx = dx / distance, ny = dy / distance, d = std::fmax(0.0L, radius_[0] + radius_[1] - distance);
    const long double slip =
        (s.vx[1] - s.vx[0]) * ny - (s.vy[1] - s.vy[0]) * nx + s.spin[0] * radius_[0] + s.spin[1] * radius_[1];
    const long double root = std::sqrt(m_.radius * d);
    const long double normal = 4.0L / 3 * m_.modulus * root * d, shear = -8.0L * m_.shear * root * s.xi;
    const long double fx = -normal * nx - shear * ny, fy = -normal * ny + shear * nx;
    State r{};
    for (int i = 0; i < 2; ++i) {
      const long double sign = i == 0 ? 1 : -1;
      r.x[i] = pace * s.vx[i], r.y[i] = pace * s.vy[i];
      r.vx[i] = pace * sign * fx / mass_[i], r.vy[i] = pace * sign * fy / mass_[i];
      r.spin[i] = pace * radius_[i] * shear / inertia_[i];
    }
    r.xi = pace * slip;
    return r;
  }
  static State moved(State s, const State& r, long double h) {
    for (int i = 0; i < 2; ++i) {
      s.x[i] += h * r.x[i], s.y[i] += h * r.y[i], s.vx[i] += h * r.vx[i], s.vy[i] += h * r.vy[i],
          s.spin[i] += h * r.spin[i];
    }
    s.xi += h * r.xi;
    return s;
  }
  State run(long double end, int steps) const {
    const auto pace = [end](long double q) { return end * 140 * q * q * q * (1 - q) * (1 - q) * (1 - q); };
    State s = start_;
    const long double h = 1.0L / steps;
    for (int n = 0; n < steps; ++n) {
      const State k1 = rates(s, pace(n * h)), k2 = rates(moved(s, k1, h / 2), pace((n + 0.5L) * h));
      const State k3 = rates(moved(s, k2, h / 2), pace((n + 0.5L) * h)), k4 = rates(moved(s, k3, h), pace((n + 1) * h));
      s = moved(moved(moved(moved(s, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
    }
    return s;
  }

  Meeting m_;
  long double radius_[2]{}, mass_[2]{}, inertia_[2]{};
  State start_{};
};

Expected oblique_pair(const Json& c) {
  const StickingPair::State end = StickingPair(c).after();
  Expected all;
  fill(all, c, [&](const Json& seen) {
    const int i = seen["of"][0] == c["body"][0]["name"] ? 0 : 1;
    if (seen["what"] == "spin") return static_cast<double>(end.spin[i]);
    return static_cast<double>(seen["direction"][0].get<double>() * end.vx[i] +
                               seen["direction"][1].get<double>() * end.vy[i]);
  });
  return all;
}

}  // namespace

const std::map<std::string, Oracle>& contact_oracles() {
  static const std::map<std::string, Oracle> all{{"normal impact", normal_impact},
                                                 {"oblique impact", oblique_impact},
                                                 {"opposite spins", opposite_spins},
                                                 {"node impact", normal_impact},
                                                 {"edge impact", normal_impact},
                                                 {"three bodies", three_bodies_in_line},
                                                 {"series", series},
                                                 {"plate meets node", plate_meets_node},
                                                 {"oblique pair", oblique_pair}};
  return all;
}

}  // namespace furrow::verification
