#include <stdexcept>

#include "methods/method.h"

namespace furrow {
namespace {

using Maker = std::unique_ptr<Method> (*)(const Tolerances&);

constexpr Maker makers[] = {make_pece,       make_verlet,      make_runge_kutta_4,
                            make_odeint_rk4, make_odeint_abm2, make_odeint_dopri5};

}  // namespace

const std::vector<MethodInfo>& method_catalogue() {
  static const std::vector<MethodInfo> all = [] {
    std::vector<MethodInfo> list;
    for (const Maker make : makers) list.push_back(make({})->info());
    return list;
  }();
  return all;
}

std::unique_ptr<Method> make_method(const std::string& name, const Tolerances& tolerances) {
  std::string known;
  for (std::size_t k = 0; k < method_catalogue().size(); ++k) {
    if (method_catalogue()[k].name == name) return makers[k](tolerances);
    known += (k == 0 ? "" : ", ") + method_catalogue()[k].name;
  }
  throw std::invalid_argument("no method '" + name + "'; there are " + known);
}

}  // namespace furrow
