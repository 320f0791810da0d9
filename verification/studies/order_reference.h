// Integration in long double, without the solver, for motions without closed form.
#pragma once

#include <functional>
#include <vector>

#include "system/ode.h"

namespace furrow::verification {

using Numbers = std::vector<long double>;
using Rate = std::function<Numbers(const Numbers&)>;

State rounded(const Numbers& y);

// One step of the modified midpoint rule with 2, 4, ..., 16 substeps, extrapolated in h^2: order 16.
// Sources: Gragg 1965; Bulirsch and Stoer 1966; Deuflhard 1985.
Numbers extrapolated_step(const Rate& f, const Numbers& y, long double h);

// The solution from t = 0 on, kept at equal steps of which each is one extrapolated step.
class Trajectory {
 public:
  Trajectory(Rate f, Numbers start, long double step, long double end);
  Numbers at(long double t) const;  // 0 <= t <= end

 private:
  Rate f_;
  long double step_;
  std::vector<Numbers> kept_;
};

}  // namespace furrow::verification
