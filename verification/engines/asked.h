// What an engine answers to a case, read from its JSON.
#pragma once

#include <optional>

#include "verification/engines/judge.h"

namespace furrow::verification {

struct Asked {
  std::vector<Json> answers;          // one a resolution, if it can
  std::optional<std::string> cannot;  // why
};

// Asks at each resolution of the case, and keeps in the judgement what the engine calls itself and which order it claims.
// An engine that can do a case can do it at every resolution, by one method. Throws std::runtime_error with what is wrong
// with an answer.
Asked ask(const Json& whole, const Engine& engine, Judgement& j);

// The observable of that name; throws std::runtime_error if the answer has none or it is no number.
double value_of(const Json& answer, const std::string& name);

}  // namespace furrow::verification
