// Oracles of beds of discs, which no closed form has: the laws of the protocol, carried by the independent engine.
#include <cmath>
#include <random>
#include <vector>

#include "verification/engines/independent.h"
#include "verification/engines/oracle_parts.h"

namespace furrow::verification {
namespace {

// By rk4, `steps` in the unit of the case.
Json integrated(const Json& c, int steps) {
  return independent_answer(request_of(c, steps), odeint_steppers().front())["observables"];
}

// With an eighth of the finest step that an engine is asked for.
Expected bed_integrated(const Json& c) {
  const Json got = integrated(c, 8 * c["steps"].back().get<int>());
  Expected all;
  fill(all, c, [&](const Json& seen) { return got[seen["name"].get<std::string>()].get<double>(); });
  return all;
}

// Own arithmetic: distributions of the library differ.
double between(std::mt19937_64& random, double most) {
  return most * (2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1);
}

Json moved(Json c, std::mt19937_64& random) {
  const double most = c["moved"];
  for (Json& body : c["body"]) {
    for (Json& coordinate : body["position"]) coordinate = coordinate.get<double>() + between(random, most);
  }
  return c;
}

// Four standard deviations to either side of the mean.
Expected beds_statistics(const Json& c) {
  std::mt19937_64 random(1);
  std::vector<Json> beds;
  for (int k = 0; k < c["members"].get<int>(); ++k)
    beds.push_back(integrated(moved(c, random), c["steps"].front().get<int>()));
  Expected all;
  for (const Json& seen : c["observe"]) {
    const std::string name = seen["name"];
    double sum = 0, squares = 0;
    for (const Json& bed : beds) sum += bed[name].get<double>();
    const double count = static_cast<double>(beds.size()), mean = sum / count;
    for (const Json& bed : beds) squares += std::pow(bed[name].get<double>() - mean, 2);
    const double deviation = std::sqrt(squares / (count - 1));
    all[low_of(name)] = mean - 4 * deviation;
    all[high_of(name)] = mean + 4 * deviation;
  }
  return all;
}

}  // namespace

const std::map<std::string, Oracle>& bed_oracles() {
  static const std::map<std::string, Oracle> all{{"bed, integrated", bed_integrated},
                                                 {"beds, statistics", beds_statistics}};
  return all;
}

}  // namespace furrow::verification
