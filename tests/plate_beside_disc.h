// A plate that goes 0.5 m/s beside a disc that it never meets: what depends on its way alone.
#pragma once

#include <string>

#include "scene/read.h"

namespace furrow::test {

// `time` and `plate`: further lines of these tables; samples are due every 0.02 s.
inline Scene plate_beside_disc(const std::string& time, const std::string& plate = "", const std::string& output = "") {
  return parse_scene(R"(title = "a plate beside a disc"
material = [{ name = "soft", young = 2e5, poisson = 0.3 }]
disc = [{ position = [-1.0, 1.0], radius = 0.1, material = "soft" }]
[time]
step = 1e-3
)" + time + R"(
[[plate]]
left_edge = 0.0
lower_edge = 0.0
width = 0.01
height = 0.1
velocity = [0.3, 0.4]
material = "soft"
)" + plate + "\n[output]\ninterval = 0.02\n" +
                         output,
                     "beside");
}

}  // namespace furrow::test
