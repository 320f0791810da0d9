#include "program/run_summary.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/wording.h"

namespace furrow {
namespace {

using nlohmann::ordered_json;

std::string digits(double value) { return rounded(value, 3); }

std::string said(const ordered_json& run, const char* key) {
  return run.contains(key) && run[key].is_number() ? digits(run[key].get<double>()) : "?";
}

long rows_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return std::max(0L, static_cast<long>(std::count(std::istreambuf_iterator<char>(stream), {}, '\n')) - 1);
}

std::string force_line(const ordered_json& run) {
  std::string line;
  for (const ordered_json& plate : run.value("largest_force", ordered_json::array()))
    line += (line.empty() ? "largest force " : "; ") + digits(plate.at("F")) + " N on plate " +
            plate.at("plate").get<std::string>() + " at t = " + digits(plate.at("time")) + " s";
  return line.empty() ? "no plate, so no force" : line;
}

std::string watch(const ordered_json& run, const char* name, const std::string& words, double scale,
                  const std::string& unit) {
  const ordered_json watched = run.value("validity", ordered_json::object()).value(name, ordered_json());
  if (!watched.is_object() || !watched.at("worst").is_number()) return {};
  return ", " + words + " " + digits(scale * watched.at("worst").get<double>()) + unit;
}

}  // namespace

std::string run_summary(const std::string& json, const std::filesystem::path& directory, bool replaced) {
  const ordered_json run = ordered_json::parse(json);
  const std::string place = directory.string();
  std::string text = run.at("ended").get<std::string>() + " at t = " + said(run, "ended_at") +
                     " s: " + std::to_string(run.value("steps", 0L)) + " steps of " + run.value("method", "?") +
                     " in " + said(run, "cpu_seconds") + " s of CPU time\n";
  text += force_line(run) + "\n";
  text += "links torn " + std::to_string(rows_in(directory / "events.csv")) +
          watch(run, "overlap", "greatest overlap", 1, " R") +
          watch(run, "energy_made", "energy made by method or law", 100, " % of what was given") +
          watch(run, "step", "step", 1, " of the largest stable one") + "\n";
  text += "files in " + place + (replaced ? ", in place of those of an earlier run" : "") + "; furrow view " + place +
          " plays it, --json prints run.json\n";
  return text;
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string lines, line;
  const auto end_line = [&] {
    lines += line + "\n";
    line = std::string(indent, ' ');
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t blank = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, blank - at);
    if (line.size() + word.size() > width && line.find_first_not_of(' ') != std::string::npos) {
      line.erase(line.find_last_not_of(' ') + 1);
      end_line();
    }
    line += word + (blank < text.size() ? " " : "");
    at = blank + 1;
  }
  return lines + line;
}

}  // namespace furrow
