// A run of the search: a scene of the paper by a reading, at a step and with a packing.
#pragma once

#include <cstdint>
#include <functional>

#include "report/study.h"
#include "validation/studies/readings.h"

namespace furrow::validation {

inline constexpr double paper_step = 1e-4;  // s

// A scene of the paper, of this name, read by the letter, from which the search begins; without ledger.
Scene literal_scene(const std::string& name, std::uint64_t packing);

// The same with an alternative's keys.
Scene read_as(const std::string& name, Scene scene, const Alternative& alternative);

bool concerns(std::size_t choice, const std::string& name);  // whether a choice, by its place, changes the scene at all

// The reading with all literal that does not change the scene.
Interpretation concerning(const Interpretation& reading, const std::string& name);

Scene scene_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing);

// What the scene says of the rows of its sentences. Readings that make one scene have one key.
std::string key_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing);
Task task_of(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing);

// A run that a search asks for; its scene is made where its result is not known.
struct Wanted {
  std::string key;
  std::function<Task()> task;
};
Wanted wanted(const std::string& name, const Interpretation& reading, double step, std::uint64_t packing);
Wanted wanted_watched(const std::string& name, const Interpretation& reading, std::uint64_t packing);

// The same at the paper's step, watched as `furrow run` does it: "valid", "reason", "reached" in mm, "torn".
bool is_valid(const Json& watched);
std::string watched_key(const std::string& name, const Interpretation& reading, std::uint64_t packing);
Task watched_task(const std::string& name, const Interpretation& reading, std::uint64_t packing);

// Runs of scene 1 whose links never tear, or tear late, watched in the same way.
struct Untorn {
  double strength = 0, step = 0;  // N, s
};
std::vector<Untorn> untorn_runs();
Wanted wanted(const Untorn& run);

}  // namespace furrow::validation
