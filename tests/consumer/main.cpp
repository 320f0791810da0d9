// A project that uses the installed library: its headers are found, what they include is found, and it links.
#include <iostream>
#include <string_view>

#include "output/build_info.h"
#include "scene/read.h"

constexpr std::string_view falling_disc = R"(
title = "furrow"
[time]
end = 1.0
step = 1e-3
[[material]]
name = "soil"
young = 2e5
poisson = 0.3
[[disc]]
position = [0.0, 0.0]
radius = 0.01
material = "soil"
)";

int main() {
  const furrow::Scene scene = furrow::parse_scene(falling_disc, "falling_disc");
  std::cout << scene.title << ' ' << furrow::build_info().version << '\n';
}
