#include "verification/studies/order_problems.h"

#include <map>
#include <mutex>
#include <stdexcept>

namespace furrow::verification {
namespace {

// Every method asks for the same states: they are computed once.
std::function<State(long double)> remembered(std::function<State(long double)> state) {
  struct Memory {
    std::mutex mutex;
    std::map<long double, State> states;
  };
  return [state = std::move(state), memory = std::make_shared<Memory>()](long double t) {
    const std::scoped_lock lock(memory->mutex);
    auto& states = memory->states;
    const auto found = states.find(t);
    return found != states.end() ? found->second : states.emplace(t, state(t)).first->second;
  };
}

}  // namespace

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = [] {
    std::vector<Problem> list;
    for (auto* make : {spring_problems, contact_problems, friction_problems}) {
      for (Problem& p : make()) {
        p.state = remembered(std::move(p.state));
        list.push_back(std::move(p));
      }
    }
    return list;
  }();
  return all;
}

const Problem& problem(const std::string& name) {
  for (const Problem& p : problems()) {
    if (p.name == name) return p;
  }
  throw std::invalid_argument("no problem '" + name + "'");
}

}  // namespace furrow::verification
