// Oracles of masses on springs, and of springs that tear.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/engines/oracle_parts.h"
#include "verification/own_lattice.h"

namespace furrow::verification {
namespace {

const Json& structural(const Json& c) { return c["lattice"][0]["structural"]; }
double stiffness(const Json& c) { return structural(c)["stiffness"]; }
double node_mass(const Json& c) { return c["lattice"][0]["node_mass"]; }
double swing(const Json& c) { return std::sqrt(stiffness(c) / node_mass(c)); }
double longest(const Json& c) { return structural(c)["strength"].get<double>() / stiffness(c); }  // m, x_c
double first(const Json& c, const char* what) { return c["lattice"][0]["node"][0][what][0]; }

Expected oscillator(const Json& c) {
  const double w = swing(c), t = c["end"], x0 = first(c, "displacement");
  const double decay = structural(c).value("damping", 0.0) / (2 * node_mass(c)),
               turn = std::sqrt(w * w - decay * decay);
  Expected all;
  fill(all, c, [&](const Json& seen) {
    const double fading = x0 * std::exp(-decay * t);
    if (seen["what"] == "velocity") return -fading * w * w / turn * std::sin(turn * t);
    return fading * (std::cos(turn * t) + decay / turn * std::sin(turn * t)) - x0;
  });
  return all;
}

Expected circling(const Json& c) {
  const Json& l = c["lattice"][0];
  const double longer = l["node"][1]["displacement"][0], speed = l["node"][1]["velocity"][1];
  const double r = l["spacing"].get<double>() / 2 + longer, angle = speed / r * c["end"].get<double>();
  Expected all;
  fill(all, c, [&](const Json& seen) {
    return dot({r * (std::cos(angle) - 1), r * std::sin(angle)}, vec(seen["direction"]));
  });
  return all;
}

Expected chain_mode(const Json& c) {
  const int spaces = c["lattice"][0]["columns"].get<int>() - 1;
  const double w = 2 * swing(c) * std::sin(3 * std::numbers::pi / (2 * spaces));
  Expected all;
  fill(all, c, [&](const Json& seen) {
    const std::string node = seen["of"][0];
    const int column = std::stoi(node.substr(node.rfind('.') + 1));
    return 0.02 * std::sin(3 * std::numbers::pi * column / spaces) * (std::cos(w * c["end"].get<double>()) - 1);
  });
  return all;
}

// The initial shape is A cos(q n); A and q are read off the first two masses.
Expected dispersion(const Json& c) {
  const Json& l = c["lattice"][0];
  const auto shape = [&](std::size_t column) { return l["node"][column]["displacement"][0].get<double>(); };
  const double q = std::acos(shape(1) / shape(0));
  const double k = l["structural"]["stiffness"], kb = l["bending"]["stiffness"];
  const double w =
      2 / std::sqrt(node_mass(c)) * std::sqrt(k * std::pow(std::sin(q / 2), 2) + kb * std::pow(std::sin(q), 2));
  Expected all;
  fill(all, c, [&](const Json& seen) {
    const std::string node = seen["of"][0];
    return shape(std::stoul(node.substr(node.rfind('.') + 1))) * (std::cos(w * c["end"].get<double>()) - 1);
  });
  return all;
}

// Along a row and along a diagonal the two polarisations of a square lattice part:
//   q = (q, 0)  m w^2/4 = (k + kd) sin^2(q/2)             along q,   kd sin^2(q/2)  across it
//   q = (q, q)  m w^2/4 = k sin^2(q/2) + kd sin^2(q)      along q,   k sin^2(q/2)   across it
// A and q are read off the middle node and the ones beside it and above it.
Expected square_lattice_waves(const Json& c) {
  Expected all;
  fill(all, c, [&](const Json& seen) {
    const std::string node = seen["of"][0], name = node.substr(0, node.find('.'));
    const Json& l = c["lattice"][c["lattice"][0]["name"] == name ? 0 : 1];
    const std::size_t columns = l["columns"], middle = columns * columns / 2;  // columns: odd, as many as rows
    const auto shape = [&](std::size_t n) { return vec(l["node"][n]["displacement"]); };
    const Vec start = shape(middle);
    const double q = std::acos(shape(middle + 1)[0] / start[0]);
    const bool diagonal = shape(middle + columns)[0] != start[0];
    const double half = std::pow(std::sin(q / 2), 2), whole = std::pow(std::sin(q), 2);
    const double k = l["structural"]["stiffness"], kd = l["shear"]["stiffness"], m = l["node_mass"];
    const double along = diagonal ? k * half + kd * whole : (k + kd) * half, across = diagonal ? k * half : kd * half;
    const Vec e = diagonal ? Vec{std::sqrt(0.5), std::sqrt(0.5)} : Vec{1, 0}, f{-e[1], e[0]};
    const auto way = [&](double square, Vec to) {
      return dot(start, to) * (std::cos(2 * std::sqrt(square / m) * c["end"].get<double>()) - 1);
    };
    const Vec seen_along = vec(seen["direction"]);
    return way(along, e) * dot(e, seen_along) + way(across, f) * dot(f, seen_along);
  });
  return all;
}

Expected cantilever(const Json& c) {
  const Json& l = c["lattice"][0];
  const Beam beam{.rows = l["rows"],
                  .columns = l["columns"],
                  .clamped_columns = 1,
                  .ks = l["structural"]["stiffness"],
                  .kd = l["shear"]["stiffness"],
                  .kb = l["bending"]["stiffness"],
                  .load_y = l["node"][0]["force"][1],
                  .spacing = l["spacing"]};
  const Assembly net(beam);
  const Vector u = net.equilibrium();
  Expected all;
  fill(all, c, [&](const Json& seen) { return dot({u[net.tip], u[net.tip + 1]}, vec(seen["direction"])); });
  return all;
}

Expected rests(const Json& c) {
  Expected all;
  fill(all, c, [](const Json&) { return 0.0; });
  return all;
}

Expected tear_by_load(const Json& c) {
  const double w = swing(c), k = stiffness(c), x_c = longest(c), end = c["end"];
  const double heavy = c["lattice"][0]["node"][0]["force"][0], light = c["lattice"][1]["node"][0]["force"][0];
  const double torn = std::acos(1 - k * x_c / heavy) / w, speed = heavy / k * w * std::sin(w * torn), left = end - torn;
  const double flown = x_c + speed * left + heavy / node_mass(c) * left * left / 2;
  Expected all;
  fill(all, c, [&](const Json& seen) {
    if (seen["what"] == "torn springs") return 1.0;
    return seen["of"][0] == "heavy load.0.1" ? flown : light / k * (1 - std::cos(w * end));
  });
  return all;
}

Expected tear_after(const Json& c, double wait) {
  const double w = swing(c), x_c = longest(c), v = std::fabs(first(c, "velocity"));
  Expected all;
  fill(all, c, [&](const Json& seen) {
    if (seen["what"] == "torn springs") return 1.0;
    return seen["what"] == "velocity" ? std::sqrt(v * v - w * w * x_c * x_c) : wait / w + std::asin(w * x_c / v) / w;
  });
  return all;
}

// A row of three nodes, the first fixed, the last struck along it with v: x'' = -A x, m A = [2 ks, -ks; -ks, ks + kb]; until
// kb x of the last is its strength, by both modes.
double row_tears(const Json& l) {
  const long double m = l["node_mass"].get<double>(), ks = l["structural"]["stiffness"].get<double>();
  const long double kb = l["bending"]["stiffness"].get<double>(), strength = l["bending"]["strength"].get<double>();
  const long double v = l["node"][0]["velocity"][0].get<double>();
  const long double mean = (3 * ks + kb) / (2 * m), half = std::hypot((ks - kb) / 2, ks) / m;
  const long double fast = std::sqrt(mean + half), slow = std::sqrt(mean - half);
  // Shares of the last node in the modes: a + b = 1, a fast^2 + b slow^2 = (ks + kb)/m.
  const long double a = ((ks + kb) / m - slow * slow) / (2 * half);
  const auto pulls = [&](long double t) {
    return kb * v * (a * std::sin(fast * t) / fast + (1 - a) * std::sin(slow * t) / slow);
  };
  long double low = 0, high = 0;
  while (pulls(high) < strength) {
    low = high, high += 1e-4L;
    if (high > 1) throw std::invalid_argument("the bending spring does not tear");
  }
  for (int k = 0; k < 60; ++k) (pulls((low + high) / 2) < strength ? low : high) = (low + high) / 2;
  return static_cast<double>(high);
}

// A square whose free side is struck outwards: by symmetry one node's motion, in long double until a diagonal tears.
Expected own_strength(const Json& c) {
  const Json& l = c["lattice"][0];
  const long double s = l["spacing"].get<double>(), m = l["node_mass"].get<double>(), ks = stiffness(c);
  const long double kd = l["shear"]["stiffness"].get<double>(), strength = l["shear"]["strength"].get<double>();
  struct Node {
    long double x, y, vx, vy;  // of the upper one, against its fixed neighbour and the middle
  };
  const auto diagonal = [&](const Node& n) {
    return std::hypot(n.x, n.y + s / 2) - s * std::numbers::sqrt2_v<long double>;
  };
  const auto rates = [&](const Node& n) -> Node {
    const long double level = std::hypot(n.x, n.y - s / 2), across = std::hypot(n.x, n.y + s / 2);
    const long double f = ks * (level - s) / level, g = kd * diagonal(n) / across, h = ks * (2 * n.y - s);
    return {n.vx, n.vy, -(f * n.x + g * n.x) / m, -(f * (n.y - s / 2) + g * (n.y + s / 2) + h) / m};
  };
  const auto moved = [](const Node& n, const Node& r, long double h) -> Node {
    return {n.x + h * r.x, n.y + h * r.y, n.vx + h * r.vx, n.vy + h * r.vy};
  };
  const auto step = [&](const Node& n, long double h) {
    const Node k1 = rates(n), k2 = rates(moved(n, k1, h / 2)), k3 = rates(moved(n, k2, h / 2)),
               k4 = rates(moved(n, k3, h));
    return moved(moved(moved(moved(n, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  };
  Node n{s, s / 2, first(c, "velocity"), 0};
  long double t = 0;
  for (long double h = 1e-4L; h > 1e-15L;) {
    const Node next = step(n, h);
    if (kd * diagonal(next) > strength) {
      h /= 2;
      continue;
    }
    n = next;
    t += h;
    if (t > 1) throw std::invalid_argument("the diagonal does not tear");
  }
  Expected all;
  fill(all, c, [&](const Json& seen) {
    if (seen["what"] == "torn springs") return 3.0;
    return seen["of"][0] == "cord.0.0" ? row_tears(c["lattice"][1]) : static_cast<double>(t);
  });
  return all;
}

Expected tear_by_pull(const Json& c) {
  const Json& l = c["lattice"][0];
  const double k = 4.0 / 3 * pair_of_materials(c, l["material"], "rigid")["modulus"].get<double>() * std::sqrt(0.01);
  const double force = structural(c)["strength"];
  return {{c["observe"][0]["name"],
           (longest(c) + std::cbrt(force * force / (k * k))) / c["plate"][0]["velocity"][0].get<double>()}};
}

// sqrt(k m)/T v_j = J_(2j+1)(z) + 2 sum J_(2j+1+2i)(z), see unloading_wave.cpp.
Expected unloading_wave(const Json& c) {
  const double z = 2 * swing(c) * c["end"].get<double>();
  const double tension = c["lattice"][0]["node"][0]["displacement"][0].get<double>() * stiffness(c);
  const int end = c["lattice"][0]["columns"].get<int>() - 2;
  Expected all;
  fill(all, c, [&](const Json& seen) {
    if (seen["what"] == "torn springs") return 1.0;
    const std::string node = seen["of"][0];
    const int j = end - std::stoi(node.substr(node.rfind('.') + 1));
    double sum = std::cyl_bessel_j(2.0 * j + 1, z);
    for (int n = 2 * j + 3; n < 2 * j + 3 + 4 * z; n += 2) sum += 2 * std::cyl_bessel_j(static_cast<double>(n), z);
    return -tension / std::sqrt(stiffness(c) * node_mass(c)) * sum;
  });
  return all;
}

}  // namespace

const std::map<std::string, Oracle>& spring_oracles() {
  static const std::map<std::string, Oracle> all{
      {"oscillator", oscillator},
      {"circling", circling},
      {"chain mode", chain_mode},
      {"dispersion", dispersion},
      {"waves of a square lattice", square_lattice_waves},
      {"cantilever", cantilever},
      {"rests", rests},
      {"tear by load", tear_by_load},
      {"tear by impulse", [](const Json& c) { return tear_after(c, 0); }},
      {"tear after pressure", [](const Json& c) { return tear_after(c, std::numbers::pi); }},
      {"own strength", own_strength},
      {"tear by pull", tear_by_pull},
      {"unloading wave", unloading_wave}};
  return all;
}

}  // namespace furrow::verification
