#include "studies/rest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "methods/method.h"
#include "studies/measured_run.h"

namespace furrow::studies {
namespace {

constexpr double step = 1e-4;  // s, of rk4
constexpr int steps_between_looks = 20;
constexpr int looks_to_sleep = 25;  // 50 ms
constexpr int looks_between_samples = 5;
constexpr double relaxation = 1e-3;  // s: a disc of these beds creeps at about its acceleration, from rest, times this
constexpr std::array<double, 4> bounds{1e-5, 1e-4, 1e-3, 1e-2};  // m/s; the plate moves at 0.1 m/s

// The system with some discs held where they are. All forces are evaluated as before: this measures what an active set
// would do and save, it does not save.
class Resting final : public System {
 public:
  explicit Resting(const System& system) : System(system), quiet_(static_cast<std::size_t>(parts().disc.count())) {}

  void rhs(double t, const State& y, State& dydt) const override {
    System::rhs(t, y, dydt);
    for (int i = 0; i < parts().disc.count(); ++i) {
      if (asleep(i)) set_motion(dydt, i);
    }
  }

  bool asleep(int disc) const { return quiet_[disc] >= looks_to_sleep; }

  // A disc falls asleep when it has been slower than the bound for some time; it wakes when it would creep faster.
  // Contacts of two sleeping discs do not change, so that its neighbours that are awake tell.
  void look(double t, State& y, double bound) {
    rates_.resize(size());
    System::rhs(t, y, rates_);
    for (int i = 0; i < parts().disc.count(); ++i) {
      const bool moves = std::hypot(y[vx_of(i)], y[vy_of(i)]) > bound;
      const bool driven = relaxation * std::hypot(rates_[vx_of(i)], rates_[vy_of(i)]) > bound;
      const bool before = asleep(i);
      quiet_[i] = (before ? driven : moves || driven) ? 0 : std::min(quiet_[i] + 1, looks_to_sleep);
      if (asleep(i) && !before) set_velocity(y, i);
    }
  }

 private:
  void set_velocity(State& y, int disc) const {
    y[vx_of(disc)] = y[vy_of(disc)] = 0;
    if (has_friction()) y[spin_of(disc)] = 0;
  }
  void set_motion(State& rates, int disc) const {
    rates[x_of(disc)] = rates[y_of(disc)] = 0;
    set_velocity(rates, disc);
  }

  std::vector<int> quiet_;  // looks since the disc last moved
  State rates_;
};

struct Shares {
  double contacts = 0, sleeping = 0;  // touching; of them those between sleeping discs, or a sleeping disc and a wall
};

void count(const Resting& system, double t, const State& y, Outcome& outcome, Shares& shares) {
  double x = 0;
  double height = 0;
  system.for_each_touch(t, y, [&](const TouchBlock& c) {
    shares.contacts += c.count;
    for (int k = 0; k < c.count; ++k) {
      const bool still = (c.kind == disc_disc && system.asleep(c.b[k])) || c.kind == disc_wall;
      if (still && system.asleep(c.a[k])) ++shares.sleeping;
      if (c.kind != disc_plate && c.kind != node_plate) continue;
      x -= c.force_x(k);
      height -= c.force_y(k);
    }
  });
  outcome.force.insert(outcome.force.end(), {x, height});
}

// With bound 0 nothing sleeps.
Json run_with(const Case& scene, double bound) {
  Resting system(scene.system);
  State y = scene.y;
  const auto method = make_method("rk4");
  Outcome outcome;
  Shares shares;
  const long steps = std::lround((scene.span.end() - scene.span.start) / step);
  system.jump(scene.span.start, y);
  for (long n = 0; n < steps; ++n) {
    const double t = scene.span.start + static_cast<double>(n) * step;
    if (n % (steps_between_looks * looks_between_samples) == 0) count(system, t, y, outcome, shares);
    if (bound > 0 && n % steps_between_looks == 0) system.look(t, y, bound);
    method->step(system, t, y, step);
    if (system.jump(t + step, y).flow_jumped()) method->restart();
  }
  outcome.place.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(system.positions()));
  for (int i = 0; i < system.parts().bodies(); ++i)
    outcome.reach.push_back(
        std::hypot(y[system.x_of(i)] - scene.y[system.x_of(i)], y[system.y_of(i)] - scene.y[system.y_of(i)]));
  return {{"force", outcome.force},
          {"place", outcome.place},
          {"reach", outcome.reach},
          {"share", shares.sleeping / shares.contacts}};
}

Outcome outcome_of(const Json& json) {
  Outcome o;
  o.force = json.at("force").get<std::vector<double>>();
  o.place = json.at("place").get<std::vector<double>>();
  o.reach = json.at("reach").get<std::vector<double>>();
  return o;
}

std::string percent(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", 100 * value);
  return text.data();
}

}  // namespace

void add_rest(Report& report, const Settings& settings) {
  const std::vector<std::string> names{"scenario_2", "scenario_3"};
  std::vector<CaseInfo> wanted;
  for (const std::string& name : names)
    wanted.push_back({.name = name, .span = {0, 0.01, 450}, .scene = [name] { return scene_file(name); }});
  LazyCase second(wanted[0]);
  LazyCase third(wanted[1]);
  const std::array<LazyCase*, 2> scenes{&second, &third};
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<double> all{0};
    all.insert(all.end(), bounds.begin(), bounds.end());
    for (const double bound : all)
      tasks.push_back({"rest " + names[k] + " " + std::to_string(bound),
                       [&scenes, k, bound] { return run_with(scenes[k]->get(), bound); }});
  }
  const std::vector<Json> results = run_tasks("need", settings, tasks);
  std::vector<std::vector<Json>> rows;
  std::string best;
  double most = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t first = k * (bounds.size() + 1);
    const Outcome base = outcome_of(results[first]);
    for (std::size_t b = 0; b < bounds.size(); ++b) {
      const Json& result = results[first + 1 + b];
      if (result.contains("failed")) {
        rows.push_back({names[k], bounds[b], "failed: " + result["failed"].get<std::string>()});
        continue;
      }
      const Error error = error_of(outcome_of(result), base);
      const double share = result["share"];
      rows.push_back({names[k], bounds[b], 100 * share, 100 * error.force, 100 * error.place});
      if (error.force < 0.01 && share > most) {
        most = share;
        best = names[k];
      }
    }
  }
  report.heading("Rest");
  report.text(
      "Most discs of the second and third scene hardly move. An active set would not evaluate contacts between "
      "sleeping discs: a disc falls asleep when it has been slower than a bound for 50 ms, and wakes when its force "
      "would make it creep faster than the bound, so that it is misplaced by less than the bound times the time. "
      "Measured with all forces evaluated and the sleeping discs held.");
  report.table("What could be left out over the whole scene, and the error that comes of it",
               {"scene", "bound [m/s]", "contacts asleep [%]", "force curve [%]", "positions [%]"}, rows);
  report.text(most > 0 ? "With less than 1 % of error in the force curve at most " + percent(most) +
                             " % of the contacts sleep, in " + best + ": an evaluation could become " +
                             percent(1 / (1 - most) - 1) + " % faster at best, if looking cost nothing."
                       : "No bound that lets a contact sleep keeps the force curve within 1 %.");
}

}  // namespace furrow::studies
