// Scenes made of the examples that the keys give: every table with its required keys, and one further key.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "scene/keys.h"

namespace furrow::test {

// Keys without which a table does not pass, though none of them is required by itself; a second material.
inline std::vector<std::string> needed(const std::string& table, const std::string& changed) {
  if (table == "material") return {"young", changed == "material.shear" ? "shear" : "poisson"};
  if (table == "contact" && changed == "model.law") return {"normal_stiffness"};
  if (changed == table + ".tangential_damping") return {"damping"};
  if (table == "lattice.drive" && changed != "lattice.drive.columns") return {"rows"};
  if (table == "lattice.link" && changed == "lattice.link.from") return {"to"};
  if (table == "lattice.link" && changed == "lattice.link.to") return {"from"};
  if (table == "lattice.link" && changed == "lattice.link.cut_from") return {"cut_to"};
  if (table == "lattice.link" && changed == "lattice.link.cut_to") return {"cut_from"};
  if (table == "plate" && changed != "plate.working_depth") return {"lower_edge"};
  return {};
}

// A lattice is a stem only where that is what is looked at: other keys follow from it.
inline bool of_stem(const SceneKey& changed) { return changed.path.starts_with("lattice.stem."); }

inline std::string keys_of(const std::string& table, const SceneKey& changed, const std::string& value) {
  if (changed.path == "material.rigid" && table == "material") return keys_of(table, {}, "");  // see the second one
  const std::vector<std::string> also = needed(table, changed.path);
  std::string text;
  for (const SceneKey& key : scene_keys()) {
    if (key.table() != (table.empty() ? "" : table + '.') || key.type == SceneKey::Type::table) continue;
    if (of_stem(changed) && !key.follows.empty()) continue;
    const bool given = key.required || std::find(also.begin(), also.end(), key.name()) != also.end();
    if (key.path == changed.path && !value.empty())
      text += key.name() + " = " + value + '\n';
    else if (key.path != changed.path && given)
      text += key.name() + " = " + key.example + '\n';
  }
  return text;
}

// The scene in which the key has this value, as TOML; empty: it is left out.
inline std::string scene_with(const SceneKey& changed, const std::string& value) {
  std::string text = keys_of("", changed, value);
  for (const SceneKey& table : scene_keys()) {
    if (table.type != SceneKey::Type::table) continue;
    if (of_stem(changed) ? !table.follows.empty() : table.path == "lattice.stem") continue;
    text += (table.list ? "[[" + table.path + "]]\n" : '[' + table.path + "]\n") + keys_of(table.path, changed, value);
    if (table.path != "material") continue;
    text += "[[material]]\nname = \"steel\"\n";
    if (const std::string rigid = changed.path == "material.rigid" ? value : "true"; !rigid.empty())
      text += "rigid = " + rigid + '\n';
  }
  return text;
}

}  // namespace furrow::test
