// What a calibration aims at: statements about observables of runs, and measured force curves.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "validation/page/run_record.h"

namespace furrow::validation {

using Json = nlohmann::ordered_json;

enum class Relation { equals, below, above, between, says };
enum class CurveNorm {
  rms,
  mean,
  max
};  // of the differences of two curves: root mean square, mean magnitude, greatest

struct MeasuredCurve {
  std::string file, component = "F";  // "F", "Fx" or "Fy"
  std::string heading{};              // the component that the heading of its file names; empty: just a force
  CurveNorm norm = CurveNorm::rms;
  std::vector<double> mm, force;  // displacement of the plate, N
};

struct CalibrationTarget {
  std::string name, scene, observable;
  bool named = false;                           // the file gives the name
  std::optional<std::array<double, 2>> window;  // mm
  Relation relation = Relation::equals;
  std::array<double, 2> value{};  // equals, below, above: the first
  std::string words;              // says
  double tolerance = 1;           // in the unit of the observable: a misfit of 1
  double weight = 1;
  std::optional<MeasuredCurve> curve;
  // What of a run it needs to be judged, as a text: two targets that ask the same share their runs.
  std::string asked() const;
};

struct Targets {
  std::string title;
  std::vector<CalibrationTarget> all;
  double missing = 10;  // tolerances: the misfit of a number that a run does not say
  bool bounded =
      false;  // the misfit r of a target counts r^2 / (1 + r^2), so that one that cannot be met rules no other
};

// From TOML, or JSON if the file's name ends so; curves are found beside it. Throws std::runtime_error with the file
// and all that is wrong. `scenes`: the names that a target may name; one that names none belongs to the only one.
Targets read_targets(const std::filesystem::path& file, const std::vector<std::string>& scenes);

// What a run says of a target: a number, words, of a curve the forces at the measured displacements; null if it does
// not say, as where the plate does not go through all of the curve or window. Throws std::invalid_argument if there is no such observable.
Json value_of(const CalibrationTarget& target, const RunRecord& run);

// Whether a value of a run can be compared with the target: a number with a number, of a curve all its forces.
bool comparable(const CalibrationTarget& target, const Json& value);

// By how many tolerances a value misses, one number for each that is compared: one, or as many as a curve has points.
std::vector<double> residuals(const CalibrationTarget& target, const Json& value, double missing);

// The misfit of a target, its norm taken, and of all: the root of the weighted mean of their squares.
double misfit(const CalibrationTarget& target, const Json& value, double missing);
double misfit(const Targets& targets, const Json& values);

// One number that stands for the value in tables: of a curve its mean force; NaN if there is none.
double number_of(const Json& value);

}  // namespace furrow::validation
