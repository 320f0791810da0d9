#include "benchmarks/studies/speed.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <vector>

#include "output/files.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

const fs::path results = "benchmarks/results";

std::string text_in(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

// Who measured it, as far as the file says; one that does not say of which sources it is is older than any.
Maker maker_in(const Json& report) {
  const Json context = report.value("context", Json::object());
  if (context.contains("made_by")) {
    const Json& by = context["made_by"];  // Google Benchmark keeps texts only
    return maker_of(by.is_string() ? Json::parse(by.get<std::string>()) : by);
  }
  Maker maker{.commit = report.value("commit", "unknown"),
              .when = text_in(context, "date"),
              .machine = text_in(context, "machine")};
  if (maker.machine.empty() && context.contains("num_cpus"))
    maker.machine = context["num_cpus"].dump() + " processors of " + context.at("mhz_per_cpu").dump() + " MHz";
  if (context.contains("load_avg") && !context["load_avg"].empty()) maker.load = context["load_avg"][0];
  return maker;
}

// Of a report of Google Benchmark the medians, where something was measured several times, without what no chapter reads.
Json in_short(Json report) {
  if (!report.contains("benchmarks")) return report;
  std::set<std::string> with_median;
  for (const Json& one : report["benchmarks"]) {
    if (text_in(one, "aggregate_name") == "median") with_median.insert(one.at("run_name"));
  }
  Json kept = Json::array();
  for (Json one : report["benchmarks"]) {
    if (with_median.contains(one.at("run_name")) && text_in(one, "aggregate_name") != "median") continue;
    for (const char* key :
         {"name", "run_type", "family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads",
          "aggregate_unit", "iterations", "cpu_seconds", "base_cpu_seconds", "base_instructions"})
      one.erase(key);
    kept.push_back(std::move(one));
  }
  report["benchmarks"] = std::move(kept);
  for (const char* key : {"made_by", "caches", "host_name", "executable"}) {
    if (report.contains("context")) report["context"].erase(key);
  }
  return report;
}

Json whole_value(const fs::path& file) {
  std::ifstream stream(file);
  if (file.extension() == ".json") return Json::parse(stream);
  Json lines = Json::array();
  for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
  return lines;
}

Json value_of(const Json& whole) {
  if (!whole.is_array()) return in_short(whole);
  Json lines = Json::array();
  for (const Json& line : whole) lines.push_back(in_short(line));
  return lines;
}

}  // namespace

void measure_speed(Measurement& measurement) {
  std::vector<fs::path> files;
  if (fs::is_directory(results)) {
    for (const auto& entry : fs::directory_iterator(results)) files.push_back(entry.path());
  }
  if (files.empty())
    throw FileError("no results in " + results.string() +
                    " of this directory; scripts/rivals, scripts/track and "
                    "scripts/scale make them");
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const Json whole = whole_value(file);
    measurement.take({.key = file.filename(), .timed = true, .value = value_of(whole)},
                     maker_in(whole.is_array() ? whole.back() : whole));
  }
}

}  // namespace furrow::benchmarks
