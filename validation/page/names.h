// One name for each thing, in words.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace furrow::validation {

// "scenario_1" is "scene 1", "single_spring" is "single spring", "step_scenario_2" is "step scene 2".
inline std::string scene_words(std::string name) {
  for (std::size_t at = 0; (at = name.find("scenario_", at)) != std::string::npos;) name.replace(at, 9, "scene ");
  for (char& c : name) c = c == '_' ? ' ' : c;
  return name;
}

inline std::string capital(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

// "from 2 s on, for 0.1 s", of a title that begins with "the paper's second scene ": the name stands before it.
inline std::string without_scene(const std::string& title) {
  constexpr std::string_view before = "the paper's ", after = " scene";
  const std::size_t at = title.find(after);
  if (!title.starts_with(before) || at == std::string::npos) return title;
  const std::size_t rest = title.find_first_not_of(", ", at + after.size());
  return rest == std::string::npos ? title : title.substr(rest);
}

// "Scene 1: a plate drawn against a lattice", of a scene file whose title begins with "First scene of the paper: ".
inline std::string scene_title(const std::string& name, const std::string& title) {
  constexpr std::string_view of_the_paper = " scene of the paper: ";
  const std::size_t at = title.find(of_the_paper);
  if (at == std::string::npos) return title;
  return capital(scene_words(name)) + ": " + title.substr(at + of_the_paper.size());
}

}  // namespace furrow::validation
