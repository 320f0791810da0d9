// What all studies share: independent runs side by side, kept as they end so that an interrupted study goes on where it
// stopped, and a result that the page can show without knowing the study.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace furrow {

using Json = nlohmann::ordered_json;

struct Settings {
  bool quick = false;                              // the form for every build: fewer runs, the same questions
  std::filesystem::path directory{};               // for the result NAME.json; empty: nothing is kept
  unsigned jobs = 1;                               // runs at a time; 1 where time is measured
  std::function<bool(double, double)> progress{};  // (runs done, of all); false stops the study
};

// The scene of that name in validation/scenes, wherever the program stands.
Scene scene_named(const std::string& name);

// One run of a study. `key` names it among all runs of the study, its settings included; `run` must not depend on any
// other run. What `run` throws becomes {"failed": what}: failure of a method is a result. Want of memory and errors of
// the system or of files are none: they end the study.
struct Task {
  std::string key;
  std::function<Json()> run;
};

// The results in the order of the tasks. Each is kept in directory/STUDY.runs.jsonl as soon as it is there; those that
// the same program has left there on the same machine, for the same form of the same study, are not run again unless
// they failed. Throws Interrupted if `progress` says so, std::logic_error if two tasks have one key, FileError.
std::vector<Json> run_tasks(const std::string& study, const Settings& settings, const std::vector<Task>& tasks);

// A figure of the page: a script of validation/figures after variables and data blocks (see page/gnuplot.h).
struct Figure {
  std::string name;    // stem of its file, unlike that of any other figure
  std::string script;  // "order.gp"
  std::string caption, description;
  Json variables = Json::object();  // name: number or text
  Json blocks = Json::object();     // name: list of rows; a row is numbers and, last, perhaps a label
};

// What the page shows of a study, part by part. Cells of tables: numbers are shown with three digits, texts as they
// are, null and NaN as missing. All words are plain text.
class Report {
 public:
  explicit Report(std::string title, std::string question);
  Report& heading(std::string text);
  Report& text(std::string text);
  Report& table(std::string caption, std::vector<std::string> head, std::vector<std::vector<Json>> rows);
  Report& figure(Figure figure);
  // A claim of the study that its numbers bear out or not.
  Report& claim(const std::string& text, bool holds);
  // The parts and claims of another report.
  Report& append(const Report& other);
  // What is not for the eye: all numbers behind the tables and figures.
  Report& data(Json data);
  // With provenance: commit, compiler, flags, machine.
  Json json() const { return json_; }

 private:
  Json json_;
};

struct Study {
  std::string name, what;
  Json (*run)(const Settings& settings);
};

// Runs the study and writes settings.directory/NAME.json, sealed. Returns the claims that do not hold. Throws
// Interrupted.
std::vector<std::string> run_study(const Study& study, const Settings& settings);

}  // namespace furrow
