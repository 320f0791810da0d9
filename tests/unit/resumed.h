// Runs that are saved on their way, and others that go on from there.
#pragma once

#include <bit>
#include <string>
#include <vector>

#include "output/checkpoint.h"
#include "scenes.h"

namespace furrow::test {

struct Setting {
  std::string method;
  Locate locate = Locate::none;
  double end = 0, step = 0;  // s
};

// A system under way, with all that it takes to go on.
struct Running {
  System system;
  std::unique_ptr<Method> method;
  State y;
  RunPoint point{};
  std::string before_end;  // saved before the first step that has the end in sight

  Running(const Scene& scene, const Setting& setting)
      : system(scene), method(make_method(setting.method, {.first_step = setting.step})), y(system.initial_state()) {}

  void history(HistoryVisitor& visit) {
    DiscreteState discrete = system.discrete_state();
    visit("y", y);
    discrete.history(visit);
    method->history(visit);
    point.history(visit);
    system.restore(discrete);
  }

  template <class AfterEach>
  RunEnd go_on(const Setting& setting, AfterEach after_each) {
    RunPlan plan;
    plan.end = setting.end;
    plan.step = setting.step;
    plan.locate = setting.locate;
    plan.point = &point;
    plan.before_end = [this] {
      HistoryWriter writer;
      history(writer);
      before_end = writer.bytes();
    };
    // Stops as those of output rows, so that a controlled method's step is cut now and then.
    plan.stop = [&](double t) {
      return std::min(setting.end, (std::floor(t / (7 * setting.step)) + 1) * 7 * setting.step);
    };
    return run(system, *method, y, plan, after_each);
  }
};

// Positions, velocities, spins, springs, the ledger, angles and the time, but for slots that nothing holds: so they are the
// same however much room there is.
inline std::vector<std::uint64_t> bits_of(const System& system, double t, const State& y) {
  std::vector<std::uint64_t> bits{std::bit_cast<std::uint64_t>(t), system.state_hash(y)};
  for (int k = 0; system.keeps_ledger() && k < ledger_entries; ++k)
    bits.push_back(std::bit_cast<std::uint64_t>(y[system.ledger_of(static_cast<Ledger>(k))]));
  for (int disc = 0; disc < system.layout().angles; ++disc)
    bits.push_back(std::bit_cast<std::uint64_t>(y[system.layout().angle_of(disc)]));
  return bits;
}

struct Course {
  RunEnd end;
  std::vector<std::vector<std::uint64_t>> bits;  // after the start and after each step
  std::vector<std::string> saved;                // then, too
  std::vector<std::size_t> tears, slips;         // at which of them
};

inline Course course_of(Running& running, const Setting& setting, bool saves) {
  Course c;
  c.end = running.go_on(setting, [&](double t, const State& y, const JumpReport& report) {
    if (!report.torn.empty()) c.tears.push_back(c.bits.size());
    if (report.springs_changed) c.slips.push_back(c.bits.size());
    c.bits.push_back(bits_of(running.system, t, y));
    HistoryWriter writer;
    if (saves) running.history(writer);
    c.saved.push_back(writer.bytes());
    return true;
  });
  return c;
}

// Of a new system and a new method that go on from what was saved.
inline Course course_from(const Scene& scene, const Setting& setting, const std::string& saved) {
  Running running(scene, setting);
  HistoryReader reader(saved);
  running.history(reader);
  return course_of(running, setting, false);
}

}  // namespace furrow::test
