// What `furrow explain` says of a scene, and the numbers in it.
#pragma once

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace furrow::test {

class Explain : public Program {
 protected:
  // What `explain` says of the scene; its exit code is kept.
  std::string explain(const std::string& scene, const std::string& options = "") {
    put("s.toml", scene);
    code_ = furrow("explain s.toml " + options).code;
    errors_ = err();
    return out();
  }

  // All numbers after the first line that begins with `part` and holds `word`.
  static std::vector<double> numbers(const std::string& text, const std::string& part, const std::string& word) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t at = line.find(word);
      if (at == std::string::npos || line.find_first_not_of(' ') != line.find(part)) continue;
      static const std::regex number(R"(-?\d+\.?\d*(e[+-]?\d+)?)");
      const std::string rest = line.substr(line.find(part) + part.size());
      std::vector<double> found;
      for (std::sregex_iterator one(rest.begin(), rest.end(), number), end; one != end; ++one)
        found.push_back(std::stod(one->str()));
      return found;
    }
    ADD_FAILURE() << "no line '" << part << " ... " << word << "' in\n" << text;
    return {};
  }

  // As printed: with so many digits.
  static void expect(double got, double want, int digits) {
    EXPECT_NEAR(got, want, 0.6 * std::pow(10, 1 - digits) * std::fabs(want));
  }

  std::string errors_;
  int code_ = -1;
};

// Discs of sand and steel on a floor, one pressed 1 mm into it, one flying at 3 m/s.
inline const std::string discs = R"(
title = "Explained"
[model]
gravity = 2.5
disc_depth = 0.5
[time]
step = 1e-5
end = 1e-3
[contact]
damping_factor = 0.3
friction = 0.4
rolling_friction = 0.02
[[contact.pair]]
materials = ["sand", "steel"]
damping_factor = 1.5
friction = 0.25
[[material]]
name = "sand"
density = 2000.0
young = 1e6
poisson = 0.25
[[material]]
name = "steel"
density = 8000.0
young = 4e6
shear = 1.6e6
[[material]]
name = "rock"
rigid = true
[[disc]]
position = [0.0, 0.049]
radius = 0.05
material = "sand"
[[disc]]
position = [1.0, 0.5]
radius = 0.02
velocity = [3.0, 0.0]
material = "steel"
[[wall]]
point = [0.0, 0.0]
normal = [0.0, 1.0]
material = "rock"
)";

// One spring of omega = sqrt(k/m), no damping: verlet and symplectic Euler hold to 2/omega, rk4 to 2.828/omega.
inline const std::string spring = R"(
title = "Spring"
[time]
step = 1e-2
end = 1.0
method = "verlet"
[output]
interval = 0.5
[[material]]
name = "soft"
young = 1e6
poisson = 0.25
[[lattice]]
name = "spring"
origin = [0.0, 0.0]
rows = 1
columns = 2
spacing = 1.0
node_mass = 2.0
material = "soft"
fixed_columns = [0]
structural = { stiffness = 800.0, damping = 0.0 }
)";

}  // namespace furrow::test
