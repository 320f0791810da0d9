// What files call the parts of a list.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace furrow {

// The name of each part, or its index if it has none; with "#" before it where another part has that very name.
template <class Part>
std::vector<std::string> labels(const std::vector<Part>& parts) {
  std::vector<std::string> all;
  for (const Part& part : parts) {
    std::string label = part.name.empty() ? std::to_string(all.size()) : part.name;
    const auto has_it = [&](const Part& other) { return other.name == label; };
    while (part.name.empty() && std::any_of(parts.begin(), parts.end(), has_it)) label.insert(0, "#");
    all.push_back(std::move(label));
  }
  return all;
}

}  // namespace furrow
