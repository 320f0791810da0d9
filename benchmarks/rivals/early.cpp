#include "benchmarks/rivals/early.h"

#include <cmath>
#include <stdexcept>

#include "output/files.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;
using Rows = std::vector<std::vector<double>>;

constexpr double reference_step = 1e-6;  // s
constexpr double between_rows = 0.01;    // s: programs write each hundredth step, of 1e-4 s

// The bed at another step and friction. It stands as it settled, with the friction of the scene.
Bed changed(const Bed& bed, double step, double friction) {
  Bed other = bed;
  other.directory = bed.directory / "early";
  fs::create_directories(other.directory);
  other.prepared.scene.time.step = step;
  other.prepared.scene.contact.friction = friction;
  other.prepared.scene.output.interval = between_rows;
  write_scene(other, other.prepared.scene);
  write_bodies(other);
  return other;
}

// Push along x by row.
Rows pushes(const Bed& bed, const Rival& rival) {
  const double step = bed.prepared.scene.time.step;
  const Task task{0.1, std::lround(early / step), true, bed.directory / "run"};
  fs::remove_all(task.directory);
  fs::create_directories(task.directory);
  run_measured_well(rival.command(bed, task));
  const bool own = rival.package.empty();
  Rows rows;
  for (const auto& row :
       own ? rows_of(task.directory / "run/plate_force.csv", 5) : rows_of(task.directory / "force.txt", 2))
    rows.push_back(own ? std::vector{row[0], row[2]} : std::vector{row[0] * step, row[1]});
  return rows;
}

// Over the greatest; the start, before the first step, is passed over. Signs are those of the reaction or of the force.
double error_of(const Rows& rows, const Rows& reference) {
  double most = 0, error = 0;
  int compared = 0;
  for (const auto& at : reference) {
    if (at[0] < 0.5 * between_rows) continue;
    most = std::max(most, std::fabs(at[1]));
    for (const auto& row : rows) {
      if (std::fabs(row[0] - at[0]) > 1e-9) continue;
      error = std::max(error, std::fabs(std::fabs(row[1]) - std::fabs(at[1])));
      ++compared;
    }
  }
  if (compared < 4) throw std::runtime_error("forces are missing");
  return error / most;
}

}  // namespace

bool agrees_early(const nlohmann::ordered_json& of_each_friction) {
  const auto& smooth = of_each_friction.at(0);
  return smooth.at("order").get<double>() >= least_early_order &&
         smooth.at("errors").at(1).get<double>() < most_early_error;
}

nlohmann::ordered_json early_agreement(const Bed& bed, const Rival& rival) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const double friction : {0.0, bed.prepared.scene.contact.friction}) {
    const Rows reference = pushes(changed(bed, reference_step, friction), converged());
    std::vector<double> errors;
    for (const double step : early_steps)
      errors.push_back(error_of(pushes(changed(bed, step, friction), rival), reference));
    all.push_back({{"friction", friction},
                   {"errors", errors},
                   {"order", std::log(errors[0] / errors[1]) / std::log(early_steps[0] / early_steps[1])}});
  }
  return all;
}

}  // namespace furrow::benchmarks
