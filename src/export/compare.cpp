#include "export/compare.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "export/engine_output.h"
#include "export/export.h"
#include "methods/method.h"
#include "output/files.h"
#include "run/observe.h"
#include "run/run.h"
#include "scene/read.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<double>>;

constexpr double least_order = 0.8;  // of a fit over two steps; between order 1 and none
constexpr double floor_of_error = 1e-9;
constexpr double most_with_one_step = 0.05;  // what a step that is a tenth of a contact time leaves at order 1
constexpr int blocks = 10;                   // of the later force
constexpr double most_steps_apart = 3;       // a node loses one link a step there, so that several at once take several

// furrow's own run: forces by row as the deck writes them, the state at the end, and what tore.
struct OwnRun {
  Rows forces;
  State end;
  std::vector<Tear> tears;
};

OwnRun own_run(Prepared& prepared, const std::string& method_name, double step, double until) {
  OwnRun own;
  System& system = prepared.system;
  const Timing& time = prepared.scene.time;
  const auto method = make_method(method_name, {time.relative_tolerance, time.absolute_tolerance, step});
  const double interval = prepared.scene.output.interval;
  own.end = prepared.y;
  RunPlan plan{.start = 0, .end = until, .step = step};
  long row = 0;
  plan.stop = [&](double t) { return interval * std::floor(t / interval + 1 + 1e-9); };
  const RunEnd ended = run(system, *method, own.end, plan, [&](double t, const State& y, const JumpReport& jump) {
    own.tears.insert(own.tears.end(), jump.torn.begin(), jump.torn.end());
    if (t < static_cast<double>(row) * interval - 0.5 * step) return true;
    const Observation seen = observe(system, t, y);
    own.forces.push_back({static_cast<double>(row)});
    for (const auto& list : {seen.plate, seen.wall})
      for (const Force& f : list) own.forces.back().insert(own.forces.back().end(), {f.x, f.y});
    ++row;
    return true;
  });
  if (ended.ending != Ending::finished) throw Divergence("furrow's own run: " + ended.reason);
  return own;
}

// Of one plate or wall: columns c and c + 1.
double greatest_of(const Rows& rows, std::size_t c) {
  double most = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) most = std::max(most, std::hypot(rows[k][c], rows[k][c + 1]));
  return most;
}

// Over the greatest force. The first row is passed over: the engine's plates have no speed before their first step.
double error_of(const Rows& engine, const Rows& own, std::size_t c) {
  double most = 0;
  const std::size_t count = std::min(engine.size(), own.size());
  for (std::size_t k = 1; k < count; ++k)
    most = std::max(most, std::hypot(engine[k][c] - own[k][c], engine[k][c + 1] - own[k][c + 1]));
  return most / greatest_of(own, c);
}

struct Mean {
  double value = 0, error = 0;  // N, its standard error
};

// Of the size of the force, over the rows after `first`.
Mean mean_of(const Rows& rows, std::size_t c, std::size_t first) {
  const std::size_t count = rows.size() > first ? (rows.size() - first) / blocks : 0;
  if (count == 0) return {};
  std::vector<double> means(blocks, 0.0);
  for (std::size_t k = 0; k < blocks * count; ++k)
    means[k / count] += std::hypot(rows[first + k][c], rows[first + k][c + 1]) / static_cast<double>(count);
  Mean mean;
  double square = 0;
  for (const double m : means) mean.value += m / blocks;
  for (const double m : means) square += (m - mean.value) * (m - mean.value);
  mean.error = std::sqrt(square / (blocks - 1) / blocks);
  return mean;
}

class Comparison {
 public:
  Comparison(const fs::path& directory, double early)
      : outputs_(engine_outputs(directory)), scene_(read_scene(directory / "scene.toml")) {
    std::ifstream file(directory / "export.json");
    told_ = Json::parse(file, nullptr, false);
    if (told_.is_discarded())
      throw FileError((directory / "export.json").string() + ": is not what furrow export writes");
    early_ = std::min(early, scene_.time.end);
    exact_ = told_.at("deviations").empty();
  }

