#include "verification/engines/transform.h"

#include <cmath>

namespace furrow::verification {
namespace {

using Json = nlohmann::ordered_json;

struct View {
  double cosine, sine, mirror;
  double drift[2];

  void turn(Json& v) const {
    const double x = mirror * v[0].get<double>(), y = v[1];
    v = {cosine * x - sine * y, sine * x + cosine * y};
  }
  void turn(Json& list, const char* key) const {
    for (Json& one : list) {
      if (one.contains(key)) turn(one[key]);
    }
  }
};

// What drifts with the frame is taken off again by the judge.
double drift_along(const View& view, const Json& seen, double end) {
  if (!seen.contains("direction")) return 0;
  const Json& along = seen["direction"];
  const double speed = view.drift[0] * along[0].get<double>() + view.drift[1] * along[1].get<double>();
  return seen["what"] == "velocity" ? speed : seen["what"] == "displacement" ? speed * end : 0;
}

void see(const View& view, Json& seen, double end) {
  const bool turns = seen["what"] == "spin" || seen["what"] == "angular momentum";
  if (seen.contains("direction")) view.turn(seen["direction"]);
  for (const char* key : {"value", "interval", "limit", "published", "published_by"}) seen.erase(key);
  seen["kind"] = "same";
  seen["factor"] = turns ? view.mirror : 1.0;
  seen["offset"] = drift_along(view, seen, end);
}

}  // namespace

Json seen_from(Json c, const Json& wanted) {
  const Json& how = wanted["view"];
  const double angle = how.value("turn", 0.0);
  View view{std::cos(angle), std::sin(angle), how.value("mirror", false) ? -1.0 : 1.0, {0, 0}};
  if (how.contains("drift")) {
    view.drift[0] = how["drift"][0];
    view.drift[1] = how["drift"][1];
  }
  for (const char* key : {"name", "title", "text", "view", "source"}) c[key] = wanted[key];
  c["oracle"] = "the engine's own answer to " + how["of"].get<std::string>();
  for (const char* key : {"position", "velocity", "load"}) view.turn(c["body"], key);
  for (Json& body : c["body"]) {
    for (const int i : {0, 1}) body["velocity"][i] = body["velocity"][i].get<double>() + view.drift[i];
    body["spin"] = view.mirror * body["spin"].get<double>();
  }
  for (const char* key : {"point", "normal"}) view.turn(c["wall"], key);
  view.turn(c["gravity"]);
  for (Json& seen : c["observe"]) {
    see(view, seen, c["end"]);
    if (wanted.contains("floor")) seen["floor"] = wanted["floor"];
    if (wanted.contains("reason")) seen["reason"] = wanted["reason"];
  }
  return c;
}

}  // namespace furrow::verification
