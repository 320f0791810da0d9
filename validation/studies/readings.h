// The readings of the paper: every choice that it leaves open, searched over its three scenes with one set of choices for
// all (validation/readings.toml).
//
// First each alternative alone, then points drawn at random, then from the best of them pass after pass every
// alternative of every choice, the best of a choice kept. The best few and the literal reading are judged again by packings
// that did not choose them, at the paper's step and at a finer one.
#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "report/study.h"
#include "validation/studies/sentences.h"

namespace furrow::validation {

struct Alternative {
  std::string name, reason;
  std::vector<std::string> set;  // "KEY=VALUE", "SCENE:KEY=VALUE"
  bool drawn = true;             // false: costs too much to be drawn at random
};

struct Choice {
  std::string id, open;
  std::vector<Alternative> alternatives;  // the first is the literal one
};

struct Readings {
  std::vector<Choice> choices;
  std::vector<std::pair<std::string, std::string>> unsearched;  // what, why
  int random = 0, exchanges = 0, finalists = 0, packings = 0;
  double fine_step = 0;  // s
  std::uint64_t seed = 1;
};
const Readings& the_readings();

// A scene of the paper, of this name, with an alternative's keys.
Scene read_as(const std::string& name, Scene scene, const Alternative& alternative);

// An alternative of each choice, by its place.
using Interpretation = std::vector<int>;
std::string words_of(const Interpretation& reading);  // what is not literal: "box 0.54 m, damping alpha = 20"

struct ReadPoint {
  Interpretation reading;
  std::map<std::string, Json> said;  // by scene
  double misfit(const std::vector<std::string>& scenes) const { return misfit_of(said, scenes); }
};

struct Finalist {
  Interpretation reading;
  std::map<std::string, std::vector<Json>> said, finer;  // by scene, packings; at the paper's step and at the finer one
};

// Runs of scene 1 whose links never tear, or tear late, each watched as `furrow run` does it.
struct Untorn {
  double strength = 0, step = 0;  // N, s
  std::string key() const;
};
std::vector<Untorn> untorn_runs();

struct ReadingsFound {
  std::vector<std::string> scenes;
  std::vector<ReadPoint> points;  // in the order in which they were tried: literal, alone, at random, exchanged
  std::size_t alone = 0, random = 0;
  std::vector<Finalist> finalists;                                  // the literal one first, then the best
  std::vector<Json> untorn;                                         // by untorn_runs()
  const ReadPoint& best(const std::vector<std::string>& of) const;  // the least misfit of those scenes
};

// The search. `run` makes tasks, or knows what they gave. The quick form looks at scene 1 alone.
using RunTasks = std::function<std::vector<Json>(const std::vector<Task>&)>;
ReadingsFound search_readings(const RunTasks& run, bool quick);

void measure_readings(Measurement& measurement);

}  // namespace furrow::validation
