// The ranges of schema.h, held against a scene that came from a command line or from code, not from a file.
#include <concepts>
#include <initializer_list>
#include <optional>
#include <type_traits>
#include <utility>

#include "scene/findings.h"
#include "scene/schema.h"
#include "scene/utf8.h"

namespace furrow {
namespace {

// A place in the scene. Its text is made only if something is wrong there: a bed may have millions of them.
struct Place {
  const Place* outer = nullptr;
  const char* key = "";
  std::ptrdiff_t index = -1;  // of an item in the list `outer`; -1: a key of the table `outer`

  std::string text() const {
    if (!outer) return {};
    const std::string before = outer->text();
    if (index >= 0) return item(before, static_cast<std::size_t>(index));
    return before + (before.empty() ? "" : ".") + key;
  }
};

// It is a visitor of schema.h.
class RangeChecker {
 public:
  RangeChecker(const Place& place, Findings& found) : place_(place), found_(found) {}

  void operator()(const char* key, auto& field, const Key& about) {
    check({&place_, key}, field, about.unit, about.range);
  }
  void required(const char* key, auto& field, const Key& about) { (*this)(key, field, about); }
  void follows(const char*, const char*) {}
  template <class Enum>
  void choice(const char*, Enum&, std::initializer_list<Choice<Enum>>, std::string_view) {}

 private:
  void check(const Place&, bool, std::string_view, const Range&) {}

  template <class Number>
  requires(std::floating_point<Number> || std::integral<Number>) void check(const Place& place, Number number,
                                                                            std::string_view unit, const Range& range) {
    const auto value = static_cast<double>(number);
    if (!within(range, value)) found_.refuse(place.text(), outside(range, place.text(), unit, value));
  }

  void check(const Place& place, const std::string& text, std::string_view, const Range&) {
    if (const std::string fault = text_fault(text); !fault.empty()) found_.refuse(place.text(), fault);
  }

  void check(const Place& place, Vec2& v, std::string_view unit, const Range& range) {
    check({&place, "", 0}, v.x, unit, range);
    check({&place, "", 1}, v.y, unit, range);
  }

  template <class T>
  void check(const Place& place, std::optional<T>& field, std::string_view unit, const Range& range) {
    if (field) check(place, *field, unit, range);
  }

  template <class T>
  void check(const Place& place, std::vector<T>& items, std::string_view unit, const Range& range) {
    for (std::size_t i = 0; i < items.size(); ++i)
      check({&place, "", static_cast<std::ptrdiff_t>(i)}, items[i], unit, range);
  }

  template <class Struct>
  requires(std::is_aggregate_v<Struct>) void check(const Place& place, Struct& field, std::string_view, const Range&) {
    RangeChecker inner(place, found_);
    describe(inner, field);
  }

  const Place& place_;
  Findings& found_;
};

}  // namespace

void judge_ranges(const Scene& scene, Findings& found) {
  Scene copy = scene;  // the schema describes what may be written to
  const Place whole;
  RangeChecker checker(whole, found);
  describe(checker, copy);
}

}  // namespace furrow
