// The terms of the model that a scene can be written without, and the scenes in which that is tried.
#pragma once

#include "report/cases.h"

namespace furrow::benchmarks {

struct Term {
  std::string name;
  bool (*present)(const Scene&);
  void (*drop)(Scene&);
};

const std::vector<Term>& terms();

struct Subject {
  std::string name;
  Span span;
  std::string method;
  double step;       // s: not the paper's where that chatters
  int packings = 1;  // seeds
  std::function<Scene()> scene;
};

std::vector<Subject> subjects(bool quick);

}  // namespace furrow::benchmarks
