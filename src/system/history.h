// What is carried from one step to the next. Each class that carries something lists it in one function, item by item;
// a visitor saves it, restores it, or makes room in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "system/ode.h"

namespace furrow {

class HistoryVisitor {
 public:
  virtual ~HistoryVisitor() = default;
  HistoryVisitor(const HistoryVisitor&) = delete;
  HistoryVisitor& operator=(const HistoryVisitor&) = delete;

  virtual void number(std::string_view name, double& value) = 0;
  virtual void integer(std::string_view name, std::int64_t& value) = 0;
  virtual void text(std::string_view name, std::string& value) = 0;
  virtual void integers(std::string_view name, std::vector<std::int64_t>& values) = 0;

  // A state, rates of one, or the end of either.
  virtual void state(std::string_view name, State& values) = 0;

  void operator()(std::string_view name, double& value) { number(name, value); }
  void operator()(std::string_view name, std::string& value) { text(name, value); }
  void operator()(std::string_view name, State& values) { state(name, values); }

  // Of any integer, truth value or enumeration.
  template <class T>
  std::enable_if_t<std::is_integral_v<T> || std::is_enum_v<T>> operator()(std::string_view name, T& value) {
    auto wide = static_cast<std::int64_t>(value);
    integer(name, wide);
    value = static_cast<T>(wide);
  }
  template <class T>
  std::enable_if_t<std::is_integral_v<T>> operator()(std::string_view name, std::vector<T>& values) {
    std::vector<std::int64_t> wide(values.begin(), values.end());
    integers(name, wide);
    values.resize(wide.size());
    for (std::size_t k = 0; k < wide.size(); ++k) values[k] = static_cast<T>(wide[k]);
  }

  // A list of anything else: each(item) visits one.
  template <class T, class Each>
  void list(std::string_view name, std::vector<T>& items, Each each) {
    std::size_t count = items.size();
    (*this)(name, count);
    items.resize(count);
    for (T& item : items) each(item);
  }

 protected:
  HistoryVisitor() = default;
};

// Numbers inserted into a state: `count` zeros, `before_end` places before its end.
struct Growth {
  std::size_t count = 0, before_end = 0;
  void apply(State& y) const { y.insert(y.end() - static_cast<State::difference_type>(before_end), count, 0.0); }
};

// Makes the same room in all states that are remembered.
class GrowHistory final : public HistoryVisitor {
 public:
  explicit GrowHistory(const Growth& growth) : growth_(growth) {}
  void number(std::string_view /*name*/, double& /*value*/) override {}
  void integer(std::string_view /*name*/, std::int64_t& /*value*/) override {}
  void text(std::string_view /*name*/, std::string& /*value*/) override {}
  void integers(std::string_view /*name*/, std::vector<std::int64_t>& /*values*/) override {}
  void state(std::string_view /*name*/, State& values) override {
    if (!values.empty()) growth_.apply(values);
  }

 private:
  Growth growth_;
};

}  // namespace furrow
