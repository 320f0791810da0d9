#include "validation/studies/observed_run.h"

#include <array>
#include <cmath>

#include "output/first_touch.h"
#include "output/schedule.h"
#include "physics/stress.h"
#include "report/embedded.h"
#include "report/seal.h"
#include "run/observe.h"
#include "run/run.h"
#include "system/place.h"

namespace furrow::validation {
namespace {

Frame frame_of(const System& system, double t, const State& y) {
  std::vector<std::vector<double>> discs(4), links(4), plates(4);
  const auto add = [](std::vector<std::vector<double>>& to, const std::array<double, 4>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) to[k].push_back(row[k]);
  };
  const std::vector<Stress> stress = disc_stresses(system, t, y);
  for (const int i : places_in(system.parts().disc.number))
    add(discs, {y[system.x_of(i)], y[system.y_of(i)], system.parts().disc.radius[i], von_mises(stress[i])});
  const NodeMotion node = system.nodes(t, y);
  const LinkArrays& link = system.parts().link;
  for (int k = 0; k < link.count(); ++k) {
    if (!system.torn(k)) add(links, {node.x[link.a[k]], node.y[link.a[k]], node.x[link.b[k]], node.y[link.b[k]]});
  }
  for (int k = 0; k < std::ssize(system.parts().plate); ++k) {
    const auto [left, lower, vx, vy] = system.plate_at(k, t);
    add(plates, {left, lower, system.parts().plate[k].width, system.parts().plate[k].height});
  }
  return {.discs = Table({"x [m]", "y [m]", "radius [m]", "von Mises [Pa]"}, discs),
          .links = Table({"x1 [m]", "y1 [m]", "x2 [m]", "y2 [m]"}, links),
          .plates = Table({"left [m]", "lower [m]", "width [m]", "height [m]"}, plates)};
}

}  // namespace

RunRecord observed_run(Prepared prepared, const Timing& time, Watch watch) {
  System& system = prepared.system;
  const double interval = prepared.scene.output.interval;
  RunRecord record;
  record.scene = prepared.scene;
  record.lattices = system.parts();
  const auto mm = [&](double t) { return plate_displacement(record, t); };
  const auto method = make_method(time.method, {time.relative_tolerance, time.absolute_tolerance, time.step});
  const bool controlled = method->info().controlled;
  Due due(method->info(), time.step, interval);
  double last = -1;  // s, of the last sample
  const auto sample = [&](double t, const Force& force) {
    last = t;
    record.force.mm.push_back(mm(t));
    record.force.fx.push_back(0 - force.x);
    record.force.fy.push_back(force.y);
    record.force.f.push_back(std::hypot(force.x, force.y));
  };
  std::optional<Validity> validity;
  if (watch == Watch::on) validity.emplace(system, prepared.scene, [](const std::string&) {});
  const RunPlan plan{.start = 0,
                     .end = time.end,
                     .step = controlled ? time.max_step : time.step,
                     .stop = [&](double t) { return due.stop(t, time.end); },
                     .locate = time.locate,
                     .validity = validity ? &*validity : nullptr};
  FirstTouch touch;
  const RunEnd end = run(system, *method, prepared.y, plan, [&](double t, const State& y, const JumpReport& jump) {
    touch.see(system, t, y);
    for (const Tear& tear : jump.torn) record.torn.push_back({mm(tear.time), tear.link});
    const std::vector<double>& pictures = prepared.scene.output.frames;
    while (record.frames.size() < pictures.size() && t >= pictures[record.frames.size()] - due.slack()) {
      record.frames.push_back(frame_of(system, t, y));
      record.frames.back().mm = mm(t);
    }
    if (!due.at(t)) return true;
    const Observation seen = observe(system, t, y);
    if (validity) validity->judge_row(t, seen);
    sample(t, seen.plate.at(0));
    due.take(t);
    return true;
  });
  record.force.due = record.force.mm.size();
  if (end.time != last) sample(end.time, observe(system, end.time, prepared.y).plate.at(0));
  record.met = std::isfinite(touch.time()) ? mm(touch.time()) : std::numeric_limits<double>::quiet_NaN();
  record.facts = {{"ended", {end.ending == Ending::finished ? "finished" : "diverged"}},
                  {"reason", {end.reason}},
                  {"rhs_evaluations", {std::to_string(method->evaluations())}},
                  {"steps", {std::to_string(end.steps)}}};
  return record;
}

std::vector<Reported> reported(const RunRecord& run, const Publication& paper, const std::string& scene) {
  std::vector<Reported> all;
  for (const Statement& s : paper.statements) {
    if (s.scene == scene) all.push_back({s.id, measure(run, s.observable, s.window)});
  }
  return all;
}

const Publication& the_paper() {
  static const Publication paper = read_publication(embedded("validation/statements.toml"));
  return paper;
}

std::string hash_of_observed(const Scene& made, const std::string& scene) {
  std::string asked;
  for (const Statement& s : the_paper().statements) {
    if (s.scene != scene) continue;
    asked += s.id + " " + s.observable;
    if (s.window) asked += " " + std::to_string((*s.window)[0]) + " " + std::to_string((*s.window)[1]);
    asked += "\n";
  }
  return hash_of(hash_of_scene(made) + "\n" + asked);
}

}  // namespace furrow::validation
