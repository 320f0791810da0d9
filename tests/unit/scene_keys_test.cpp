// What `furrow keys` says of a key is what the reader does with it.
#include <cmath>
#include <set>

#include "scene/keys.h"
#include "scene/set_key.h"
#include "scene/wording.h"
#include "tests/unit/scene_of_examples.h"
#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

using Type = SceneKey::Type;
using test::scene_with;

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

// What the reader alone says of a text, before keys are held against each other.
std::string read_errors(const std::string& text) {
  try {
    SceneFile::parse(text, "f").throw_if_wrong();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

// The keys that the reader knows in a table: for a name that is near to none it lists all.
std::set<std::string> known_to_reader(const SceneKey& table) {
  const SceneKey stranger{.path = table.path + ".zzzzzzzzzzzzzzzz", .type = Type::text};
  std::string text = scene_with(stranger, "");
  const std::string header = table.list ? "[[" + table.path + "]]\n" : '[' + table.path + "]\n";
  text.insert(text.find(header) + header.size(), "zzzzzzzzzzzzzzzz = 1\n");
  const std::string errors = read_errors(text), mark = "known: ";
  std::set<std::string> names;
  for (std::size_t at = errors.find(mark) + mark.size(); at < errors.size();) {
    const std::size_t end = std::min(errors.find_first_of(",\n", at), errors.size());
    names.insert(errors.substr(at, end - at));
    if (end == errors.size() || errors[end] == '\n') break;
    at = end + 2;
  }
  return names;
}

TEST(SceneKeys, HaveEveryKeyThatTheReaderAccepts) {
  for (const SceneKey& table : scene_keys()) {
    if (table.type != Type::table) continue;
    std::set<std::string> listed;
    for (const SceneKey& key : scene_keys())
      if (key.table() == table.path + '.') listed.insert(key.name());
    EXPECT_EQ(known_to_reader(table), listed) << table.path;
  }
}

TEST(SceneKeys, EachIsThereOnceWithAMeaningAndAnExample) {
  std::set<std::string> paths;
  for (const SceneKey& key : scene_keys()) {
    EXPECT_TRUE(paths.insert(key.path).second) << key.path;
    EXPECT_GE(key.meaning.size(), 8U) << key.path;
    EXPECT_EQ(key.meaning.back(), '.') << key.path;
    EXPECT_EQ(key.example.empty(), key.type == Type::table) << key.path;
    for (const auto& [word, meaning] : key.words) EXPECT_FALSE(meaning.empty()) << key.path << ' ' << word;
    const bool measured = key.type == Type::number || key.type == Type::vector;
    EXPECT_EQ(key.unit.empty(), !measured) << key.path << ": a number has a unit, or - for a ratio";
  }
  EXPECT_GT(paths.size(), 100U);
}

TEST(SceneKeys, AnExampleIsNotTheDefault) {
  for (const SceneKey& key : scene_keys()) {
    if (!key.default_value.empty()) {
      EXPECT_NE(key.example, key.default_value) << key.path;
    }
  }
}

TEST(SceneKeys, ARequiredKeyIsMissedAndNoOther) {
  for (const SceneKey& key : scene_keys()) {
    if (key.type == Type::table) continue;
    EXPECT_EQ(has(read_errors(scene_with(key, "")), key.name() + ": missing, but required"), key.required) << key.path;
  }
}

// Where a key is left out and where its default is given the scenes are the same, and where its example is given they
// are not.
TEST(SceneKeys, TheDefaultIsWhatTheReaderTakesWhereAKeyIsLeftOut) {
  int compared = 0;
  for (const SceneKey& key : scene_keys()) {
    if (key.type == Type::table || key.default_value.empty()) continue;
    const auto text_with = [&](const std::string& value) {
      return canonical_text(SceneFile::parse(scene_with(key, value), "f").scene);
    };
    EXPECT_EQ(text_with(""), text_with(key.default_value)) << key.path;
    EXPECT_NE(text_with(""), text_with(key.example)) << key.path;
    ++compared;
  }
  EXPECT_GT(compared, 40);
}

std::string number_as(const SceneKey& key, double value) {
  const std::string text = key.type == Type::integer ? std::to_string(static_cast<long long>(value)) : shortest(value);
  if (key.type == Type::vector) return '[' + text + ", " + text + ']';
  return key.list ? '[' + text + ']' : text;
}

bool reader_accepts(const SceneKey& key, double value) {
  return !has(read_errors(scene_with(key, number_as(key, value))), "is outside");
}

// At the end of a range and next to it, inside and outside.
void try_end(const SceneKey& key, double end, bool open, double outwards) {
  const bool whole = key.type == Type::integer;
  if (whole && std::fabs(end) > 1e15) return;  // the end of TOML's own integers
  const double beyond = whole ? end + outwards : std::nextafter(end, outwards * infinity);
  const double within = whole ? end - outwards : std::nextafter(end, -outwards * infinity);
  EXPECT_EQ(reader_accepts(key, end), !open) << key.path << " at " << end;
  if (std::isfinite(end)) {
    EXPECT_FALSE(reader_accepts(key, beyond)) << key.path << " at " << beyond;
  }
  EXPECT_TRUE(reader_accepts(key, within)) << key.path << " at " << within;
}

TEST(SceneKeys, TheRangeIsThatOfTheReader) {
  int tried = 0;
  for (const SceneKey& key : scene_keys()) {
    if (key.type != Type::integer && key.type != Type::number && key.type != Type::vector) continue;
    try_end(key, key.range.low, key.range.low_open, -1);
    try_end(key, key.range.high, key.range.high_open, 1);
    ++tried;
  }
  EXPECT_GT(tried, 60);
}

TEST(SceneKeys, AWordIsOneOfThoseListed) {
  for (const SceneKey& key : scene_keys()) {
    for (const auto& [word, meaning] : key.words) EXPECT_EQ(read_errors(scene_with(key, in_quotes(word))), "");
    if (key.words.empty()) continue;
    EXPECT_TRUE(has(read_errors(scene_with(key, "\"none of them\"")), "must be one of")) << key.path;
  }
}

// "lattice.node.row" as it stands in the scene of examples: "lattice[0].node[0].row".
std::string place_of(const SceneKey& key) {
  std::string path = key.name();
  for (const SceneKey& table : scene_keys())
    if (table.type == Type::table && key.table() == table.path + '.')
      path = place_of(table) + (table.list ? "[0]." : ".") + path;
  return key.path == "material.rigid" ? "material[1].rigid" : path;
}

TEST(SceneKeys, SetByATextEveryKeyIsWhatTheReaderMakesOfIt) {
  for (const SceneKey& key : scene_keys()) {
    if (key.type == Type::table) continue;
    Scene set = SceneFile::parse(scene_with(key, ""), "f").scene;
    EXPECT_EQ(set_key(set, place_of(key), key.example), "") << place_of(key);
    EXPECT_EQ(canonical_text(set), canonical_text(SceneFile::parse(scene_with(key, key.example), "f").scene))
        << place_of(key);
  }
}

TEST(SceneKeys, SetByATextAWrongPathOrValueIsAFaultAndChangesNothing) {
  for (const SceneKey& key : scene_keys()) {
    if (key.type == Type::table || key.type == Type::text) continue;  // any text is a string
    Scene scene = SceneFile::parse(scene_with(key, key.example), "f").scene;
    const std::string before = canonical_text(scene);
    EXPECT_NE(set_key(scene, place_of(key), "x y"), "") << place_of(key);
    EXPECT_NE(set_key(scene, place_of(key), "[7, x]"), "") << place_of(key);
    EXPECT_NE(set_key(scene, place_of(key) + "x", key.example), "") << place_of(key);
    EXPECT_NE(set_key(scene, place_of(key) + ".x", key.example), "") << place_of(key);
    if (!key.list) {
      EXPECT_EQ(set_key(scene, place_of(key) + "[0]", key.example), "is no list: leave out the [...]") << place_of(key);
    }
    EXPECT_EQ(canonical_text(scene), before) << place_of(key);
  }
}

TEST(SceneKeys, ABadPatternNamesTheNearestKey) {
  try {
    scene_keys("stifness");
    ADD_FAILURE() << "no key has that in its name";
  } catch (const std::invalid_argument& fault) {
    EXPECT_TRUE(has(fault.what(), "did you mean \"stiffness\"?")) << fault.what();
  }
  EXPECT_EQ(scene_keys("node.row").size(), 1U);
}

TEST(SetKey, SetsOneNumberOfAVector) {
  Scene scene;
  scene.plate.resize(1);
  EXPECT_EQ(set_key(scene, "plate[0].velocity.x", "0.2"), "");
  EXPECT_EQ(set_key(scene, "plate[0].velocity.y", "-1e-2"), "");
  EXPECT_EQ(scene.plate[0].velocity.x, 0.2);
  EXPECT_EQ(scene.plate[0].velocity.y, -0.01);
  EXPECT_NE(set_key(scene, "plate[0].velocity.z", "1"), "");
  EXPECT_NE(set_key(scene, "plate[0].velocity.x", "[1, 2]"), "");
}

}  // namespace
}  // namespace furrow
