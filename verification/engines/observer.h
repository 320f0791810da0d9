// What a case wants observed, gathered step by step while an engine runs. For engines that live in this program.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "verification/engines/case.h"

namespace furrow::verification {

// An engine's run at one moment. Forces are on the first of the two, along the line that pushes them apart.
struct Moment {
  double time = 0;                                                                  // s
  std::function<std::array<double, 2>(const std::string&body)> position, velocity;  // m, m/s
  std::function<double(const std::string& body)> spin;                              // rad/s
  std::function<double(const std::string&a, const std::string&b)> overlap, force;   // m, N
  std::function<std::array<double, 2>(const std::string& plate)> push;              // N
  std::function<bool(const std::string& a, const std::string& b)> torn;             // a spring
};

class Observer {
 public:
  explicit Observer(const Json& c);
  ~Observer();
  void look(const Moment& now);  // at the start and after each step
  Json observables() const;      // by name

 private:
  struct Watch;
  const Json& case_;
  std::vector<Watch> watches_;
};

}  // namespace furrow::verification
