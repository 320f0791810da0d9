// What the files of a run say, and what the paper reports.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "system/parts.h"
#include "validation/page/table.h"

namespace furrow::validation {

// Force on the first plate. Resistance is positive: fx is minus the force on the plate.
struct ForceCurve {
  std::vector<double> mm, fx, fy, f;  // mm of displacement, N
  // The samples that were due, evenly spaced in time; more than there are: all. The state at the end, if none was due
  // there, follows them: it is seen by largest values and places, not by means and shares.
  std::size_t due = static_cast<std::size_t>(-1);
  std::size_t even() const { return std::min(due, mm.size()); }
  double end() const { return mm.empty() ? 0 : mm.back(); }
};

struct TornLink {
  double mm = 0;  // displacement of the plate
  int link = 0;   // index in RunRecord::lattices.link
};

struct Frame {
  double mm = 0;
  Table discs, links, plates;
};

// One entry of run.json.
struct Fact {
  std::string key;
  std::vector<std::string> texts;  // of an array all, of null none, of anything else one
  bool fraction = false;           // a floating-point number
};

// One watch of run.json's "validity"; what was measured is of all steps, see validity.h.
struct WatchedFact {
  std::string name, verdict, where;
  double worst = 0, time = 0;              // time: s, of the worst; NaN: not watched
  double warns_above = 0, ends_above = 0;  // ends: infinity, it does not
  std::optional<double> allowed{};         // infinity: any number
};

// The largest force on a plate, of all steps.
struct LargestForce {
  double f = 0, time = 0;  // N, s
};

struct RunRecord {
  std::string name;
  std::vector<Fact> facts;  // in the order of the file, but for the next three
  std::string validity;     // verdict on the whole; empty: run.json has none
  std::vector<WatchedFact> watched;
  std::vector<LargestForce> largest_force;  // by plate
  Scene scene;
  Parts lattices;  // nodes and links of the scene's lattices, nothing else
  ForceCurve force;
  Table energy;                // without rows: no ledger
  std::vector<TornLink> torn;  // in order of time
  std::optional<double> met;   // mm, when the plate first touches a lattice; NaN: never; none: not recorded
  std::vector<Frame> frames;

  const Fact* fact(std::string_view key) const;  // null if there is none
  bool finished() const;
};

double plate_speed(const RunRecord& run);                   // of the first plate, after its ramp, mm/s
double plate_displacement(const RunRecord& run, double t);  // of the first plate since t = 0, its ramp included, mm

// Of a run that ended while its scene was prepared there are only facts and scene. Throws std::runtime_error that names
// the file that is missing or malformed.
RunRecord read_run(const std::string& name, const std::filesystem::path& directory);

// One thing that the paper reports; the heading of validation/statements.toml explains the fields.
struct Statement {
  std::string id, scene, quantity, unit, relation, where, read, observable, ours, mark, label, words, expect;
  double value = std::numeric_limits<double>::quiet_NaN();  // NaN: the paper says it in `words`
  std::optional<std::array<double, 2>> window;              // mm
  std::optional<std::array<double, 2>> holds;               // of the observable, where the paper says it in words
};

struct Publication {
  std::string title;
  std::vector<Statement> statements;
};

// Throws std::runtime_error that says what is wrong with the TOML text.
Publication read_publication(std::string_view toml);

}  // namespace furrow::validation
