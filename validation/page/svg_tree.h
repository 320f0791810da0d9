// The elements of an SVG file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace furrow::validation {

struct SvgNode {
  std::string name;  // empty: text
  std::vector<std::pair<std::string, std::string>> attributes{};
  std::vector<SvgNode> children{};
  std::string text{};  // as it stands in the file, entities and all

  // Empty if there is none of that name.
  std::string attribute(std::string_view key) const;
  void set(const std::string& key, std::string value);
  void drop(std::string_view key);
};

// The <svg> of a file. Comments, declarations and text of blanks alone are left out. Throws std::runtime_error if an
// element has no end.
SvgNode parsed_svg(std::string_view file);

std::string text_of(const SvgNode& node);

// The words of a <text>: its spans keep what they change; one that says and shifts nothing is left out.
std::string words_of(const SvgNode& text);

}  // namespace furrow::validation
