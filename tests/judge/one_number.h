// An answer that says the same number for everything.
#pragma once

#include <string>

#include "verification/engines/judge.h"

namespace furrow::test {

inline verification::Json all_observables(const std::string& name, double value) {
  using verification::Json;
  Json answer{{"engine", "x"}, {"order", 2}, {"observables", Json::object()}};
  for (const Json& seen : verification::case_named(name)["observe"])
    answer["observables"][seen["name"].get<std::string>()] = value;
  return answer;
}

}  // namespace furrow::test
