// A plate that bends a small stem: the parts that scenes of several tests share.
#pragma once

#include <string>

namespace furrow::test {

// Two columns of `rows` nodes, 10 mm apart, on the ground, and a plate that comes from the left at 0.1 m/s, its lower edge
// at `lower_edge` (m).
inline std::string bent_stem(int rows, const std::string& lower_edge, const std::string& tool) {
  return R"([[lattice]]
origin = [0.0, 0.0]
rows = )" +
         std::to_string(rows) + R"(
columns = 2
spacing = 0.01
node_mass = 0.02
material = "wood"
fixed_rows = [0]
structural = { stiffness = 2e3, damping = 4.0 }
shear = { stiffness = 1e3, damping = 4.0 }
[[plate]]
left_edge = -0.012
lower_edge = )" +
         lower_edge + R"(
width = 0.01
height = 0.02
velocity = [0.1, 0.0]
material = ")" +
         tool + "\"\n";
}

// A scene of four nodes that runs in a moment: the plate goes 10 mm.
inline std::string bent_twig() {
  return R"(title = "a plate bends a twig"
time = { end = 0.1, step = 1e-4 }
output = { interval = 2e-3 }
material = [{ name = "wood", young = 2e5, poisson = 0.3 }]
)" + bent_stem(2, "0.002", "wood");
}

}  // namespace furrow::test
