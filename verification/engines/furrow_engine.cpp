#include "verification/engines/furrow_engine.h"

#include <cmath>
#include <map>
#include <stdexcept>

#include "output/build_info.h"
#include "run/observe.h"
#include "run/run.h"
#include "scene/read.h"
#include "verification/engines/observer.h"

namespace furrow::verification {
namespace {

using Vec = std::array<double, 2>;

// The bodies of a case in a system, and what touches them now.
class Running {
 public:
  Running(const Json& c, const Scene& scene) : case_(c), system_(scene) {
    int disc = 0, node = 0;
    for (const Json& body : c["body"])
      (body["radius"] > 0.0 ? disc_ : node_)[body["name"]] = body["radius"] > 0.0 ? disc++ : node++;
  }
  System& system() { return system_; }

  Moment moment(double t, const State& y) const {
    return {.time = t,
            .position = [this, &y](const std::string& b) { return position(y, b); },
            .velocity = [this, &y](const std::string& b) { return velocity(y, b); },
            .spin = [this, &y](const std::string& b) { return system_.spin(y, disc_.at(b)); },
            .overlap = [this, t, &y](const std::string& a, const std::string& b) { return overlap(t, y, a, b); },
            .force = [this, t, &y](const std::string& a, const std::string& b) { return contact(t, y, a, b).normal; },
            .push = [this, t, &y](const std::string& plate) -> Vec {
              const Force force = observe(system_, t, y).plate.at(index_in("plate", plate));
              return {force.x, force.y};
            },
            .torn = [this](const std::string& a, const std::string& b) { return is_torn(a, b); }};
  }

 private:
  int moving(const std::string& name) const {
    if (const auto disc = disc_.find(name); disc != disc_.end()) return disc->second;
    return system_.parts().node.body[static_cast<std::size_t>(node_.at(name))];
  }
  Vec position(const State& y, const std::string& name) const {
    const int body = moving(name);
    if (body >= 0) return {y[system_.x_of(body)], y[system_.y_of(body)]};
    const auto node = static_cast<std::size_t>(node_.at(name));
    return {system_.parts().node.x[node], system_.parts().node.y[node]};
  }
  Vec velocity(const State& y, const std::string& name) const {
    const int body = moving(name);
    return body < 0 ? Vec{0, 0} : Vec{y[system_.vx_of(body)], y[system_.vy_of(body)]};
  }
  std::size_t index_in(const char* list, const std::string& name) const {
    const Json& all = case_[list];
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k]["name"] == name) return k;
    }
    throw std::invalid_argument(std::string("no ") + list + " " + name);
  }
  bool has(const char* list, const std::string& name) const {
    for (const Json& one : case_[list]) {
      if (one["name"] == name) return true;
    }
    return false;
  }

  // The gap too, as a negative overlap; of an outline and a plate only what touches.
  double overlap(double t, const State& y, const std::string& a, const std::string& b) const {
    const Vec p = position(y, a);
    const double r = named(case_, "body", a)["radius"];
    if (disc_.contains(b)) {
      const Vec q = position(y, b);
      return r + named(case_, "body", b)["radius"].get<double>() - std::hypot(q[0] - p[0], q[1] - p[1]);
    }
    if (!has("wall", b)) return contact(t, y, a, b).depth;
    const WallPart& wall = system_.parts().wall[index_in("wall", b)];
    return r - ((p[0] - wall.px) * wall.nx + (p[1] - wall.py) * wall.ny);
  }

  struct Pressed {
    double depth = 0, normal = 0;
  };
  Pressed contact(double t, const State& y, const std::string& a, const std::string& b) const {
    Pressed seen;
    const int first = disc_.contains(a) ? disc_.at(a) : node_.at(a);
    const ContactKind kind = disc_.contains(b) ? disc_disc
                             : has("wall", b)  ? disc_wall
                             : has("plate", b) ? disc_plate
                                               : disc_lattice;
    const int second = disc_.contains(b) ? disc_.at(b)
                                         : static_cast<int>(index_in(kind == disc_wall    ? "wall"
                                                                     : kind == disc_plate ? "plate"
                                                                                          : "lattice",
                                                                     b));
    system_.for_each_contact(t, y, [&](const Contact& c) {
      if (c.id.kind == kind && c.id.a == first && c.id.b == second) seen = {c.touch.overlap, c.force.normal};
    });
    return seen;
  }
  bool is_torn(const std::string& a, const std::string& b) const {
    const LinkArrays& link = system_.parts().link;
    for (int k = 0; k < link.count(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const bool same = (link.a[i] == node_.at(a) && link.b[i] == node_.at(b)) ||
                        (link.a[i] == node_.at(b) && link.b[i] == node_.at(a));
      if (same && system_.torn(k)) return true;
    }
    return false;
  }

  const Json& case_;
  System system_;
  std::map<std::string, int> disc_, node_;
};

Json named_engine(const std::string& method) {
  return {{"engine", "furrow " + std::string(build_info().version)}, {"method", method}};
}

void refuse_bad_scene(const Scene& scene) {
  const std::vector<Problem> problems = problems_of(scene);
  if (!problems.empty()) throw std::invalid_argument(problems[0].path + ": " + problems[0].message);
}

}  // namespace

Json furrow_answer(const Json& request, const std::string& method) {
  const Json& c = request["case"];
  Json answer = named_engine(method);
  if (const std::string missing = lacking(c); !missing.empty()) return answer["cannot"] = missing, answer;
  const auto integrator = make_method(method);
  const double h = request["step"], end = h * request["count"].get<double>();
  Scene scene = scene_of_case(c);
  scene.time.step = h;
  scene.time.end = end;
  scene.output.interval = end;
  refuse_bad_scene(scene);
  Running running(c, scene);
  if (const std::string why = refusal(integrator->info(), running.system()); !why.empty())
    return answer["cannot"] = why, answer;
  Observer observer(c);
  State y = running.system().initial_state();
  const RunEnd ran = run(running.system(), *integrator, y, {.start = 0, .end = end, .step = h, .stop = {}},
                         [&](double t, const State& now, const JumpReport&) {
                           observer.look(running.moment(t, now));
                           return true;
                         });
  if (ran.ending != Ending::finished) throw Divergence(ran.reason);
  answer["order"] = integrator->info().order;
  answer["observables"] = observer.observables();
  return answer;
}

}  // namespace furrow::verification
