// A calibration from its scenes, keys and targets to its result: files, and words for a page.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "report/study.h"
#include "validation/calibration/identify.h"
#include "validation/calibration/search.h"

namespace furrow::validation {

constexpr int usual_fresh = 5;

struct CalibrationRequest {
  std::vector<std::filesystem::path> scenes;
  std::vector<std::string> vary;  // see VariedKey::of
  std::filesystem::path targets;
  std::filesystem::path directory;  // empty: nothing is kept
  SearchPlan plan{};
  std::optional<int> fresh{};  // packings that the search has not seen, for the best few; empty: the usual number
  std::function<bool(double, double)> progress{};  // (runs, of at most); false stops
};

// A setting that the search found, and what it gives with packings that it has not seen.
struct Candidate {
  Point searched, fresh;
};

struct Calibration {
  std::vector<Case> cases;
  std::vector<VariedKey> keys;
  Targets targets;
  std::vector<Candidate> best;  // settings that differ by more than a fiftieth of a range, the best first
  Identified identified;        // about the first of them
  long points = 0, failed = 0, made = 0, replayed = 0;
};

// The names of the files in the directory of a calibration of these scenes. Figures of the page come on top.
std::vector<std::string> files_of_calibration(const std::vector<Case>& cases);

// Throws what reading scenes, keys and targets throws, std::invalid_argument if one of them is a file that the
// calibration writes, or if packings are asked for and no scene has one, FileError if the directory is not its own, Interrupted, and what search() throws.
Calibration calibrate(const CalibrationRequest& request);

Json json_of(const Calibration& calibration);
Report report_of(const Calibration& calibration);

// calibration.json, calibration.html and best/SCENE.toml, in a directory that is a calibration's own or new: see
// OwnedDirectory. Throws FileError.
void write_calibration(const Calibration& calibration, const std::filesystem::path& directory);

}  // namespace furrow::validation
