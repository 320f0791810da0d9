// Each value of small scenes with a part of each kind replaced by others, alone and beside one that cannot be read: the
// reader says where it is wrong, or takes a scene that survives being written. Judges of geometry see what others refuse.
#include <gtest/gtest.h>

#include <regex>

#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

struct Place {
  std::size_t at, length;
};

std::vector<Place> values_of(const std::string& text) {
  static const std::regex value(R"(-?[0-9][0-9.e+-]*|"[^"]*"|true|false)");
  std::vector<Place> places;
  for (auto found = std::sregex_iterator(text.begin(), text.end(), value); found != std::sregex_iterator(); ++found)
    places.push_back({static_cast<std::size_t>(found->position()), static_cast<std::size_t>(found->length())});
  return places;
}

std::vector<std::string> small_scenes() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir / "tests/property/scenes"))
    texts.push_back(content(entry.path()));
  return texts;
}

// What is wrong with the answer of the reader; empty if nothing is.
std::string wrong_answer(const std::string& text) {
  static const std::regex with_place(R"([^:]+:[1-9][0-9]*:[1-9][0-9]*: error: [^]+)");
  try {
    const std::string written = canonical_text(parse_scene(text, "scene"));
    return canonical_text(parse_scene(written, "scene")) == written ? "" : "what is written reads as another scene";
  } catch (const SceneError& error) {
    if (error.messages().empty()) return "refused without a message";
    for (const std::string& message : error.messages())
      if (!std::regex_match(message, with_place)) return "no place in: " + message;
    return "";
  }
}

TEST(SceneReader, AnswersWhateverOneValueIs) {
  int tried = 0;
  for (const std::string& text : small_scenes())
    for (const Place& place : values_of(text))
      for (const char* other : {"\"x\"", "inf", "-1", "0", "7", "1e300", "1e-300", "[]", "{ x = 1 }"}) {
        std::string changed = text;
        changed.replace(place.at, place.length, other);
        EXPECT_EQ(wrong_answer(changed), "") << changed;
        ++tried;
      }
  EXPECT_GT(tried, 1500);
}

// A value that cannot be read leaves its default, for which the others were not meant.
TEST(SceneReader, AnswersWhateverOneValueIsBesideOneThatCannotBeRead) {
  int tried = 0;
  for (const std::string& text : small_scenes()) {
    const std::vector<Place> places = values_of(text);
    for (std::size_t k = 0; k < places.size(); ++k)
      for (std::size_t j = 0; j < places.size(); ++j)
        for (const char* other : {"7", "0.5"}) {
          if (j == k) continue;
          std::string changed = text;
          const auto put = [&](const Place& place, const char* value) {
            changed.replace(place.at, place.length, value);
          };
          put(places[std::max(j, k)], j > k ? other : "\"x\"");  // the later one first: it moves no other
          put(places[std::min(j, k)], j > k ? "\"x\"" : other);
          EXPECT_EQ(wrong_answer(changed), "") << changed;
          ++tried;
        }
  }
  EXPECT_GT(tried, 10000);
}

TEST(SceneReader, AnswersWithoutAnyOfTheLines) {
  int tried = 0;
  for (const std::string& text : small_scenes())
    for (std::size_t from = 0; from < text.size(); ++tried) {
      const std::size_t to = std::min(text.find('\n', from), text.size() - 1) + 1;
      EXPECT_EQ(wrong_answer(text.substr(0, from) + text.substr(to)), "") << text.substr(from, to - from);
      from = to;
    }
  EXPECT_GT(tried, 100);
}

}  // namespace
}  // namespace furrow
