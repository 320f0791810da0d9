// What the files of a run say, and the numbers that the paper reports, computed from them.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output/table.h"
#include "scene/scene.h"
#include "system/parts.h"

namespace furrow {

// Force on the first plate against its displacement (mm). Resistance is positive: fx is minus the force on the plate.
struct ForceCurve {
  std::vector<double> mm, fx, fy, f;  // mm, N
};

struct TornLink {
  double mm = 0;  // displacement of the plate
  int link = 0;   // index in RunRecord::lattices.link
};

struct Frame {
  double mm = 0;
  Table discs, links, plates;
};

struct RunRecord {
  std::string name;
  nlohmann::json facts;  // run.json
  Scene scene;
  Parts lattices;        // nodes and links of the scene's lattices, nothing else
  ForceCurve force;
  Table energy;
  std::vector<TornLink> torn;  // in order of time
  std::vector<Frame> frames;
};

// Throws std::runtime_error that names the file that is missing or malformed.
RunRecord read_run(const std::string& name, const std::filesystem::path& directory);

// One thing that the paper reports; the heading of reference_data/published/paper.toml explains the fields.
struct Statement {
  std::string id, scene, quantity, unit, relation, where, read, observable, ours, mark, label;
  double value = std::numeric_limits<double>::quiet_NaN();  // NaN: the paper says it in words
  std::string words;
  std::optional<std::array<double, 2>> window;  // mm
};

struct Publication {
  std::string title;
  std::vector<Statement> statements;
};

// Throws std::runtime_error that says what is wrong with the TOML text.
Publication read_publication(std::string_view toml);

// A number, or words where a number will not do. NaN without words: the run does not say.
struct Measured {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string words;
};

// Throws std::invalid_argument if there is no observable of that name.
Measured measure(const RunRecord& run, const Statement& statement);

// Largest sum of forces in each whole stretch of `length` mm: where and how large.
struct Maximum {
  double mm, f;
};
std::vector<Maximum> maxima(const ForceCurve& curve, double length);

// Displacement of the first plate, mm, from which no chain of intact links joins the lowest row of a lattice to its highest.
// NaN if that never happens.
double split_at(const RunRecord& run);

// Whether one end of the link, and only one, is fixed.
bool half_fixed(const Parts& lattices, int link);

}  // namespace furrow
