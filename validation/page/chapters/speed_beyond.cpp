// Beyond one machine: how a scene's keys go into a deck for LAMMPS, and how far its run is from furrow's. Measured by
// scripts/beyond; the keys are those of src/export.
#include <algorithm>

#include "benchmarks/measuring/samples.h"
#include "export/export.h"
#include "validation/page/chapters/speed_parts.h"

namespace furrow::validation {
namespace {

constexpr double aim_of_order = 0.8, aim_of_error = 1e-3;  // at 1e-5 s, of the greatest force

double median(const Json& times) { return benchmarks::median_interval(times.get<std::vector<double>>()).middle; }

void add_keys(Report& report) {
  std::vector<std::vector<Json>> rows;
  std::vector<std::pair<Fidelity, int>> counts{
      {Fidelity::exact, 0}, {Fidelity::to_the_step, 0}, {Fidelity::another_law, 0}, {Fidelity::refused, 0}};
  for (const KeyRow& row : usual_lammps_keys()) {
    for (auto& [fidelity, count] : counts) count += row.fidelity == fidelity ? 1 : 0;
    if (row.fidelity == Fidelity::another_law || row.fidelity == Fidelity::refused)
      rows.push_back({row.key, to_string(row.fidelity), row.text});
  }
  std::string words;
  for (const auto& [fidelity, count] : counts)
    words += (words.empty() ? "" : ", ") + std::to_string(count) + " " + to_string(fidelity);
  report.text(
      "A scene that has outgrown one machine goes on in LAMMPS, which runs on many: `furrow export` settles it and "
      "writes the deck. Of the keys of a scene go in: " +
      words +
      ". A scene with a key of the last two kinds is refused, with how far it is off, unless the key is allowed.");
  if (!rows.empty())
    report.table("Keys of a scene that LAMMPS has another law for, or none", {"key", "how", "what"}, rows);
}

struct Worst {
  double error = 0, order = infinity;
};

// A row for each plate and wall with a force.
void add_parts(const Json& discs, const Json& compared, const std::string& friction,
               std::vector<std::vector<Json>>& rows, Worst& worst) {
  for (const Json& part : compared.at("early").at("parts")) {
    const Json& steps = part.at("steps");
    const double error = steps.back().at("error");
    rows.push_back({discs, friction, part.at("part"), part.at("greatest"), steps.front().at("error"), error,
                    part.value("order", Json())});
    if (friction != "no") continue;
    worst.error = std::max(worst.error, error);
    worst.order = std::min(worst.order, part.value("order", 0.0));
  }
}

void add_times(const Json& one, std::vector<std::vector<Json>>& rows) {
  for (const auto& [name, all] : one.at("seconds_a_step").items()) {
    const std::string engine = name.substr(0, name.find('_')), count = name.substr(name.find('_') + 1);
    rows.push_back({one.at("discs"), engine == "furrow" ? "furrow, verlet" : "LAMMPS", count,
                    1e6 * median(all.at("clock")), 1e6 * median(all.at("cpu")), one.at("load_before")});
  }
}

}  // namespace

void add_beyond(Report& report, const Numbers& numbers) {
  std::vector<std::vector<Json>> parts, times;
  Worst worst;
  std::string engine, dearer;
  for (const char* discs : {"230", "23000", "230000"}) {
    const Json one = measured(numbers, std::string("beyond_") + discs + ".json");
    if (one.is_null()) continue;
    engine = one.at("engine");
    add_parts(one.at("discs"), one.at("without_friction"), "no", parts, worst);
    if (one.contains("with_friction")) add_parts(one.at("discs"), one.at("with_friction"), "yes", parts, worst);
    add_times(one, times);
    const Json& seconds = one.at("seconds_a_step");
    dearer += (dearer.empty() ? "" : ", ") +
              rounded(median(seconds.at("lammps_1").at("cpu")) / median(seconds.at("furrow_1").at("cpu")), 2);
  }
  report.heading("Beyond one machine");
  add_keys(report);
  if (parts.empty())
    return not_measured(report, "an exported bed beside furrow's run, on two processes", "scripts/beyond");
  report.text(
      "A bed that furrow settled, run by LAMMPS (" + engine +
      ") under mpirun with two processes. The force on the plate and on each wall up to 0.05 s is put beside "
      "furrow's rk4 at the smaller step. Without friction both have the same law, so the error must fall as the "
      "step: order 1. With friction the laws differ after a slip, and the error stays.");
  report.table("Error of the force over its greatest value",
               {"discs", "friction", "on", "greatest [N]", "error at 0.1 ms", "error at 0.01 ms", "order"}, parts);
  report.claim(
      {.text = "Without friction: the least order, and the greatest error at 0.01 ms, of an exported bed's forces.",
       .value = rounded(worst.order, 3) + ", " + rounded(worst.error, 2),
       .aim = "at least " + rounded(aim_of_order, 1) + ", below " + rounded(aim_of_error, 1),
       .holds = worst.order >= aim_of_order && worst.error < aim_of_error});
  report.table(
      "A step without friction, in µs: medians; on one processor LAMMPS takes " + dearer +
          " times the CPU time of furrow's verlet, one evaluation each; how many other programs ran is the load",
      {"discs", "engine", "processes or threads", "by the clock", "CPU time of one process, of all threads", "load"},
      times);
}

}  // namespace furrow::validation