  Compared compare() {
    out_.json = {{"engine", told_.at("to")}, {"deviations", told_.at("deviations")}};
    compare_early();
    compare_later();
    if (!exact_) say("The deck has another law than the scene, so none of this is a verdict: keys.md says where.");
    out_.json["good"] = out_.good;
    return out_;
  }

 private:
  void say(const std::string& line) { out_.text += line + "\n"; }
  std::size_t parts() const { return scene_.plate.size() + scene_.wall.size(); }
  std::string part(std::size_t k) const {
    const bool plate = k < scene_.plate.size();
    const std::size_t i = plate ? k : k - scene_.plate.size();
    const std::string& name = plate ? scene_.plate[i].name : scene_.wall[i].name;
    return (plate ? "plate " : "wall ") + (name.empty() ? std::to_string(i) : name);
  }

  void compare_early() {
    const int finest = outputs_.back().refine;
    const double step = scene_.time.step / finest;
    Prepared prepared = prepare(scene_);
    const OwnRun own = own_run(prepared, "rk4", step, early_);
    Json list = Json::array();
    say("force up to " + shortest(early_) + " s, error over the greatest force, against furrow's rk4 at " +
        shortest(step) + " s:");
    for (std::size_t k = 0; k < parts(); ++k) {
      if (greatest_of(own.forces, 2 * k + 1) > 0) list.push_back(early_force(own.forces, k));
    }
    out_.json["early"] = {{"until", early_}, {"step", step}, {"parts", list}};
  }

  Json early_force(const Rows& own, std::size_t k) {
    Json steps = Json::array();
    std::vector<double> errors;
    std::string line = "  " + part(k) + ", to " + rounded(greatest_of(own, 2 * k + 1), 4) + " N:";
    for (const EngineOutput& output : outputs_) {
      if (output.forces.empty()) continue;
      const double h = scene_.time.step / output.refine;
      errors.push_back(error_of(output.forces, own, 2 * k + 1));
      steps.push_back({{"step", h}, {"error", errors.back()}});
      line += " " + rounded(errors.back(), 3) + " at " + shortest(h) + " s" + (&output == &outputs_.back() ? "" : ",");
    }
    Json json{{"part", part(k)}, {"greatest", greatest_of(own, 2 * k + 1)}, {"steps", steps}};
    if (errors.size() > 1) {
      const auto n = errors.size();
      const double ratio = static_cast<double>(outputs_[n - 1].refine) / outputs_[n - 2].refine;
      const double order = std::log(errors[n - 2] / errors[n - 1]) / std::log(ratio);
      json["order"] = order;
      line += "; order " + rounded(order, 3);
      judge(order >= least_order || errors.back() < floor_of_error);
    } else if (!errors.empty()) {
      line += "; for the order run it with -var refine 10 too";
      judge(errors.back() < most_with_one_step);
    }
    say(line);
    return json;
  }

  void judge(bool good) { out_.good = out_.good && (good || !exact_); }

  void compare_later() {
    Prepared prepared = prepare(scene_);
    const OwnRun own = own_run(prepared, scene_.time.method, scene_.time.step, scene_.time.end);
    const EngineOutput& engine = outputs_.front();
    const auto first = static_cast<std::size_t>(early_ / scene_.output.interval);
    Json later = Json::array();
    for (std::size_t k = 0; k < scene_.plate.size() && !engine.forces.empty(); ++k) {
      const Mean ours = mean_of(own.forces, 2 * k + 1, first), theirs = mean_of(engine.forces, 2 * k + 1, first);
      if (ours.value == 0) continue;
      later.push_back(
          {{"part", part(k)}, {"furrow", {ours.value, ours.error}}, {"engine", {theirs.value, theirs.error}}});
      say("mean push after that, " + part(k) + ": engine " + rounded(theirs.value, 4) + " +- " +
          rounded(theirs.error, 2) + " N, furrow " + rounded(ours.value, 4) + " +- " + rounded(ours.error, 2) + " N");
    }
    out_.json["later"] = later;
    compare_ends(prepared.system, own, engine);
    if (prepared.system.parts().link.count() > 0) compare_links(prepared.system, own, engine);
  }

