#include "benchmarks/tracking/profile.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/measuring/made_by.h"
#include "output/files.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

struct Part {
  const char* name;
  std::vector<const char*> functions;  // what their names have in common; a file stands for all that is compiled in it
};

// The first that fits counts. Loops of several widths are named without the width, which may be inlined into them. A
// function of no part (of the C and C++ libraries, mostly) belongs to whoever called it.
const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"pairs of discs",
       {"::interleave", "::locate_pairs", "Kernel::fill_discs(", "Kernel::point_at(", "Kernel::update_positions("}},
      {"contact law", {"furrow::evaluate", "::gather_springs"}},
      {"sums of forces",
       {"::add_loads", "::scatter_to_slots", "Kernel::add_contacts(", "Kernel::clear_loads(", "Kernel::join_blocks("}},
      {"walls, plate, border of the lattice",
       {"Kernel::fill_flat", "Kernel::fill_walls", "::locate_walls", "Kernel::nearest_border("}},
      {"links", {"Kernel::add_link_forces(", "Kernel::tear_links(", "move_nodes("}},
      {"neighbour search", {"NeighbourSearch::", "::all_within"}},
      {"springs and jump",
       {"::note_near", "::scatter_returned", "Slots::", "Kernel::return_springs(", "Kernel::jump("}},
      {"rates", {"System::rhs(", "Kernel::flow(", "Kernel::begin_rates(", "Kernel::finish_rates(", "::accelerate"}},
      {"ledger", {"::add_powers", "Kernel::add_to_ledger("}},
      {"method",
       {"Pece::step(", "::extrapolate", "::add_mean", "Watch::", "::all_finite", "::all_near",
        "EventSteps::", "furrow::run(", "furrow::jump("}},
      {"observers and files",
       {"run_with_files(", "furrow::observe(", "keep_touching(", "greatest_speed(", "disc_stresses(", "link_forces(",
        "::Series::", "furrow::Frames::", "OutputFile"}},
  };
  return all;
}

constexpr const char* rest = "rest";

std::string part_of(std::string_view function) {
  for (const Part& part : parts()) {
    for (const char* name : part.functions) {
      if (function.find(name) != std::string_view::npos) return part.name;
    }
  }
  return {};
}

struct Function {
  double own = 0;                         // instructions
  std::map<std::string, double> callers;  // instructions that calls from there took
};

// A file of callgrind without compression: "fn=NAME", then "LINE COST"; a call is "cfn=NAME", "calls=...", and a line
// with the cost of all that it led to. Source: valgrind's manual, Callgrind Format Specification.
std::map<std::string, Function> functions_in(const fs::path& file) {
  std::ifstream stream(file);
  std::map<std::string, Function> all;
  std::string here, called;
  bool is_call = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("fn=", 0) == 0) here = line.substr(3);
    if (line.rfind("cfn=", 0) == 0) called = line.substr(4);
    if (line.rfind("calls=", 0) == 0) is_call = true;
    if (line.empty() || line[0] < '0' || line[0] > '9') continue;
    const double cost = std::strtod(line.c_str() + line.find(' '), nullptr);
    if (is_call) {
      all[called].callers[here] += cost;
    } else {
      all[here].own += cost;
    }
    is_call = false;
  }
  return all;
}

// Hands the cost of a function up to its callers, as much as the calls of each took, until it comes to a part.
void hand_up(const std::map<std::string, Function>& all, const std::string& name, double cost, int depth, Json& sums) {
  constexpr int deepest = 30;  // of what calls itself
  const auto found = all.find(name);
  std::string part = part_of(name);
  double calls = 0;
  if (found != all.end()) {
    for (const auto& [caller, taken] : found->second.callers) calls += caller == name ? 0 : taken;
  }
  if (part.empty() && (calls == 0 || depth == deepest)) part = rest;
  if (!part.empty()) {
    sums[part] = sums[part].get<double>() + cost;
    return;
  }
  for (const auto& [caller, taken] : found->second.callers) {
    if (caller != name && taken > 0 && cost * taken / calls >= 0.5) {
      hand_up(all, caller, cost * taken / calls, depth + 1, sums);
    } else if (caller != name) {
      sums[rest] = sums[rest].get<double>() + cost * taken / calls;
    }
  }
}

Json sums_by_part(const fs::path& file) {
  Json sums;
  for (const Part& part : parts()) sums[part.name] = 0.0;
  sums[rest] = 0.0;
  const auto all = functions_in(file);
  for (const auto& [name, function] : all) {
    if (function.own > 0) hand_up(all, name, function.own, 0, sums);
  }
  return sums;
}

Json read(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw FileError("cannot read " + file.string());
  return Json::parse(stream);
}

Json scene_profile(const Build& build, const std::string& name, const Json& said) {
  const Json run = read(build.beds / "runs" / name / "run.json");
  const double total = said.at("instructions"), steps = run.at("steps"), evaluations = run.at("rhs_evaluations");
  const double discs = run.at("discs");
  Json sums = sums_by_part(build.beds / (name + ".callgrind"));
  double sum = 0;
  for (const auto& [part, cost] : sums.items()) sum += cost.get<double>();
  if (std::fabs(sum - total) > 1e-9 * total)
    throw std::runtime_error(name + ": the parts add up to " + number(sum) + ", not to " + number(total));
  Json json{{"name", name},
            {"steps", steps},
            {"evaluations", evaluations},
            {"discs", discs},
            {"state_hash", run.at("state_hash")},
            {"instructions", total},
            {"a_step", total / steps},
            {"a_disc_and_evaluation", discs > 0 ? Json(total / discs / evaluations) : Json()},
            {"parts", Json::object()}};
  for (const auto& [part, cost] : sums.items()) json["parts"][part] = std::round(cost.get<double>());
  return json;
}

void show(const Json& scene) {
  std::printf("%s: %.0f instructions a step\n", scene["name"].get<std::string>().c_str(),
              scene["a_step"].get<double>());
  for (const auto& [part, cost] : scene["parts"].items()) {
    std::printf("  %-36s %6.1f %%\n", part.c_str(), 100 * cost.get<double>() / scene["instructions"].get<double>());
  }
}

}  // namespace

int profile(const Build& build, const fs::path& result) {
  make_beds(build);
  const std::vector<std::string> names{"scenario_3", "scenario_2", "scenario_1"};  // the longest first
  const Json said = counted(build, names);
  const Json run = read(build.beds / "runs/scenario_1/run.json");
  Json json{{"context", {{"made_by", made_by()}}},    {"commit", run.at("commit")},
            {"compiler", run.at("compiler")},         {"flags", run.at("flags")},
            {"counted_with", identity(said.front())}, {"scenes", Json::array()}};
  for (const std::string name : {"scenario_1", "scenario_2", "scenario_3"}) {
    json["scenes"].push_back(scene_profile(build, name, said.at(name)));
    show(json["scenes"].back());
  }
  OutputFile file = OutputFile::replacing(result);
  file << json.dump(1) << "\n";
  file.finish();
  return 0;
}

}  // namespace furrow::benchmarks
