#include "export/compare.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "export/deck_record.h"
#include "export/engine_output.h"
#include "export/own_run.h"
#include "export/tears_apart.h"
#include "output/build_info.h"
#include "run/observe.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "system/place.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double least_order = 0.8;  // of a fit over two steps; between order 1 and none
constexpr double no_force = 1;       // the error of an engine in which nothing feels a force
constexpr double floor_of_error = 1e-9;
constexpr double most_at_least_step = 0.05;  // what a step that is a tenth of a contact time leaves at order 1
constexpr double most_held_apart = 1e-4;     // spacings: what is printed has six digits and more
constexpr double most_places_apart = 1e-6;   // of the greatest way: rounding, grown by a long run
constexpr double most_steps_apart = 3;       // a node loses one link a step there, so that several at once take several

std::string newtons(double force) { return rounded(force, 4) + " N"; }

class Comparison {
 public:
  Comparison(const fs::path& directory, double early)
      : record_(read_deck_record(directory)),
        scene_(read_scene(directory / "scene.toml")),
        run_(deck_run(prepare(scene_))),
        outputs_(engine_outputs(directory, run_, record_.scene_hash)),
        early_(std::min(early, scene_.time.end)),
        exact_(record_.deviations.empty()) {
    if (early < run_.interval() * (1 - 1e-9))
      throw std::invalid_argument("--early: " + shortest(early) + " s is before the first row of the output, at " +
                                  shortest(run_.interval()) + " s; choose a longer one");
  }

  Compared compare() {
    out_.json = {{"engine", record_.to},
                 {"exported_by", record_.furrow},
                 {"compared_by", build_info().commit},
                 {"scene_hash", record_.scene_hash},
                 {"deviations", record_.deviations}};
    compare_early();
    compare_later();
    conclude();
    return out_;
  }

 private:
  void say(const std::string& line) { out_.text += line + "\n"; }
  std::string part(std::size_t k) const {
    const bool plate = k < scene_.plate.size();
    const std::size_t i = plate ? k : k - scene_.plate.size();
    const std::string& name = plate ? scene_.plate[i].name : scene_.wall[i].name;
    return (plate ? "plate " : "wall ") + (name.empty() ? std::to_string(i) : name);
  }

  // As it stands in the file.
  Json judged(const std::string& what, bool good) {
    compared_ = true;
    if (!exact_) return {};
    (good ? good_ : bad_).push_back(what);
    return good;
  }

  void conclude() {
    if (!bad_.empty() || !good_.empty()) out_.good = bad_.empty();
    out_.in_vain = !compared_;
    out_.json["good"] = out_.good ? Json(*out_.good) : Json();
    if (!compared_) say_nothing_compared();
    if (!exact_) say("The deck has another law than the scene, so none of this is a verdict: keys.md says where.");
    if (out_.good)
      say("Verdict: " + std::string(*out_.good ? "good: " : "not good: ") + joined(*out_.good ? good_ : bad_) +
          (bad_.empty() || good_.empty() ? "" : "; good: " + joined(good_)) + ". Nothing else is judged.");
  }

  void say_nothing_compared() {
    if (run_.parts == 0)
      return say("Nothing was compared: the scene has no plate, no wall, and no link tore up to " + shortest(early_) +
                 " s. Places are judged of a lattice alone that goes by verlet.");
    say("Nothing was compared: up to " + shortest(early_) +
        " s no plate or wall had a force, and no link tore; choose a longer --early. Places are judged of a lattice "
        "alone "
        "that does not tear and goes by verlet.");
  }

  void compare_early() {
    Json list = Json::array();
    const double step = scene_.time.step / outputs_.back().refine;
    if (run_.parts > 0) {
      Prepared prepared = prepare(scene_);
      const OwnRun own = own_run(prepared, "rk4", step, early_);
      say("force up to " + shortest(early_) + " s, " + std::to_string(own.forces.size() - 1) +
          " rows, error over the greatest force, against furrow's rk4 at " + shortest(step) + " s:");
      for (std::size_t k = 0; k < run_.parts; ++k) list.push_back(early_force(own.forces, k));
    }
    out_.json["early"] = {{"until", early_}, {"step", step}, {"parts", list}};
  }

