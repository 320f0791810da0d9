// Discs are stored, and so their forces summed, in the order of the scene where they fit in one block (system/order.h).
// More of them are stored along a curve through the places that the scene gives them, before they settle, so that those
// that may touch are near in memory whatever the order in which the scene lists them. The order follows from the scene
// alone. What a user sees has the scene's numbers.
#pragma once

#include <vector>

namespace furrow {

// The numbers of the discs at these places (m) in the order of storage. Discs at one place keep their order.
std::vector<int> order_of_storage(const std::vector<double>& x, const std::vector<double>& y);

// Where each number stands in an order.
std::vector<int> places_in(const std::vector<int>& order);

}  // namespace furrow
