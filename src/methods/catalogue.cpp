#include <algorithm>
#include <functional>
#include <stdexcept>

#include "methods/method.h"

namespace furrow {
namespace {

struct Entry {
  std::string name;
  std::function<std::unique_ptr<Method>(const Tolerances&)> make;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> list{{"pece", [](const Tolerances&) { return make_pece(); }},
                            {"verlet", [](const Tolerances&) { return make_verlet(); }},
                            {"rk4", [](const Tolerances&) { return make_runge_kutta_4(); }}};
    for (const char* name : {"odeint_rk4", "odeint_abm2", "odeint_dopri5"}) {
      list.push_back({name, [name](const Tolerances& tolerances) { return make_odeint(name, tolerances); }});
    }
    return list;
  }();
  return all;
}

}  // namespace

const std::vector<MethodInfo>& method_catalogue() {
  static const std::vector<MethodInfo> all = [] {
    std::vector<MethodInfo> list;
    for (const Entry& e : entries()) list.push_back(e.make({})->info());
    return list;
  }();
  return all;
}

std::unique_ptr<Method> make_method(const std::string& name, const Tolerances& tolerances) {
  for (const Entry& e : entries()) {
    if (e.name == name) return e.make(tolerances);
  }
  std::string known;
  for (const Entry& e : entries()) known += (known.empty() ? "" : ", ") + e.name;
  throw std::invalid_argument("no method '" + name + "'; there are " + known);
}

}  // namespace furrow
