#include <stdexcept>

#include "methods/method.h"
#include "scene/wording.h"

namespace furrow {
namespace {

using Maker = std::unique_ptr<Method> (*)(const Tolerances&);

// One a line, so that additions do not meet.
// clang-format off
constexpr Maker makers[] = {
    make_pece,
    make_pec,
    make_pecece,
    make_pece_adaptive,
    make_adams_bashforth_2,
    make_symplectic_euler,
    make_verlet,
    make_runge_kutta_4,
    make_runge_kutta_chebyshev,
    make_odeint_rk4,
    make_odeint_abm2,
    make_odeint_dopri5,
};
// clang-format on

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
  std::vector<std::string> known;
  for (const MethodInfo& info : method_catalogue()) {
    if (info.name == name) return makers[known.size()](tolerances);
    known.push_back(info.name);
  }
  throw std::invalid_argument("no method '" + name + "'" + did_you_mean(name, known) + "; there are " + joined(known));
}

}  // namespace furrow
