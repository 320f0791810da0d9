#include "output/validity_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/labels.h"

namespace furrow {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

// A flag in the scene allows any number.
Json allowed_json(const std::optional<double>& allowed) {
  if (!allowed) return nullptr;
  return std::isfinite(*allowed) ? Json(*allowed) : Json(true);
}

Json watched_json(const Watched& w) {
  if (!w.watched) return "not watched";
  return {{"verdict", to_string(w.verdict())},
          {"worst", number_or_null(w.worst)},
          {"warns_above", w.warns_above},
          {"ends_above", number_or_null(w.ends_above)},
          {"allowed", allowed_json(w.allowed)},
          {"time", w.time},
          {"where", w.where},
          {"times", w.times}};
}

}  // namespace

Json validity_json(const Validity& validity) {
  Verdict worst = Verdict::kept;
  for (const Watched& w : validity.watches()) worst = std::max(worst, w.verdict());
  Json json{{"verdict", to_string(worst)}};
  for (const Watched& w : validity.watches()) json[w.name] = watched_json(w);
  return json;
}

void add_extremes(Json& json, const Validity& validity, const Scene& scene) {
  const RunExtremes& extremes = validity.extremes();
  const std::vector<std::string> plates = labels(scene.plate);
  json["largest_force"] = Json::array();
  for (std::size_t k = 0; k < extremes.plate.size(); ++k) {
    const RunExtremes::PlateForce& f = extremes.plate[k];
    json["largest_force"].push_back(
        {{"plate", plates[k]}, {"F", f.force}, {"Fx", f.fx}, {"Fy", f.fy}, {"time", f.time}});
  }
  const Watched& overlap = validity.watches()[static_cast<std::size_t>(WatchKind::overlap)];
  json["greatest_relative_overlap"] = overlap.worst;
  json["greatest_overlap_between"] = overlap.where;
  json["greatest_speed"] = extremes.speed;
}

}  // namespace furrow
