#include "verification/engines/observer.h"

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace furrow::verification {
namespace {

// The greatest value of a series: vertex of the parabola through the three highest.
class Crest {
 public:
  void add(double value) {
    if (seen_ >= 2 && b_ > a_ && b_ >= value) {
      const double rise = value - a_;
      highest_ = std::max(highest_, b_ - rise * rise / (8 * (a_ - 2 * b_ + value)));
    }
    highest_ = std::max(highest_, value);
    a_ = b_;
    b_ = value;
    ++seen_;
  }
  double highest() const { return highest_; }

 private:
  double a_ = 0, b_ = 0, highest_ = -HUGE_VAL;
  int seen_ = 0;
};

using Vec = std::array<double, 2>;

double along(const Json& seen, const Vec& v) {
  return v[0] * seen["direction"][0].get<double>() + v[1] * seen["direction"][1].get<double>();
}

}  // namespace

struct Observer::Watch {
  const Json& seen;
  const Json& whole;
  Crest crest{};
  double value = NAN, first = NAN, before = 0, time_before = 0, sum = 0, count = 0;

  std::string of(std::size_t i) const { return seen["of"][i]; }

  void look(const Moment& now) {
    const std::string what = seen["what"];
    if (what == "velocity")
      value = along(seen, now.velocity(of(0)));
    else if (what == "spin")
      value = now.spin(of(0));
    else if (what == "displacement")
      displace(along(seen, now.position(of(0))));
    else if (what == "overlap")
      value = now.overlap(of(0), of(1));
    else if (what == "greatest overlap")
      raise(now.overlap(of(0), of(1)));
    else if (what == "greatest force")
      raise(now.force(of(0), of(1)));
    else if (what == "contact time")
      time_contact(now);
    else if (what == "torn springs")
      count_torn(now);
    else if (what == "time of tear")
      time_tear(now);
    else if (what == "momentum" || what == "angular momentum")
      sum_momentum(now, what == "momentum");
    else if (what == "push")
      value = along(seen, now.push(of(0)));
    else if (what == "greatest push")
      raise(along(seen, now.push(of(0))));
    else if (what == "mean push")
      average(now, along(seen, now.push(of(0))));
    else if (what == "mean height")
      mean_height(now);
    else
      throw std::invalid_argument("nothing is known of how to observe " + what);
  }

  void raise(double now) {
    crest.add(now);
    value = crest.highest();
  }
  void displace(double now) {
    if (std::isnan(first)) first = now;
    value = now - first;
  }
  void time_contact(const Moment& now) {
    const double depth = now.overlap(of(0), of(1));
    if (std::isnan(first) && depth >= 0) first = now.time;
    if (before > 0 && depth <= 0) value = time_before + (now.time - time_before) * before / (before - depth) - first;
    before = depth;
    time_before = now.time;
  }
  void count_torn(const Moment& now) {
    value = 0;
    for (const Json& spring : whole["spring"]) value += now.torn(spring["a"], spring["b"]) ? 1 : 0;
  }
  void time_tear(const Moment& now) {
    if (std::isnan(value) && now.torn(of(0), of(1))) value = now.time;
  }
  void average(const Moment& now, double push) {
    if (now.time < seen["from"].get<double>()) return;
    sum += push;
    value = sum / ++count;
  }
  void sum_momentum(const Moment& now, bool linear) {
    value = 0;
    for (const Json& body : whole["body"]) {
      const std::string name = body["name"];
      const double m = body["mass"], inertia = body["inertia"];
      const Vec x = now.position(name), v = now.velocity(name);
      value +=
          linear ? m * along(seen, v) : m * (x[0] * v[1] - x[1] * v[0]) + (inertia > 0 ? inertia * now.spin(name) : 0);
    }
  }
  void mean_height(const Moment& now) {
    double heights = 0, discs = 0;
    for (const Json& body : whole["body"]) {
      if (body["radius"] == 0.0) continue;
      heights += now.position(body["name"])[1];
      ++discs;
    }
    value = heights / discs;
  }
};

Observer::Observer(const Json& c) : case_(c) {
  for (const Json& seen : case_["observe"]) watches_.push_back({seen, case_});
}
Observer::~Observer() = default;

void Observer::look(const Moment& now) {
  for (Watch& watch : watches_) watch.look(now);
}

Json Observer::observables() const {
  Json all = Json::object();
  for (const Watch& watch : watches_) all[watch.seen["name"].get<std::string>()] = watch.value;
  return all;
}

}  // namespace furrow::verification
