// Any sound scene, written and read, is the same scene: every number to its last bit, every name in every tongue.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <concepts>
#include <optional>

#include "scene/schema.h"
#include "scene/set_key.h"
#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

// Moves every number by up to a thousandth, to one of many digits, and renames what may have any name. It is a visitor
// of schema.h.
class Shaker {
 public:
  void operator()(const char* key, auto& field, const Key&) {
    key_ = key;
    shake(field);
  }
  void required(const char* key, auto& field, const Key& about) { (*this)(key, field, about); }
  void follows(const char*, const char*) {}
  template <class Enum>
  void choice(const char* key, Enum& field, std::initializer_list<Choice<Enum>> choices, std::string_view) {
    if (std::string(key) != "disc_mass" && std::string(key) != "law")  // they need other keys
      field = (choices.begin() + *rc::gen::inRange<std::size_t>(0, choices.size()))->value;
  }

 private:
  void shake(double& number) { number *= 1 + 1e-3 * *rc::gen::inRange(0, 1'000'000) / 1e6; }
  void shake(Vec2& v) { shake(v.x), shake(v.y); }
  void shake(bool& value) { value = *rc::gen::arbitrary<bool>(); }
  void shake(std::string& text) {
    static const std::vector<std::string> letters = {
        "a",       "\"", "\\", "'",       "#", "=", "?", " ", "\xC3\xBC", "\xE2\x82\xAC", "\xF0\x9F\x8C\x99",
        "\\u00e9", "[",  ",",  "\xC2\xA0"};
    if (key_ == "title")
      for (int i = *rc::gen::inRange(0, 8); i > 0; --i) text += *rc::gen::elementOf(letters);
  }
  template <class T>
  void shake(std::optional<T>& field) {
    if (field) shake(*field);
  }
  template <class T>
  void shake(std::vector<T>& items) {
    for (T& item : items) shake(item);
  }
  template <class Struct>
  requires(std::is_aggregate_v<Struct>) void shake(Struct& inner) { describe(*this, inner); }
  void shake(std::integral auto&) {}

  std::string key_;
};

RC_GTEST_PROP(SceneRoundTrip, GivesTheSameSceneAndTheSameHash, ()) {
  const auto name = *rc::gen::element<std::string>("scenario_1", "scenario_2", "scenario_3", "cantilever",
                                                   "single_spring", "disc_on_wall");
  Scene scene = read_scene(source_dir / "validation/scenes" / (name + ".toml"));
  Shaker shaker;
  describe(shaker, scene);
  for (Material& m : scene.material) m.rigid = m.name == "rigid";
  for (Lattice& l : scene.lattice) {
    for (NodeSetting& n : l.node) {  // what is pushed is not held
      n.fixed_x = n.fixed_x && n.force.x == 0 && n.velocity.x == 0;
      n.fixed_y = n.fixed_y && !n.fixed_x && n.force.y == 0 && n.velocity.y == 0;
    }
  }
  for (Packing& p : scene.packing) p.radius_max = std::max(p.radius_min, p.radius_max);
  std::erase_if(scene.output.frames, [&](double t) { return t > scene.time.end; });
  const std::vector<std::pair<const char*, const char*>> options = {{"time.method", "rk4"},
                                                                    {"time.locate", "all"},
                                                                    {"search.threads", "2"},
                                                                    {"time.step", "0.00000012345678901234567"}};
  const auto& [path, value] = *rc::gen::elementOf(options);
  RC_ASSERT(set_key(scene, path, value).empty());
  for (const Problem& p : problems_of(scene)) RC_FAIL(p.path + ": " + p.message);
  const Scene read = parse_scene(canonical_text(scene), "f");
  RC_ASSERT(canonical_text(read) == canonical_text(scene));
  RC_ASSERT(scene_hash(read) == scene_hash(scene));
  RC_ASSERT(read.title == scene.title);
  for (std::size_t i = 0; i < scene.plate.size(); ++i) RC_ASSERT(read.plate[i].velocity == scene.plate[i].velocity);
}

}  // namespace
}  // namespace furrow
