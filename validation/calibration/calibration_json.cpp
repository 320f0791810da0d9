// What a calibration leaves as files.
#include <cmath>

#include "output/build_info.h"
#include "output/files.h"
#include "output/owned_directory.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "validation/calibration/calibration.h"
#include "validation/page/studies.h"
#include "validation/page/template.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

Json or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json json_of(const VariedKey& key) {
  Json json{{"key", key.name}};
  if (key.listed()) {
    json["values"] = key.values;
  } else {
    json.update({{"low", key.low}, {"high", key.high}, {"logarithmic", key.logarithmic}});
  }
  return json;
}

Json json_of(const CalibrationTarget& target) {
  Json json{{"name", target.name}, {"scene", target.scene}, {"weight", target.weight}};
  if (target.curve) {
    json.update({{"curve", target.curve->file}, {"component", target.curve->component}});
  } else {
    json["observable"] = target.observable;
  }
  if (target.relation != Relation::says) json["tolerance"] = target.tolerance;
  return json;
}

Json setting_of(const std::vector<VariedKey>& keys, const Setting& setting) {
  Json json = Json::object();
  for (std::size_t k = 0; k < keys.size(); ++k) json[keys[k].name] = setting[k];
  return json;
}

Json misfit_of(const Point& point) {
  return {{"packings", point.misfits.size()}, {"misfit", point.misfit()}, {"spread", or_null(point.spread())}};
}

Json json_of(const Candidate& candidate, const Calibration& c) {
  Json json{{"setting", setting_of(c.keys, candidate.searched.setting)},
            {"searched", misfit_of(candidate.searched)},
            {"fresh", misfit_of(candidate.fresh)},
            {"targets", Json::array()}};
  for (std::size_t k = 0; k < c.targets.all.size(); ++k) {
    Json one{{"name", c.targets.all[k].name}, {"values", Json::array()}, {"misfits", Json::array()}};
    for (const Json& values : candidate.fresh.values) {
      one["values"].push_back(values[k]);
      one["misfits"].push_back(misfit(c.targets.all[k], values[k], c.targets.missing));
    }
    json["targets"].push_back(std::move(one));
  }
  return json;
}

Json json_of(const Identified& found) {
  Json json{{"intervals", Json::array()}, {"flat", Json::array()}, {"effects", Json::array()}};
  if (!found.why_not.empty()) json["no_intervals"] = found.why_not;
  for (const Known& k : found.known)
    json["intervals"].push_back({{"key", k.key},
                                 {"value", k.value},
                                 {"low", k.low.empty() ? Json() : Json(k.low)},
                                 {"high", k.high.empty() ? Json() : Json(k.high)},
                                 {"at_edge", k.at_edge},
                                 {"arrived", k.arrived}});
  for (const Flat& f : found.flat)
    json["flat"].push_back({{"keys", found.ranged},
                            {"direction", f.direction},
                            {"from", f.from},
                            {"to", f.to},
                            {"misfit", f.misfit},
                            {"misfit_backward", f.backward},
                            {"misfit_forward", f.forward}});
  for (const Effect& e : found.effects) {
    Json one{{"key", e.key}, {"change", e.change}, {"misfit", or_null(e.misfit)}, {"targets", Json::array()}};
    for (std::size_t k = 0; k < e.effect.size(); ++k)
      one["targets"].push_back({{"effect", or_null(e.effect[k])}, {"error", or_null(e.error[k])}});
    json["effects"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

Json json_of(const Calibration& c) {
  Json json{{"schema", 1}, {"commit", build_info().commit}, {"title", c.targets.title}, {"scenes", Json::array()}};
  for (const Case& of : c.cases) json["scenes"].push_back(of.name);
  json["keys"] = Json::array();
  for (const VariedKey& key : c.keys) json["keys"].push_back(json_of(key));
  json["targets"] = Json::array();
  for (const CalibrationTarget& target : c.targets.all) json["targets"].push_back(json_of(target));
  json["search"] = {{"points", c.points}, {"failed", c.failed}, {"runs_made", c.made}, {"runs_replayed", c.replayed}};
  json["best"] = Json::array();
  for (const Candidate& candidate : c.best) json["best"].push_back(json_of(candidate, c));
  json["identified"] = json_of(c.identified);
  return json;
}

std::vector<std::string> files_of_calibration(const std::vector<Case>& cases) {
  std::vector<std::string> files{"runs.jsonl", "calibration.json", "calibration.html"};
  for (const Case& of : cases) files.push_back("best/" + of.name + ".toml");
  return files;
}

void write_calibration(const Calibration& c, const fs::path& directory) {
  Json json = json_of(c);
  const Json section = report_of(c).json();
  json["section"] = section;
  Page page;
  const std::string html = chapter_html({.name = "calibration", .report = section, .age = {}, .numbers = {}}, "", page);
  std::vector<std::string> files = files_of_calibration(c.cases);
  for (const auto& [name, content] : page.files) files.push_back(name);
  OwnedDirectory owned(directory, "calibration", files, OwnedDirectory::Earlier::kept);
  owned.keep_only(files);
  for (const Case& of : c.cases)
    replace_file(directory / "best" / (of.name + ".toml"),
                 canonical_text(scene_with(of, c.keys, c.best.front().searched.setting, 0)));
  replace_file(directory / "calibration.json", json.dump(1) + "\n");
  for (const auto& [name, content] : page.files) replace_file(directory / name, content);
  replace_file(directory / "calibration.html",
               "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
                   escaped(c.targets.title) + "</title>\n<style>\n" + page_file("page.css") +
                   "</style>\n</head>\n<body>\n<main>\n<section>\n" + html + "</section>\n</main>\n</body>\n</html>\n");
  owned.conclude("finished");
}

}  // namespace furrow::validation
