// The independent engine as a program: a request on standard input, an answer on standard output, see PROTOCOL.md.
//
// usage: independent_engine [rk4 | dopri5 | euler]
#include <exception>
#include <iostream>

#include "verification/engines/independent.h"

int main(int argc, char** argv) {
  using namespace furrow::verification;
  const std::string wanted = argc > 1 ? argv[1] : "rk4";
  try {
    for (const Stepper& stepper : odeint_steppers()) {
      if (stepper.name != wanted) continue;
      std::cout << independent_answer(Json::parse(std::cin), stepper).dump(2) << "\n";
      return 0;
    }
    std::cerr << "independent_engine: error: there is no method " << wanted << "; there are rk4, dopri5, euler\n";
    return 2;
  } catch (const std::exception& fault) {
    std::cerr << "independent_engine: error: " << fault.what() << "\n";
    return 2;
  }
}