  Json early_force(const ForceRows& own, std::size_t k) {
    const std::size_t c = 2 * k + 1;
    const double greatest = greatest_force(own, c, own.size());
    if (greatest > 0) return early_errors(own, k, greatest);
    double theirs = 0;
    for (const EngineOutput& output : outputs_)
      theirs = std::max(theirs, greatest_force(output.forces, c, own.size() - 1));
    const Json good = theirs > 0 ? judged("the force on " + part(k), false) : Json();
    say("  " + part(k) + ": " +
        (theirs > 0 ? "no force in furrow, to " + newtons(theirs) + " in the engine" : "no force in either"));
    return {{"part", part(k)}, {"greatest", 0}, {"engine", theirs}, {"good", good}};
  }

  Json early_errors(const ForceRows& own, std::size_t k, double greatest) {
    Json steps = Json::array();
    std::vector<double> errors;
    std::string line = "  " + part(k) + ", to " + newtons(greatest) + ":";
    for (const EngineOutput& output : outputs_) {
      const double h = scene_.time.step / output.refine;
      errors.push_back(force_error(output.forces, own, 2 * k + 1));
      steps.push_back({{"step", h}, {"error", errors.back()}});
      line += " " + rounded(errors.back(), 3) + " at " + shortest(h) + " s" + (&output == &outputs_.back() ? "" : ",");
    }
    Json json{{"part", part(k)}, {"greatest", greatest}, {"steps", steps}};
    if (errors.size() > 1) {
      const auto n = errors.size();
      const double ratio = static_cast<double>(outputs_[n - 1].refine) / outputs_[n - 2].refine;
      const double order = std::log(errors[n - 2] / errors[n - 1]) / std::log(ratio);
      json["order"] = order;
      line += "; order " + rounded(order, 3);
      json["good"] = judged("the force on " + part(k),
                            (order >= least_order && errors[n - 2] < no_force && errors.back() < most_at_least_step) ||
                                errors.back() < floor_of_error);
    } else {
      line += "; for the order run it with -var refine 10 too";
      json["good"] = judged("the force on " + part(k), errors.back() < most_at_least_step);
    }
    say(line);
    return json;
  }

  void compare_later() {
    Prepared prepared = prepare(scene_);
    const OwnRun own = own_run(prepared, scene_.time.method, scene_.time.step, scene_.time.end);
    const EngineOutput& engine = outputs_.front();
    const auto first = static_cast<std::size_t>(early_ / run_.interval());
    Json later = Json::array();
    for (std::size_t k = 0; k < scene_.plate.size(); ++k) {
      const Mean ours = mean_force(own.forces, 2 * k + 1, first), theirs = mean_force(engine.forces, 2 * k + 1, first);
      if (ours.value == 0 && theirs.value == 0) continue;
      later.push_back({{"part", part(k)},
                       {"furrow", {ours.value, ours.error}},
                       {"engine", {theirs.value, theirs.error}},
                       {"good", nullptr}});
      say("mean push after that, no verdict, " + part(k) + ": engine " + rounded(theirs.value, 4) + " +- " +
          rounded(theirs.error, 2) + " N, furrow " + rounded(ours.value, 4) + " +- " + rounded(ours.error, 2) + " N");
    }
    out_.json["later"] = later;
    compare_ends(prepared, own, engine);
    if (!run_.bonds.empty()) compare_links(own, engine);
  }

  // A lattice alone that does not tear has the same places by the same scheme, but for rounding.
  bool has_the_same_places(const OwnRun& own, const EngineOutput& engine) const {
    const bool tears = !own.tears.empty() || !engine.tears.empty();
    return scene_.disc.empty() && run_.parts == 0 && !tears && scene_.time.method == "verlet";
  }

