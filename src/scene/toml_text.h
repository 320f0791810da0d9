// A scene file's text as toml++ 3.3 can read it. That library mishandles some characters beyond ASCII, so none reaches
// it: in strings each is replaced by a tab, which no title or name may hold, and put back after parsing.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace furrow {

using TextPosition = std::pair<std::uint32_t, std::uint32_t>;  // line and column, from 1

struct SafeText {
  std::string text;                                          // ASCII; each character stands where it stood
  std::map<TextPosition, std::vector<std::string>> letters;  // what was replaced, by where its string begins
};

// Reports what cannot be taken: bytes that are not UTF-8, characters beyond ASCII outside strings and comments, and
// keys of very many parts, since toml++ deletes nested tables by recursion.
SafeText safe_text(std::string_view text, const std::function<void(TextPosition, const char*)>& fault);

// The text of the string that begins there, as it stood in the file. False if that is not known.
bool restore(const SafeText& safe, TextPosition begin, std::string& text);

}  // namespace furrow
