// The keys of scene files as a list: what schema.h says of each, with the default of its struct.
#pragma once

#include <string>
#include <vector>

#include "scene/range.h"

namespace furrow {

struct SceneKey {
  enum class Type { boolean, integer, number, text, word, vector, table };
  struct Word {
    std::string word, meaning;
  };

  std::string path;  // "lattice.node.row": without the indices of lists
  Type type = Type::table;
  bool list = false;  // of values of this type, or of tables
  bool required = false;
  std::string unit;           // "-": a ratio; empty: none
  Range range;                // of each number
  std::string default_value;  // as TOML; empty: none
  std::string meaning;
  std::string example;        // as TOML; of a table empty
  std::vector<Word> words{};  // of which it is one
  std::string follows{};      // the key that it follows from; where that is given it must be left out

  std::string name() const { return path.substr(path.rfind('.') + 1); }              // without the tables that it is in
  std::string table() const { return path.substr(0, path.size() - name().size()); }  // "lattice.node.", or empty
};

// In the order of the schema, each table before its keys.
const std::vector<SceneKey>& scene_keys();

// Those whose path has the pattern in it. Throws std::invalid_argument that names the nearest one if there is none.
std::vector<SceneKey> scene_keys(const std::string& pattern);

// The table with its required keys, each with its example, as a scene file has it; empty if none is required.
std::string example_of(const SceneKey& table);

// "a number [m], 0 < radius < inf"
std::string type_and_range(const SceneKey& key);

}  // namespace furrow