  void compare_ends(const Prepared& prepared, const OwnRun& own, const EngineOutput& engine) {
    const System& system = prepared.system;
    const int discs = system.parts().disc.count();
    const NodeMotion nodes = system.nodes(scene_.time.end, own.end), start = system.nodes(0, prepared.y);
    State theirs = own.end;
    double apart = 0, held_apart = 0, way = 0, ours_high = 0, theirs_high = 0;
    const std::vector<int> place = places_in(system.parts().disc.number);
    for (const EngineBody& body : engine.end) {
      const int k = discs > 0 ? place[static_cast<std::size_t>(body.id - 1)] : body.id - 1;
      const Vec2 at = discs > 0 ? Vec2{own.end[system.x_of(k)], own.end[system.y_of(k)]} : Vec2{nodes.x[k], nodes.y[k]};
      apart = std::max(apart, std::hypot(at.x - body.at.x, at.y - body.at.y));
      if (discs == 0) {
        if (system.parts().node.body[k] < 0)
          held_apart =
              std::max(held_apart, std::hypot(at.x - body.at.x, at.y - body.at.y) / system.parts().node.spacing[k]);
        way = std::max(way, std::hypot(at.x - start.x[k], at.y - start.y[k]));
        continue;
      }
      ours_high += at.y / discs;
      theirs_high += body.at.y / discs;
      theirs[system.x_of(k)] = body.at.x;
      theirs[system.y_of(k)] = body.at.y;
    }
    const bool same = way > 0 && has_the_same_places(own, engine);
    out_.json["end"] = {{"bodies", engine.end.size()},
                        {"greatest_distance", apart},
                        {"good", same ? judged("the places at the end", apart <= most_places_apart * way) : Json()}};
    say(std::string("at the end") + (same ? "" : ", no verdict") + ": none of " + std::to_string(engine.end.size()) +
        " bodies further than " + rounded(apart, 3) + " m from where furrow has it");
    // That they are where they are held is no comparison; that they are not is a fault.
    if (held_apart > most_held_apart)
      judged("held and driven nodes, " + rounded(held_apart, 3) + " spacings away", false);
    if (discs == 0) return;
    const double ours = surface_height(system, own.end), other = surface_height(system, theirs);
    out_.json["end"]["mean_height"] = {{"furrow", ours_high}, {"engine", theirs_high}};
    out_.json["end"]["surface"] = {{"furrow", ours}, {"engine", other}};
    say("mean height: engine " + rounded(theirs_high, 6) + " m, furrow " + rounded(ours_high, 6) +
        " m; surface: engine " + rounded(other, 4) + " m, furrow " + rounded(ours, 4) + " m");
  }

  void compare_links(const OwnRun& own, const EngineOutput& engine) {
    const TearsApart found = tears_apart(run_, own.tears, engine, early_);
    out_.json["links"] = {{"compared", run_.bonds.size()}, {"furrow", found.furrow},
                          {"engine", found.engine},        {"both", found.both},
                          {"early", found.furrow_early},   {"engine_early", found.engine_early},
                          {"steps_apart", found.steps}};
    say("torn links of " + std::to_string(run_.bonds.size()) + ": engine " + std::to_string(found.engine) +
        ", furrow " + std::to_string(found.furrow) + ", the same " + std::to_string(found.both) + "; up to " +
        shortest(early_) + " s engine " + std::to_string(found.engine_early) + ", furrow " +
        std::to_string(found.furrow_early) + ", each within " + rounded(found.steps, 3) + " steps");
    const bool tore = found.furrow_early + found.engine_early > 0;  // or nothing is compared
    out_.json["links"]["good"] = tore ? judged("torn links", found.steps <= most_steps_apart) : Json();
  }

  const DeckRecord record_;
  const Scene scene_;
  const DeckRun run_;
  const std::vector<EngineOutput> outputs_;
  const double early_;  // s
  const bool exact_;
  bool compared_ = false;
  std::vector<std::string> good_{}, bad_{};  // what is judged
  Compared out_;
};

}  // namespace

Compared compare_with_engine(const fs::path& directory, double early) { return Comparison(directory, early).compare(); }

}  // namespace furrow
