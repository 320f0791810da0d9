#include "output/strict_json.h"

#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "scene/wording.h"

namespace furrow {
namespace {

using Json = nlohmann::ordered_json;
using Event = Json::parse_event_t;

constexpr int deepest = 100;

}  // namespace

Json strict_json(std::string_view text) try {
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  return Json::parse(text, [&](int depth, Event event, Json& value) {
    if (depth > deepest) throw std::invalid_argument("is nested deeper than " + std::to_string(deepest));
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(value.get<std::string>()).second)
      throw std::invalid_argument("has " + in_quotes(value.get<std::string>()) + " twice");
    return true;
  });
} catch (const Json::parse_error& error) {
  throw std::invalid_argument("is no JSON: byte " + std::to_string(error.byte) + " cannot stand there");
} catch (const Json::out_of_range&) {
  throw std::invalid_argument("has a number that is too large");
}

Json json_or_discarded(std::string_view text) try { return strict_json(text); } catch (const std::invalid_argument&) {
  return Json::value_t::discarded;
}

Json json_or_discarded(std::istream& stream) {
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return json_or_discarded(text);
}

}  // namespace furrow
