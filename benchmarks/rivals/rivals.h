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

// Rows of so many numbers, separated by spaces or commas; others are headings.
std::vector<std::vector<double>> rows_of(const std::filesystem::path& file, std::size_t columns);

}  // namespace furrow::benchmarks
