// An engine that is a program of its own: PROTOCOL.md.
#include <stdexcept>

#include "output/child.h"
#include "output/strict_json.h"
#include "scene/utf8.h"
#include "verification/engines/judge.h"

namespace furrow::verification {

Engine program_engine(const std::string& command, double limit) {
  return [command, limit](const Json& request) {
    const ChildEnd end = run_child({.words = {"/bin/sh", "-c", "{ " + command + "\n} <\"$1\"", "engine", "{input}"},
                                    .input = request.dump(),
                                    .limit = limit});
    const std::string last = end.errors.empty() ? "" : ": " + visible(end.errors.substr(0, 400));
    if (end.code != 0) throw std::runtime_error("the engine ended with code " + std::to_string(end.code) + last);
    const std::size_t begin = end.output.find('{');
    if (begin == std::string::npos) throw std::runtime_error("the engine printed no JSON" + last);
    try {
      return strict_json(std::string_view(end.output).substr(begin));
    } catch (const std::invalid_argument& fault) {
      throw std::runtime_error(std::string("the answer ") + fault.what());
    }
  };
}

}  // namespace furrow::verification
