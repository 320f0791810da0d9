// The scene as other programs take it, and how each is called.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/measured_process.h"
#include "run/prepare.h"
#include "scene/scene.h"

namespace furrow::benchmarks {

// The settled bed, from which all start, in the files of all programs.
struct Bed {
  Prepared prepared;
  std::filesystem::path directory, decks, furrow;
};

// Settles benchmarks/rivals/scene.toml and writes bed.data, plate.stl and scene.toml. `furrow` is the program.
Bed make_bed(const std::filesystem::path& decks, const std::filesystem::path& directory,
             const std::filesystem::path& furrow);
void write_scene(const Bed& bed, const Scene& scene);
void write_bodies(const Bed& bed);  // bed.data and plate.stl

struct Task {
  double speed;  // m/s, of the plate
  long steps;
  bool look;  // whether to write forces (force.txt) and the end (end.txt); not while time is taken
  std::filesystem::path directory;
};

struct Rival {
  std::string name, package, law;  // the package is empty for furrow
  long steps;                      // that are timed
  int evaluations;                 // of the forces, a step
  std::function<MeasuredCommand(const Bed&, const Task&)> command;
};

std::vector<Rival> rivals();

// furrow's rk4, which others are compared with.
Rival converged();

std::string version_of(const std::string& package);  // empty: furrow's commit
std::string build_of(const std::string& package);    // compiler and flags, as far as it says

// Rows of so many numbers, separated by spaces or commas; others are headings.
std::vector<std::vector<double>> rows_of(const std::filesystem::path& file, std::size_t columns);

}  // namespace furrow::benchmarks
