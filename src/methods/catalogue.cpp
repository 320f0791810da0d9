#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "methods/method.h"
#include "scene/wording.h"

namespace furrow {

// The methods that the files of this folder add; written when the build is configured.
void methods_of_all_files(std::vector<MethodEntry>& catalogue);

namespace {

std::mutex mutex;

// The paper's method is the first, own ones come before others.
std::vector<MethodEntry>& entries() {
  static std::vector<MethodEntry> all = [] {
    std::vector<MethodEntry> list;
    methods_of_all_files(list);
    const auto rank = [](const MethodEntry& e) { return e.info.name == "pece" ? 0 : e.info.family == "own" ? 1 : 2; };
    std::stable_sort(list.begin(), list.end(),
                     [&](const auto& one, const auto& other) { return rank(one) < rank(other); });
    return list;
  }();
  return all;
}

std::deque<MethodInfo>& infos() {
  static std::deque<MethodInfo> all = [] {
    std::deque<MethodInfo> list;
    for (const MethodEntry& entry : entries()) list.push_back(entry.info);
    return list;
  }();
  return all;
}

}  // namespace

const std::deque<MethodInfo>& method_catalogue() {
  const std::scoped_lock lock(mutex);
  return infos();
}

std::unique_ptr<Method> make_method(const std::string& name, const Tolerances& tolerances) {
  const std::scoped_lock lock(mutex);
  std::vector<std::string> known;
  for (const MethodEntry& entry : entries()) {
    if (entry.info.name == name) return entry.make(tolerances);
    known.push_back(entry.info.name);
  }
  throw std::invalid_argument("no method '" + name + "'" + did_you_mean(name, known) + "; see furrow methods");
}

void register_method(const MethodEntry& entry) {
  const std::scoped_lock lock(mutex);
  for (const MethodEntry& other : entries()) {
    if (other.info.name == entry.info.name)
      throw std::invalid_argument("there is a method '" + entry.info.name + "' already");
  }
  infos().push_back(entry.info);
  entries().push_back(entry);
}

namespace {

constexpr std::size_t most_unknowns = 200;  // above it a dense Jacobian costs more than it gains

}  // namespace

std::string refusal(const MethodInfo& method, const OdeSystem& system) {
  if (const std::string what = system.velocity_dependence(); method.conservative && !what.empty())
    return "the method " + method.name + " cannot carry forces that depend on velocity; here these do: " + what +
           ". Take another method, or set their coefficients to zero";
  if (method.dense_jacobian && system.controlled() > most_unknowns)
    return "the method " + method.name + " solves a dense system and takes at most " + std::to_string(most_unknowns) +
           " numbers of state; the scene has " + std::to_string(system.controlled()) + ". Take another method";
  return {};
}

}  // namespace furrow
