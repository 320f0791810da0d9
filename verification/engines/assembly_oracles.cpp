// Oracles of bodies that roll, bounce, rest on each other or hand on momentum.
#include <Eigen/Dense>
#include <cmath>

#include "verification/engines/oracle_parts.h"
#include "verification/rolling_scenes.h"

namespace furrow::verification {
namespace {

double c_of(const Json& body) {
  const double r = body["radius"];
  return body["inertia"].get<double>() / (body["mass"].get<double>() * r * r);
}
double weight(const Json& c) { return std::hypot(c["gravity"][0].get<double>(), c["gravity"][1].get<double>()); }

Expected slide_to_roll(const Json& c) {
  const Json& b = c["body"][0];
  const double r = b["radius"], height = b["position"][1];
  const double arm = c["contact"]["moment_arm"] == "radius" ? r : height;  // it starts at rest on the floor
  const double end = b["velocity"][0].get<double>() / (1 + c_of(b) * r * r / (arm * arm));
  Expected all;
  fill(all, c, [&](const Json& seen) { return seen["what"] == "spin" ? -end / arm : end; });
  return all;
}

Expected rolling_down(const Json& c) {
  const Json& b = c["body"][0];
  const double rise = -c["wall"][0]["normal"][0].get<double>(), r = b["radius"];
  const double gained = weight(c) * rise / (1 + c_of(b)) * c["end"].get<double>();
  const double start = std::hypot(b["velocity"][0].get<double>(), b["velocity"][1].get<double>());
  Expected all;
  fill(all, c, [&](const Json& seen) { return (start + gained) / (seen["what"] == "spin" ? r : 1); });
  return all;
}

// It slides from the start; its friction is at the limit.
Expected sliding_down(const Json& c) {
  const Json& b = c["body"][0];
  const Vec n = vec(c["wall"][0]["normal"]);
  const double push = c["contact"]["friction"].get<double>() * weight(c) * n[1], t = c["end"];  // m/s^2
  const double start = std::hypot(b["velocity"][0].get<double>(), b["velocity"][1].get<double>());
  Expected all;
  fill(all, c, [&](const Json& seen) {
    return seen["what"] == "spin" ? push * t / (c_of(b) * b["radius"].get<double>())
                                  : start + (weight(c) * -n[0] - push) * t;
  });
  return all;
}

// m g R sin(theta) = mu_r R m g cos(theta) w/sqrt(w^2 + w0^2)
Expected creep_down(const Json& c) {
  const Vec n = vec(c["wall"][0]["normal"]);
  const double share = -n[0] / n[1] / c["contact"]["rolling_friction"].get<double>();
  const double spin = c["contact"]["rolling_smoothing"].get<double>() * share / std::sqrt(1 - share * share);
  Expected all;
  fill(all, c,
       [&](const Json& seen) { return seen["what"] == "spin" ? spin : spin * c["body"][0]["radius"].get<double>(); });
  return all;
}

// Friction m g sin(theta) = St xi, moment m g R sin(theta) = kr turn; the centre goes by both.
Expected rest_on_slope(const Json& c) {
  const Json& b = c["body"][0];
  const Vec n = vec(c["wall"][0]["normal"]);
  const double m = b["mass"], r = b["radius"], pull = m * weight(c) * -n[0];
  const Json& pair = pair_of_materials(c, b["material"], c["wall"][0]["material"]);
  const double k = 4.0 / 3 * pair["modulus"].get<double>() * std::sqrt(r);
  const double contact_radius = std::sqrt(r) * std::cbrt(m * weight(c) * n[1] / k);
  const double tangential = 8 * pair["shear_modulus"].get<double>() * contact_radius;
  const double way = pull * (r * r / c["contact"]["rolling_stiffness"].get<double>() + 1 / tangential);
  Expected all;
  fill(all, c, [&](const Json& seen) { return seen["what"] == "displacement" ? way : 0.0; });
  return all;
}

// falling(omega) = falling(omega at the start) - mu_r g t / (c R), solved by bisection.
Expected rolling_decay(const Json& c) {
  const Json& b = c["body"][0];
  const double w0 = c["contact"]["rolling_smoothing"], start = b["spin"];
  const double left = rolling_resistance::falling(start, w0) - c["contact"]["rolling_friction"].get<double>() *
                                                                   weight(c) * c["end"].get<double>() /
                                                                   (c_of(b) * b["radius"].get<double>());
  double low = 0, high = start;
  for (int k = 0; k < 200; ++k) {
    const double middle = (low + high) / 2;
    (rolling_resistance::falling(middle, w0) < left ? low : high) = middle;
  }
  return {{c["observe"][0]["name"], low}};
}

// Fall, a damped swing about the place of rest until the overlap ends, flight.
Expected linear_bounce(const Json& c) {
  const Json& b = c["body"][0];
  const double m = b["mass"], r = b["radius"], g = weight(c), h = b["position"][1];
  const double k = c["contact"]["kn"], cn = c["contact"]["cn"];
  const double fall = std::sqrt(2 * (h - r) / g), v = g * fall;
  const double decay = cn / (2 * m), turn = std::sqrt(k / m - decay * decay), rest = m * g / k;
  const auto depth = [&](double t) {
    return rest + std::exp(-decay * t) * (-rest * std::cos(turn * t) + (v - decay * rest) / turn * std::sin(turn * t));
  };
  const auto speed = [&](double t) {
    const double s = (v - decay * rest) / turn;
    return std::exp(-decay * t) *
           ((turn * s + decay * rest) * std::cos(turn * t) + (turn * rest - decay * s) * std::sin(turn * t));
  };
  double leave = 3 / turn;
  for (int n = 0; n < 50; ++n) leave -= depth(leave) / speed(leave);
  const double up = -speed(leave), flight = c["end"].get<double>() - fall - leave;
  Expected all;
  fill(all, c, [&](const Json& seen) {
    return seen["what"] == "velocity" ? up - g * flight : r + up * flight - g * flight * flight / 2 - h;
  });
  return all;
}

// Two masses on three springs that stay closed.
Expected linear_stack(const Json& c) {
  const Json &low = c["body"][0], &high = c["body"][1];
  const double m1 = low["mass"], m2 = high["mass"], r = low["radius"], k = c["contact"]["kn"], g = weight(c),
               t = c["end"];
  const double y1 = low["position"][1], y2 = high["position"][1], lid = c["wall"][1]["point"][1];
  Eigen::Matrix2d a;
  a << 2 * k, -k, -k, 2 * k;
  const Eigen::Vector2d load(k * r - k * 2 * r - m1 * g, k * 2 * r - k * (r - lid) - m2 * g);
  const Eigen::Vector2d rest = a.inverse() * load, mass(m1, m2), start(y1, y2);
  const Eigen::Vector2d root = mass.cwiseSqrt();
  const Eigen::Matrix2d scaled = root.cwiseInverse().asDiagonal() * a * root.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes(scaled);
  Eigen::Vector2d q = modes.eigenvectors().transpose() * (root.asDiagonal() * (start - rest));
  for (int i = 0; i < 2; ++i) q[i] *= std::cos(std::sqrt(modes.eigenvalues()[i]) * t);
  const Eigen::Vector2d end = rest + root.cwiseInverse().asDiagonal() * (modes.eigenvectors() * q);
  Expected all;
  fill(all, c, [&](const Json& seen) { return seen["of"][0] == "lower" ? end[0] - y1 : end[1] - y2; });
  return all;
}

Expected stack(const Json& c) {
  const Json& bodies = c["body"];
  Expected all;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    double carried = 0;
    for (std::size_t k = i; k < bodies.size(); ++k) carried += bodies[k]["mass"].get<double>() * weight(c);
    const Json& below = i == 0 ? c["wall"][0] : bodies[i - 1];
    const double modulus = pair_of_materials(c, bodies[i]["material"], below["material"])["modulus"];
    const double curvature = 1 / bodies[i]["radius"].get<double>() + (i == 0 ? 0 : 1 / below["radius"].get<double>());
    const double k = 4.0 / 3 * modulus / std::sqrt(curvature);
    all[c["observe"][i]["name"]] = std::cbrt(carried * carried / (k * k));
  }
  return all;
}

Expected cradle(const Json& c) {
  double incoming = c["body"][0]["velocity"][0];
  Expected all;
  for (std::size_t i = 0; i < c["body"].size(); ++i) {
    const bool last = i + 1 == c["body"].size();
    const double m1 = c["body"][i]["mass"], m2 = last ? 0 : c["body"][i + 1]["mass"].get<double>();
    all[c["observe"][i]["name"]] = last ? incoming : (m1 - m2) / (m1 + m2) * incoming;
    incoming *= 2 * m1 / (m1 + m2);
  }
  return all;
}

Expected conserved(const Json& c) {
  double px = 0, py = 0, spin = 0;
  for (const Json& b : c["body"]) {
    const double m = b["mass"];
    const Vec x = vec(b["position"]), v = vec(b["velocity"]);
    px += m * v[0];
    py += m * v[1];
    spin += m * (x[0] * v[1] - x[1] * v[0]) + b["inertia"].get<double>() * b["spin"].get<double>();
  }
  Expected all;
  fill(all, c, [&](const Json& seen) {
    return seen["what"] == "momentum" ? dot({px, py}, vec(seen["direction"])) : spin;
  });
  return all;
}

}  // namespace

const std::map<std::string, Oracle>& assembly_oracles() {
  static const std::map<std::string, Oracle> all{{"slide to roll", slide_to_roll},
                                                 {"rolling down", rolling_down},
                                                 {"sliding down", sliding_down},
                                                 {"creep down", creep_down},
                                                 {"rest on slope", rest_on_slope},
                                                 {"rolling decay", rolling_decay},
                                                 {"linear bounce", linear_bounce},
                                                 {"linear stack", linear_stack},
                                                 {"stack", stack},
                                                 {"cradle", cradle},
                                                 {"conserved", conserved}};
  return all;
}

}  // namespace furrow::verification
