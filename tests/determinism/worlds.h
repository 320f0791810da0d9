// Worlds that differ only in what must change no bit: threads, the width of the vectors, the settings of the lists.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "run/events.h"
#include "run/system.h"
#include "scene/wording.h"

namespace furrow::test {

struct Setting {
  int threads = 1;
  double skin = 0, cell_size = 0;  // m; 0: chosen
  std::string vectors{};           // as FURROW_VECTORS, which a process has from its start; empty: the widest
};

inline std::string to_string(const Setting& s) {
  const auto length = [](const char* what, double l) { return l == 0 ? "" : what + shortest(l); };
  return std::to_string(s.threads) + (s.threads == 1 ? " thread" : " threads") + length(", skin ", s.skin) +
         length(", cell ", s.cell_size) + (s.vectors.empty() ? "" : ", vectors " + s.vectors);
}

enum class BedKind { full, elastic };

// Two blocks of discs numbered at random, so that pairs reach across them all over the bed; a plate goes through it,
// and a lattice over it tears. Elastic: nothing depends on velocity, for methods that take no other.
inline Scene bed(BedKind kind, const Setting& setting) {
  constexpr int count = 4096 + 300, a_row = 80;
  Scene s;
  Material grain;
  grain.name = "grain";
  grain.young = 5e6;
  grain.poisson = 0.25;
  s.material = {grain};
  s.search = {setting.skin, setting.cell_size, setting.threads};
  std::mt19937_64 random(11);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  std::vector<int> order(count);
  for (int k = 0; k < count; ++k) order[k] = k;
  for (int k = count - 1; k > 0; --k) std::swap(order[k], order[random() % static_cast<std::uint64_t>(k + 1)]);
  s.disc.resize(count);
  for (int place = 0; place < count; ++place) {
    s.disc[order[place]] = {{0.0198 * (place % a_row), 0.0098 + 0.0198 * static_cast<double>(place / a_row)},
                            between(0.0095, 0.0105),
                            {between(-1, 1), between(-1, 1)},
                            0,
                            "grain"};
  }
  s.wall = {{"", {0, 0}, {0, 1}, "grain"}};
  Lattice l;
  l.name = "stem";
  l.origin = {0.3, 1.12};
  l.rows = 6;
  l.columns = 3;
  l.spacing = 0.02;
  l.node_mass = 0.1;
  l.material = "grain";
  l.structural = {2e4, 0, 5};
  l.shear = {1e4, 0, 5};
  l.node = {{5, 0, {-2e-4, 0}, {-1, 0}, {}}};  // tears off in the second step
  s.lattice = {l};
  if (kind == BedKind::elastic) return s;
  for (Disc& disc : s.disc) disc.spin = between(-50, 50);
  s.contact.restitution = 0.5;
  s.contact.friction = 0.4;
  s.contact.rolling_friction = 0.1;
  s.lattice[0].structural.damping = s.lattice[0].shear.damping = 2;
  Plate p;
  p.left_edge = 0.2895;
  p.lower_edge = 1;
  p.width = 0.01;
  p.height = 0.3;
  p.velocity = {1, 0};
  p.material = "grain";
  s.plate = {p};
  s.output.energy = true;
  return s;
}

// What a run goes on from.
struct Snapshot {
  double t = 0;  // s
  State y;
  DiscreteState discrete;
  void history(HistoryVisitor& visit) {
    visit("t", t);
    visit("y", y);
    discrete.history(visit);
  }
};

// A bed under way, step by step as in a run.
class World {
 public:
  World(BedKind kind, const Setting& setting, const std::string& method)
      : system_(bed(kind, setting)),
        method_(make_method(method, {.relative = 1e-3, .absolute = 1e-6, .first_step = step_})) {
    at_.y = system_.initial_state();
    see(furrow::jump(system_, *method_, at_.t, at_.y));
  }

  void step() {
    at_.t += method_->step(system_, at_.t, at_.y, step_);
    see(furrow::jump(system_, *method_, at_.t, at_.y));
  }

  const Snapshot& now() const { return at_; }
  const System& system() const { return system_; }
  long slips() const { return slips_; }

 private:
  void see(const JumpReport& report) {
    at_.discrete = system_.discrete_state();
    slips_ += report.springs_changed ? 1 : 0;
  }

  static constexpr double step_ = 5e-5;  // s
  System system_;
  std::unique_ptr<Method> method_;
  Snapshot at_;
  long slips_ = 0;
};

}  // namespace furrow::test
