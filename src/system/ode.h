// What an integration method sees of a system:  y' = f(t, y).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace furrow {

using State = std::vector<double>;

// A run cannot go on: a number is not finite, a body outran its contacts, a controlled step failed.
class Divergence : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// y = [ q, v, z ]: `positions` numbers q, as many v with q' = v, and the rest z, which f may use but q' does not.
class OdeSystem {
 public:
  virtual ~OdeSystem() = default;
  virtual std::size_t size() const = 0;
  virtual std::size_t positions() const = 0;

  // How many of the leading numbers count in the error control of a controlled method.
  virtual std::size_t controlled() const { return size(); }

  // How many of those are always there; the numbers of contacts come after them. Whatever a method decides by counts or
  // sums must depend on these alone, so that the room reserved for contacts does not matter.
  virtual std::size_t lasting() const { return controlled(); }

  // The number of threads that an evaluation uses, and that a method may use for passes over its states.
  virtual int threads() const { return 1; }

  // Which forces depend on velocity, for a message; empty: none.
  virtual std::string velocity_dependence() const { return {}; }

  // Pure: the same (t, y) gives the same bits, in whatever order it is called. dydt has the size of y already.
  virtual void rhs(double t, const State& y, State& dydt) const = 0;

 protected:
  OdeSystem() = default;
  OdeSystem(const OdeSystem&) = default;
  OdeSystem& operator=(const OdeSystem&) = default;
  OdeSystem(OdeSystem&&) = default;
  OdeSystem& operator=(OdeSystem&&) = default;
};

}  // namespace furrow
