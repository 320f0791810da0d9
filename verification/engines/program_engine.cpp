// An engine that is a program of its own: PROTOCOL.md.
#include <set>
#include <stdexcept>

#include "output/child.h"
#include "scene/wording.h"
#include "verification/engines/judge.h"

namespace furrow::verification {
namespace {

// A key that stands twice would hide a value.
Json parsed(const std::string& text) {
  std::vector<std::set<std::string>> keys;
  return Json::parse(text, [&](int /*depth*/, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw std::runtime_error("the answer has " + in_quotes(value.get<std::string>()) + " twice");
    return true;
  });
}

}  // namespace

Engine program_engine(const std::string& command, double limit) {
  return [command, limit](const Json& request) {
    const ChildEnd end = run_child({.words = {"/bin/sh", "-c", "{ " + command + "\n} <\"$1\"", "engine", "{input}"},
                                    .input = request.dump(),
                                    .limit = limit});
    const std::string last = end.errors.empty() ? "" : ": " + end.errors.substr(0, 400);
    if (end.code != 0) throw std::runtime_error("the engine ended with code " + std::to_string(end.code) + last);
    const std::size_t begin = end.output.find('{');
    if (begin == std::string::npos) throw std::runtime_error("the engine printed no JSON" + last);
    return parsed(end.output.substr(begin));
  };
}

}  // namespace furrow::verification