  void compare_ends(const System& system, const OwnRun& own, const EngineOutput& engine) {
    const int discs = system.parts().disc.count();
    const NodeMotion nodes = system.nodes(scene_.time.end, own.end);
    State theirs = own.end;
    double apart = 0, ours_high = 0, theirs_high = 0;
    for (const EngineBody& body : engine.end) {
      const int k = body.id - 1;
      const Vec2 at = discs > 0 ? Vec2{own.end[system.x_of(k)], own.end[system.y_of(k)]} : Vec2{nodes.x[k], nodes.y[k]};
      apart = std::max(apart, std::hypot(at.x - body.at.x, at.y - body.at.y));
      if (discs == 0) continue;
      ours_high += at.y / discs;
      theirs_high += body.at.y / discs;
      theirs[system.x_of(k)] = body.at.x;
      theirs[system.y_of(k)] = body.at.y;
    }
    out_.json["end"] = {{"bodies", engine.end.size()}, {"greatest_distance", apart}};
    say("at the end: no body further than " + rounded(apart, 3) + " m from where furrow has it");
    if (discs == 0) return;
    const double ours = surface_height(system, own.end), other = surface_height(system, theirs);
    out_.json["end"]["mean_height"] = {{"furrow", ours_high}, {"engine", theirs_high}};
    out_.json["end"]["surface"] = {{"furrow", ours}, {"engine", other}};
    say("mean height: engine " + rounded(theirs_high, 6) + " m, furrow " + rounded(ours_high, 6) +
        " m; surface: engine " + rounded(other, 4) + " m, furrow " + rounded(ours, 4) + " m");
  }

  void compare_links(const System& system, const OwnRun& own, const EngineOutput& engine) {
    const LinkArrays& link = system.parts().link;
    std::set<std::pair<int, int>> intact;
    for (const auto& row : engine.links)
      intact.insert(std::minmax({static_cast<int>(row[0]) - 1, static_cast<int>(row[1]) - 1}));
    int ours = 0, theirs = 0, both = 0;
    for (int k = 0; k < link.count(); ++k) {
      if (std::binary_search(link.notched.begin(), link.notched.end(), k)) continue;
      const bool torn = system.torn(k), torn_there = !intact.contains(std::minmax(link.a[k], link.b[k]));
      ours += torn;
      theirs += torn_there;
      both += torn && torn_there;
    }
    const Lateness late = lateness(own, engine);
    out_.json["links"] = {
        {"furrow", ours}, {"engine", theirs}, {"both", both}, {"early", late.tears}, {"steps_apart", late.steps}};
    say("torn links: engine " + std::to_string(theirs) + ", furrow " + std::to_string(ours) + ", the same " +
        std::to_string(both) + "; of the " + std::to_string(late.tears) + " up to " + shortest(early_) +
        " s each within " + rounded(late.steps, 3) + " steps");
    judge(late.steps <= most_steps_apart);
  }

  struct Lateness {
    int tears = 0;     // of furrow's, early
    double steps = 0;  // of the scene, between the n-th here and there
  };

  Lateness lateness(const OwnRun& own, const EngineOutput& engine) const {
    Lateness late;
    for (const Tear& tear : own.tears) {
      if (tear.time > early_) break;
      const auto n = static_cast<double>(++late.tears);
      const auto at =
          std::find_if(engine.tears.begin(), engine.tears.end(), [&](const auto& row) { return row[1] >= n; });
      const double step = at == engine.tears.end() ? infinity : (*at)[0] / engine.refine;
      late.steps = std::max(late.steps, std::fabs(step - tear.time / scene_.time.step));
    }
    return late;
  }

  const std::vector<EngineOutput> outputs_;
  const Scene scene_;
  Json told_;
  double early_ = 0;
  bool exact_ = true;
  Compared out_;
};

}  // namespace

Compared compare_with_engine(const fs::path& directory, double early) { return Comparison(directory, early).compare(); }

}  // namespace furrow
