// The files of tests/bad_input are refused for the reason in their first line, and whatever is done to a good file, the
// reader survives it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

TEST(SceneReader, RefusesEveryBadInputForTheReasonInItsFirstLine) {
  const std::vector<std::pair<std::string, Lines>> expected = {
      {"misspelt_key",
       {"4:2: modle: unknown key; did you mean \"model\"?", "7:1: time.step: missing, but required [s]",
        "9:1: time.setp: unknown key; did you mean \"step\"?",
        "20:1: disc[0].colour: unknown key; known: position, radius, velocity, spin, material"}},
      {"missing_key",
       {"1:1: title: missing, but required", "2:1: time.step: missing, but required [s]",
        "5:1: disc[0].radius: missing, but required [m]", "5:1: disc[0].material: missing, but required"}},
      {"not_utf8", {"2:12: not UTF-8", "5:4: only ASCII is accepted outside strings and comments"}},
      {"not_toml", {"5:7: not TOML: Error while parsing key-value pair: expected value, saw '#'"}},
      {"nothing_moves",
       {"1:1: nothing moves: there is no [[disc]], no [[packing]] and no [[lattice]] with a node that is not fixed"}},
      {"out_of_range",
       {"6:8: time.step: -0.001 is outside 0 < step < inf [s]",
        "11:11: material[0].poisson: 0.7 is outside -1 < poisson <= 0.5",
        "14:13: disc[0].position[0]: nan is outside -inf < position[0] < inf [m]",
        "14:18: disc[0].position[1]: inf is outside -inf < position[1] < inf [m]",
        "15:10: disc[0].radius: 0 is outside 0 < radius < inf [m]"}},
      {"table_or_list",
       {"18:1: wall: must be a list of tables, [[wall]], not a table",
        "23:1: settle: must be one table, [settle], not a list of tables"}},
      {"two_rigid", {"21:1: wall[0]: rigid \"stone\" can meet rigid \"steel\" of disc[0], where nothing would deform"}},
      {"unknown_material",
       {"16:12: disc[0].material: no material is named \"sotf\"; did you mean \"soft\"?",
        "21:12: wall[0].material: no material is named \"granite\"; known: soft"}},
      {"unknown_word", {"5:13: model.disc_mass: must be one of disc, sphere, not \"spere\"; did you mean \"sphere\"?"}},
      {"wrong_type",
       {"5:8: model.pull: must be true or false, not an integer", "9:8: time.step: must be a number [s], not a string",
        "22:9: packing[0].count: must be an integer, not a float",
        "25:14: packing[0].lower_left: must be an array of two numbers [m], not an array of 1",
        "26:21: packing[0].upper_right[1]: must be a number [m], not a string",
        "28:8: packing[0].seed: must be an integer, not a string"}},
  };
  const std::filesystem::path folder = source_dir / "tests/bad_input";
  for (const auto& [stem, lines] : expected) {
    const std::string text = content(folder / (stem + ".toml"));
    EXPECT_TRUE(text.starts_with("# Wrong: ")) << stem;
    EXPECT_EQ(errors(text), lines) << stem;
  }
}

// Whatever is done to a good file, it is a scene or it is refused with at least one message; nothing else is thrown.
RC_GTEST_PROP(SceneReader, SurvivesAnyMutation, ()) {
  static const std::string whole = content(source_dir / "validation/scenes/scenario_3.toml");
  std::string text = whole;
  const int changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    const auto length = std::min(*rc::gen::inRange<std::size_t>(0, 40), text.size() - at);
    const auto from = *rc::gen::inRange<std::size_t>(0, whole.size() - 40);
    const std::vector<std::string> inserts = {"",
                                              whole.substr(from, 20),
                                              *rc::gen::string<std::string>(),
                                              "\"",
                                              "'''",
                                              "[",
                                              "]]",
                                              "{",
                                              "=",
                                              "\n",
                                              "#",
                                              ".",
                                              "-",
                                              "nan",
                                              "1e999",
                                              "\xC3",
                                              std::string(1, '\0')};
    text.replace(at, length, *rc::gen::elementOf(inserts));
  }
  try {
    const std::string canonical = canonical_text(parse_scene(text, "f"));
    RC_ASSERT(canonical_text(parse_scene(canonical, "f")) == canonical);
  } catch (const SceneError& error) {
    RC_ASSERT(!error.messages().empty());
    for (const std::string& message : error.messages()) RC_ASSERT(message.find(" error: ") != std::string::npos);
  }
}

}  // namespace
}  // namespace furrow
